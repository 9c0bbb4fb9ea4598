"""The springs of the built-in cast: what of its faces swings, how fast, and by what it is driven."""

from __future__ import annotations

from collections.abc import Container, Mapping
from types import MappingProxyType
from typing import Literal, get_args

from omote.perform.limits import check_known
from omote.perform.springs.spring import Spring

SpringName = Literal["ears-sway", "ears-flap", "jowls-sway", "cheeks-bounce"]
SPRING_NAMES: tuple[SpringName, ...] = get_args(SpringName)

_SPRINGS: dict[SpringName, Spring] = {
    "ears-sway": Spring("ears-sway", 2.0, 0.2, {"yaw": 1.0, "roll": 1.0, "x": 3.0}, 4.0),
    "ears-flap": Spring("ears-flap", 2.2, 0.22, {"pitch": 1.0}, 4.5),
    "jowls-sway": Spring("jowls-sway", 3.0, 0.25, {"yaw": 1.0, "roll": 0.7, "x": 3.0}, 6.0),
    "cheeks-bounce": Spring("cheeks-bounce", 5.0, 0.35, {"pitch": 1.0, "jawOpen": -0.12}, 12.0),
}
SPRINGS: Mapping[SpringName, Spring] = MappingProxyType(_SPRINGS)
"""By name. A cast has those whose channels it has, and a face shows them by its gains."""


def check_spring(name: object) -> SpringName:
    """The spring of this name; ValueError with those that there are where there is none."""
    return check_known(name, SPRINGS, "spring")


def springs_of(names: Container[str]) -> dict[SpringName, Spring]:
    """The springs of a cast. names: of its expressions."""
    return {name: spring for name, spring in SPRINGS.items() if spring.channel in names}


_PLAYED = frozenset(spring.channel for spring in _SPRINGS.values())


def without_springs(channels: Mapping[str, float], hands: Mapping[str, float] | None) -> dict[str, float]:
    """The channels without what springs add, which they add anew wherever this is played: of what they play, what hands
    hold.

    channels: as they show; hands: what hands hold, None where that is what shows.
    """
    if hands is None or _PLAYED.isdisjoint(channels):
        return dict(channels)
    shown = {name: weight for name, weight in channels.items() if name not in _PLAYED}
    return shown | {name: weight for name, weight in hands.items() if name in _PLAYED}
