"""Frames of the app VTube Studio (iPhone) and of MeowFace (Android): one JSON document a frame over UDP.

Source: DenchiSoft/VTubeStudioBlendshapeUDPReceiverTest; MeowFace sends the same with fewer names. The phone sends for
some seconds after each request.
"""

from __future__ import annotations

from itertools import islice
from typing import Any

import msgspec

from omote.inputs.trackers.head_angles import HeadAngles, average_eyes, read_right_handed_degrees
from omote.inputs.trackers.loose_json import find_field, read_number, read_pairs
from omote.inputs.trackers.tracker_frame import MOST_SHAPES, TrackerFrame, read_json

REQUEST_SECONDS = 5.0
HALVES = ("browinnerupleft", "browinnerupright")


class PhoneAngles(msgspec.Struct, frozen=True):
    """Degrees about x, y and z."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0


class Coefficient(msgspec.Struct, frozen=True):
    """A coefficient: its name and its value."""

    k: str
    v: float


class PhoneFrame(msgspec.Struct, frozen=True, rename="pascal"):
    """A frame as the phone sends it; what else it holds is left out."""

    blend_shapes: list[Coefficient]
    face_found: bool = True
    timestamp: float | None = None
    rotation: PhoneAngles | None = None
    eye_left: PhoneAngles | None = None
    eye_right: PhoneAngles | None = None


def decode_phone_frame(data: bytes) -> list[TrackerFrame]:
    """The frame of a packet; TrackerError where it is none."""
    frame = read_json(PhoneFrame, data, "the packet is no frame of a phone", _read_loosely)
    time = None if frame.timestamp is None else 0.001 * frame.timestamp
    if not frame.face_found:
        return [TrackerFrame(found=False, time=time)]
    weights = {shape.k: shape.v for shape in islice(frame.blend_shapes, MOST_SHAPES)}
    halves = [name for name in weights if name.lower() in HALVES]
    if len(halves) == len(HALVES):  # of MeowFace: one channel takes the mean of both
        weights["browInnerUp"] = sum(weights.pop(name) for name in halves) / len(HALVES)
    eyes = (None if (turn := _turn(eye)) is None else turn[:2] for eye in (frame.eye_left, frame.eye_right))
    return [TrackerFrame(weights, _turn(frame.rotation), average_eyes(eyes), time=time)]


def request_frames(port: int) -> bytes:
    """What asks a phone for frames at our port for some seconds."""
    request = {"messageType": "iOSTrackingDataRequest", "time": REQUEST_SECONDS, "sentBy": "Omote", "ports": [port]}
    return msgspec.json.encode(request)


def _read_loosely(document: Any) -> PhoneFrame | None:
    """The frame of a document that has other names of fields, or values that are no numbers."""
    shapes = find_field(document, "blendshapes")
    weights = read_pairs(shapes, "k", "v")
    if not weights:
        return None
    time = find_field(document, "timestamp")
    return PhoneFrame(
        [Coefficient(name, value) for name, value in weights.items()],
        find_field(document, "facefound") not in (False, 0.0),
        time if isinstance(time, float) else None,
        *(_read_angles(find_field(document, name)) for name in ("rotation", "eyeleft", "eyeright")),
    )


def _read_angles(document: Any) -> PhoneAngles | None:
    if not isinstance(document, dict):
        return None
    return PhoneAngles(*(read_number(find_field(document, axis, 0.0)) for axis in "xyz"))


def _turn(angles: PhoneAngles | None) -> HeadAngles | None:
    return None if angles is None else read_right_handed_degrees(angles.x, angles.y, angles.z)
