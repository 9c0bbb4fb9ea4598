"""Messages of VTube Studio's API: one envelope for requests, answers, events and the announcement in the network.

Source: DenchiSoft/VTubeStudio, README and Events/README. Unknown fields are left out, as it asks for.
"""

from __future__ import annotations

from typing import Annotated, Any

import msgspec

from omote.inputs.trackers.tracker_frame import TrackerError, read_json

API_NAME = "VTubeStudioPublicAPI"
API_VERSION = "1.0"
API_PORT = 8001
ANNOUNCEMENT_PORT = 47779
PLUGIN = {"pluginName": "Omote", "pluginDeveloper": "Omote contributors"}
ANNOUNCEMENT = "VTubeStudioAPIStateBroadcast"
LONGEST_MESSAGE = 1 << 20
"""Bytes; a list of all its parameters has some ten thousands."""


class ApiMessage(msgspec.Struct, frozen=True, rename="camel"):
    """An answer or an event. data: what belongs to its type, as it came."""

    api_name: Annotated[str, msgspec.Meta(max_length=80)]
    message_type: Annotated[str, msgspec.Meta(max_length=80)]
    request_id: str = msgspec.field(default="", name="requestID")
    data: msgspec.Raw = msgspec.Raw(b"{}")


class Announcement(msgspec.Struct, frozen=True, rename="camel"):
    """That VTube Studio runs somewhere: whether its API is on, and at which port."""

    active: bool
    port: Annotated[int, msgspec.Meta(gt=0, lt=65536)]
    window_title: str = ""


class Token(msgspec.Struct, frozen=True, rename="camel"):
    """What its user has granted."""

    authentication_token: Annotated[str, msgspec.Meta(min_length=1, max_length=64)]


class Authentication(msgspec.Struct, frozen=True):
    """Whether this connection may read and set."""

    authenticated: bool
    reason: str = ""


class ApiFault(msgspec.Struct, frozen=True):
    """What went wrong: its number and sentence."""

    number: int = msgspec.field(name="errorID")
    message: str = ""


class FaceStatus(msgspec.Struct, frozen=True, rename="camel"):
    """Whether a face is there: of the event (`faceFound`) and of the answer (`found`)."""

    face_found: bool | None = None
    found: bool | None = None


class Parameter(msgspec.Struct, frozen=True):
    """A tracking parameter and its value now."""

    name: Annotated[str, msgspec.Meta(max_length=80)]
    value: float = 0.0


class ParameterList(msgspec.Struct, frozen=True, rename="camel"):
    """All tracking parameters."""

    custom_parameters: Annotated[list[Parameter], msgspec.Meta(max_length=1024)] = []
    default_parameters: Annotated[list[Parameter], msgspec.Meta(max_length=1024)] = []


def encode_request(message_type: str, data: dict[str, Any] | None = None, request_id: str = "omote") -> bytes:
    """The bytes of a request.

    message_type: its kind, as the API calls it; data: what belongs to that; request_id: what the answer repeats.
    """
    return msgspec.json.encode(
        {
            "apiName": API_NAME,
            "apiVersion": API_VERSION,
            "requestID": request_id,
            "messageType": message_type,
            "data": data or {},
        }
    )


def decode_message(data: bytes) -> ApiMessage:
    """An answer or an event; TrackerError where it is none."""
    if len(data) > LONGEST_MESSAGE:
        raise TrackerError(f"the message has {len(data)} bytes, but at most {LONGEST_MESSAGE} are read")
    message = read_json(ApiMessage, data, "the message is none of VTube Studio")
    if message.api_name != API_NAME:
        raise TrackerError(f"the message is of the API {message.api_name[:40]!r}, expected {API_NAME}")
    return message


def decode_announcement(data: bytes) -> Announcement | None:
    """Where VTube Studio runs, by what it sends into the network every two seconds; None for anything else."""
    try:
        message = decode_message(data)
        announced = message.message_type == ANNOUNCEMENT
        return read_json(Announcement, message.data, "the announcement cannot be read") if announced else None
    except TrackerError:
        return None
