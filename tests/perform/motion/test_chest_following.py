"""The chest that follows the head."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

import omote
from omote import Cast
from omote.perform.limits import HEAD_LIMITS
from omote.perform.motion.chest_following import AT_HOME, FARTHEST, HEAD_ALONE, chest_goal, follow_head

FAR = HEAD_LIMITS["yaw"]
yaws = st.floats(-FAR, FAR)


@given(yaws, yaws)
def test_a_chest_goes_where_the_head_goes_less_far_and_not_for_a_glance(one: float, other: float) -> None:
    goals = chest_goal(one), chest_goal(other)
    assert goals[0] == -chest_goal(-one)
    assert abs(goals[0]) <= 1.0
    assert abs(goals[0] * FARTHEST) <= abs(one)
    assert (abs(one) > HEAD_ALONE) or goals[0] == 0.0
    assert (goals[0] - goals[1]) * (one - other) >= 0.0


@given(st.lists(yaws, min_size=2, max_size=6), st.floats(1 / 120, 1 / 10))
def test_a_chest_never_goes_beyond_its_goals_and_comes_to_rest_there(heads: list[float], dt: float) -> None:
    chest = AT_HOME
    far = max(abs(chest_goal(yaw)) for yaw in heads)
    for yaw in heads:
        for _ in range(5):
            chest = follow_head(chest, yaw, dt)
            assert abs(chest[1]) <= far + 1e-12
    for _ in range(round(8.0 / dt)):
        chest = follow_head(chest, heads[-1], dt)
    assert chest[1] == pytest.approx(chest_goal(heads[-1]), abs=1e-6)


def test_a_performer_brings_its_chest_after_its_head(cast: Cast) -> None:
    performer = omote.Performer(cast)
    performer.set_head(1.0, 0.0, 0.0)
    frames = [performer.advance(dt) for dt in [0.0, *[1 / 60] * 180]]
    turned = [frame.idle[2] for frame in frames]
    assert turned[0] == 0.0
    assert turned[54] == pytest.approx(0.9 * chest_goal(1.0), abs=0.03), "nine tenths in CHEST_SECONDS"
    assert all(after >= before for before, after in pairwise(turned))
    assert omote.Performer.restored(cast, performer.snapshot()).advance(0.0).idle == frames[-1].idle
    performer.set_head(0.0, 0.0, 0.0)
    for _ in range(600):
        frame = performer.advance(1 / 60)
    assert frame.idle == (0.0, 0.0, 0.0)
