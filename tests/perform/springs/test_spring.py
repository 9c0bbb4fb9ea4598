"""A spring: its exact step, what kicks it, and that no rate of ticks changes what it plays."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.linalg import expm

from omote.perform.easing import EASINGS
from omote.perform.springs.cast_springs import SPRINGS
from omote.perform.springs.spring import (
    CUT,
    FASTEST,
    LONGEST_STEP,
    RANGES,
    Spring,
    SpringState,
    advance_spring,
    decay_of,
    weight_of,
)

frequencies = st.floats(*RANGES["frequency"])
dampings = st.floats(*RANGES["damping"])
EARS = SPRINGS["ears-sway"]
Way = Callable[[float], float]


def smoothed(share: float) -> float:
    x = min(max(share, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)


def turned(seconds: float) -> float:
    """40 degrees in a quarter of a second."""
    return math.radians(40.0) * smoothed((seconds - 0.5) / 0.25)


def shaken(seconds: float) -> float:
    """30 degrees there and back twice a second, for two seconds."""
    return math.radians(15.0) * smoothed(seconds - 0.5) * smoothed(3.5 - seconds) * math.sin(4.0 * math.pi * seconds)


def played(spring: Spring, way: Way, rate: float, *, seconds: float = 6.0) -> NDArray[np.float64]:
    """What a spring plays at each tick."""
    state = SpringState()
    weights = []
    for tick in range(round(seconds * rate) + 1):
        state = advance_spring(spring, state, way(tick / rate), 1.0 / rate)
        weights.append(weight_of(spring, state.turn, state.speed, 1.0))
    return np.array(weights)


@given(frequencies, dampings, st.floats(1e-4, 70.0))
def test_a_step_is_the_matrix_exponential(frequency: float, damping: float, dt: float) -> None:
    rate = 2.0 * math.pi * frequency
    expected = expm(np.array([[0.0, 1.0], [-rate * rate, -2.0 * damping * rate]]) * dt)
    turn_turn, turn_speed, speed_turn, speed_speed, _ = decay_of(frequency, damping, dt)
    units = np.array([[1.0, 1.0 / rate], [rate, 1.0]])
    found = np.array([[turn_turn, turn_speed], [speed_turn, speed_speed]])
    np.testing.assert_allclose(found / units, expected / units, atol=1e-9)


@given(frequencies, dampings, st.floats(0.001, 0.5))
def test_one_long_step_is_many_short_ones(frequency: float, damping: float, dt: float) -> None:
    spring = Spring("ears-sway", frequency, damping, {"yaw": 1.0}, 1.0)
    long = advance_spring(spring, SpringState(0.3, -1.0), 0.0, dt)
    short = SpringState(0.3, -1.0)
    for _ in range(12):
        short = advance_spring(spring, short, 0.0, dt / 12.0)
    assert long[:2] == pytest.approx(short[:2], abs=1e-6)


@pytest.mark.parametrize("spring", SPRINGS.values(), ids=SPRINGS)
@pytest.mark.parametrize("way", [turned, shaken])
def test_a_spring_plays_the_same_at_30_60_and_120_ticks_a_second(spring: Spring, way: Way) -> None:
    finest = played(spring, way, 960.0)
    for rate in (30, 60, 120):
        assert np.abs(played(spring, way, rate) - finest[:: 960 // rate]).max() <= 0.05 * np.abs(finest).max()


@pytest.mark.parametrize("spring", SPRINGS.values(), ids=SPRINGS)
def test_a_spring_lags_swings_back_and_is_quiet_within_a_second_and_a_half(spring: Spring) -> None:
    weights = np.sign(spring.gain) * played(spring, turned, 120.0)
    most = np.abs(weights).max()
    assert weights[: round(0.7 * 120)].min() < -0.5 * most
    assert weights.max() > 0.3 * most
    assert np.abs(weights[round((0.75 + 1.5) * 120) :]).max() < 0.05 * most


@given(
    st.sampled_from([*SPRINGS.values()]),
    st.lists(st.tuples(st.floats(0.002, 0.4), st.floats(-4.0, 4.0)), min_size=2, max_size=80),
)
def test_no_driver_and_no_rate_leads_out_of_the_limit(spring: Spring, ticks: list[tuple[float, float]]) -> None:
    state = SpringState()
    for dt, driver in ticks:
        state = advance_spring(spring, state, driver, dt)
        assert abs(weight_of(spring, state.turn, state.speed, 2.0)) < spring.limit


@pytest.mark.parametrize("rate", [10.0, 24.0, 60.0, 120.0])
def test_a_shake_brings_no_jump_at_any_rate(rate: float) -> None:
    """No step between ticks is longer than the driver and the spring's own swing go at their fastest together."""
    far_from_limit = replace(EARS, gain=0.2)
    steps = [abs(after - before) for before, after in pairwise(played(far_from_limit, shaken, rate))]
    swing = 2.0 * math.pi * EARS.frequency * np.abs(played(far_from_limit, shaken, 960.0)).max()
    assert max(steps) < (swing + far_from_limit.gain * 4.0 * math.pi * math.radians(15.0)) / rate


