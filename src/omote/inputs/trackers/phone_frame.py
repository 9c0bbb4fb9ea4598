"""Frames of the app VTube Studio (iPhone) and of MeowFace (Android): one JSON document a frame over UDP.

Source: DenchiSoft/VTubeStudioBlendshapeUDPReceiverTest; MeowFace sends the same with fewer names. The phone sends for
some seconds after each request.
"""

from __future__ import annotations

from typing import Annotated

import msgspec

from omote.inputs.trackers.head_angles import HeadAngles, average_eyes, read_right_handed_degrees
from omote.inputs.trackers.tracker_frame import TrackerFrame, read_json

REQUEST_SECONDS = 5.0
MOST_SHAPES = 256
HALVES = ("browinnerupleft", "browinnerupright")


class PhoneAngles(msgspec.Struct, frozen=True):
    """Degrees about x, y and z."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0


class Coefficient(msgspec.Struct, frozen=True):
    """A coefficient: its name and its value."""

    k: Annotated[str, msgspec.Meta(max_length=80)]
    v: float


class PhoneFrame(msgspec.Struct, frozen=True, rename="pascal"):
    """A frame as the phone sends it; what else it holds is left out."""

    blend_shapes: Annotated[list[Coefficient], msgspec.Meta(max_length=MOST_SHAPES)]
    face_found: bool = True
    timestamp: float | None = None
    rotation: PhoneAngles | None = None
    eye_left: PhoneAngles | None = None
    eye_right: PhoneAngles | None = None


def decode_phone_frame(data: bytes) -> list[TrackerFrame]:
    """The frame of a packet; TrackerError where it is none."""
    frame = read_json(PhoneFrame, data, "the packet is no frame of a phone")
    time = None if frame.timestamp is None else 0.001 * frame.timestamp
    if not frame.face_found:
        return [TrackerFrame(found=False, time=time)]
    weights = {shape.k: shape.v for shape in frame.blend_shapes}
    halves = [name for name in weights if name.lower() in HALVES]
    if len(halves) == len(HALVES):  # of MeowFace: one channel takes the mean of both
        weights["browInnerUp"] = sum(weights.pop(name) for name in halves) / len(HALVES)
    eyes = (None if (turn := _turn(eye)) is None else turn[:2] for eye in (frame.eye_left, frame.eye_right))
    return [TrackerFrame(weights, _turn(frame.rotation), average_eyes(eyes), time=time)]


def request_frames(port: int) -> bytes:
    """What asks a phone for frames at our port for some seconds."""
    request = {"messageType": "iOSTrackingDataRequest", "time": REQUEST_SECONDS, "sentBy": "Omote", "ports": [port]}
    return msgspec.json.encode(request)


def _turn(angles: PhoneAngles | None) -> HeadAngles | None:
    return None if angles is None else read_right_handed_degrees(angles.x, angles.y, angles.z)
