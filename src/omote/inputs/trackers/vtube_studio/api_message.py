"""Messages of VTube Studio's API: one envelope for requests, answers, events and the announcement in the network.

Source: DenchiSoft/VTubeStudio, README and Events/README. Unknown fields are left out, as it asks for.
"""

from __future__ import annotations

import json
from typing import Annotated, Any

import msgspec

from omote.inputs.trackers.loose_json import find_field, read_pairs
from omote.inputs.trackers.tracker_frame import MOST_SHAPES, TrackerError, read_json

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

    name: str
    value: float = 0.0


class ParameterList(msgspec.Struct, frozen=True, rename="camel"):
    """All tracking parameters."""

    custom_parameters: list[Parameter] = []
    default_parameters: list[Parameter] = []

    def values(self) -> tuple[dict[str, float], dict[str, float]]:
        """The values of those that were added and of its own, by name, as many as are read."""
        custom, own = (
            {parameter.name: parameter.value for parameter in listed[:MOST_SHAPES]}
            for listed in (self.custom_parameters, self.default_parameters)
        )
        return custom, own


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
    message = read_json(ApiMessage, data, "the message is none of VTube Studio", _read_loosely)
    if message.api_name != API_NAME:
        raise TrackerError(f"the message is of the API {message.api_name[:40]!r}, expected {API_NAME}")
    return message


def read_parameter_list(message: ApiMessage) -> ParameterList:
    """The parameters of an answer; TrackerError where it is none."""
    return read_json(ParameterList, message.data, f"{message.message_type} cannot be read", _read_list_loosely)


def _read_loosely(document: Any) -> ApiMessage | None:
    """The message of a document with numbers as no JSON has them."""
    name, kind, request = (find_field(document, field, "") for field in ("apiname", "messagetype", "requestid"))
    if not (isinstance(name, str) and isinstance(kind, str) and name and kind):
        return None
    data = json.dumps(find_field(document, "data", {})).encode()
    return ApiMessage(name[:80], kind[:80], str(request), msgspec.Raw(data))


def _read_list_loosely(document: Any) -> ParameterList | None:
    listed = [find_field(document, name) for name in ("customparameters", "defaultparameters")]
    pairs = [read_pairs(each, "name", "value") for each in listed]
    if not any(pairs):
        return None
    return ParameterList(*([Parameter(name, value) for name, value in each.items()] for each in pairs))


def decode_announcement(data: bytes) -> Announcement | None:
    """Where VTube Studio runs, by what it sends into the network every two seconds; None for anything else."""
    try:
        message = decode_message(data)
        announced = message.message_type == ANNOUNCEMENT
        return read_json(Announcement, message.data, "the announcement cannot be read") if announced else None
    except TrackerError:
        return None
