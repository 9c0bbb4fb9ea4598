"""A frame of a scene: its characters with their places, its light and its framing, at one instant."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from omote.perform.frame import CallStatus, Frame
from omote.perform.limits import check_within
from omote.perform.motion.sight import Point
from omote.perform.scene.movement import Ranges

PLACE_LIMITS: Ranges = {"x": (-10.0, 10.0), "depth": (0.0, 20.0), "size": (0.25, 4.0), "turn": (-math.pi, math.pi)}
"""Metres, metres, a factor, radians."""
_UNITS = {"x": " (metres)", "depth": " (metres)", "size": "", "turn": " (radians)"}
BESIDE = 0.35
"""Metres from the middle of one head to the next: their hair does not touch."""


@dataclass(frozen=True)
class Place:
    """Where a character is, as the audience sees it.

    `x`: metres to the picture's right; `depth`: metres behind the front line; `size`: a factor; `turn`: radians about
    the vertical, + to the character's own left, as the yaw of a head.
    """

    x: float = 0.0
    depth: float = 0.0
    size: float = 1.0
    turn: float = 0.0

    def __post_init__(self) -> None:
        """Rejects a place out of range."""
        for name, (low, high) in PLACE_LIMITS.items():
            number = check_within(getattr(self, name), low, high, f"the {name} of a place{_UNITS[name]}")
            object.__setattr__(self, name, number)


@dataclass(frozen=True)
class CharacterFrame:
    """A character at one instant: what it plays, where it is, how much of it is on the stage (0..1), what it is called.

    `leaves`: it was removed and will be gone.
    """

    frame: Frame
    place: Place
    presence: float
    label: str
    leaves: bool = False


@dataclass(frozen=True)
class SceneFrame:
    """The characters by name in the order in which they were added, and the mixes of lights and of framings at `time`.

    A framing is `*`, a shot of all that are on the stage, or the names of its characters, sorted and joined by `+`;
    with `:full` and the like behind it their figures are seen.
    gaze_points: the named points that eyes may look at, metres. black: how far the picture is faded to black, 0..1;
    black_goal: where that goes. memories: the names of the looks that were kept.
    """

    characters: Mapping[str, CharacterFrame]
    light: Mapping[str, float]
    framing: Mapping[str, float]
    time: float = 0.0
    light_call: CallStatus | None = None
    framing_call: CallStatus | None = None
    gaze_points: Mapping[str, Point] = field(default_factory=dict)
    black: float = 0.0
    black_goal: float = 0.0
    memories: tuple[str, ...] = ()


def free_place(taken: Iterable[Place]) -> Place:
    """The place nearest to the middle where nobody stands: right and left of it by turns."""
    others = [place.x for place in taken]
    steps = (BESIDE * (n // 2 + n % 2) * (1 if n % 2 else -1) for n in range(2 * len(others) + 1))
    return next(Place(x=x) for x in steps if all(abs(x - other) >= 0.75 * BESIDE for other in others))
