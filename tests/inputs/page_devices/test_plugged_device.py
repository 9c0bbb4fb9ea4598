"""A device at a page: bytes and controls become readings; sticks rest in their middle."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.page_devices.plugged_device import DEAD, PluggedDevice
from omote.inputs.reading import Reading


def pad(kind: str = "gamepad") -> PluggedDevice:
    return PluggedDevice("pad", kind, "a", "Ana", 0.0, None)  # type: ignore[arg-type]


def test_bytes_that_come_in_parts_are_read_and_those_of_no_message_are_counted() -> None:
    desk = pad("midi")
    assert desk.feed(b"\xb0\x07") == []
    assert desk.feed(b"\x7f") == [Reading("pad", "1/cc7", 1.0)]
    desk.plug("midi", "b", "Ben", None)
    assert desk.feed(b"\x40\x41") == []
    assert desk.health.rejected == 2


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_a_stick_goes_an_even_way_from_its_middle_to_both_ends(one: float, other: float) -> None:
    low, high = sorted((one, other))
    (first,), (second,) = (pad().read({"axis0": value}) for value in (low, high))
    assert 0.0 <= first.value <= second.value <= 1.0
    assert (first.value == 0.5) == (abs(low - 0.5) <= DEAD)
    (mirrored,) = pad().read({"axis0": 1.0 - low})
    assert mirrored.value == pytest.approx(1.0 - first.value, abs=1e-9)
    assert [pad().read({"axis0": end})[0].value for end in (0.0, 1.0)] == [0.0, 1.0]


def test_what_has_not_moved_is_no_reading_and_what_is_no_stick_has_no_middle() -> None:
    device = pad()
    assert device.read({"trigger6": 0.5, "button0": 1.0}) == [
        Reading("pad", "trigger6", 0.5),
        Reading("pad", "button0", 1.0, key=True),
    ]
    assert device.read({"trigger6": 0.53, "button0": 1.0}) == [Reading("pad", "trigger6", 0.53)]


def test_one_wrong_value_rejects_the_whole_message() -> None:
    device = pad()
    with pytest.raises(ValueError, match=r"axis1 of pad is 1\.5; give 0 to 1"):
        device.read({"axis0": 1.0, "axis1": 1.5})
    assert device.read({"axis0": 1.0}) != []


def test_its_state_says_that_it_is_gone() -> None:
    device = pad()
    device.health.note(3)
    assert device.state(2.0, {}, "", []).rate == 1.5
    device.who = ""
    state = device.state(2.5, {}, "B", ["A", "B"])
    assert (state.plugged, state.rate, state.where, state.banks) == (False, 0.0, "Ana", ["A", "B"])
