"""sACN and Art-Net as readings of the slots that are bound."""

import pytest
from sacn.messages.data_packet import DataPacket

from omote.inputs.dmx.dmx_input import ARTNET, SACN, DmxInput, read_control
from omote.inputs.reading import Reading

DESK = "10.0.0.5"


def sacn(levels: tuple[int, ...], universe: int = 1, cid: int = 1, options: int = 0, start: int = 0) -> bytes:
    data = bytearray(DataPacket((cid,) * 16, "Desk", universe, dmxData=levels).getBytes())
    data[112], data[125] = options, start
    return bytes(data)


def artnet(levels: bytes, universe: int = 0) -> bytes:
    return b"Art-Net\0\x00\x50\x00\x0e\x00\x00" + universe.to_bytes(2, "little") + len(levels).to_bytes(2) + levels


@pytest.fixture
def dmx() -> DmxInput:
    made = DmxInput([1, 2])
    made.watch([(SACN, "1/1"), (SACN, "1/3"), (SACN, "9/1"), (ARTNET, "0/2"), ("pad", "1/cc7")])
    return made


def test_watched_slots_are_read_when_they_change(dmx: DmxInput) -> None:
    dmx.receive_sacn(DESK, sacn((255, 9, 51)), 0.0)
    assert dmx.take_readings(0.0) == [Reading(SACN, "1/1", 1.0), Reading(SACN, "1/3", 0.2)]
    assert dmx.take_readings(0.1) == []
    dmx.receive_artnet(DESK, artnet(b"\xff\x33"), 0.1, DESK)
    assert dmx.take_readings(0.1) == [Reading(ARTNET, "0/2", 0.2)]


def test_slots_that_are_not_sent_are_not_read(dmx: DmxInput) -> None:
    dmx.receive_artnet(DESK, artnet(b"\xff"), 0.0, DESK)
    assert dmx.take_readings(0.0) == []


@pytest.mark.parametrize(("options", "start"), [(0x80, 0), (0, 0xDD)])
def test_previews_and_other_start_codes_play_nothing(dmx: DmxInput, options: int, start: int) -> None:
    dmx.receive_sacn(DESK, sacn((255, 0, 0), options=options, start=start), 0.0)
    assert (dmx.take_readings(0.0), dmx.heard, dmx.rejected) == ([], 1, 0)


def test_a_universe_that_nobody_asked_for_is_rejected_with_what_is_heard(dmx: DmxInput) -> None:
    dmx.receive_sacn(DESK, sacn((255,), universe=7), 0.0)
    assert dmx.last_rejection is not None
    assert dmx.last_rejection.sender == "sACN from 10.0.0.5"
    assert dmx.last_rejection.reason == "universe 7 came; heard are 1, 2 (--sacn)"


def test_damaged_packets_are_counted(dmx: DmxInput) -> None:
    dmx.receive_sacn(DESK, b"hello", 0.0)
    dmx.receive_artnet(DESK, b"hello", 0.0, DESK)
    assert (dmx.heard, dmx.rejected) == (2, 2)


def test_a_poll_is_answered(dmx: DmxInput) -> None:
    (reply,) = dmx.receive_artnet(DESK, b"Art-Net\0\x00\x20\x00\x0e\x02\x00", 0.0, "10.0.0.9")
    assert reply[10:14] == b"\x0a\0\0\x09"


def test_a_universe_without_sources_is_told_once(dmx: DmxInput) -> None:
    dmx.receive_sacn(DESK, sacn((255, 0, 0)), 0.0)
    assert dmx.take_lost(1.0) == []
    assert dmx.take_lost(3.0) == ["sACN universe 1 has lost its source; its last levels hold"]
    assert dmx.take_lost(4.0) == []
    dmx.receive_sacn(DESK, sacn((255, 0, 0), options=0x40), 5.0)
    assert dmx.take_lost(5.0) == []


@pytest.mark.parametrize("text", ["", "1", "1/0", "1/513", "a/1", "1/-1", "1/1/1", "\u0661/1"])
def test_what_is_no_slot_is_said(text: str) -> None:
    with pytest.raises(ValueError, match=r"is no slot|does not exist"):
        read_control(text)
