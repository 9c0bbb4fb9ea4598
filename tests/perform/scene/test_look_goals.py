"""What eyes look at as a goal."""

import pytest

from omote.perform.frame import GazeTarget
from omote.perform.scene.look_goals import goal_of_target, name_in, target_of_goal

TARGETS = (
    GazeTarget(),
    GazeTarget("stage"),
    GazeTarget("stage", "left wing"),
    GazeTarget("character", "two"),
    GazeTarget("gaze_point", "seat 7"),
    GazeTarget("direction", yaw=0.2, pitch=-0.1),
    GazeTarget("point", x=1.0, y=0.5, z=3.0),
)


@pytest.mark.parametrize("target", TARGETS)
def test_a_goal_says_the_target_that_it_was_made_of(target: GazeTarget) -> None:
    goal = goal_of_target(target)
    assert target_of_goal(goal) == target
    assert name_in(goal) == (target.name if target.kind == "character" else "")


@pytest.mark.parametrize(
    "goal",
    [
        {},
        {"two": 1.0},
        {"character": 1.0},
        {"gaze_point ": 1.0},
        {"ahead two": 1.0},
        {"character two": 0.5},
        {"character two": 0.5, "ahead": 0.5},
        {"yaw": 0.2},
        {"x": 0.0, "y": 0.0},
    ],
)
def test_what_eyes_cannot_look_at_is_rejected(goal: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="eyes cannot look at"):
        target_of_goal(goal)


def test_a_number_out_of_range_is_rejected() -> None:
    with pytest.raises(ValueError, match="give a number from"):
        target_of_goal({"yaw": 9.0, "pitch": 0.0})
