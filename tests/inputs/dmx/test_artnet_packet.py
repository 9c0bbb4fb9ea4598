"""Packets of Art-Net: golden ones by its specification, and every damage is rejected."""

import struct

import numpy as np
import pytest

from omote.inputs.dmx.artnet_packet import (
    ArtDmx,
    ArtNetError,
    ArtPoll,
    decode_artnet,
    encode_poll_replies,
)

LEVELS = b"Art-Net\0\x00\x50\x00\x0e\x05\x00\x12\x01\x00\x04\x01\x02\x03\xff"
POLL = b"Art-Net\0\x00\x20\x00\x0e\x02\x00"


def test_golden_packets_are_read() -> None:
    assert decode_artnet(LEVELS) == ArtDmx(0x112, 5, b"\x01\x02\x03\xff")
    assert decode_artnet(LEVELS + b"more") == ArtDmx(0x112, 5, b"\x01\x02\x03\xff")
    assert decode_artnet(POLL) == ArtPoll()
    assert decode_artnet(b"Art-Net\0\x00\x97" + b"\0" * 9) is None  # time code


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "too short"),
        (b"Art-Nets\0\x50", "begins with"),
        (LEVELS[:15], "its head alone"),
        (LEVELS[:-1], "3 are there"),
        (LEVELS[:10] + b"\0\x0d" + LEVELS[12:], "version 13"),
        (LEVELS[:16] + b"\0\0" + LEVELS[18:], "announces 0"),
        (LEVELS[:16] + b"\x02\x01" + b"\0" * 600, "announces 513"),
        (LEVELS[:15] + b"\x80" + LEVELS[16:], "net 128"),
        (POLL[:-2], "ArtPoll of 12"),
    ],
)
def test_damage_is_rejected_with_a_reason(data: bytes, why: str) -> None:
    with pytest.raises(ArtNetError, match=why):
        decode_artnet(data)


def test_the_answer_to_a_poll_says_which_universes_are_heard() -> None:
    replies = encode_poll_replies("10.0.0.5", [0, 1, 2, 3, 4, 0x112])
    found = set()
    for index, reply in enumerate(replies, 1):
        assert len(reply) == 239
        assert reply[:10] == b"Art-Net\0\x00\x21"
        assert (reply[10:14], struct.unpack("<H", reply[14:16])) == (b"\x0a\0\0\x05", (6454,))
        assert reply[26:31] == b"Omote"
        (count,) = struct.unpack(">H", reply[172:174])
        assert (reply[174 : 174 + count], reply[211]) == (b"\x80" * count, index)
        found |= {reply[18] << 8 | reply[19] << 4 | port for port in reply[190 : 190 + count]}
    assert found == {0, 1, 2, 3, 4, 0x112}
    assert len(replies) == 3
    assert len(encode_poll_replies("10.0.0.5", [])) == 1


def test_no_bytes_raise_anything_else() -> None:
    generator = np.random.default_rng(2)
    for _ in range(3000):
        data = bytearray(LEVELS if generator.random() < 0.5 else POLL)
        for place in generator.integers(0, len(data), 2):
            data[place] = generator.integers(256)
        try:
            found = decode_artnet(bytes(data))
        except ArtNetError:
            continue
        assert not isinstance(found, ArtDmx) or found.universe <= 0x7FFF
