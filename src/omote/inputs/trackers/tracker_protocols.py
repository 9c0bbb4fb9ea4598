"""The protocols of trackers: one entry each, from which options, sockets, pages and the manual are made."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from omote.inputs.trackers.face_motion.motion_receiver import Answer, MotionReceiver, ask_for_motion
from omote.inputs.trackers.face_text import (
    FACEMOTION3D_START,
    FACEMOTION3D_STREAM,
    IFACIALMOCAP_START,
    IFACIALMOCAP_STREAM,
)
from omote.inputs.trackers.live_link_face import decode_live_link_face
from omote.inputs.trackers.mediapipe_frame import decode_mediapipe
from omote.inputs.trackers.open_see_face import decode_open_see_face
from omote.inputs.trackers.phone_frame import decode_phone_frame, request_frames
from omote.inputs.trackers.tracker_frame import Decode
from omote.inputs.trackers.vmc_messages import open_vmc
from omote.inputs.trackers.vtube_studio.api_message import API_PORT
from omote.inputs.trackers.vtube_studio.api_session import ApiSession

API_NAME = "vtubestudio-pc"
MEDIAPIPE_PATH = "/mediapipe"
Ask = Callable[[int], bytes]
"""What asks a phone for frames at a port of ours."""


@dataclass(frozen=True)
class TrackerProtocol:
    """A protocol. name: as options spell it; title: as people know it; port: of UDP, where it is heard, None where it
    comes by a WebSocket at the port of the pages.

    advice: what to do at the sender, with `{host}` and `{port}` of this machine. open: makes a decoder for one sender,
    given what answers it. phone_port, ask: where a phone hears what asks it for frames, and what does; None where
    nothing is asked. stream: whether it comes by TCP; program: whether it is a program that we connect to.
    """

    name: str
    title: str
    port: int | None
    advice: str
    open: Callable[[Answer], Decode]
    phone_port: int | None = None
    ask: Ask | None = None
    stream: bool = False
    program: bool = False

    @property
    def heard(self) -> bool:
        """Whether it has a socket of its own here."""
        return self.port is not None and not self.program


def _stateless(decode: Decode) -> Callable[[Answer], Decode]:
    return lambda _: decode


def _open_motion(answer: Answer) -> Decode:
    return MotionReceiver(answer).decode


def _open_stream(answer: Answer) -> Decode:
    return MotionReceiver(answer, stream=True).decode


def _open_vmc(_: Answer) -> Decode:
    return open_vmc()


def _open_api(answer: Answer) -> Decode:
    return ApiSession(answer).decode


_PHONE = "in the app type the address {host}, or name the phone here: --listen {name}@PHONE"
_NAMED = "name the phone here: --listen {name}@PHONE; the app is the one of 2026 or newer"
_ALL = (
    TrackerProtocol(
        "vmc", "VMC", 39539, "in the sender choose VMC (OSC) to the address {host} and the port {port}", _open_vmc
    ),
    TrackerProtocol(
        "vmc-performer", "VMC performer", 39540,
        "in the tracker choose VMC as an assistant, to the address {host} and the port {port}", _open_vmc,
    ),
    TrackerProtocol(
        "livelink", "Live Link Face", 11111,
        "in the app choose the mode Live Link (ARKit), then as a target type {host} and the port {port}",
        _stateless(decode_live_link_face),
    ),
    TrackerProtocol(
        "ifacialmocap", "iFacialMocap", 49983, _PHONE, _open_motion, 49983, lambda _: IFACIALMOCAP_START,
    ),
    TrackerProtocol(
        "ifacialmocap-v3", "iFacialMocap v3", 49983, _NAMED, _open_motion, 49983, ask_for_motion,
    ),
    TrackerProtocol(
        "ifacialmocap-tcp", "iFacialMocap TCP", 49986, _PHONE, _open_stream, 49983, lambda _: IFACIALMOCAP_STREAM,
        stream=True,
    ),
    TrackerProtocol(
        "facemotion3d", "Facemotion3D", 49993, _PHONE, _open_motion, 49993, lambda _: FACEMOTION3D_START,
    ),
    TrackerProtocol(
        "facemotion3d-v3", "Facemotion3D v3", 49993, _NAMED, _open_motion, 49993, ask_for_motion,
    ),
    TrackerProtocol(
        "facemotion3d-tcp", "Facemotion3D TCP", 49986, _PHONE, _open_stream, 49993, lambda _: FACEMOTION3D_STREAM,
        stream=True,
    ),
    TrackerProtocol(
        "openseeface", "OpenSeeFace", 11573, "run facetracker.py with --ip {host} --port {port}",
        _stateless(decode_open_see_face),
    ),
    TrackerProtocol(
        "vtubestudio", "VTube Studio", 11125,
        "in the app turn 3rd Party PC Clients on, and name the phone here: --listen {name}@PHONE",
        _stateless(decode_phone_frame), 21412, request_frames,
    ),
    TrackerProtocol(
        API_NAME, "VTube Studio PC", API_PORT,
        "in VTube Studio turn Allow Plugin API access on, and allow Omote in its window when it asks",
        _open_api, program=True,
    ),
    TrackerProtocol(
        "meowface", "MeowFace", 12345,
        "in the app type the address {host} and the port {port}, or name the phone here: --listen {name}@PHONE",
        _stateless(decode_phone_frame), 21412, request_frames,
    ),
    TrackerProtocol(
        "mediapipe", "MediaPipe", None,
        "send each result of the face landmarker as JSON by WebSocket to the show's own address and " + MEDIAPIPE_PATH,
        _stateless(decode_mediapipe),
    ),
)  # fmt: skip
TRACKER_PROTOCOLS: Mapping[str, TrackerProtocol] = MappingProxyType({protocol.name: protocol for protocol in _ALL})
"""Every protocol, by the name that options spell."""
TRACKER_TITLES = tuple(protocol.title for protocol in _ALL)


def advise(protocol: TrackerProtocol, host: str, port: int | None) -> str:
    """What to do at a sender of a protocol. host: this machine's address, as the sender reaches it; port: where it is
    heard."""
    return protocol.advice.format(host=host, port=port, name=protocol.name)
