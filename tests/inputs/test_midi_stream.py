"""MIDI as a stream: every cut of it reads the same, and no bytes raise anything."""

import numpy as np
import pytest

from omote.inputs.midi_stream import MidiDecoder
from omote.inputs.reading import Reading
from omote.perform.cues.show_control import ShowControl


def read(data: bytes) -> list[tuple[str, float, bool]]:
    return [(r.control, r.value, r.key) for r in MidiDecoder("pad").feed(data)]


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        ("b0 07 7f", [("1/cc7", 1.0, False)]),
        ("bf 40 00", [("16/cc64", 0.0, False)]),
        ("b0 07 7f 07 00", [("1/cc7", 1.0, False), ("1/cc7", 0.0, False)]),  # running status
        ("b0 f8 07 fe 7f", [("1/cc7", 1.0, False)]),  # real time between
        ("90 3c 7f 3c 00", [("1/note60", 1.0, True), ("1/note60", 0.0, True)]),  # velocity 0 lets go
        ("80 3c 40", [("1/note60", 0.0, True)]),
        ("e0 00 00", [("1/bend", 0.0, False)]),
        ("e0 7f 7f", [("1/bend", 1.0, False)]),
        ("d0 7f", [("1/pressure", 1.0, False)]),
        ("a0 3c 7f", [("1/pressure60", 1.0, False)]),
        ("c0 05", [("1/program5", 1.0, True), ("1/program5", 0.0, True)]),
        ("f0 00 20 29 7f f7 b0 07 7f", [("1/cc7", 1.0, False)]),
        ("f0 01 b0 07 7f", [("1/cc7", 1.0, False)]),  # the end of a system message got lost
        ("f2 01 02 f3 01 f1 05 b0 07 7f", [("1/cc7", 1.0, False)]),
        ("b0 07 7f 27 7f", [("1/cc7", 1.0, False), ("1/cc39", 1.0, False)]),  # once is no pair
    ],
)
def test_messages_become_readings(data: str, expected: list[tuple[str, float, bool]]) -> None:
    assert read(bytes.fromhex(data)) == expected


def test_show_control_is_heard_however_it_is_cut_and_no_other_system_message() -> None:
    go = bytes.fromhex("F0 7F 7F 02 01 01 31 32 2E 35 F7")
    for cut in range(len(go)):
        decoder = MidiDecoder("desk")
        assert decoder.feed(b"\x90\x3c" + go[:cut]) + decoder.feed(b"\xf8" + go[cut:] + b"\xf0\x41\x10\xf7") == []
        assert [*decoder.show_control] == [ShowControl("go", number="12.5")]
        assert decoder.rejected == 1  # the note that was cut short
    for other in (go[:-1] + b"\x90\x3c\x7f", go[:3] + bytes(300) + b"\xf7", b"\xf0\xf7"):
        decoder = MidiDecoder("desk")
        decoder.feed(other)
        assert not decoder.show_control
    decoder = MidiDecoder("desk")
    decoder.feed(bytes.fromhex("F0 7F 7F 02 01 01 41 F7"))
    (said,) = decoder.show_control
    assert str(said) == "the cue of a MIDI Show Control go is b'A'; expected digits and points"


def wholes(data: bytes, decoder: MidiDecoder | None = None) -> list[float]:
    """What controls of 14 bits read."""
    return [each.value for each in (decoder or MidiDecoder("pad")).feed(data) if "+" in each.control]


def test_a_pair_is_known_once_its_fine_part_has_come_right_behind_three_times() -> None:
    assert wholes(bytes.fromhex("b0 07 10 27 01 07 20 27 02")) == []
    assert len(wholes(bytes.fromhex("b0 07 10 27 01 07 20 27 02 07 30 27 03"))) == 1
    assert len(wholes(bytes.fromhex("b0 07 10 27 01 07 20 27 02 07 30 27 03 27 04 27 05"))) == 3, "then alone too"


def test_sliders_and_keys_at_both_numbers_are_no_pair() -> None:
    """A nanoKONTROL2: sliders 0 to 7, keys 32 to 39, which go down and up."""
    decoder = MidiDecoder("nanoKONTROL2")
    for number in [*range(8)] * 10:
        press = bytes([0xB0, number, 5 * number, number + 32, 127, number + 32, 0])
        assert wholes(press, decoder) == []


def test_a_note_between_parts_a_controller_from_what_follows() -> None:
    assert wholes(bytes.fromhex("b0 07 10 90 3c 7f b0 27 01") * 5) == []


def test_a_pair_that_is_bound_is_known_at_once() -> None:
    decoder = MidiDecoder("pad", is_bound=lambda control: control == "1/cc7+39")
    assert wholes(bytes.fromhex("b0 27 01"), decoder) == [], "there is no coarse part yet"
    assert wholes(bytes.fromhex("b0 07 7f 27 7f"), decoder) == [1.0]
    assert wholes(bytes.fromhex("b0 06 7f 26 7f"), decoder) == []


def test_fourteen_bits_are_read_whole() -> None:
    decoder = MidiDecoder("pad")
    decoder.feed(bytes.fromhex("b2 01 00 21 00") * 3)
    for value in range(0, 16384, 111):
        coarse = value >> 7
        fine = value & 0x7F
        last = decoder.feed(bytes([0xB2, 1, coarse, 33, fine]))[-1]
        assert last == Reading("pad", "3/cc1+33", value / 16383)
        assert decoder.feed(bytes([0xE2, fine, coarse]))[-1] == Reading("pad", "3/bend", value / 16383)


def test_wherever_a_stream_is_cut_it_reads_the_same() -> None:
    data = bytes.fromhex("b0 07 10 07 20 90 3c 64 f8 3d 00 e1 01 02 f0 01 02 f7 c3 04")
    whole = MidiDecoder("pad").feed(data)
    for cut in range(len(data) + 1):
        decoder = MidiDecoder("pad")
        assert decoder.feed(data[:cut]) + decoder.feed(data[cut:]) == whole
        assert decoder.rejected == 0


def test_bytes_of_no_message_are_counted() -> None:
    decoder = MidiDecoder("pad")
    assert decoder.feed(bytes.fromhex("01 02 b0 07 90 3c f7 05")) == []
    assert decoder.rejected == 5


def test_no_bytes_raise_anything_and_every_reading_is_in_range() -> None:
    generator = np.random.default_rng(3)
    decoder = MidiDecoder("pad")
    for reading in decoder.feed(generator.integers(0, 256, 60_000, np.uint8).tobytes()):
        assert 0.0 <= reading.value <= 1.0
