"""Easings, the decay of a velocity, and the glide of a hand."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from omote.perform.easing import (
    DECAY_SECONDS,
    EASINGS,
    Easing,
    bump,
    bump_rate,
    decay_seconds,
    find_easing,
    glide_after,
    glide_state,
    is_over,
    plan_glide,
)
from omote.perform.mix import HIGHEST, LOWEST

GRID = np.linspace(0.0, 1.0, 1001)


@pytest.mark.parametrize("name", EASINGS)
def test_an_easing_rises_from_rest_to_rest(name: str) -> None:
    easing = EASINGS[name]
    values = np.array([easing.value(x) for x in GRID])
    assert (values[0], values[-1]) == (0.0, pytest.approx(1.0, abs=1e-12))
    assert (np.diff(values) >= 0.0).all()
    assert [easing.rate(0.0), easing.rate(1.0)] == pytest.approx([0.0, 0.0], abs=1e-12)


@pytest.mark.parametrize("name", EASINGS)
def test_the_rate_of_an_easing_is_its_derivative(name: str) -> None:
    easing = EASINGS[name]
    for x in GRID[1:-1:50]:
        assert easing.rate(x) == pytest.approx((easing.value(x + 1e-6) - easing.value(x - 1e-6)) / 2e-6, abs=1e-6)


@pytest.mark.parametrize("coefficients", [(0, 1), (0, 0, 1), (0, 0, 2, -1), (1, 0, -3, 2), (0, 0, 3, -2.1)])
def test_a_curve_that_would_kick_is_no_easing(coefficients: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match="no slope at its ends"):
        Easing(coefficients)


def test_an_unknown_easing_is_refused_with_all_there_are() -> None:
    with pytest.raises(ValueError, match=f"no easing 'linear'; choose one of {', '.join(EASINGS)}$"):
        find_easing("linear")


def test_the_bump_starts_with_slope_one_and_ends_with_nothing() -> None:
    assert (bump(0.0), bump_rate(0.0), bump(1.0), bump_rate(1.0), bump(7.0), bump_rate(7.0)) == (0, 1, 0, 0, 0, 0)
    for u in GRID[1:-1:50]:
        assert bump_rate(u) == pytest.approx((bump(u + 1e-6) - bump(u - 1e-6)) / 2e-6, abs=1e-6)
    assert max(bump(u) for u in GRID) < 0.2


@given(
    st.floats(LOWEST, HIGHEST), st.floats(-50.0, 50.0), st.booleans(), st.floats(0.05, 5.0),
    st.sampled_from(sorted(EASINGS)),
)  # fmt: skip
def test_the_planned_decay_keeps_a_weight_in_range(
    start: float, velocity: float, is_target: bool, seconds: float, easing: str
) -> None:
    target = "a" if is_target else "b"
    decay = decay_seconds({"a": start}, {"a": velocity}, {target: 1.0}, seconds, EASINGS[easing])
    assert 0.0 <= decay <= min(seconds, DECAY_SECONDS)
    assume(decay > 0.0)
    times = np.linspace(0.0, seconds, 400)
    goal = float(is_target)
    way = [
        start + (goal - start) * EASINGS[easing].value(t / seconds) + velocity * decay * bump(t / decay) for t in times
    ]
    assert min(way) >= LOWEST - 2e-3
    assert max(way) <= HIGHEST + 2e-3


def test_a_slow_move_decays_over_the_whole_third_of_a_second() -> None:
    assert (
        decay_seconds({"a": 0.5, "b": 0.5}, {"a": -1.0, "b": 1.0}, {"c": 1.0}, 2.0, EASINGS["smooth"]) == DECAY_SECONDS
    )
    assert decay_seconds({"a": 0.5, "b": 0.5}, {"a": -1.0, "b": 1.0}, {"c": 1.0}, 0.2, EASINGS["smooth"]) == 0.2


def test_rest_needs_no_decay() -> None:
    for rate in (0.0, 5e-324, -1e-300):
        assert decay_seconds({"a": 1.0}, {"a": rate}, {"b": 1.0}, 2.0, EASINGS["smooth"]) == 0.0


origins = st.floats(0.0, 1.0)


@given(origins, st.floats(-30.0, 30.0), origins, st.floats(0.01, 3.0))
def test_a_glide_takes_over_place_and_rate_and_rests_exactly_at_its_goal(
    origin: float, rate: float, goal: float, seconds: float
) -> None:
    assume(0.0 < origin < 1.0)
    way = plan_glide(origin, rate, goal, seconds)
    assume(way.seconds > 1e-6)
    assert glide_state(way) == pytest.approx((origin, rate))
    assert glide_state(glide_after(way, way.seconds)) == (goal, 0.0)
    places = np.array([glide_state(glide_after(way, way.seconds * u))[0] for u in GRID])
    assert places.min() >= -1e-12
    assert places.max() <= 1.0 + 1e-12
    if rate * (goal - origin) >= 0.0 and goal != origin:
        assert (np.diff(places) * np.sign(goal - origin) >= -1e-12).all()


@given(origins, st.floats(-30.0, 30.0), origins, st.floats(0.01, 3.0), st.floats(0.05, 0.95))
def test_the_rate_of_a_glide_is_its_derivative(
    origin: float, rate: float, goal: float, seconds: float, u: float
) -> None:
    way = plan_glide(origin, rate, goal, seconds)
    assume(way.seconds > 1e-3)
    step = 1e-6 * way.seconds
    before, after = (glide_state(glide_after(way, u * way.seconds + sign * step))[0] for sign in (-1, 1))
    rate_there = glide_state(glide_after(way, u * way.seconds))[1]
    assert rate_there * way.seconds == pytest.approx((after - before) / 2e-6, abs=1e-4)


def test_sixty_sixtieths_are_a_second() -> None:
    assert is_over(sum([1 / 60] * 60), 1.0)
    assert not is_over(sum([1 / 60] * 59), 1.0)
