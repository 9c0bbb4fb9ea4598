"""What eyes look at as a goal: a name with what it is (`character two`, `gaze_point seat`, `stage`), or numbers."""

from __future__ import annotations

from typing import get_args

from omote.perform.frame import GazeTarget, TargetKind

AHEAD = {"ahead": 1.0}
NUMBERED: dict[TargetKind, tuple[str, ...]] = {"direction": ("yaw", "pitch"), "point": ("x", "y", "z")}


def goal_of_target(target: GazeTarget) -> dict[str, float]:
    """The goal that brings eyes to a target."""
    if target.kind in NUMBERED:
        return {name: getattr(target, name) for name in NUMBERED[target.kind]}
    return {f"{target.kind} {target.name}".rstrip(): 1.0}


def target_of_goal(goal: dict[str, float]) -> GazeTarget:
    """The target of a goal; ValueError, TypeError where eyes cannot look there."""
    for numbered, numbers in NUMBERED.items():
        if goal.keys() == {*numbers}:
            return GazeTarget(numbered, **goal)  # type: ignore[arg-type]
    written = next(iter(goal), "")
    kind, _, name = written.partition(" ")
    kinds = {"stage": True, "character": name != "", "gaze_point": name != "", "ahead": name == ""}
    if len(goal) != 1 or goal[written] != 1.0 or not kinds.get(kind):
        raise ValueError(
            f"eyes cannot look at {', '.join(goal)[:80]!r}; give ahead, stage, stage NAME, character NAME, gaze_point "
            "NAME, a direction (yaw, pitch) or a point (x, y, z)"
        )
    return GazeTarget(next(each for each in get_args(TargetKind) if each == kind), name)


def name_in(goal: dict[str, float]) -> str:
    """The character that a goal names; "" for none."""
    kind, _, name = next(iter(goal), "").partition(" ")
    return name if kind == "character" else ""
