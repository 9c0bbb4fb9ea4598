"""Messages of VTube Studio's API: one envelope for requests, answers, events and the announcement in the network.

Source: DenchiSoft/VTubeStudio, README and Events/README. Unknown fields are left out, as it asks for.
"""

from __future__ import annotations

from typing import Annotated, Any

import msgspec

from omote.inputs.trackers.tracker_frame import TrackerError

API_NAME, API_VERSION = "VTubeStudioPublicAPI", "1.0"
API_PORT, ANNOUNCEMENT_PORT = 8001, 47779
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


_DECODER = msgspec.json.Decoder(ApiMessage)
_ANNOUNCEMENT = msgspec.json.Decoder(Announcement)


def encode_request(message_type: str, data: dict[str, Any] | None = None, request_id: str = "omote") -> bytes:
    """The bytes of a request."""
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
    try:
        message = _DECODER.decode(data)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise TrackerError(f"the message is none of VTube Studio: {str(error)[:160]}") from error
    if message.api_name != API_NAME:
        raise TrackerError(f"the message is of the API {message.api_name[:40]!r}, expected {API_NAME}")
    return message


def decode_announcement(data: bytes) -> Announcement | None:
    """Where VTube Studio runs, by what it sends into the network every two seconds; None for anything else."""
    try:
        message = decode_message(data)
        return _ANNOUNCEMENT.decode(message.data) if message.message_type == ANNOUNCEMENT else None
    except (TrackerError, msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return None
