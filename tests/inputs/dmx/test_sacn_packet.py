"""Packets of sACN: those of another library read back, and every damage is rejected."""

import numpy as np
import pytest
from sacn.messages.data_packet import DataPacket
from sacn.messages.universe_discovery import UniverseDiscoveryPacket

from omote.inputs.dmx.sacn_packet import SHORTEST, SacnError, SacnPacket, decode_sacn

CID = tuple(range(16))
CHECKED = [*range(22), *range(38, 44), 113, *range(115, 125)]
"""Places of bytes that have one legal value, or few, in a packet of these levels."""


def packet(levels: tuple[int, ...] = (1, 2, 255), **more: int) -> bytes:
    """A packet that the library `sacn` writes."""
    made = DataPacket(CID, "Desk", 7, dmxData=levels, **more)
    return bytes(made.getBytes())


def test_what_another_library_writes_we_read() -> None:
    found = decode_sacn(packet(tuple(range(256)) * 2, priority=150, sequence=9))
    assert found == SacnPacket(bytes(CID), "Desk", 150, 9, 7, 0, bytes(range(256)) * 2)


def test_flags_are_read() -> None:
    for bit, expected in ((0x80, (True, False)), (0x40, (False, True)), (0xC0, (True, True)), (0x20, (False, False))):
        data = bytearray(packet())
        data[112] = bit
        found = decode_sacn(bytes(data))
        assert found is not None
        assert (found.preview, found.terminated) == expected


def test_discovery_is_passed_over() -> None:
    assert decode_sacn(bytes(UniverseDiscoveryPacket(CID, "Desk", (1, 2)).getBytes())) is None


@pytest.mark.parametrize("count", range(4))
def test_a_packet_that_is_cut_or_longer_is_rejected(count: int) -> None:
    whole = packet()
    for data in (whole[: count * 50], whole[:-1], whole + b"\0" * (count + 1)):
        with pytest.raises(SacnError):
            decode_sacn(data)


@pytest.mark.parametrize("place", CHECKED)
def test_a_byte_that_is_wrong_is_rejected(place: int) -> None:
    data = bytearray(packet())
    data[place] ^= 0xFF
    with pytest.raises(SacnError):
        decode_sacn(bytes(data))


@pytest.mark.parametrize(("place", "value", "why"), [(114, 0, "universe 0"), (108, 201, "priority 201")])
def test_numbers_out_of_their_range_are_rejected(place: int, value: int, why: str) -> None:
    data = bytearray(packet())
    data[place] = value
    with pytest.raises(SacnError, match=why):
        decode_sacn(bytes(data))


def test_no_bytes_raise_anything_else() -> None:
    generator = np.random.default_rng(1)
    whole = packet()
    for _ in range(3000):
        data = bytearray(whole)
        for place in generator.integers(0, len(data), 3):
            data[place] = generator.integers(256)
        try:
            found = decode_sacn(
                bytes(data[: generator.integers(len(data) + 1)]) if generator.random() < 0.2 else bytes(data)
            )
        except SacnError:
            continue
        assert found is None or (len(found.slots) == len(whole) - SHORTEST and found.priority <= 200)
