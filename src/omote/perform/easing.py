"""How a weight moves in time: easings, the decay of a velocity, the glide of a hand
(docs/method.md, "Interrupted calls").

Everything is a polynomial of time since its start, so one large step lands exactly where many small ones do. Powers
are written as products: `pow` of a C library is not correctly rounded, so a replay on another would end in other bits.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Values
from omote.perform.mix import HIGHEST, LOWEST, Weights

DECAY_SECONDS = 0.33
"""A velocity taken over dies out in this time, or in the time of the call where that is shorter."""
HAND_SECONDS = 0.06
"""A step of a T-bar is followed in this time."""
STILL = 1e-12
"""Per second; a slower weight is at rest."""
DEFAULT_EASING = "smooth"


@dataclass(frozen=True)
class Easing:
    """A polynomial from 0 at 0 to 1 at 1 with no slope at either end; coefficients from the constant up."""

    coefficients: tuple[float, ...]

    def __post_init__(self) -> None:
        """Rejects a curve whose ends would jump."""
        ends = (self.value(0.0), self.value(1.0), self.rate(0.0), self.rate(1.0))
        if not np.allclose(ends, (0.0, 1.0, 0.0, 0.0), atol=1e-12):
            raise ValueError(f"an easing goes from 0 to 1 with no slope at its ends; this one gives {ends}")

    def value(self, x: float) -> float:
        """The share of the way at the share `x` of the time."""
        total = 0.0
        for coefficient in reversed(self.coefficients):
            total = total * x + coefficient
        return total

    def rate(self, x: float) -> float:
        """The derivative of `value` by `x`."""
        total = 0.0
        for power in range(len(self.coefficients) - 1, 0, -1):
            total = total * x + power * self.coefficients[power]
        return total


EASINGS: Mapping[str, Easing] = {
    "smooth": Easing((0, 0, 0, 10, -15, 6)),  # quintic: no acceleration at the ends either
    "gentle": Easing((0, 0, 3, -2)),  # cubic: the slowest peak
    "sharp": Easing((0, 0, 0, 0, 35, -84, 70, -20)),  # septic: waits, moves, waits
    "early": Easing((0, 0, 10, -20, 15, -4)),  # most of the way at once, the rest slowly
    "late": Easing((0, 0, 0, 0, 5, -4)),  # early, backwards
}


@dataclass(frozen=True)
class Glide:
    """A T-bar's way from `origin`, where it moved at `rate` per second, to rest at `goal`; `elapsed` of `seconds`."""

    origin: float
    rate: float
    goal: float
    seconds: float
    elapsed: float = 0.0


def find_easing(name: str) -> Easing:
    """Finds an easing by name; ValueError that lists all of them for an unknown one."""
    if name not in EASINGS:
        raise ValueError(f"there is no easing {name!r}; choose one of {', '.join(EASINGS)}")
    return EASINGS[name]


def bump(u: float) -> float:
    """The quintic with slope 1 at 0, no curvature there, and nothing at all left at 1."""
    left = 1.0 - u
    return u * (left * left * left) * (1.0 + 3.0 * u) if u < 1.0 else 0.0


def bump_rate(u: float) -> float:
    """The derivative of `bump`."""
    return 1.0 - u * u * (18.0 - u * (32.0 - 15.0 * u)) if u < 1.0 else 0.0


def decay_seconds(start: Weights, velocity: Weights, goal: Weights, seconds: float | None, easing: Easing) -> float:
    """The one time in which all velocities of an axis die out: short enough that no weight leaves its range.

    start, velocity, goal: the mixes, and their change per second; seconds, easing: as of `decays`.
    """
    names = [name for name, rate in velocity.items() if abs(rate) > STILL]
    if not names:
        return 0.0
    rates = np.array([velocity[name] for name in names])
    starts = np.array([start.get(name, 0.0) for name in names])
    goals = np.array([goal.get(name, 0.0) for name in names])
    return float(decays(starts, rates, goals, seconds, easing).min())


def decays(starts: Values, rates: Values, goals: Values, seconds: float | None, easing: Easing) -> Values:
    """The time (n) in which each velocity dies out, if it were alone: short enough that its weight stays in range.

    starts, goals: weights (n); rates: their change per second, not 0; seconds: of the call, None by hand; easing: the
    curve of the way.

    A weight is at most base + velocity * decay * bump, and its base goes the way of the easing (by hand: anywhere
    between start and goal), so the longest decay is the least room over velocity * bump.
    """
    longest = DECAY_SECONDS if seconds is None else min(seconds, DECAY_SECONDS)
    starts = starts[:, None]
    rates = rates[:, None]
    goals = goals[:, None]
    towards = (goals - starts) * rates > 0.0
    base = starts + np.where(towards, goals - starts, 0.0) * (1.0 if seconds is None else _sample_easing(easing))
    room = np.where(rates > 0.0, HIGHEST - base, base - LOWEST)
    longest_each: Values = (room / (np.abs(rates) * _BUMPS)).min(axis=1)
    return np.minimum(longest, np.maximum(0.0, longest_each))


def plan_glide(origin: float, rate: float, goal: float, seconds: float) -> Glide:
    """Plans the way from `origin` at `rate` to rest at `goal`, shortened where it would pass the goal or leave 0..1.

    seconds: how long the way takes.

    A cubic from a slope to none is monotone up to slope * time = 3 * distance (Fritsch & Carlson 1980); a slope that
    points away from the goal carries at most 4/27 of slope * time past the origin.
    """
    reach = goal - origin
    if rate * reach > 0.0:
        seconds = min(seconds, 3.0 * reach / rate)
    elif rate:
        room = (1.0 - origin) if rate > 0.0 else origin
        seconds = min(seconds, 6.75 * max(room, 0.0) / abs(rate))
    return Glide(origin, rate, goal, seconds)


def glide_state(way: Glide) -> tuple[float, float]:
    """The position of a glide now, and its rate per second."""
    if way.elapsed >= way.seconds:
        return way.goal, 0.0
    u = way.elapsed / way.seconds
    reach = way.goal - way.origin
    carried = way.rate * way.seconds
    left = 1.0 - u
    value = way.origin + reach * u * u * (3.0 - 2.0 * u) + carried * u * (left * left)
    return value, (reach * 6.0 * u * left + carried * left * (1.0 - 3.0 * u)) / way.seconds


def glide_after(way: Glide, dt: float) -> Glide:
    """The same glide `dt` seconds later. way: the glide."""
    return replace(way, elapsed=way.elapsed + dt)


def is_over(elapsed: float, seconds: float) -> bool:
    """Whether a span of `seconds` has passed, up to the rounding of summed time steps. elapsed: seconds so far."""
    return elapsed >= seconds or math.isclose(elapsed, seconds, rel_tol=1e-9)


_GRID = np.arange(1, 32) / 32.0
_BUMPS = np.array([bump(u) for u in _GRID])


def _sample_easing(easing: Easing) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.array([easing.value(u) for u in _GRID])
