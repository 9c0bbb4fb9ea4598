"""Learn: what a hand clearly moves is bound as what it is; what trembles, is touched or comes along is not."""

import pytest

from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import BoundTarget, read_target
from omote.inputs.midi_stream import MidiDecoder
from omote.inputs.page_devices.learning import Learning
from omote.inputs.reading import Reading

JAW = read_target("/omote/one/channel/jawOpen")
FACE = read_target("/omote/one/face", ["dog"])
HEAD = read_target("/omote/one/head", axis="yaw")


def learn_midi(*messages: str, target: BoundTarget = JAW) -> Binding | None:
    """What is bound by messages of MIDI that come one by one."""
    learning = Learning(target, 0.0)
    decoder = MidiDecoder("pad")
    for message in messages:
        found = learning.hear(decoder.feed(bytes.fromhex(message)))
        if found is not None:
            return found
    return None


def learn(*readings: Reading, target: BoundTarget = JAW) -> Binding | None:
    learning = Learning(target, 0.0)
    return next((found for each in readings if (found := learning.hear([each])) is not None), None)


def test_a_dial_that_trembles_is_not_bound_and_one_that_is_turned_is() -> None:
    assert learn_midi(*["b0 07 40", "b0 07 41"] * 20) is None
    found = learn_midi("b0 08 10", "b0 07 40", "b0 07 44", "b0 07 48", "b0 07 50")
    assert found == Binding("pad", "1/cc7", JAW)
    assert found.pick_up


def test_a_fader_of_14_bits_is_bound_whole() -> None:
    moves = [
        f"b0 07 {coarse:02x} 27 {fine:02x}" for coarse, fine in zip(range(10, 40, 3), range(3, 120, 12), strict=True)
    ]
    found = learn_midi(*moves)
    assert found is not None
    assert found.control == "1/cc7+39"


def test_a_button_with_a_number_that_could_be_a_fine_part_is_a_button() -> None:
    decoder = MidiDecoder("nano")
    learning = Learning(JAW, 0.0)
    decoder.feed(bytes.fromhex("b0 00 40"))  # the slider was moved before
    found = learning.hear(decoder.feed(bytes.fromhex("b0 20 7f")) + decoder.feed(bytes.fromhex("b0 20 00")))
    assert found == Binding("nano", "1/cc32", JAW, pick_up=False, button="toggle")


@pytest.mark.parametrize(
    ("right", "left", "code"),
    [(1, 127, "twos_complement"), (65, 63, "binary_offset"), (1, 65, "sign_magnitude")],
)
def test_an_encoder_is_known_by_the_bytes_that_it_repeats(right: int, left: int, code: str) -> None:
    found = learn_midi(*(f"b0 10 {byte:02x}" for byte in (right, left, right, right, right)))
    assert found is not None
    assert (found.relative, found.control, found.pick_up) == (code, "1/cc16", False)
    assert found.steps(right / 127) == 1
    assert found.steps(left / 127) == -1


def test_a_note_is_bound_when_it_is_let_go_and_a_touch_of_a_fader_is_not() -> None:
    assert learn_midi("90 3c 40") is None
    assert learn_midi("90 3c 40", "80 3c 00", target=FACE) == Binding("pad", "1/note60", FACE)
    touched = learn_midi("90 68 7f", "e0 00 20", "e0 00 30", "e0 00 40")
    assert touched is not None
    assert touched.control == "1/bend"


def test_the_pressure_of_a_key_that_is_held_is_not_bound() -> None:
    pressures = [f"a0 3c {value:02x}" for value in range(0, 120, 10)]
    found = learn_midi("90 3c 40", *pressures, "90 3c 00")
    assert found is not None
    assert found.control == "1/note60"
    alone = learn_midi(*pressures)
    assert alone is not None
    assert alone.control == "1/pressure60"


def test_of_a_stick_the_axis_that_goes_farthest_is_bound() -> None:
    learning = Learning(HEAD, 0.0)
    steps = [[Reading("pad", "axis0", 0.5 + n / 20), Reading("pad", "axis1", 0.5 + n / 50)] for n in range(8)]
    found = next(found for each in steps if (found := learning.hear(each)) is not None)
    assert (found.control, found.low, found.high, found.pick_up) == ("axis0", -60.0, 60.0, False)
    drift = [Reading("pad", "axis0", 0.5 + 0.02 * (n % 3)) for n in range(40)]
    assert learn(*drift, target=HEAD) is None


@pytest.mark.parametrize(
    ("address", "axis", "farthest"),
    [("/omote/one/pad/moods", "y", 1.0), ("/omote/one/head", "pitch", 40.0), ("/omote/one/gaze", "pitch", 25.0)],
)
def test_a_stick_that_is_pushed_up_plays_up_as_far_as_the_preset_does(address: str, axis: str, farthest: float) -> None:
    """A learned stick was upside down, and turned a head by 90 degrees."""
    target = read_target(address, axis=axis)
    up = learn(*(Reading("pad", "axis3", 0.5 - n / 20) for n in range(8)), target=target)
    assert up is not None
    assert (up.value_at(0.0), up.value_at(0.52), up.value_at(1.0)) == (farthest, 0.0, -farthest)
    opens = learn(*(Reading("pad", "axis1", 0.5 - n / 20) for n in range(8)))
    assert opens is not None
    assert (opens.low, opens.high) == (1.0, 0.0)


def test_a_stick_plays_both_halves_of_a_macro_and_rests_in_its_middle_and_a_dial_plays_one() -> None:
    macro = read_target("/omote/one/macro/turn")
    stick = learn(*(Reading("pad", "axis0", 0.5 + n / 20) for n in range(8)), target=macro)
    dial = learn(*(Reading("pad", "1/cc7", n / 20) for n in range(8)), target=macro)
    assert stick is not None
    assert dial is not None
    assert (stick.low, stick.high, stick.value_at(0.52), stick.pick_up) == (-1.0, 1.0, 0.0, False)
    assert (dial.low, dial.high, dial.dead_zone, dial.pick_up) == (0.0, 1.0, 0.0, True)


def test_a_trigger_plays_a_level_as_a_level_and_a_call_as_a_key() -> None:
    way = (0.2, 0.5, 1.0, 0.4, 0.0)
    both = [each for v in way for each in (Reading("pad", "trigger6", v), Reading("pad", "button6", v, key=True))]
    found = learn(*both)
    assert found is not None
    assert (found.control, found.button) == ("trigger6", None)
    called = learn(*both, target=FACE)
    assert called is not None
    assert called.control == "button6"


def test_what_is_no_position_is_passed_over() -> None:
    assert learn(*(Reading("pad", "axis0", value) for value in (float("nan"), 2.0, -1.0, float("inf")))) is None