def test_what_was_put_elsewhere_does_not_kick() -> None:
    still = advance_spring(EARS, SpringState(), 0.0, 1 / 60)
    still = advance_spring(EARS, still, 0.0, 1 / 60)
    cut = advance_spring(EARS, still, 1.01 * CUT / 60, 1 / 60)
    assert cut[:2] == (0.0, 0.0)
    assert advance_spring(EARS, cut, 1.01 * CUT / 60, 1 / 60)[:2] == (0.0, 0.0)
    fast = advance_spring(EARS, still, 0.99 * CUT / 60, 1 / 60)
    assert fast == advance_spring(EARS, still, FASTEST / 60, 1 / 60)._replace(driver=0.99 * CUT / 60)
    assert fast.turn < 0.0


def test_after_a_long_step_the_driver_is_seen_anew() -> None:
    moving = advance_spring(EARS, SpringState(driver=0.0, driver_speed=2.0), 0.0, 1.01 * LONGEST_STEP)
    assert moving == SpringState(driver=0.0)


def test_a_spring_that_begins_in_a_turn_is_not_kicked_by_it() -> None:
    state = SpringState()
    for tick in range(30):
        state = advance_spring(EARS, state, tick / 60.0, 1 / 60)
    assert state[:2] == (0.0, 0.0)


@given(frequencies, dampings, st.floats(-1.0, 1.0), st.floats(-20.0, 20.0), st.floats(1e-3, LONGEST_STEP))
def test_a_swing_of_its_own_changes_its_speed_by_no_more_than_the_square_of_its_frequency_allows(
    frequency: float, damping: float, turn: float, speed: float, dt: float
) -> None:
    spring = replace(EARS, frequency=frequency, damping=damping)
    rate = 2.0 * math.pi * frequency
    after = advance_spring(spring, SpringState(turn, speed, 0.0, 0.0), 0.0, dt)
    largest = rate * math.sqrt(1.0 + 4.0 * damping * damping) * math.hypot(rate * turn, speed)
    assert abs(after.speed - speed) <= largest * dt + 1e-4
    assert math.hypot(rate * after.turn, after.speed) <= math.hypot(rate * turn, speed) + 1e-4


def test_what_can_hardly_be_seen_is_not_played() -> None:
    assert weight_of(EARS, 0.00028 / EARS.gain, 0.0, 1.0) == 0.0
    assert weight_of(EARS, -0.00028 / EARS.gain, 0.0, 1.0) == 0.0
    assert 0.0 < weight_of(EARS, 0.00032 / EARS.gain, 0.0, 1.0) < 0.0001


@pytest.mark.parametrize("phase", [0.0, 0.25, 0.5, 0.75])
@pytest.mark.parametrize("spring", SPRINGS.values(), ids=SPRINGS)
def test_a_small_sway_that_becomes_a_turn_begins_to_be_seen_without_a_jump(spring: Spring, phase: float) -> None:
    dt = 1.0 / 240.0
    hertz = spring.frequency / 2.0
    turns = 1.0 + phase / hertz
    state = SpringState()
    shown = []
    left_out = []
    for time in np.arange(0.0, turns + 0.8, dt).tolist():
        sway = 0.003 / spring.gain * math.sin(math.tau * hertz * time)
        turn = 0.3 * EASINGS["smooth"].value(min(max(time - turns, 0.0) / 0.5, 1.0))
        state = advance_spring(spring, state, sway + turn, dt)
        whole = spring.gain * state.turn
        shown.append(weight_of(spring, state.turn, state.speed, 1.0))
        left_out.append(whole / math.hypot(1.0, whole / spring.limit) - shown[-1])
    assert np.abs(np.diff(left_out, 2)).max() < np.abs(np.diff(shown)).max() / 16.0


def test_a_swing_that_is_seen_goes_through_its_middle_without_a_stop() -> None:
    fast = 2.0 * math.pi * EARS.frequency * 0.1 / EARS.gain  # a swing of .1 of the field
    assert weight_of(EARS, 1e-4, fast, 1.0) == pytest.approx(1e-4 * EARS.gain, rel=0.05)
    assert weight_of(EARS, -1e-4, fast, 1.0) == -weight_of(EARS, 1e-4, fast, 1.0)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"frequency": 0.1}, "frequency"), ({"damping": 2.0}, "damping"), ({"gain": math.inf}, "gain"),
        ({"limit": 1.5}, "limit"), ({"drivers": {}}, "no driver"), ({"drivers": {"yaw": 40.0}}, "yaw"),
        ({"channel": ""}, "channel"),
    ],
)  # fmt: skip
def test_what_is_no_spring_is_refused(changes: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(EARS, **changes)  # type: ignore[arg-type]
