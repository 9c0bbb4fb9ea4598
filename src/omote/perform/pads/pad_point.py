"""The point of a pad that plays an axis: where it is, and the mixture that follows it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from omote.perform.frame import with_fields
from omote.perform.layers.follower import NEAR, rate_of, steps_of
from omote.perform.mix import Weights, combine
from omote.perform.pads.blend_space import PadPlace

FOLLOW_SECONDS = 0.06
"""In which nine tenths of a step of the weights are gone: a stick that jumps shows no jump. To smooth the place instead
cures nothing, for a straight way has kinks where it passes a look."""
TAKE_UP_SECONDS = 0.25
"""In which what shows makes way for a pad whose point is taken up: as soon as a panic is over."""
NOTHING = 1e-12
"""What weighs less while a point moves is forgotten."""
_RATE = rate_of(FOLLOW_SECONDS)


@dataclass(frozen=True)
class PadPoint:
    """The point of a pad, by its name, at a place; `goal`: the mixture of its looks there. What shows follows that by
    two filters in a row, which give `first` and `second`; all sum to one."""

    pad: str
    place: PadPlace
    goal: Weights
    first: Weights
    second: Weights


def point_at(pad: str, place: PadPlace, mix: Weights) -> PadPoint:
    """A point that stands. pad: its name; place: where; mix: what the pad shows there."""
    return PadPoint(pad, place, mix, mix, mix)


def point_moved(point: PadPoint, place: PadPlace, mix: Weights) -> PadPoint:
    """The point at another place, where the pad shows a mix: that follows."""
    return with_fields(point, place=place, goal=mix)


def point_after(point: PadPoint, dt: float) -> PadPoint:
    """The point `dt` seconds later, the same object where nothing moves."""
    if point.second is point.goal or not dt:
        return point
    names = dict.fromkeys((*point.goal, *point.second, *point.first), 0.0)
    first = {**names, **point.first}
    second = {**names, **point.second}
    farthest = 0.0
    for step in steps_of(dt):
        z = _RATE * step
        left = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))  # as of `follow_number`
        farthest = 0.0
        for name in names:
            goal = point.goal.get(name, 0.0)
            ahead = first[name] - goal
            behind = ((second[name] - goal) + ahead * z) * left
            ahead *= left
            first[name] = goal + ahead
            second[name] = goal + behind
            farthest = max(farthest, abs(ahead), abs(behind))
    if farthest < NEAR:
        return with_fields(point, first=point.goal, second=point.goal)
    return with_fields(point, first=_seen(first), second=_seen(second))


def point_rates(point: PadPoint) -> dict[str, float]:
    """The change of what shows per second; it sums to nothing."""
    if point.second is point.goal:
        return {}
    return combine(((_RATE, point.first), (-_RATE, point.second)))


def _seen(mix: Mapping[str, float]) -> dict[str, float]:
    return {name: weight for name, weight in mix.items() if weight > NOTHING}
