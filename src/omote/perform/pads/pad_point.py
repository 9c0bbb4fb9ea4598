"""The point of a pad that plays an axis: where it is, and the mixture that follows it."""

from __future__ import annotations

from dataclasses import dataclass

from omote.perform.frame import with_fields
from omote.perform.layers.follower import LONGEST_STEP, NEAR, rate_of, steps_of
from omote.perform.mix import Weights, combine
from omote.perform.pads.blend_space import PadPlace

FOLLOW_SECONDS = 0.06
"""In which nine tenths of a step of the weights are gone: a stick that jumps shows no jump. To smooth the place instead
cures nothing, for a straight way has kinks where it passes a look."""
FACE_SECONDS = 0.2
"""The same of faces: a whole head takes longer to look natural than a mouth. A hand that crosses the pad of the cast at
2 widths a second bends its weights by .35 in 1/240 s, with .06 by .81."""
TAKE_UP_SECONDS = 0.33
"""In which what shows makes way for a pad whose point is taken up: as the speed of what was taken over dies out. In .25
a hand that takes up another pad each moment bends weights by 1/16 of what a freeze does; this leaves room below."""
NOTHING = 1e-12
"""What weighs less while a point moves is forgotten."""


@dataclass(frozen=True)
class PadPoint:
    """The point of a pad, by its name, at a place; `goal`: the mixture of its looks there. What shows follows that by
    two filters in a row, which give `first` and `second`; all sum to one. `seconds`: in which nine tenths of a step are
    gone."""

    pad: str
    place: PadPlace
    goal: Weights
    first: Weights
    second: Weights
    seconds: float = FOLLOW_SECONDS


def point_at(pad: str, place: PadPlace, mix: Weights, seconds: float = FOLLOW_SECONDS) -> PadPoint:
    """A point that stands. pad: its name; place: where; mix: what the pad shows there; seconds: in which it is
    followed."""
    return PadPoint(pad, place, mix, mix, mix, seconds)


def point_moved(point: PadPoint, place: PadPlace, mix: Weights) -> PadPoint:
    """The point at another place, where the pad shows a mix: that follows."""
    return with_fields(point, place=place, goal=mix)


def point_after(point: PadPoint, dt: float) -> PadPoint:
    """The point `dt` seconds later, the same object where nothing moves."""
    if point.second is point.goal or not dt:
        return point
    goal = point.goal
    first = point.first
    second = point.second
    rate = rate_of(point.seconds)
    for step in (dt,) if dt <= LONGEST_STEP else steps_of(dt):  # nearly always one
        first, second, farthest = _step(goal, first, second, rate * step)
    if farthest < NEAR:
        return with_fields(point, first=goal, second=goal)
    return with_fields(point, first=first, second=second)


def _step(goal: Weights, first: Weights, second: Weights, z: float) -> tuple[Weights, Weights, float]:
    """What the first and the second filter give some time later, and how far from the goal any of it is: each weight
    as of `follow_number`. goal, first, second: as of `PadPoint`; z: that time, at the rate of the filters."""
    left = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))
    later_first: dict[str, float] = {}
    later_second: dict[str, float] = {}
    farthest = 0.0
    for name in {**goal, **second, **first}:
        to = goal.get(name, 0.0)
        ahead = first.get(name, 0.0) - to
        behind = ((second.get(name, 0.0) - to) + ahead * z) * left
        ahead *= left
        if to + ahead > NOTHING:
            later_first[name] = to + ahead
        if to + behind > NOTHING:
            later_second[name] = to + behind
        if not -farthest <= ahead <= farthest:
            farthest = abs(ahead)
        if not -farthest <= behind <= farthest:
            farthest = abs(behind)
    return later_first, later_second, farthest


def point_rates(point: PadPoint) -> dict[str, float]:
    """The change of what shows per second; it sums to nothing."""
    if point.second is point.goal:
        return {}
    rate = rate_of(point.seconds)
    return combine(((rate, point.first), (-rate, point.second)))
