"""Cuts a stream of TCP into packets of OSC: SLIP frames (RFC 1055, OSC 1.1) or a length before each (OSC 1.0)."""

from __future__ import annotations

import re
import struct
from typing import Protocol

from omote.inputs.osc_packet import LONGEST_PACKET, OscError

END, ESCAPE, ESCAPED_END, ESCAPED_ESCAPE = b"\xc0", b"\xdb", b"\xdb\xdc", b"\xdb\xdd"
WRONG_ESCAPE = re.compile(rb"\xdb(?![\xdc\xdd])")
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
        data, found = self._rest + data, []
        while len(data) >= LENGTH:
            (size,) = struct.unpack_from(">i", data)
            if not 0 <= size <= LONGEST_PACKET:
                raise OscError(f"a packet of {size} bytes is announced, but at most {LONGEST_PACKET} are read")
            if len(data) < LENGTH + size:
                break
            found.append(data[LENGTH : LENGTH + size])
            data = data[LENGTH + size :]
        self._rest = data
        return found

    def frame(self, packet: bytes) -> bytes:
        """A packet behind its length."""
        return struct.pack(">i", len(packet)) + packet


def choose_framing(first: bytes) -> Framing:
    """The framing of a stream, from its first byte: a length of a packet that can be begins with a zero byte; a SLIP
    frame begins with END, or where a sender spares that, with the packet's own "/" or "#"."""
    return LengthFraming() if first[:1] == b"\0" else SlipFraming()


def _unescaped(packet: bytes) -> bytes:
    if WRONG_ESCAPE.search(packet):
        raise OscError("a SLIP frame has an ESC byte before what needs none")
    return packet.replace(ESCAPED_END, END).replace(ESCAPED_ESCAPE, ESCAPE)
