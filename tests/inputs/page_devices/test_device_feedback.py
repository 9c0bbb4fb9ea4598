"""Feedback: motor faders and lamps show what is on air, and never fight a hand."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.midi_stream import MidiDecoder
from omote.inputs.page_devices.device_feedback import MOST_MESSAGES, QUIET_SECONDS, DeviceFeedback, message_of
from omote.inputs.presets.lamp import DeviceLamp
from omote.inputs.reading import Reading


@given(st.integers(1, 16), st.integers(0, 127), st.floats(0.0, 1.0), st.sampled_from(["cc", "note", "bend", "fine"]))
def test_what_is_sent_reads_as_what_it_shows(channel: int, number: int, position: float, kind: str) -> None:
    names = {
        "cc": f"cc{number}",
        "note": f"note{number}",
        "bend": "bend",
        "fine": f"cc{number % 32}+{number % 32 + 32}",
    }
    control = f"{channel}/{names[kind]}"
    readings = MidiDecoder("pad", lambda _: True).feed(message_of(control, position))
    (found,) = [each.value for each in readings if each.control == control]
    assert found == pytest.approx(position, abs=0.5 / 16383 if kind in ("bend", "fine") else 0.5 / 127)


@pytest.mark.parametrize("control", ["1/program5", "1/pressure", "axis0", "17/cc1", "1/cc200", "1/cc", "", "1/cc1+200"])
def test_a_control_that_nothing_can_be_sent_to_is_left_alone(control: str) -> None:
    assert message_of(control, 0.5) == b""


def test_only_what_is_new_is_sent() -> None:
    feedback = DeviceFeedback(greeting=b"\xf0\x7d\xf7")
    assert feedback.news({"1/cc7": 1.0}, 0.0) == bytes.fromhex("f0 7d f7 b0 07 7f")
    assert feedback.news({"1/cc7": 1.0}, 0.1) == b""
    assert feedback.news({"1/cc7": 0.0}, 0.2) == bytes.fromhex("b0 07 00")


def test_a_fader_in_a_hand_is_sent_nothing_and_stands_right_afterwards() -> None:
    feedback = DeviceFeedback()
    assert not feedback.hear(Reading("pad", "1/cc7", 0.5), 0.0)
    assert feedback.news({"1/cc7": 0.9}, QUIET_SECONDS / 2) == b""
    assert feedback.news({"1/cc7": 0.9}, QUIET_SECONDS) == message_of("1/cc7", 0.9)


def test_while_it_is_touched_it_waits_however_still_the_hand() -> None:
    feedback = DeviceFeedback()
    feedback.hear(Reading("pad", "1/note105", 1.0, key=True), 0.0)
    assert feedback.news({"2/bend": 0.9, "1/bend": 0.9}, 10.0) == message_of("1/bend", 0.9)
    feedback.hear(Reading("pad", "1/note105", 0.0, key=True), 10.0)
    assert feedback.news({"2/bend": 0.9}, 10.0 + QUIET_SECONDS) == message_of("2/bend", 0.9)


def test_the_way_of_a_motor_is_no_hand() -> None:
    feedback = DeviceFeedback()
    for value in (1.0, 0.0):
        feedback.hear(Reading("pad", "1/note104", value, key=True), 0.0)
    assert feedback.hear(Reading("pad", "1/bend", 0.3), 5.0)


def test_what_comes_back_at_once_is_an_echo_and_later_a_hand() -> None:
    feedback = DeviceFeedback()
    feedback.news({"1/cc7": 1.0}, 0.0)
    assert feedback.hear(Reading("pad", "1/cc7", 1.0), 0.01)
    assert not feedback.hear(Reading("pad", "1/cc7", 1.0), 1.0)


def test_lamps_show_in_their_own_way() -> None:
    feedback = DeviceFeedback({"11/cc1": DeviceLamp(0xB0, 9, 1, 13)})
    assert feedback.news({"11/cc1": 0.5}, 0.0) == bytes([0xB0, 9, 7])


def test_a_page_of_changes_goes_out_over_several_times() -> None:
    feedback = DeviceFeedback()
    positions = {f"1/cc{number}": 1.0 for number in range(100)}
    sizes = [len(feedback.news(positions, time / 30)) for time in range(5)]
    assert sum(sizes) == 300
    assert max(sizes) <= 3 * (MOST_MESSAGES + 1)
