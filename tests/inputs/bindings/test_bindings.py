"""Controls played: pick-up by crossing, buttons, encoders, axes, banks, and devices that go and come back."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from omote.inputs.bindings.bindings import NEAR, Bindings
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.bindings.target import read_target
from omote.inputs.osc_packet import Argument, OscMessage
from omote.inputs.reading import Reading

JAW = "/omote/one/channel/jawOpen"
SMILE = "/omote/one/channel/smile"
HEAD = "/omote/one/head"


class Desk:
    """A device with bindings, and what is on air, which takes what they send one state later."""

    def __init__(self, *bindings: Binding) -> None:
        self.bindings = Bindings(bindings)
        self.on_air: dict[str, tuple[Argument, ...]] = {JAW: (0.0,), HEAD: (0.0, 0.0, 0.0)}
        self.number = 1

    def turn(self, *positions: float, control: str = "1", key: bool = False) -> list[tuple[Argument, ...]]:
        """The values that a control sends while it is turned through positions, a state for each."""
        found = []
        for position in positions:
            messages = self.bindings.hear(Reading("pad", control, position, key), self.on_air, self.number)
            self.take(messages)
            found += [message.arguments for message in messages]
        return found

    def take(self, messages: list[OscMessage]) -> None:
        self.on_air |= {message.address: message.arguments for message in messages}
        self.number += 1


def fader(control: str = "1", path: str = JAW, axis: str | None = None, **more: Any) -> Binding:
    return Binding("pad", control, read_target(path, axis=axis), **more)


def test_a_fader_acts_once_it_has_crossed_the_value_on_air() -> None:
    desk = Desk(fader())
    desk.on_air[JAW] = (0.5,)
    assert desk.turn(0.0, 0.2, 0.49) == []
    assert desk.bindings.waiting == {("pad", "1"): 0.49}
    assert desk.turn(0.51, 0.6) == [(0.51,), (0.6,)]
    assert desk.bindings.waiting == {}


@pytest.mark.parametrize("seed", range(20))
def test_however_fast_it_is_moved_no_fader_jumps_but_over_the_value(seed: int) -> None:
    generator = np.random.default_rng(seed)
    value = float(generator.random())
    desk = Desk(fader())
    desk.on_air[JAW] = (value,)
    positions = generator.random(50).tolist()
    sent = desk.turn(*positions)
    first = next(n for n, (a, b) in enumerate(pairwise(positions), 1) if (a - value) * (b - value) <= 0.0)
    first = 0 if abs(positions[0] - value) <= NEAR else first
    assert [values[0] for values in sent] == pytest.approx(positions[first:])


def test_a_value_that_others_move_is_picked_up_anew() -> None:
    desk = Desk(fader())
    assert desk.turn(0.0, 0.3, 0.4) == [(0.0,), (0.3,), (0.4,)]
    desk.on_air[JAW] = (0.9,)
    assert desk.turn(0.45, 0.5) == []
    assert desk.turn(0.95) == [(0.95,)]


def test_several_readings_before_the_next_state_do_not_let_go() -> None:
    bindings = Bindings([fader()])
    on_air = {JAW: (0.0,)}
    sent = [bindings.hear(Reading("pad", "1", p), on_air, 5) for p in (0.0, 0.1, 0.2, 0.3)]
    assert [messages[0].arguments for messages in sent[1:]] == [(0.1,), (0.2,), (0.3,)]


def test_without_pick_up_it_acts_at_once() -> None:
    desk = Desk(fader(pick_up=False))
    desk.on_air[JAW] = (0.5,)
    assert desk.turn(0.1) == [(0.1,)]


def test_range_and_curve() -> None:
    desk = Desk(fader(low=1.0, high=-0.5, curve=2.0, pick_up=False))
    assert desk.turn(0.0, 0.5, 1.0) == [(1.0,), (0.625,), (-0.5,)]


def test_an_axis_leaves_the_others_where_they_are_even_within_one_state() -> None:
    bindings = Bindings(
        [
            fader("x", HEAD, "yaw", low=-90.0, high=90.0, pick_up=False),
            fader("y", HEAD, "pitch", low=-90.0, high=90.0, pick_up=False),
        ]
    )
    on_air: dict[str, tuple[Argument, ...]] = {HEAD: (0.0, 0.0, 7.0)}
    bindings.hear(Reading("pad", "x", 1.0), on_air, 3)
    (message,) = bindings.hear(Reading("pad", "y", 0.0), on_air, 3)
    assert message == OscMessage(HEAD, (90.0, -90.0, 7.0))


def test_a_momentary_button_holds_and_lets_go() -> None:
    desk = Desk(fader(button="momentary", low=0.1, high=0.8))
    assert desk.turn(1.0, 1.0, 0.0) == [(0.8,), (0.1,)]


def test_a_toggle_changes_at_each_press_and_follows_what_others_do() -> None:
    desk = Desk(fader(button="toggle"))
    assert desk.turn(1.0, 0.0, 1.0, 0.0) == [(1.0,), (0.0,)]
    desk.on_air[JAW] = (1.0,)
    assert desk.turn(1.0) == [(0.0,)]


def test_a_key_is_pressed_at_any_velocity_and_a_level_from_one_half_on() -> None:
    call = Binding("pad", "1", read_target("/omote/one/face", ["dog", 2.0]))
    for value, key, calls in ((0.01, True, 1), (0.01, False, 0), (0.5, False, 1), (0.0, True, 0)):
        assert desk_calls(Desk(call), value, key=key) == [("dog", 2.0)] * calls


def desk_calls(desk: Desk, value: float, *, key: bool) -> list[tuple[Argument, ...]]:
    return desk.turn(value, value, control="1", key=key)


def test_an_encoder_turns_on_from_what_is_on_air_and_stops_at_the_ends() -> None:
    desk = Desk(fader(relative="binary_offset", step=0.25, pick_up=False))
    desk.on_air[JAW] = (0.5,)
    one = 65 / 127.0
    back = 63 / 127.0
    assert desk.turn(one, one, one) == [(0.75,), (1.0,), (1.0,)]
    assert desk.turn(back) == [(0.75,)]


def test_an_encoder_turned_twice_within_one_state_makes_both_steps() -> None:
    bindings = Bindings([fader(relative="binary_offset", step=0.25)])
    for expected in (0.25, 0.5):
        (message,) = bindings.hear(Reading("pad", "1", 65 / 127.0), {JAW: (0.0,)}, 9)
        assert message.arguments == (expected,)


def test_banks_turn_and_their_faders_are_picked_up_anew() -> None:
    bank = Binding("pad", "b", read_target("bank:B"))
    desk = Desk(bank, fader(bank="B", pick_up=True), fader("2", bank="A"))
    assert desk.turn(0.0, 0.5) == []
    assert desk.turn(1.0, control="b") == []
    assert desk.bindings.bank_of("pad") == "B"
    assert desk.turn(0.0, 0.5) == [(0.0,), (0.5,)]
    assert desk.turn(0.0, 1.0, control="2") == []


def test_a_fader_that_was_moved_in_another_bank_does_not_jump() -> None:
    desk = Desk(fader(bank="A"), fader(bank="B", path=SMILE))
    desk.on_air |= {JAW: (0.0,), SMILE: (0.5,)}
    desk.bindings.choose_bank("pad", "B")
    assert desk.turn(0.1, 0.2) == []
    desk.bindings.choose_bank("pad", "A")
    desk.turn(0.3, 0.8)
    desk.bindings.choose_bank("pad", "B")
    assert desk.turn(0.81, 0.7) == []
    assert desk.turn(0.4) == [(0.4,)]


def test_a_fader_that_rests_where_the_value_is_acts_with_its_first_step() -> None:
    assert Desk(fader()).turn(1 / 127, 2 / 127) == [(1 / 127,), (2 / 127,)]
    assert Desk(fader()).turn(0.1, 0.2) == []


def test_a_button_that_is_held_while_the_bank_changes_lets_go() -> None:
    desk = Desk(fader(bank="A", button="momentary"), fader(bank="B", path=SMILE))
    desk.bindings.choose_bank("pad", "A")
    assert desk.turn(1.0) == [(1.0,)]
    desk.bindings.choose_bank("pad", "B")
    assert desk.turn(0.0)[0] == (0.0,)


def test_bindings_that_stay_go_on_as_they_were_when_others_change() -> None:
    stays = fader()
    desk = Desk(stays)
    assert desk.turn(0.0, 0.5) == [(0.0,), (0.5,)]
    desk.bindings.replace([fader("2"), stays])
    assert desk.turn(0.6) == [(0.6,)]


def test_where_controls_would_stand_that_show_what_is_on_air() -> None:
    call = Binding("pad", "k", read_target("/omote/one/face", ["dog"]))
    desk = Desk(fader(high=0.5), call, fader("e", relative="binary_offset"), Binding("pad", "b", read_target("bank:B")))
    desk.on_air |= {JAW: (0.25,), "/omote/one/face": ("dog",)}
    assert desk.bindings.positions("pad", desk.on_air) == {"1": 0.5, "k": 1.0, "b": 0.0}
    assert "e" in desk.bindings.positions("pad", desk.on_air, ["e"])
    assert desk.bindings.positions("another", desk.on_air) == {}
    desk.turn(0.9)
    assert desk.bindings.crossings("pad", desk.on_air) == {"1": 0.5}


def test_bindings_wait_for_their_own_device() -> None:
    desk = Desk(fader(button="momentary"), fader("2"))
    desk.turn(1.0)
    desk.turn(0.0, 0.4, control="2")
    let_go = desk.bindings.unplug("pad", desk.on_air, desk.number)
    assert let_go == [OscMessage(JAW, (0.0,))]
    assert desk.bindings.unplug("pad", desk.on_air, desk.number) == []
    assert desk.bindings.hear(Reading("another", "1", 1.0), desk.on_air, desk.number) == []
    desk.take(let_go)
    assert desk.turn(1.0) == [(1.0,)]


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -0.1, 1.1])
def test_a_reading_that_is_no_position_plays_nothing(value: float) -> None:
    assert Desk(fader(pick_up=False)).turn(value) == []


@pytest.mark.parametrize(("position", "sent"), [(0.0, 0.0), (0.4, 0.0), (0.6, 1.0), (1.0, 1.0)])
def test_a_fader_on_a_switch_sends_on_or_off_alone(position: float, sent: float) -> None:
    path = "/omote/one/layer_on/tracker"
    bindings = Bindings([Binding("pad", "fader", read_target(path), pick_up=False)])
    assert bindings.hear(Reading("pad", "fader", position), {}, 1) == [OscMessage(path, (sent,))]
