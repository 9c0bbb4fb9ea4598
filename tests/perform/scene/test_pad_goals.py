"""Points of pads as goals."""

from __future__ import annotations

import pytest

from omote.perform.scene.goals import check_goal
from omote.perform.scene.pad_goals import goal_of_point, is_pad_goal, point_of_goal


@pytest.mark.parametrize("place", [(0.5,), (0.0, -1.0), (1.0, 0.25, -0.5)])
def test_a_point_is_its_goal_and_back(place: tuple[float, ...]) -> None:
    goal = goal_of_point("mouth", place)
    assert point_of_goal(goal) == ("mouth", place)
    assert check_goal("one/mouth", goal) == goal
    assert is_pad_goal("one/mouth", goal)


def test_another_goal_or_part_has_no_point() -> None:
    assert not is_pad_goal("one/mouth", {"smile": 1.0})
    assert not is_pad_goal("*/light", {":pad mouth": 1.0, ":x": 0.0})


@pytest.mark.parametrize(
    "goal",
    [
        {":pad mouth": 0.5, ":x": 0.0},
        {":pad mouth": 1.0},
        {":pad mouth": 1.0, ":y": 0.0},
        {":pad mouth": 1.0, ":x": 0.0, "smile": 1.0},
        {":pad mouth": 1.0, ":pad eyes": 1.0, ":x": 0.0},
    ],
)
def test_what_is_no_point_is_refused_with_what_it_is(goal: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="a pad goes to :pad mouth = "):
        check_goal("one/expression", goal)
    with pytest.raises(ValueError, match="x of a pad is 2"):
        check_goal("one/expression", {":pad mouth": 1.0, ":x": 2.0})
