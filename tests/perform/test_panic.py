"""What hands left behind eases to rest after a panic."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.frame import Gaze, Head, Held
from omote.perform.panic import PANIC_SECONDS, EasingToRest, ease_later, eased, without_channels

LEFT = EasingToRest({"jawOpen": 1.2, "cheekPuff": -0.4}, Head(0.6, -0.3, 0.1), Gaze(-0.5, 0.2))


def test_it_begins_where_the_hand_was_and_ends_at_rest() -> None:
    found = eased(Held(), LEFT)
    assert found.channels == pytest.approx(LEFT.channels)
    assert (found.head, found.gaze) == (LEFT.head, LEFT.gaze)
    assert ease_later(LEFT, PANIC_SECONDS) is None
    held = Held({"jawOpen": 0.3}, Head(0.1), Gaze(0.1))
    assert eased(held, None) == eased(held, EasingToRest()) == held


@given(st.lists(st.floats(0.001, 0.05), max_size=20))
def test_it_only_comes_closer_and_one_step_lands_where_many_do(steps: list[float]) -> None:
    easing_to_rest: EasingToRest | None = LEFT
    last = LEFT.channels["jawOpen"]
    for step in steps:
        easing_to_rest = ease_later(easing_to_rest, step)
        value = eased(Held(), easing_to_rest).channels.get("jawOpen", 0.0)
        assert 0.0 <= value <= last
        last = value
    assert last == pytest.approx(eased(Held(), ease_later(LEFT, sum(steps))).channels.get("jawOpen", 0.0))


def test_what_a_hand_takes_again_is_its_own() -> None:
    half = replace(LEFT, elapsed=PANIC_SECONDS / 2)
    left = without_channels(half, ["jawOpen"])
    found = eased(Held({"jawOpen": 0.9}), left).channels
    assert found["jawOpen"] == 0.9
    assert -0.4 < found["cheekPuff"] < 0.0
    assert without_channels(None, ["jawOpen"]) is None
