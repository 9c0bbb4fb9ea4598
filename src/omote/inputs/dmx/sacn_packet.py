"""Reads packets of sACN (ANSI E1.31-2018): levels of one universe of DMX512, strictly: what is not exactly one is
rejected."""

from __future__ import annotations

import struct
from dataclasses import dataclass

from omote.inputs.rejection import PacketError

SACN_PORT = 5568
IDENTIFIER = b"ASC-E1.17\0\0\0"
ROOT_LAYER = struct.Struct(">HH12sHI16s")
FRAMING_LAYER = struct.Struct(">HI64sBHBBH")
DMP_LAYER = struct.Struct(">HBBHHH")
FRAMING_AT = 38
DMP_AT = 115
SHORTEST = 126
LONGEST = 638
DATA = 4
EXTENDED = 8
HIGHEST_PRIORITY = 200
LOWEST_UNIVERSE = 1
HIGHEST_UNIVERSE = 63999
PREVIEW = 0x80
TERMINATED = 0x40
FLAGS = 0x7000


class SacnError(PacketError):
    """What came is no packet of sACN, and why."""


@dataclass(frozen=True)
class SacnPacket:
    """Levels of a universe. source: the sender's own number (CID); start_code: 0 for levels; preview: not for the
    stage; terminated: the source ends; slots: up to 512 bytes."""

    source: bytes
    name: str
    priority: int
    sequence: int
    universe: int
    start_code: int
    slots: bytes
    preview: bool = False
    terminated: bool = False


def decode_sacn(data: bytes) -> SacnPacket | None:
    """The levels in a packet; None for a packet of the standard that holds none (synchronisation, discovery);
    SacnError where it is no packet of sACN."""
    if len(data) < ROOT_LAYER.size:
        raise SacnError(f"a packet of {len(data)} bytes is too short for sACN")
    preamble, postamble, identifier, length, vector, source = ROOT_LAYER.unpack_from(data)
    if (preamble, postamble, identifier) != (0x10, 0, IDENTIFIER):
        raise SacnError(f"a packet begins with {data[:8]!r}; sACN begins with its own name")
    _check_length(length, len(data) - 16, "root")
    if vector == EXTENDED:
        return None
    if vector != DATA:
        raise SacnError(f"a packet has vector {vector}; expected {DATA} (data) or {EXTENDED}")
    if not SHORTEST <= len(data) <= LONGEST:
        raise SacnError(f"a data packet of {len(data)} bytes came; expected {SHORTEST} to {LONGEST}")
    return _decode_framing(data, source)


def _decode_framing(data: bytes, source: bytes) -> SacnPacket:
    length, vector, name, priority, _, sequence, options, universe = FRAMING_LAYER.unpack_from(data, FRAMING_AT)
    _check_length(length, len(data) - FRAMING_AT, "framing")
    if vector != 2:
        raise SacnError(f"a data packet has framing vector {vector}; expected 2")
    if priority > HIGHEST_PRIORITY:
        raise SacnError(f"a packet has priority {priority}; expected 0 to {HIGHEST_PRIORITY}")
    if not LOWEST_UNIVERSE <= universe <= HIGHEST_UNIVERSE:
        raise SacnError(f"a packet is for universe {universe}; expected {LOWEST_UNIVERSE} to {HIGHEST_UNIVERSE}")
    _check_levels(data)
    title = name.partition(b"\0")[0].decode(errors="replace")
    flags = {"preview": bool(options & PREVIEW), "terminated": bool(options & TERMINATED)}
    return SacnPacket(source, title, priority, sequence, universe, data[125], data[SHORTEST:], **flags)


def _check_levels(data: bytes) -> None:
    length, vector, kind, first, step, count = DMP_LAYER.unpack_from(data, DMP_AT)
    _check_length(length, len(data) - DMP_AT, "DMP")
    if (vector, kind, first, step) != (2, 0xA1, 0, 1):
        raise SacnError("a packet's DMP layer is not that of levels (vector 2, type 0xa1, from 0 by 1)")
    if count != len(data) - SHORTEST + 1:
        raise SacnError(f"a packet announces {count} values, but {len(data) - SHORTEST + 1} are there")


def _check_length(flags_and_length: int, length: int, layer: str) -> None:
    if flags_and_length != FLAGS | length:
        raise SacnError(f"the {layer} layer's length is {flags_and_length & 0xFFF}, but {length} bytes are there")
