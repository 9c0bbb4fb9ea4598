"""Which protocol a packet is of that another could not read: a sender was set to the wrong port."""

from __future__ import annotations

from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, TrackerProtocol

_FAMILIES = (
    ("vmc", "vmc-performer"),
    ("livelink",),
    ("ifacialmocap", "ifacialmocap-v3", "ifacialmocap-tcp", "facemotion3d", "facemotion3d-v3", "facemotion3d-tcp"),
    ("vtubestudio", "meowface"),
)
"""Protocols whose packets are alike, the usual one first."""
LONGEST_TEXT = 256


def explain_wrong_port(data: bytes, protocol: TrackerProtocol) -> str:
    """Where a packet is to be sent that came to another protocol, in words; "" where it is of that one, or of none that
    is known by its beginning."""
    name = _recognize(data)
    own = next((family for family in _FAMILIES if protocol.name in family), (protocol.name,))
    return "" if name is None or name in own else explain_protocol(name)


def explain_protocol(name: str) -> str:
    """Where packets of a protocol are to be sent, as a clause."""
    found = TRACKER_PROTOCOLS[name]
    return f"this is {found.title}: switch that on (--listen {name}) and send it to its port, usually {found.port}"


def _recognize(data: bytes) -> str | None:
    beginning = data[:64]
    if beginning.startswith(b"/VMC/") or (beginning.startswith(b"#bundle\0") and b"/VMC/" in beginning):
        return "vmc"
    if beginning[:1] == b"\x06" and 0 < int.from_bytes(beginning[1:5]) <= LONGEST_TEXT < len(data):
        return "livelink"
    if b"jawOpen" in data and b"|" in data and b"\0" not in beginning:
        return "ifacialmocap"
    if beginning.startswith(b"{") and b'"BlendShapes"' in data:
        return "vtubestudio"
    return None
