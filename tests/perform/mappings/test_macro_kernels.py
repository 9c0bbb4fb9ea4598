"""How macros follow: each way at its own speed, without a jump of speed, and equal however time is cut."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.layers.follower import rate_of
from omote.perform.mappings import macro_kernels
from omote.perform.mappings.monotone_curve import check_knots, curve_at, pieces_of

SECONDS = st.sampled_from([0.05, 0.1, 0.5, 2.0])
STEP = 1e-3


def follow_pair(
    pair: tuple[float, float], goal: float, rise: float, fall: float, dt: float, count: int = 1
) -> tuple[float, float]:
    """A pair some steps of dt later. rise, fall: seconds, 0 at once."""
    rises, falls = (rate_of(seconds) if seconds else 0.0 for seconds in (rise, fall))
    first, second = macro_kernels.follow_pair(pair[0], pair[1], goal, rises, falls, dt, count)
    return first, second


@given(st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=6), SECONDS, SECONDS)
def test_what_follows_stays_between_and_never_jumps_in_speed(goals: list[float], rise: float, fall: float) -> None:
    pair = (0.0, 0.0)
    values = [0.0, 0.0]
    for goal in goals:
        for _ in range(40):
            pair = follow_pair(pair, goal, rise, fall, STEP)
            values.append(pair[1])
    speeds = [(after - before) / STEP for before, after in pairwise(values)]
    rate = 4.0 / min(rise, fall)
    change = max(abs(after - before) for before, after in pairwise(speeds))
    assert change <= rate * rate * 2.0 * STEP * 1.1  # the second filter's rate of change: rate² times the distance
    assert min(0.0, *goals) - 1e-12 <= min(values)
    assert max(values) <= max(0.0, *goals) + 1e-12


@given(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), SECONDS, SECONDS)
def test_many_short_steps_land_near_one_long_one(start: float, goal: float, rise: float, fall: float) -> None:
    one = follow_pair((start, start), goal, rise, fall, 0.025, 4)
    many = (start, start)
    for _ in range(100):
        many = follow_pair(many, goal, rise, fall, STEP)
    assert many == pytest.approx(one, abs=0.012 * abs(goal - start) + 1e-6)


def test_no_seconds_are_at_once_and_each_way_has_its_own() -> None:
    assert follow_pair((0.0, 0.0), 0.7, 0.0, 0.0, 0.0) == (0.7, 0.7)
    assert follow_pair((0.0, 0.0), 0.7, 0.0, 0.5, 1 / 60) == (0.7, 0.7)
    risen = follow_pair((0.7, 0.7), 0.0, 0.0, 0.5, 1 / 60)
    assert 0.0 < risen[1] < 0.7
    assert follow_pair((0.0, 0.0), 1.0, 0.2, 0.2, 0.025, 8)[1] == pytest.approx(0.9, abs=0.02)


@given(st.lists(st.floats(0.0, 1.0), min_size=1, max_size=6), st.floats(0.0, 1.0))
def test_a_macro_that_plays_gives_what_its_curve_says(heights: list[float], at: float) -> None:
    count = len(heights)
    curve = check_knots([(0.0, 0.0), *(((n + 1) / count, height) for n, height in enumerate(heights))], "the curve")
    pieces = np.array(pieces_of(curve)).reshape(-1, 9)
    assert macro_kernels.curve_value(pieces, 0, len(pieces), at) == curve_at(curve, at)
