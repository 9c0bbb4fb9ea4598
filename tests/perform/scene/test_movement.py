"""Whatever is called while numbers move: they go on from where they are, at their speed, in range."""

import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.easing import EASINGS
from omote.perform.scene.movement import Movement, Way, check_movement, proceed, rates, redirect, values, with_pace

RANGES = {"x": (-10.0, 10.0), "size": (0.25, 4.0)}
goals = st.fixed_dictionaries({name: st.floats(*ends) for name, ends in RANGES.items()})
orders = st.lists(
    st.tuples(goals, st.floats(0.05, 3.0), st.floats(0.0, 1.0), st.sampled_from([*EASINGS])), min_size=1, max_size=6
)
Sent = list[tuple[dict[str, float], float, float, str]]
HOME = Movement({"x": 0.0, "size": 1.0})
MOMENT = 1e-6


def after(sent: Sent) -> Movement:
    """The movement that was sent somewhere else again and again, each time a while after the last."""
    movement = HOME
    for goal, seconds, wait, easing in sent:
        movement = proceed(redirect(movement, goal, seconds, RANGES, easing), wait)
    return movement


@given(orders, goals, st.floats(0.05, 3.0), st.one_of(st.none(), st.floats(0.0, 1.0)))
def test_a_new_way_begins_where_the_old_one_is_and_at_its_speed(
    sent: Sent, goal: dict[str, float], seconds: float, pace: float | None
) -> None:
    movement = after(sent)
    turned = with_pace(redirect(movement, goal, seconds, RANGES), pace)
    assert values(turned, RANGES) == pytest.approx(values(movement, RANGES), abs=1e-9)
    if turned.way is not None and turned.way.decay > 0.0:
        assert rates(turned) == pytest.approx(rates(movement), rel=1e-9, abs=1e-9)


@given(orders)
def test_nothing_leaves_its_range_and_nothing_jumps(sent: Sent) -> None:
    movement = after(sent)
    before = values(movement, RANGES)
    for _ in range(60):
        speed = rates(movement)
        movement = proceed(movement, MOMENT)
        now = values(movement, RANGES)
        for name, (low, high) in RANGES.items():
            assert low <= now[name] <= high
            assert abs(now[name] - before[name]) <= MOMENT * (abs(speed[name]) + 1.0) + 1e-9
        before = now
        movement = proceed(movement, 0.05)
        before = values(movement, RANGES)


@given(orders, st.floats(0.0, 3.0))
def test_it_arrives_in_its_time_and_short_steps_land_where_a_long_one_does(sent: Sent, wait: float) -> None:
    movement = after(sent)
    goal, seconds, waited, _ = sent[-1]
    assert proceed(movement, max(0.0, seconds - waited) + 1e-6) == Movement(goal)
    stepped = movement
    for _ in range(10):
        stepped = proceed(stepped, wait / 10)
    assert values(stepped, RANGES) == pytest.approx(values(proceed(movement, wait), RANGES), abs=1e-6)


def test_no_seconds_cut_and_a_way_to_where_it_is_is_none() -> None:
    goal = {"x": 1.0, "size": 2.0}
    assert redirect(HOME, goal, 0.0, RANGES) == Movement(goal)
    assert redirect(HOME, dict(HOME.goal), 2.0, RANGES) == HOME


ON_ITS_WAY = Movement({"x": 1.0, "size": 1.0}, Way({"x": 0.0, "size": 1.0}, {"x": 0.0, "size": 0.0}, 0.0, 2.0, 0.5))


def with_way(**changes: Any) -> Movement:
    assert ON_ITS_WAY.way is not None
    return replace(ON_ITS_WAY, way=replace(ON_ITS_WAY.way, **changes))


@pytest.mark.parametrize(
    ("movement", "said"),
    [
        (Movement({"x": 1.0}), "has x; it must have x, size"),
        (Movement({}), "has no numbers"),
        (Movement({"x": 11.0, "size": 1.0}), "here: x is 11.0; give a number from -10 to 10"),
        (Movement({"x": math.nan, "size": 1.0}), "here: x is no number"),
        (with_way(start={"x": 0.0, "size": 5.0}), "here: size is 5.0"),
        (with_way(velocity={"x": math.inf, "size": 0.0}), "the speed of here:: x is infinite"),
        (with_way(seconds=0.0), "the time of its way"),
        (with_way(decay=1.0), "the decay of its speed"),
        (with_way(elapsed=2.5), "the elapsed time of its way"),
        (with_way(easing="jump"), "there is no easing 'jump'"),
    ],
)
def test_what_no_movement_can_be_is_rejected(movement: Movement, said: str) -> None:
    check_movement(ON_ITS_WAY, RANGES, "here:")
    with pytest.raises(ValueError, match=said.replace("(", r"\(")):
        check_movement(movement, RANGES, "here:")
