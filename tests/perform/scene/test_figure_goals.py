"""Goals of a figure read what is called, and call what is read."""

from __future__ import annotations

from omote.perform.axis import goal_of, repaced
from omote.perform.figures.figure_axes import AT_REST, on_all
from omote.perform.scene.figure_goals import called_figure, figure_goal
from omote.perform.scene.goals import BODY, POSE, POSE_PARTS, WITH_FACE


def test_what_is_called_of_a_part_is_its_goal_and_a_whole_pose_takes_its_regions() -> None:
    figure = None
    for part, goal in ((POSE, {"bow": 1.0}), (BODY, {"heavy": 1.0}), *((part, {"wave": 1.0}) for part in POSE_PARTS)):
        figure = called_figure(figure, part, goal, 1.0, "smooth", None)
        assert figure_goal(figure, part, goal_of) == goal
    whole = called_figure(figure, POSE, {"point": 1.0}, 1.0, "smooth", None)
    assert all(figure_goal(whole, part, goal_of) == {"point": 1.0} for part in (POSE, *POSE_PARTS))
    assert called_figure(AT_REST, POSE_PARTS[0], WITH_FACE, 1.0, "smooth", None) == AT_REST
    assert figure_goal(None, POSE_PARTS[0], goal_of) == WITH_FACE


def test_a_pace_holds_what_was_called_with_one() -> None:
    figure = called_figure(None, POSE, {"bow": 1.0}, 1.0, "smooth", 1.0)
    held = on_all(figure, lambda on: repaced(on, 0.0))
    assert held is not None
    assert held.pose.call is not None
    assert held.pose.call.pace == 0.0
    assert held.body == figure.body
    assert on_all(None, lambda on: on) is None
