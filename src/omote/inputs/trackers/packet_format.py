"""Which tracker's format a packet has, by its first bytes, and where that is sent: for what comes to a wrong port."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType

from omote.inputs.osc_packet import BUNDLE
from omote.inputs.trackers.face_motion.motion_message import MAGIC
from omote.inputs.trackers.live_link_face import LENGTH, LONGEST_TEXT, VERSION
from omote.inputs.trackers.open_see_face import RECORD
from omote.inputs.trackers.tracker_protocols import API_NAME, MEDIAPIPE_PATH, TRACKER_PROTOCOLS

READ_BYTES = 2048
"""Of a packet, which are looked at."""
_FACE_TEXT = re.compile(rb"(?:[A-Za-z_]\w*[&-]-?\d+(?:\.\d+)?\|){2}|=head#")
_SHARED: Mapping[str, str] = MappingProxyType(
    {
        "vmc-performer": "vmc", "ifacialmocap-tcp": "ifacialmocap", "facemotion3d": "ifacialmocap",
        "facemotion3d-tcp": "ifacialmocap", "facemotion3d-v3": "ifacialmocap", "ifacialmocap-v3": "ifacialmocap",
        "meowface": "vtubestudio",
    }
)  # fmt: skip
"""Protocols that read the same packets as another."""
_FIELDS: Mapping[bytes, str] = MappingProxyType(
    {
        b'"BlendShapes"': "vtubestudio", b'"VTubeStudioPublicAPI"': API_NAME, b'"faceBlendshapes"': "mediapipe",
        b'"face_blendshapes"': "mediapipe", b'"faceLandmarks"': "mediapipe",
    }
)  # fmt: skip
"""Of documents of JSON, what only one of them has."""


def recognize_format(packet: bytes) -> str:
    """The protocol whose packet this is, as `--listen` spells it; "" for none that is known."""
    start = packet[:READ_BYTES]
    if start.startswith((b"/VMC/", BUNDLE)) and b"/VMC/" in start:
        return "vmc"
    if _is_live_link(start):
        return "livelink"
    if start.lstrip().startswith(b"{"):
        return next((name for field, name in _FIELDS.items() if field in start), "")
    if start.startswith(MAGIC) or _FACE_TEXT.search(start):
        return "ifacialmocap"
    return "openseeface" if packet and len(packet) % RECORD == 0 else ""


def is_read_by(name: str, protocol: str) -> bool:
    """Whether a protocol reads the packets of a format that was recognized. name: of that format."""
    return _SHARED.get(protocol, protocol) == name


def explain_format(name: str, port: int | None = None) -> str:
    """What a packet of a format is, and where it goes, as a clause. port: where that is heard now, None where it is
    not; name: of the protocol."""
    protocol = TRACKER_PROTOCOLS[name]
    if protocol.port is None:
        return f"this is {protocol.title}: it comes by WebSocket to {MEDIAPIPE_PATH} of the show (--listen {name})"
    if port is not None:
        return f"this is {protocol.title}, which is heard at port {port}: send it there"
    return f"this is {protocol.title}: switch that on (--listen {name}) and send it to port {protocol.port}"


def _is_live_link(data: bytes) -> bool:
    """Version 6, then the length of a text that can be one."""
    if len(data) < 1 + LENGTH.size or data[0] != VERSION:
        return False
    (size,) = LENGTH.unpack_from(data, 1)
    return bool(0 <= size <= LONGEST_TEXT)
