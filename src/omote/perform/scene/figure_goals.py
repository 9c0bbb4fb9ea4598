"""The goals of a figure: its pose, the poses of its regions, and its body, read and called."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from omote.model.body.pose_regions import check_pose_region
from omote.perform.axis import Axis, call_part, called_to_mix, goal_of, plays_same_pad, with_pace
from omote.perform.figures.figure_axes import AT_REST, FigureAxes
from omote.perform.scene.goals import BODY, POSE, POSE_PART, WITH_FACE, Goal


def figure_goal(figure: FigureAxes | None, name: str, mix: Callable[[Axis], Goal]) -> Goal:
    """Where a part of a figure goes, or what it shows; nothing for a region that goes with the whole figure.

    figure: as it is; name: pose, pose:arm_left and the other regions, or body; mix: what is read of an axis.
    """
    here = figure or AT_REST
    if name == BODY:
        return dict(mix(here.body))
    if name == POSE:
        return dict(mix(here.pose))
    own = here.regions.get(check_pose_region(name.removeprefix(POSE_PART)))
    return WITH_FACE if own is None or plays_same_pad(own, here.pose) else dict(mix(own))


def called_figure(
    figure: FigureAxes | None, name: str, goal: Goal, seconds: float, easing: str, pace: float | None
) -> FigureAxes:
    """The figure with a part of it called to a goal. figure, name: as of `figure_goal`; goal, seconds, easing and pace:
    as of `Scene.call_goal`."""
    here = figure or AT_REST

    def call(on: Axis) -> Axis:
        return with_pace(called_to_mix(on, goal or goal_of(here.pose), seconds, easing), pace)

    if name == BODY:
        return replace(here, body=call(here.body))
    region = None if name == POSE else check_pose_region(name.removeprefix(POSE_PART))
    if region is not None and not goal and region not in here.regions:
        return here  # it goes with the whole figure already
    pose, regions = call_part(here.pose, here.regions, region, call)
    return replace(here, pose=pose, regions=regions)
