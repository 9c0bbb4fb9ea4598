"""Packets of OpenSeeFace: a record for each face of a picture, little-endian; features of lids, brows and mouth.

Source: emilianavt/OpenSeeFace, `facetracker.py` and `tracker.py`. It sends no coefficients of ARKit; its features, each
-1 to 1 about the performer's own mean, become the nearest ones.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from types import MappingProxyType

from omote.inputs.rejection import PacketError
from omote.inputs.trackers.head_angles import (
    GazeAngles,
    HeadAngles,
    Quaternion,
    average_eyes,
    multiply_quaternions,
    normalize_quaternion,
    read_direction,
    read_quaternion,
)
from omote.inputs.trackers.tracker_frame import LeftOut, TrackerError, TrackerFrame

RECORD = 1785
HEAD = struct.Struct("<diffffBf4f")
POINTS_AT = 889
POINT = struct.Struct("<3f")
FEATURES_AT = 1729
FEATURES = struct.Struct("<14f")
PUPILS = (66, 67)
EYEBALLS = (68, 69)
"""Of the right and of the left eye, among the 70 points of the head."""
MOST_FACES = 40
WORST_FIT = 100.0
"""The error of a fit from which its own programs take no face."""
NAMES = (
    "eye_l eye_r eyebrow_steepness_l eyebrow_updown_l eyebrow_quirk_l eyebrow_steepness_r eyebrow_updown_r "
    "eyebrow_quirk_r mouth_corner_updown_l mouth_corner_inout_l mouth_corner_updown_r mouth_corner_inout_r "
    "mouth_open mouth_wide"
).split()
_BOTH: Mapping[str, tuple[tuple[str, float], ...]] = {
    "mouth_open": (("jawOpen", 1.0),),
    "mouth_wide": (
        ("mouthStretchLeft", 0.6), ("mouthStretchRight", 0.6), ("mouthPucker", -0.8),
    ),
}  # fmt: skip
_SIDED: Mapping[str, tuple[tuple[str, float], ...]] = {
    "eyebrow_updown": (("browOuterUp", 1.0), ("browDown", -1.0)),
    "mouth_corner_updown": (("mouthSmile", 1.0), ("mouthFrown", -1.0)),
}
CHANNELS: Mapping[str, tuple[tuple[str, float], ...]] = MappingProxyType(
    {
        **_BOTH,
        **{
            f"{feature}_{side[0].lower()}": tuple((f"{name}{side}", part) for name, part in parts)
            for feature, parts in _SIDED.items()
            for side in ("Left", "Right")
        },
    }
)
"""The coefficients that a feature becomes, with the part of it that each takes: one for what is above 0, with a minus
for what is below."""
AT_REST = (1.0 / math.sqrt(2.0), -1.0 / math.sqrt(2.0), 0.0, 0.0)
"""The rotation of a face that looks into the camera, from the model (x right, y up, z out of the face) to the camera's
rows down, columns right, depth away."""


def decode_open_see_face(data: bytes) -> list[TrackerFrame]:
    """The frame of each face of a packet; the subject of those after the first is its number. TrackerError where it is
    none."""
    count, rest = divmod(len(data), RECORD)
    if rest or not 0 < count < MOST_FACES:
        raise TrackerError(f"the packet has {len(data)} bytes, expected a multiple of {RECORD}, one for each face")
    return [_face(data[RECORD * index : RECORD * (index + 1)]) for index in range(count)]


def _face(record: bytes) -> TrackerFrame:
    time, number, _, _, right, left, fitted, error, *rotation = HEAD.unpack_from(record)
    subject = f"face {number}" if number else ""
    if not fitted or not error <= WORST_FIT:
        return TrackerFrame(found=False, time=time, subject=subject)
    features = dict(zip(NAMES, FEATURES.unpack_from(record, FEATURES_AT), strict=True))
    weights = {"eyeBlinkLeft": 1.0 - left, "eyeBlinkRight": 1.0 - right, **_weights(features)}
    x, y, z, w = rotation
    head = None
    left_out: tuple[LeftOut, ...] = ()
    try:
        head = _turn((x, y, z, w))
    except PacketError as error:
        left_out = (LeftOut("head", str(error)),)
    return TrackerFrame(weights, head, _gaze(record), time=time, subject=subject, left_out=left_out)


def _weights(features: Mapping[str, float]) -> dict[str, float]:
    weights = {}
    for feature, parts in CHANNELS.items():
        for name, part in parts:
            weights[name] = _above(features[feature] * part)
    ups = [features[f"eyebrow_updown_{side}"] for side in "lr"]
    return {**weights, "browInnerUp": _above(0.5 * sum(ups))}


def _above(value: float) -> float:
    """The part above 0; what is no number stays so, for the frame to leave it out."""
    return 0.0 if value < 0.0 else value


def _turn(rotation: Quaternion) -> HeadAngles:
    """The head's turn. Its quaternion turns the other way (its matrix is read as for rows), and its camera has rows
    before columns, which mirrors: the rest pose is taken off, then the axes are named as ours."""
    x, y, z, w = normalize_quaternion(rotation)
    x, y, z, w = multiply_quaternions((-x, -y, -z, w), (-AT_REST[0], -AT_REST[1], -AT_REST[2], AT_REST[3]))
    # our x is its y, our y its -x, our z its -z: a mirror, in which a rotation's axis turns round
    return read_quaternion((-y, x, z, w))


def _gaze(record: bytes) -> GazeAngles | None:
    """The mean direction of both eyes, from the eyeball's centre to the pupil; points come as (x, -y, -z)."""
    return average_eyes(_direction(record, pupil, ball) for pupil, ball in zip(PUPILS, EYEBALLS, strict=True))


def _direction(record: bytes, pupil: int, ball: int) -> GazeAngles | None:
    ends = (POINT.unpack_from(record, POINTS_AT + POINT.size * point) for point in (ball, pupil))
    return read_direction([start - end for start, end in zip(*ends, strict=True)])
