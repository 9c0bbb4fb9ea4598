"""Cuts a stream of TCP into packets of OSC: SLIP frames (RFC 1055, OSC 1.1) or a length before each (OSC 1.0)."""

from __future__ import annotations

import re
import struct
from typing import Protocol

from omote.inputs.osc_packet import LONGEST_PACKET, OscError

END = b"\xc0"
ESCAPE = b"\xdb"
ESCAPED_END = b"\xdb\xdc"
ESCAPED_ESCAPE = b"\xdb\xdd"
WRONG_ESCAPE = re.compile(rb"\xdb(?![\xdc\xdd])")
FIRST_BYTES = (b"/", b"#")
"""Of a message, and of a bundle."""
LENGTH = 4
"""Bytes of a length before a packet."""


class Framing(Protocol):
    """How packets stand in a stream."""

    def feed(self, data: bytes) -> list[bytes]:
        """The packets that are whole with these bytes; OscError where the stream cannot be read on."""

    def frame(self, packet: bytes) -> bytes:
        """A packet as it is written into the stream."""


class SlipFraming:
    """Packets between END bytes."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, data: bytes) -> list[bytes]:
        """The packets that are whole with these bytes; OscError where one is too long."""
        *whole, self._rest = (self._rest + data).split(END)
        if len(self._rest) > 2 * LONGEST_PACKET:
            raise OscError(f"a SLIP frame has more than {2 * LONGEST_PACKET} bytes and no end")
        return [_unescaped(packet) for packet in whole if packet]

    def frame(self, packet: bytes) -> bytes:
        """A packet with an END before and after it."""
        return END + packet.replace(ESCAPE, ESCAPED_ESCAPE).replace(END, ESCAPED_END) + END


class LengthFraming:
    """Packets behind their lengths, four bytes, the highest first."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, data: bytes) -> list[bytes]:
        """The packets that are whole with these bytes; OscError where a length cannot be."""
        data = self._rest + data
        packets = []
        while len(data) >= LENGTH:
            (size,) = struct.unpack_from(">i", data)
            if not 0 <= size <= LONGEST_PACKET:
                raise OscError(f"a packet of {size} bytes is announced, but at most {LONGEST_PACKET} are read")
            if len(data) < LENGTH + size:
                break
            packets.append(data[LENGTH : LENGTH + size])
            data = data[LENGTH + size :]
        self._rest = data
        return packets

    def frame(self, packet: bytes) -> bytes:
        """A packet behind its length."""
        return struct.pack(">i", len(packet)) + packet


def choose_framing(first: bytes) -> Framing:
    """The framing of a stream, from its first byte: a length of a packet that can be begins with a zero byte; a SLIP
    frame begins with END, or where a sender spares that, with the packet's own "/" or "#". OscError for any other: a
    web page can send to any port of this machine, with packets behind the first line of its request."""
    if first[:1] == b"\0":
        return LengthFraming()
    if first[:1] in (END, *FIRST_BYTES):
        return SlipFraming()
    raise OscError(f"a stream begins with {first[:8]!r}, which is no OSC: its connection is ended")


def require_packets(frames: list[bytes]) -> list[bytes]:
    """The frames of a stream, each of which begins as a message or a bundle does; OscError where one does not."""
    for frame in frames:
        if frame[:1] not in FIRST_BYTES:
            raise OscError(f"a frame begins with {frame[:8]!r}, which is no OSC: its connection is ended")
    return frames


def _unescaped(packet: bytes) -> bytes:
    if WRONG_ESCAPE.search(packet):
        raise OscError("a SLIP frame has an ESC byte before what needs none")
    return packet.replace(ESCAPED_END, END).replace(ESCAPED_ESCAPE, ESCAPE)
