"""Reads packets of Art-Net 4: levels (ArtDmx) and the question who is there (ArtPoll), and writes the answer to it."""

from __future__ import annotations

import ipaddress
import struct
from collections.abc import Sequence
from dataclasses import dataclass

from omote.inputs.rejection import PacketError

ARTNET_PORT = 6454
IDENTIFIER = b"Art-Net\0"
POLL = 0x2000
POLL_REPLY = 0x2100
DMX = 0x5000
HEADER = struct.Struct("<8sH")
LEVELS = struct.Struct(">HBBBBH")
LEVELS_AT = HEADER.size
OLDEST_VERSION = 14
MOST_SLOTS = 512
HIGHEST_UNIVERSE = 0x7FFF
PORTS_OF_A_REPLY = 4
SHORTEST_POLL = 14
REPLY = struct.Struct("<8sH4sH2sBB2sBB2s18s64s64s2s4s4s4s4s4s3s3sB6s4sBB26s")
UNKNOWN_OEM = b"\x00\xff"
PROTOTYPE_MAKER = b"\xf0\x7f"
DMX_OUTPUT = 0x80
OUTPUT_RUNS = 0x80
READY = 0xD0
"""Of a node: its indicators are normal, and its addresses are set by a program."""
WIDE_ADDRESSES = 0x08
"""Of a node: it knows universes above 255."""


class ArtNetError(PacketError):
    """What came is no packet of Art-Net, and why."""


@dataclass(frozen=True)
class ArtDmx:
    """Levels of a universe (0 to 32767: net, sub-net and universe in one number). sequence: 0 where there is none."""

    universe: int
    sequence: int
    slots: bytes


@dataclass(frozen=True)
class ArtPoll:
    """The question who is there."""


def decode_artnet(data: bytes) -> ArtDmx | ArtPoll | None:
    """What a packet says; None for any other packet of Art-Net; ArtNetError where it is none, or is cut."""
    if len(data) < HEADER.size:
        raise ArtNetError(f"a packet of {len(data)} bytes is too short for Art-Net")
    identifier, code = HEADER.unpack_from(data)
    if identifier != IDENTIFIER:
        raise ArtNetError(f"a packet begins with {data[:8]!r}; Art-Net begins with its own name")
    if code == DMX:
        return _decode_levels(data)
    if code == POLL:
        if len(data) < SHORTEST_POLL:
            raise ArtNetError(f"an ArtPoll of {len(data)} bytes came; expected {SHORTEST_POLL} or more")
        return ArtPoll()
    return None


def _decode_levels(data: bytes) -> ArtDmx:
    at = LEVELS_AT + LEVELS.size
    if len(data) < at:
        raise ArtNetError(f"an ArtDmx of {len(data)} bytes came; its head alone has {at}")
    version, sequence, _, low, high, length = LEVELS.unpack_from(data, LEVELS_AT)
    if version < OLDEST_VERSION:
        raise ArtNetError(f"an ArtDmx has version {version}; expected {OLDEST_VERSION} or later")
    if not 1 <= length <= MOST_SLOTS:
        raise ArtNetError(f"an ArtDmx announces {length} levels; expected 1 to {MOST_SLOTS}")
    if len(data) < at + length:
        raise ArtNetError(f"an ArtDmx announces {length} levels, but {len(data) - at} are there")
    if high > HIGHEST_UNIVERSE >> 8:
        raise ArtNetError(f"an ArtDmx is for net {high}; expected 0 to {HIGHEST_UNIVERSE >> 8}")
    return ArtDmx(high << 8 | low, sequence, data[at : at + length])


def encode_poll_replies(address: str, universes: Sequence[int], *, port: int = ARTNET_PORT) -> list[bytes]:
    """The answers to ArtPoll: this node at an address of IPv4, one packet for each four universes of a sub-net.

    port: where this node hears Art-Net.
    """
    groups: dict[int, list[int]] = {}
    for universe in sorted(set(universes)):
        groups.setdefault(universe >> 4, []).append(universe & 0xF)
    pages = [
        (block, ports[at : at + PORTS_OF_A_REPLY])
        for block, ports in groups.items()
        for at in range(0, len(ports), PORTS_OF_A_REPLY)
    ]
    return [_reply(address, port, block, ports, index) for index, (block, ports) in enumerate(pages or [(0, [])], 1)]


def _reply(address: str, port: int, block: int, ports: Sequence[int], index: int) -> bytes:
    host = ipaddress.IPv4Address(address).packed
    kinds = bytes([DMX_OUTPUT] * len(ports))
    runs = bytes([OUTPUT_RUNS] * len(ports))
    head = (IDENTIFIER, POLL_REPLY, host, port, b"\0\1", block >> 4, block & 0xF, UNKNOWN_OEM, 0, READY)
    names = (PROTOTYPE_MAKER, b"Omote", b"Omote, faces played live", b"#0001 [0000] playing")
    outputs = (struct.pack(">H", len(ports)), kinds, b"", runs, b"", bytes(ports))
    return REPLY.pack(*head, *names, *outputs, b"", b"", 0, b"", host, index, WIDE_ADDRESSES, b"")
