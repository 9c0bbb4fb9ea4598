"""The point of a pad as a goal of what it plays: the pad's name behind a word, with weight 1, and the numbers of its
place (`{":pad mouth": 1.0, ":x": 0.2, ":y": -0.5}`). No face and no expression has a name that begins with a colon."""

from __future__ import annotations

from collections.abc import Mapping

from omote.perform.limits import check_within
from omote.perform.pads.blend_space import AXES, PAD_PARTS, PLACE_RANGE, Pad, PadPlace, check_pad_name

PAD = ":pad "
"""What the name of a pad stands behind."""


def is_pad_goal(part: str, goal: Mapping[str, float]) -> bool:
    """Whether a goal of a part, `kaori/mouth` or its name there, is a point of a pad."""
    return part.rpartition("/")[2] in PAD_PARTS and any(name.startswith(PAD) for name in goal)


def goal_of_point(pad: str, place: PadPlace) -> dict[str, float]:
    """The goal that moves the point of a pad (by its name) to a place."""
    return {f"{PAD}{pad}": 1.0, **{f":{axis}": at for axis, at in zip(AXES, place, strict=False)}}


def point_of_goal(goal: Mapping[str, float]) -> tuple[str, PadPlace]:
    """The pad of a goal, by its name, and the place of its point; ValueError, TypeError where it is none."""
    names = [name for name in goal if name.startswith(PAD)]
    place = tuple(
        check_within(goal[f":{axis}"], *PLACE_RANGE, f"{axis} of a pad") for axis in AXES if f":{axis}" in goal
    )
    pad = names[0].removeprefix(PAD)
    if not place or goal != goal_of_point(pad, place):
        said = ", ".join(f"{name} = {value!r}" for name, value in goal.items())
        raise ValueError(f"a pad goes to {said[:120]}; expected its name with weight 1, and :x, :y, :z as it has them")
    return check_pad_name(pad), place


def goal_after_rename(goal: Mapping[str, float], pad: str, to: str) -> dict[str, float]:
    """A goal with the name that a pad has now, where it calls that by its name before. goal: of any part; pad: the name
    before; to: the name now."""
    return {f"{PAD}{to}" if name == f"{PAD}{pad}" else name: value for name, value in goal.items()}


def check_point_fits(pad: Pad, part: str, place: PadPlace) -> None:
    """Raises ValueError where a pad does not play a part (by its name at a character), or has no such place."""
    if pad.part != part:
        raise ValueError(f"the pad {pad.name} plays the {pad.part}, not the {part}; move it there")
    pad.check_place(place)
