"""Frames of iFacialMocap and Facemotion3D: a text with a name and a number for each coefficient, then angles.

`name-value|...|=head#rx,ry,rz,px,py,pz|rightEye#rx,ry,rz|leftEye#rx,ry,rz|`, in version 2 `name&value`; values in
percent, angles in degrees. Source: ifacialmocap.com/for-developer and facemotion3d.net/for-developer. Real frames lack
coefficients, hold others and loose ends: what is unknown is left out, what is missing is kept.
"""

from __future__ import annotations

import math

from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, average_eyes, read_right_handed_degrees
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame

IFACIALMOCAP_START = b"iFacialMocap_sahuasouryya9218sauhuiayeta91555dy3719|sendDataVersion=v2"
IFACIALMOCAP_STREAM = IFACIALMOCAP_START.replace(b"Mocap_", b"Mocap_UDPTCP_", 1)
FACEMOTION3D_START = b"FACEMOTION3D_OtherStreaming"
FACEMOTION3D_STREAM = FACEMOTION3D_START + b"|protocol=tcp"
"""What asks the apps for frames: over UDP, and over TCP, which they open to us."""
LONGEST_FRAME = 16384
MOST_FIELDS = 256
STATUS = "trackingstatus"


def decode_face_text(data: bytes) -> list[TrackerFrame]:
    """The frame of a packet; TrackerError where it is none."""
    if len(data) > LONGEST_FRAME:
        raise TrackerError(f"the frame has {len(data)} bytes, but at most {LONGEST_FRAME} are read")
    try:
        text = data.decode("ascii")
    except UnicodeDecodeError as error:
        raise TrackerError(f"the frame is no text: {data[:16].hex(' ')}") from error
    shapes, _, turns = text.partition("=")
    fields = [field for field in shapes.split("|") if field]
    if len(fields) > MOST_FIELDS:
        raise TrackerError(f"the frame has {len(fields)} fields, but at most {MOST_FIELDS} are read")
    read = dict(shape for field in fields if (shape := _read_shape(field)) is not None)
    if not read:
        raise TrackerError("the frame has no coefficient, such as jawOpen-25")
    status = next((value for name, value in read.items() if name.lower() == STATUS), 0.01)
    weights = {name: value for name, value in read.items() if name.lower() != STATUS}
    angles = _read_turns(turns)
    gaze = average_eyes(None if (eye := angles.get(name)) is None else eye[:2] for name in ("leftEye", "rightEye"))
    return [TrackerFrame(weights, angles.get("head"), gaze, found=status != 0.0)]


def encode_face_text(weights: dict[str, float], head: HeadAngles, gaze: GazeAngles) -> bytes:
    """The frame of version 2 for weights by their names, whole percents. head, gaze: radians."""
    shapes = "|".join(f"{name}&{round(100.0 * value)}" for name, value in weights.items())
    turn = ",".join(f"{math.degrees(angle):.6f}" for angle in (-head[1], head[0], -head[2]))
    eye = f"{-math.degrees(gaze[1]):.6f},{math.degrees(gaze[0]):.6f},0"
    return f"{shapes}|=head#{turn},0,0,0|rightEye#{eye}|leftEye#{eye}|".encode("ascii")


def _read_shape(field: str) -> tuple[str, float] | None:
    """A coefficient by its name; None for what is none. A sign belongs to the number: `jawLeft--3`, `jawLeft&-3`."""
    mark = "&" if "&" in field else "-"
    name, separator, number = field.partition(mark)
    if not separator or not name.replace("_", "").isalnum():
        return None
    try:
        value = 0.01 * float(number)
    except ValueError:
        return None
    if not math.isfinite(value):
        raise TrackerError(f"{name[:40]} is {number[:20]}, which is no number")
    return name, value


def _read_turns(text: str) -> dict[str, HeadAngles]:
    turns = {}
    for field in text.split("|")[:MOST_FIELDS]:
        name, mark, numbers = field.partition("#")
        if mark and name in ("head", "leftEye", "rightEye"):
            turns[name] = _read_turn(name, numbers)
    return turns


def _read_turn(name: str, numbers: str) -> HeadAngles:
    try:
        x, y, z = (float(number) for number in numbers.split(",")[:3])
    except ValueError as error:
        raise TrackerError(f"{name} is {numbers[:60]!r}; expected three angles in degrees") from error
    return read_right_handed_degrees(x, y, z)
