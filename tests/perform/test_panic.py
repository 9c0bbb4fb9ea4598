"""What hands left behind eases to rest after a panic."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.frame import Frame, Gaze, Head, Held, with_fields
from omote.perform.limits import GAZE_LIMITS, HEAD_LIMITS
from omote.perform.panic import (
    FASTEST,
    PANIC_SECONDS,
    EasingToRest,
    at_speed,
    ease_later,
    eased,
    without_channels,
    without_turn,
)

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


def shown(value: float, turn: float, eye: float) -> Frame:
    return Frame({}, {}, channels={"jawOpen": value}, head=Head(turn), gaze=Gaze(eye))


def test_what_moves_goes_on_at_its_speed_and_a_cut_is_no_motion() -> None:
    dt = 1e-4
    found = EasingToRest({"jawOpen": 0.4}, Head(0.3), Gaze(-0.2))
    moving = at_speed(
        found, shown(0.4 + 2.0 * dt, 0.3 - 5.0 * dt, -0.2), shown(0.4 + 4.0 * dt, 0.3 - 10.0 * dt, -0.2), dt
    )
    after = eased(Held(), ease_later(moving, dt))
    assert (after.channels["jawOpen"] - 0.4) / dt == pytest.approx(2.0, rel=1e-2)
    assert (after.head.yaw - 0.3) / dt == pytest.approx(-5.0, rel=1e-2)
    assert after.gaze.yaw == pytest.approx(-0.2, abs=1e-4)
    assert at_speed(found, shown(0.401, 1.3, 0.2), shown(0.401, 1.3, 0.2), dt) == found


def test_what_a_hand_takes_again_goes_on_no_more() -> None:
    found = EasingToRest({"jawOpen": 0.4}, Head(0.3), Gaze(-0.2))
    moving = at_speed(found, shown(0.401, 0.301, -0.201), shown(0.402, 0.302, -0.202), 1e-3)
    left = without_turn(without_turn(without_channels(moving, ["jawOpen"]), "head"), "gaze")
    held = Held({"jawOpen": 0.9}, Head(0.5), Gaze(0.1))
    assert eased(held, left) == held
    assert without_turn(None, "head") is None


wild = st.floats(allow_nan=True, allow_infinity=True)
weight = st.floats(-0.5, 1.5)


@given(
    found=st.tuples(weight, st.floats(-1.5, 1.5), st.floats(-0.69, 0.69)),
    soon=st.tuples(wild, wild, wild),
    later=st.tuples(wild, wild, wild),
    dt=st.sampled_from([1e-300, 1e-4, 1.0]),
    held=weight,
    elapsed=st.floats(0.0, PANIC_SECONDS, exclude_max=True),
)
def test_whatever_moves_nothing_leaves_its_range(
    found: tuple[float, float, float],
    soon: tuple[float, float, float],
    later: tuple[float, float, float],
    dt: float,
    held: float,
    elapsed: float,
) -> None:
    """Of what no layer shows too: angles beyond their limits, numbers that are none."""

    def frame(values: tuple[float, float, float]) -> Frame:
        turned = with_fields(Head(), yaw=values[1]), with_fields(Gaze(), yaw=values[2])
        return Frame({}, {}, channels={"jawOpen": values[0]}, head=turned[0], gaze=turned[1])

    left = EasingToRest({"jawOpen": found[0]}, Head(found[1]), Gaze(found[2]))
    moving = at_speed(left, frame(soon), frame(later), dt)
    for carried in (each for part in moving.moving.values() for each in part.values()):
        assert abs(carried.speed) <= FASTEST
        assert 0.0 < carried.decay <= PANIC_SECONDS
    after = eased(Held({"jawOpen": held}, Head(), Gaze()), replace(moving, elapsed=elapsed))
    assert min(-0.1, found[0], held) <= after.channels["jawOpen"] <= max(1.1, found[0], held)
    assert abs(after.head.yaw) <= HEAD_LIMITS["yaw"]
    assert abs(after.gaze.yaw) <= GAZE_LIMITS["yaw"]
