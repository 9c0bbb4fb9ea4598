"""What hands left behind eases to rest after a panic."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.frame import Gaze, Head
from omote.perform.panic import (
    PANIC_SECONDS,
    Settling,
    settled_later,
    with_settling_channels,
    with_settling_gaze,
    with_settling_head,
    without_channels,
)

LEFT = Settling({"jawOpen": 1.2, "cheekPuff": -0.4}, Head(0.6, -0.3, 0.1), Gaze(-0.5, 0.2))


def test_it_begins_where_the_hand_was_and_ends_at_rest() -> None:
    assert with_settling_channels({}, LEFT) == pytest.approx(LEFT.channels)
    assert with_settling_head(Head(), LEFT) == LEFT.head
    assert with_settling_gaze(Gaze(), LEFT) == LEFT.gaze
    assert settled_later(LEFT, PANIC_SECONDS) is None
    assert with_settling_channels({"jawOpen": 0.3}, None) == {"jawOpen": 0.3}


@given(st.lists(st.floats(0.001, 0.05), max_size=20))
def test_it_only_comes_closer_and_one_step_lands_where_many_do(steps: list[float]) -> None:
    settling: Settling | None = LEFT
    last = LEFT.channels["jawOpen"]
    for step in steps:
        settling = settled_later(settling, step)
        value = with_settling_channels({}, settling).get("jawOpen", 0.0)
        assert 0.0 <= value <= last
        last = value
    assert last == pytest.approx(with_settling_channels({}, settled_later(LEFT, sum(steps))).get("jawOpen", 0.0))


def test_what_a_hand_takes_again_is_its_own() -> None:
    half = replace(LEFT, elapsed=PANIC_SECONDS / 2)
    left = without_channels(half, ["jawOpen"])
    found = with_settling_channels({"jawOpen": 0.9}, left)
    assert found["jawOpen"] == 0.9
    assert -0.4 < found["cheekPuff"] < 0.0
    assert without_channels(None, ["jawOpen"]) is None
