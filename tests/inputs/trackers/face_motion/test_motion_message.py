"""Messages of FMV3: the vendor's golden bytes, parts in any order, and every damage is rejected."""

import pytest

from omote.inputs.trackers.face_motion.motion_message import (
    HEADER,
    MOST_OPEN,
    Kind,
    MotionMessage,
    PartCollector,
    decode_part,
)
from omote.inputs.trackers.tracker_frame import TrackerError

SESSION = 0x0102030405060708
ACK = "464d56330a0028000807060504030201010000000000000000000000000000000000010000000000"
HELLO = "464d56330100280011223344556677880000000000000000000000000800000000000100080000003c00b00404000000"
"""Of the vendor's golden_vectors.json, contract revision 4."""


def part(index: int, count: int, payload: bytes, total: int, sequence: int = 1) -> bytes:
    """A part of a frame, by hand."""
    head = (b"FMV3", Kind.FRAME, 1, 40, SESSION, 1, sequence, 0, total, index, count, len(payload))
    return HEADER.pack(*head) + payload


def test_golden_messages_are_written_as_the_vendor_writes_them() -> None:
    assert MotionMessage(Kind.SCHEMA_ACK, SESSION, 1).encode().hex() == ACK
    nonce = int.from_bytes(bytes.fromhex("1122334455667788"), "little")
    payload = bytes.fromhex("3c00b00404000000")
    assert MotionMessage(Kind.HELLO, nonce, payload=payload).encode().hex() == HELLO


def test_parts_become_a_message_whatever_their_order() -> None:
    collector = PartCollector()
    assert collector.collect(decode_part(part(2, 3, b"c", 3))) is None
    assert collector.collect(decode_part(part(0, 3, b"a", 3))) is None
    assert collector.collect(decode_part(part(0, 3, b"a", 3))) is None
    whole = collector.collect(decode_part(part(1, 3, b"b", 3)))
    assert whole is not None
    assert (whole.payload, whole.kind, whole.sequence) == (b"abc", Kind.FRAME, 1)


def test_parts_that_do_not_fit_each_other_are_rejected() -> None:
    collector = PartCollector()
    collector.collect(decode_part(part(0, 2, b"a", 3)))
    with pytest.raises(TrackerError, match="have 2 bytes, expected 3"):
        collector.collect(decode_part(part(1, 2, b"b", 3)))


def test_messages_that_never_end_take_no_memory() -> None:
    collector = PartCollector()
    for sequence in range(100):
        assert collector.collect(decode_part(part(0, 2, b"a", 2, sequence))) is None
    assert len(collector._open) == MOST_OPEN
    for sequence in range(5):
        for index in range(500):
            collector.collect(decode_part(part(index, 512, bytes(1000), 16_000, 1000 + sequence)))
    assert sum(len(each) for parts in collector._open.values() for each in parts.values()) <= 524_288


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"FMV3", "has 4 bytes"),
        (b"FMV4" + bytes(60), "begins FMV3"),
        (MotionMessage(Kind.HELLO, 1).encode(), "type 1, which no phone sends"),
        (MotionMessage(Kind.PONG, 0).encode(), "session 0"),
        (MotionMessage(Kind.PONG, 1, flags=1).encode(), "flags 1"),
        (MotionMessage(Kind.PONG, 1, payload=b"x").encode(), "1 bytes, which cannot be"),
        (MotionMessage(Kind.PONG, 1).encode() + b"x", "but 41 have come"),
        (part(2, 2, b"a", 3), "part 2 of 2"),
        (part(0, 0, b"a", 1), "part 0 of 0"),
        (part(0, 1, b"a", 2), "2 bytes"),
        (part(0, 2, b"a", 20_000), "20000 bytes"),
    ],
)
def test_what_is_no_message_of_a_phone_is_rejected(data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        decode_part(data)
