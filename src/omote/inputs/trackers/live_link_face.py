"""Packets of Live Link Face in its mode ARKit (UDP), read and written.

Big-endian: version 6, the device's id and the subject's name each with its length, the time code, then 61 float32:
the 52 coefficients and three angles each of head, left and right eye (radians). Sources: FaceFrame by think-biq,
PyLiveLinkFace, and Unreal's EARFaceBlendShape.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles, average_eyes, read_unreal_radians
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame, trim_subject

VERSION = 6
LONGEST_TEXT = 256
ANGLES = 9
VALUES = len(ARKIT_NAMES) + ANGLES
TIME_CODE = struct.Struct(">ifii")
NUMBERS = struct.Struct(f">{VALUES}f")
LENGTH = struct.Struct(">i")
FRAME_RATE = 60


def decode_live_link_face(data: bytes) -> list[TrackerFrame]:
    """The frame of a packet; one without a face says that nobody is seen. TrackerError where it is none."""
    if not data or data[0] != VERSION:
        raise TrackerError(
            f"the packet begins with {data[:4].hex(' ') or 'nothing'}, expected version {VERSION}: "
            "choose the mode Live Link (ARKit) in the app"
        )
    _, at = _text(data, 1, "device")
    name, at = _text(data, at, "subject")
    subject = trim_subject(name)
    if at == len(data):
        return [TrackerFrame(found=False, subject=subject)]
    if len(data) < at + TIME_CODE.size + 1:
        raise TrackerError("the packet ends within its time code")
    frame, sub, rate, unit = TIME_CODE.unpack_from(data, at)
    at += TIME_CODE.size
    if data[at] == 0:
        return [TrackerFrame(found=False, subject=subject)]
    time = (frame + sub) * unit / rate if rate > 0 and unit > 0 and math.isfinite(sub) else None
    if data[at] != VALUES or len(data) != at + 1 + NUMBERS.size:
        return [_read_others(data[at], data[at + 1 :], subject, time)]
    return [frame_of_values(NUMBERS.unpack_from(data, at + 1), subject, time)]


def frame_of_values(values: Sequence[float], subject: str = "", time: float | None = None) -> TrackerFrame:
    """The frame of the 61 values, in the order of packets. subject: whose; time: seconds, None where it is not said."""
    head, left, right = (read_unreal_radians(*values[at : at + 3]) for at in (52, 55, 58))
    gaze = average_eyes((left[:2], right[:2]))
    return TrackerFrame(dict(zip(ARKIT_NAMES, values, strict=False)), head, gaze, time=time, subject=subject)


def _read_others(count: int, data: bytes, subject: str, time: float | None) -> TrackerFrame:
    """The frame of an app that sends the coefficients without angles, or more behind both."""
    if count < len(ARKIT_NAMES) or len(data) != 4 * count:
        raise TrackerError(f"the packet announces {count} values in {len(data)} bytes; expected {VALUES}")
    values = struct.unpack(f">{count}f", data)
    if count >= VALUES:
        return frame_of_values(values[:VALUES], subject, time)
    return TrackerFrame(dict(zip(ARKIT_NAMES, values, strict=False)), time=time, subject=subject)


def encode_live_link_face(
    weights: Sequence[float], head: HeadAngles, gaze: GazeAngles, *, device: str, subject: str, frame: int
) -> bytes:
    """The packet of a face. weights: of `ARKIT_NAMES`; device: an id; frame: its number at 60 a second; head, gaze:
    radians; subject: whose face it is."""
    eye = [-gaze[0], -gaze[1], 0.0]
    values = [*weights, -head[0], -head[1], head[2], *eye, *eye]
    texts = b"".join(LENGTH.pack(len(text)) + text for text in (device.encode(), subject.encode()))
    time_code = TIME_CODE.pack(frame % 2**31, 0.0, FRAME_RATE, 1)
    return bytes([VERSION]) + texts + time_code + bytes([VALUES]) + NUMBERS.pack(*values)


def _text(data: bytes, at: int, what: str) -> tuple[str, int]:
    if len(data) < at + LENGTH.size:
        raise TrackerError(f"the packet ends before the {what}'s name")
    (size,) = LENGTH.unpack_from(data, at)
    at += LENGTH.size
    if not 0 <= size <= LONGEST_TEXT or at + size > len(data):
        raise TrackerError(f"the {what}'s name has {size} bytes, which are not there")
    return data[at : at + size].decode(errors="replace"), at + size
