"""One connection to VTube Studio's API: its messages in, frames and answers out.

First it asks for a token, which VTube Studio's user grants in a window there, once; later connections show it. Then it
reads all tracking parameters, one list after the other, or adds those of ARKit's units and sets values.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeVar

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.head_angles import GazeAngles, HeadAngles
from omote.inputs.trackers.tracker_frame import TrackerError, TrackerFrame, read_json
from omote.inputs.trackers.vtube_studio.api_message import (
    PLUGIN,
    ApiFault,
    ApiMessage,
    Authentication,
    FaceStatus,
    ParameterList,
    Token,
    decode_message,
    encode_request,
    read_parameter_list,
)
from omote.inputs.trackers.vtube_studio.api_parameters import (
    custom_name,
    read_parameters,
    write_custom,
    write_parameters,
)

NEEDS_TOKEN = 8
TOKEN_DENIED = 50
"""Numbers of its faults (Files/ErrorID.cs)."""
STATUS_EVENT = "TrackingStatusChangedEvent"
Kind = TypeVar("Kind")


class ApiSession:
    """A connection. answer: sends a message; keep: takes the token that was granted, to be shown again; token: of
    before, or "". sets: whether it sets parameters, else it reads them.

    ready: whether it may; waits: what it waits for, in words, or "".
    """

    def __init__(
        self,
        answer: Callable[[bytes], None],
        keep: Callable[[str], None] = lambda _: None,
        *,
        token: str = "",
        sets: bool = False,
    ) -> None:
        self._answer = answer
        self._keep = keep
        self._token = token
        self._sets = sets
        self.ready = False
        self.waits = ""
        self._found = True
        self._asked = False
        self._known: frozenset[str] = frozenset()

    def begin(self) -> None:
        """Says who we are; to be called when the connection is open."""
        self.ready = self._asked = False
        if self._token:
            self._request("AuthenticationRequest", {**PLUGIN, "authenticationToken": self._token})
        else:
            self.waits = "allow Omote in the window of VTube Studio"
            self._request("AuthenticationTokenRequest", PLUGIN)

    def poll(self) -> None:
        """Asks for all parameters, where the list before has come."""
        if self.ready and not self._asked:
            self._asked = True
            self._request("InputParameterListRequest")

    def set_face(self, weights: Mapping[str, float], head: HeadAngles, gaze: GazeAngles) -> bool:
        """Sets the parameters of a face, of its own those that it has; False before it may. weights: of all of ARKit's
        units; head, gaze: radians."""
        if not self.ready or not self._known:
            return False
        own = {name: value for name, value in write_parameters(weights, head, gaze).items() if name in self._known}
        values = [{"id": name, "value": round(value, 5)} for name, value in {**own, **write_custom(weights)}.items()]
        self._request("InjectParameterDataRequest", {"faceFound": True, "mode": "set", "parameterValues": values})
        return True

    def decode(self, data: bytes) -> list[TrackerFrame]:
        """The frame of a list of parameters; nothing of other messages, which are answered. TrackerError where it
        cannot be read, or says that something went wrong."""
        message = decode_message(data)
        match message.message_type:
            case "InputParameterListResponse":
                return self._take_list(read_parameter_list(message))
            case "AuthenticationTokenResponse":
                self._token = _read(message, Token).authentication_token
                self._keep(self._token)
                self.begin()
            case "AuthenticationResponse":
                self._enter(_read(message, Authentication))
            case "TrackingStatusChangedEvent" | "FaceFoundResponse":
                return self._take_status(_read(message, FaceStatus))
            case "APIError":
                self._take_fault(_read(message, ApiFault))
        return []

    def _enter(self, answer: Authentication) -> None:
        """Goes on where we may; a token that is not valid any more is asked for anew."""
        self.ready = answer.authenticated
        self.waits = ""
        if not answer.authenticated:
            self._ask_anew()
        elif self._sets:
            for unit in ARKIT_NAMES:
                self._request("ParameterCreationRequest", _parameter(unit))
            self.poll()
        else:
            self._request("EventSubscriptionRequest", {"eventName": STATUS_EVENT, "subscribe": True, "config": {}})
            self._request("FaceFoundRequest")

    def _ask_anew(self) -> None:
        if self._token:
            self._token = ""
            self._keep("")
            self.begin()

    def _take_list(self, listed: ParameterList) -> list[TrackerFrame]:
        self._asked = False
        added, own = listed.values()
        self._known = frozenset(own)
        if self._sets:
            return []
        return [read_parameters({**added, **own}, found=self._found)]

    def _take_status(self, status: FaceStatus) -> list[TrackerFrame]:
        said = status.found if status.face_found is None else status.face_found
        self._found = self._found if said is None else said
        return [] if self._found or self._sets else [TrackerFrame(found=False)]

    def _take_fault(self, fault: ApiFault) -> None:
        self._asked = False
        if fault.number == NEEDS_TOKEN or (fault.number == TOKEN_DENIED and self._token):
            self.ready = False
            self._ask_anew()
        elif fault.number == TOKEN_DENIED:
            self.waits = "VTube Studio's user has denied it; switch it off and on to ask again"
        raise TrackerError(f"VTube Studio says: {fault.message[:160] or fault.number}")

    def _request(self, kind: str, data: Mapping[str, object] | None = None) -> None:
        self._answer(encode_request(kind, dict(data or {})))


def _parameter(unit: str) -> dict[str, object]:
    words = "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in unit)
    return {
        "parameterName": custom_name(unit),
        "explanation": f"The face on air in Omote: {words}",
        "min": 0,
        "max": 1,
        "defaultValue": 0,
    }


def _read(message: ApiMessage, kind: type[Kind]) -> Kind:
    return read_json(kind, message.data, f"{message.message_type} cannot be read")
