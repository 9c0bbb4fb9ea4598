"""A follower stays between its goals, is never jerked, comes to rest, and gives the same bits everywhere."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.arrays import Values
from omote.perform.layers.follower import LONGEST_STEP, REST_SECONDS, follow, follow_number, rate_of, steps_of

numbers = st.floats(-2.0, 2.0)
goals = st.lists(st.tuples(numbers, st.floats(0.0, 0.3)), min_size=1, max_size=20)
RATE = np.array([rate_of(0.5)])
NO_HASTE = np.zeros(1)


def followed(
    first: Values, second: Values, goal: float, seconds: float, haste: Values = NO_HASTE
) -> tuple[Values, Values]:
    for dt in steps_of(seconds):
        first, second = follow(first, second, np.array([goal]), RATE, haste, dt)
    return first, second


@given(goals, st.sampled_from([0.0, 60.0]))
def test_it_never_leaves_the_hull_of_its_goals(way: list[tuple[float, float]], haste: float) -> None:
    first = second = np.zeros(1)
    reached = [0.0]
    for goal, seconds in way:
        reached.append(goal)
        first, second = followed(first, second, goal, seconds, np.array([haste]))
        assert min(reached) - 1e-9 <= float(second[0]) <= max(reached) + 1e-9


def test_nine_tenths_of_the_way_take_its_seconds_and_then_it_arrives() -> None:
    first, second = followed(np.zeros(1), np.zeros(1), 1.0, 0.5)
    assert float(second[0]) == pytest.approx(0.908, abs=0.005)  # 1 - (1 + 4) exp(-4)
    first, second = followed(first, second, 1.0, 5.0)
    assert (float(first[0]), float(second[0])) == (1.0, 1.0), "what is there is quite there"


def test_a_goal_that_jumps_changes_its_speed_without_a_jump() -> None:
    dt = 1.0 / 60.0
    shown = [0.0, 0.0]
    first = second = np.zeros(1)
    for n in range(120):
        first, second = follow(first, second, np.array([float(n // 30 % 2)]), RATE, NO_HASTE, dt)
        shown.append(float(second[0]))
    assert np.abs(np.diff(shown, 2)).max() < 1.0 / 50.0


def test_what_moves_far_is_followed_sooner() -> None:
    slow = followed(np.zeros(1), np.zeros(1), 0.3, 0.1)
    fast = followed(np.zeros(1), np.zeros(1), 0.3, 0.1, np.array([60.0]))
    assert float(fast[1][0]) > 2.0 * float(slow[1][0])


def test_a_jump_is_no_motion_to_hurry_after() -> None:
    slow = followed(np.zeros(1), np.zeros(1), 1.5, 0.02)
    fast = followed(np.zeros(1), np.zeros(1), 1.5, 0.02, np.array([60.0]))
    assert float(fast[1][0]) < 1.3 * float(slow[1][0])


@given(st.floats(0.0, 100.0))
def test_a_long_gap_is_cut_into_short_steps_up_to_where_all_is_settled(seconds: float) -> None:
    steps = list(steps_of(seconds))
    assert sum(steps) == pytest.approx(min(seconds, REST_SECONDS))
    assert all(step <= LONGEST_STEP * (1 + 1e-9) for step in steps)


@given(st.floats(0.01, 2.0))
def test_one_long_gap_lands_where_frames_do(seconds: float) -> None:
    long = followed(np.zeros(1), np.zeros(1), 1.0, seconds)[1]
    first = second = np.zeros(1)
    for _ in range(int(seconds * 240) + 1):
        first, second = follow(first, second, np.ones(1), RATE, NO_HASTE, seconds / (int(seconds * 240) + 1))
    assert float(long[0]) == pytest.approx(float(second[0]), abs=0.003)


def test_the_bits_are_those_of_plain_arithmetic() -> None:
    first = 0.7
    second = 0.2
    goal = 0.4
    dt = 1.0 / 60.0
    ahead = first - goal
    square = abs(ahead) * abs(ahead)
    z = (8.0 + 60.0 * abs(ahead) / (1.0 + 39.0 * square * square)) * dt
    left = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))
    wanted = goal + ahead * left, goal + ((second - goal) + ahead * z) * left
    one, two, three, rate, haste = (np.array([x]) for x in (first, second, goal, 8.0, 60.0))
    found = follow(one, two, three, rate, haste, dt)
    assert (float(found[0][0]), float(found[1][0])) == wanted


@given(numbers, numbers, numbers, st.floats(0.5, 20.0), st.floats(0.0, LONGEST_STEP))
def test_a_number_is_followed_as_a_vector_is_to_the_bit(
    first: float, second: float, goal: float, rate: float, dt: float
) -> None:
    one = np.array([first])
    other = np.array([second])
    if dt:
        one, other = follow(one, other, np.array([goal]), np.array([rate]), NO_HASTE, dt, comes_to_rest=False)
    assert follow_number(first, second, goal, rate, dt) == (one[0], other[0])
