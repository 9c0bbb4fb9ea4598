"""Fixations and saccades."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion.gaze_motion import (
    DEGREE,
    LIDS_LEAD,
    GazeMotion,
    advance_gaze,
    blink_share,
    looked_at,
)
from omote.perform.motion.head_following import AHEAD, Turn

SEEDS = st.integers(0, 2**31 - 1)
STEP = 1 / 240


def far(one: Turn, other: Turn) -> float:
    """Degrees between two directions."""
    way = one - other
    return math.hypot(way.yaw, way.pitch) / DEGREE


@given(SEEDS)
def test_eyes_rest_or_go_by_the_main_sequence(seed: int) -> None:
    """Between two saccades nothing moves; a saccade takes 21 ms and 2.2 ms for each degree."""
    motion = GazeMotion()
    now = 0.0
    for _ in range(2400):
        before = motion
        now = now + STEP
        motion = advance_gaze(motion, seed, now, AHEAD, reach=1.0)
        if motion.count == before.count:
            continue
        way = far(motion.saccade.origin, motion.saccade.goal)
        assert motion.saccade.seconds == pytest.approx(0.021 + 0.0022 * way)
        assert far(looked_at(before, now), motion.saccade.origin) < 1e-9  # from where they were
        end = motion.saccade.began + motion.saccade.seconds
        assert motion.fixation > end
        assert far(looked_at(motion, end), looked_at(motion, motion.fixation)) < 1e-9


@given(SEEDS, st.floats(0.0, 0.04))
def test_what_moves_slowly_is_followed_without_a_saccade_of_its_own(seed: int, rate: float) -> None:
    motion = GazeMotion()
    for step in range(1, 100):
        seen = Turn(rate * step * STEP * 10)
        motion = advance_gaze(motion, seed, step * STEP, seen, reach=0.0)
        assert motion.seen == seen


@given(SEEDS, st.floats(0.1, 0.6), st.floats(-0.3, 0.3))
def test_what_is_elsewhere_at_once_is_reached_by_a_saccade_that_begins_where_the_eyes_are(
    seed: int, yaw: float, pitch: float
) -> None:
    motion = advance_gaze(GazeMotion(), seed, 0.1, AHEAD, reach=1.0)
    before = looked_at(motion, 0.1)
    seen = Turn(yaw, pitch)
    motion = advance_gaze(motion, seed, 0.1, seen, reach=1.0)
    assert far(looked_at(motion, 0.1), before) < 1e-9
    assert motion.contact
    assert far(looked_at(motion, 0.3), seen) < 3.0


@given(SEEDS)
def test_without_reach_the_eyes_stay_at_what_is_looked_at(seed: int) -> None:
    motion = GazeMotion()
    for step in range(1, 600):
        motion = advance_gaze(motion, seed, step / 60, AHEAD, reach=0.0)
        assert looked_at(motion, step / 60) == AHEAD


def test_far_shifts_always_come_with_a_blink_and_near_ones_seldom() -> None:
    assert blink_share(LIDS_LEAD) == 1.0
    shares = [blink_share(degrees * DEGREE) for degrees in range(40)]
    assert shares == sorted(shares)
    assert shares[3] < 0.1
