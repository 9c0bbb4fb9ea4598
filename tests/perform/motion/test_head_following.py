"""The head follows the gaze."""

from hypothesis import given
from hypothesis import strategies as st

from omote.perform.motion.head_following import AHEAD, EYES_ALONE, FollowingHead, Turn, follow_gaze, head_goal

ANGLES = st.floats(-1.2, 1.2)


@given(ANGLES, st.floats(-0.6, 0.6))
def test_near_shifts_leave_the_head_alone_and_far_ones_take_most_of_it(yaw: float, pitch: float) -> None:
    goal = head_goal(Turn(yaw, pitch))
    assert (goal.yaw == 0.0) == (abs(yaw) <= EYES_ALONE)
    assert abs(goal.yaw) <= abs(yaw)
    assert goal.yaw * yaw >= 0.0
    assert head_goal(Turn(-yaw, -pitch)) == Turn(-goal.yaw, -goal.pitch)


@given(ANGLES, st.floats(1e-3, 0.1))
def test_the_head_goes_there_and_never_beyond(yaw: float, dt: float) -> None:
    looked = Turn(yaw)
    head = FollowingHead()
    gone = 0.0
    for _ in range(int(4.0 / dt) + 1):
        head = follow_gaze(head, looked, dt)
        assert abs(head.second.yaw) >= gone - 1e-12
        gone = abs(head.second.yaw)
    assert abs(head.second.yaw - head_goal(looked).yaw) < 1e-3
    assert gone <= abs(head_goal(looked).yaw) + 1e-12


def test_a_head_that_is_ahead_stays() -> None:
    assert follow_gaze(FollowingHead(), AHEAD, 1.0) == FollowingHead()
