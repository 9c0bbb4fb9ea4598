"""Packets of trackers, made by hand from their specifications, for the tests of their decoders."""

import struct
from collections.abc import Mapping

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.inputs.trackers.face_motion.motion_message import Kind, MotionMessage
from omote.inputs.trackers.open_see_face import NAMES

SESSION = 0x0102030405060708
MOTION_POSE = (1.25, -2.5, 3.75, 0.1, -0.2, 0.3, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
Matrix = NDArray[np.float64]
EYEBALL = np.array([0.2, 0.3, -0.3])


def live_link_face(values: list[float], subject: str = "Phone", device: str = "D" * 36) -> bytes:
    """A packet of the app: version 6, texts with lengths, time code, count, values."""
    texts = b"".join(struct.pack(">i", len(text)) + text.encode() for text in (device, subject))
    return (
        b"\x06" + texts + struct.pack(">ifiiB", 120, 0.5, 60, 1, len(values)) + struct.pack(f">{len(values)}f", *values)
    )


def turn(axis: int, angle: float) -> Matrix:
    """The right-handed rotation about an axis."""
    first = (axis + 1) % 3
    second = (axis + 2) % 3
    made = np.eye(3)
    made[first, first] = made[second, second] = np.cos(angle)
    made[second, first] = np.sin(angle)
    made[first, second] = -np.sin(angle)
    return made


def head_matrix(yaw: float, pitch: float, roll: float) -> Matrix:
    """The head's turn as the stage makes it: Euler(-pitch, yaw, -roll) in the order YXZ."""
    return turn(1, yaw) @ turn(0, -pitch) @ turn(2, -roll)


def quaternion(matrix: Matrix) -> list[float]:
    """x, y, z, w of a rotation, by its axis."""
    values, vectors = np.linalg.eig(matrix)
    axis = np.real(vectors[:, np.argmin(np.abs(values - 1.0))])
    skew = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]])
    angle = np.arctan2(skew @ axis, np.trace(matrix) - 1.0)
    return [*(axis * np.sin(angle / 2)), float(np.cos(angle / 2))]


def open_see_face(
    head: tuple[float, float, float] = (0.0, 0.0, 0.0),
    gaze: tuple[float, float] = (0.0, 0.0),
    eyes: tuple[float, float] = (1.0, 1.0),
    features: Mapping[str, float] | None = None,
    number: int = 0,
    fitted: int = 1,
) -> bytes:
    """A record of OpenSeeFace for a turn of the head in our axes. eyes: right and left, 1 is open.

    Its model has x to the performer's right, y up, z out of the face; its camera rows down, columns right, depth away.
    """
    model = np.diag([-1.0, 1.0, 1.0])  # from its model to our axes
    camera = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])  # from our axes to its camera
    rotation = quaternion((camera @ head_matrix(*head) @ model).T)  # its quaternion is that of the transposed matrix
    points = np.zeros((70, 3))
    for ball, pupil in ((68, 66), (69, 67)):
        looks = model @ head_matrix(*gaze, 0.0) @ np.array([0.0, 0.0, 0.1])
        points[ball], points[pupil] = EYEBALL, looks + EYEBALL
    sent = points * (1.0, -1.0, -1.0)
    begin = struct.pack("<diffffBf4f", 12.5, number, 640.0, 480.0, *eyes, fitted, 3.0, *rotation)
    middle = bytes(889 - len(begin)) + sent.astype("<f4").tobytes()
    return begin + middle + struct.pack("<14f", *((features or {}).get(name, 0.0) for name in NAMES))


def motion_schema(
    names: list[str], number: int = 1, nonce: int = 0, revision: int = 4, rate: int = 30, **changed: object
) -> bytes:
    """The list of names that a phone sends before its frames over FMV3."""
    document = {
        "schema_version": 1,
        "app": "iFacialMocap",
        "profile": "ifacialmocap-stream",
        "blend_names": names,
        "blend_encoding": "i16",
        "blend_unit": "percent",
        "pose_layout": "head_rxyz_pxyz_rightEye_rxyz_leftEye_rxyz",
        "rotation_unit": "degree",
        "position_unit": "meter",
        **changed,
    }
    payload = struct.pack("<QHHII", nonce, rate, 1200, 10_000, revision) + msgspec.json.encode(document)
    return MotionMessage(Kind.SCHEMA, SESSION, number, payload=payload).encode()


def motion_frame(values: tuple[int, ...], sequence: int = 1, number: int = 1, flags: int = 1) -> bytes:
    """A frame of FMV3: percents by the names of its list, and angles."""
    payload = struct.pack(f"<{len(values)}h12f", *values, *MOTION_POSE)
    return MotionMessage(Kind.FRAME, SESSION, number, sequence, flags, payload=payload).encode()
