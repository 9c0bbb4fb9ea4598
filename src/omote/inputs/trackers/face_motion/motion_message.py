"""Messages of FMV3: a header of 40 bytes, little-endian, and what it carries, in parts where it is long.

Source: the vendor's PROTOCOL_V3.md, sections 2, 3 and 7.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum

from omote.inputs.trackers.tracker_frame import TrackerError

MAGIC = b"FMV3"
HEADER = struct.Struct("<4sBBHQIIIIHHI")
LONGEST_PAYLOAD = 262_144
MOST_PARTS = 512
MOST_OPEN = 8
MOST_BYTES = 524_288
"""Parts of a message; messages whose parts are still coming, and bytes of all of these."""


class Kind(IntEnum):
    """What a message is; 2 is reserved."""

    HELLO = 1
    SCHEMA = 3
    FRAME = 4
    GET_SCHEMA = 5
    PING = 6
    PONG = 7
    STOP = 8
    ERROR = 9
    SCHEMA_ACK = 10


FROM_PHONE = {
    Kind.SCHEMA: LONGEST_PAYLOAD, Kind.FRAME: 16_432, Kind.PONG: 0, Kind.ERROR: 512,
}  # fmt: skip
"""What a phone may send, and the most bytes that each carries."""


@dataclass(frozen=True)
class MotionMessage:
    """A message. flags: of a frame, bit 0: tracked, bit 1: a recording; session: the phone's, of a hello ours;
    schema: the number of the list of names; payload: what it carries, or a part of it."""

    kind: Kind
    session: int
    schema: int = 0
    sequence: int = 0
    flags: int = 0
    source: int = 0
    payload: bytes = b""

    def encode(self) -> bytes:
        """Its bytes, in one part."""
        size = len(self.payload)
        head = (MAGIC, self.kind, self.flags, HEADER.size, self.session, self.schema, self.sequence, self.source)
        return HEADER.pack(*head, size, 0, 1, size) + self.payload


@dataclass(frozen=True)
class MotionPart:
    """A part of a message, as it came. total: bytes of the whole; index, count: which of how many parts it is."""

    message: MotionMessage
    total: int
    index: int
    count: int


def decode_part(data: bytes) -> MotionPart:
    """The part that a packet is; TrackerError where it is none of a phone's."""
    if len(data) < HEADER.size or not data.startswith(MAGIC):
        raise TrackerError(f"the packet has {len(data)} bytes, expected a header of {HEADER.size} that begins FMV3")
    _, number, flags, size, session, schema, sequence, source, total, index, count, length = HEADER.unpack_from(data)
    if number not in FROM_PHONE:
        raise TrackerError(f"the message is of type {number}, which no phone sends")
    kind = Kind(number)
    if size != HEADER.size or length != len(data) - size:
        raise TrackerError(f"the message says {size} and {length} bytes, but {len(data)} have come")
    if total > FROM_PHONE[kind] or not 0 < count <= MOST_PARTS or index >= count or (count == 1 and length != total):
        raise TrackerError(f"the message has part {index} of {count} and {total} bytes, which cannot be")
    if session == 0 or (flags and kind is not Kind.FRAME):
        raise TrackerError(f"the message has session {session} and flags {flags}, which cannot be")
    message = MotionMessage(kind, session, schema, sequence, flags, source, data[size:])
    return MotionPart(message, total, index, count)


class PartCollector:
    """Makes messages of parts that come in any order. The oldest message is forgotten where too many are open."""

    def __init__(self) -> None:
        self._open: dict[tuple[int, ...], dict[int, bytes]] = {}

    def collect(self, part: MotionPart) -> MotionMessage | None:
        """The message that a part completes; None while others are missing."""
        sent = part.message
        if part.count == 1:
            return sent
        key = (sent.kind, sent.flags, sent.session, sent.schema, sent.sequence, sent.source, part.total, part.count)
        parts = self._open.setdefault(key, {})
        parts[part.index] = sent.payload
        if len(parts) < part.count:
            self._forget_old()
            return None
        del self._open[key]
        payload = b"".join(parts[index] for index in range(part.count))
        if len(payload) != part.total:
            raise TrackerError(f"the parts of a message have {len(payload)} bytes, expected {part.total}")
        return MotionMessage(sent.kind, sent.session, sent.schema, sent.sequence, sent.flags, sent.source, payload)

    def _forget_old(self) -> None:
        kept = sum(len(part) for parts in self._open.values() for part in parts.values())
        while len(self._open) > MOST_OPEN or kept > MOST_BYTES:
            kept -= sum(map(len, self._open.pop(next(iter(self._open))).values()))
