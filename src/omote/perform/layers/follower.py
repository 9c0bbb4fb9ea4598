"""The follower: a goal that jumps, followed without a jump in value or speed; of +, -, * and / alone, so that a show
replays bit for bit on any machine."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache
from types import ModuleType

import numpy as np

from omote.arrays import Values

LONGEST_STEP = 1.0 / 40.0
"""Seconds; a longer gap is cut into steps, so that the series stands for the exponential (rate times step below 2)."""
REST_SECONDS = 8.0
"""Seconds after which all is where it goes: what a gap lasts beyond is not stepped through."""
JUMP = 39.0
"""Makes the haste largest at a distance of 0.3, where a lid that closes is ahead of its follower."""
NEAR = 1e-7
"""What is nearer to its goal is there."""


def rate_of(seconds: float) -> float:
    """The rate of both poles (1/s) at which a follower has gone nine tenths of its way in so many seconds."""
    return 4.0 / seconds


def steps_of(dt: float) -> Iterator[float]:
    """A gap (seconds) as steps that are short enough to follow in, up to where all is at rest."""
    rest = min(dt, REST_SECONDS)
    count = math.ceil(rest / LONGEST_STEP)
    for _ in range(count):
        yield rest / count


def follow(
    first: Values, second: Values, goal: Values, rate: Values, haste: Values, dt: float, *, comes_to_rest: bool = True
) -> tuple[Values, Values]:
    """Two one-pole filters in a row, `dt` seconds later: what the first and the second give, arrays (n,), contiguous.

    Both stay between what they were and the goal. rate: of both poles, 1/s; haste: what a distance from the goal adds
    to it, so that what moves fast is followed closely and what trembles is smoothed (the idea of the One-Euro filter,
    without its kink); a distance that no motion covers in a frame is a jump, and adds nothing. comes_to_rest:
    what is near its goal is there.
    """
    later_first = np.empty_like(goal)
    later_second = np.empty_like(goal)
    near = NEAR if comes_to_rest else 0.0
    load_kernels().follow_all(first, second, goal, rate, haste, dt, JUMP, near, later_first, later_second)
    return later_first, later_second


@cache
def load_kernels() -> ModuleType:
    """The kernels of layers, loaded when the first layer is driven: no command line needs Numba."""
    from omote.perform.layers import layer_kernels

    return layer_kernels


def follow_number(first: float, second: float, goal: float, rate: float, dt: float) -> tuple[float, float]:
    """The same for one number without haste, to the bit; a gap of any length is cut into steps.

    first: after the first filter; second: after both; goal: where it goes; rate: of both poles, 1/s; dt: seconds.
    """
    for step in (dt,) if 0.0 < dt <= LONGEST_STEP else steps_of(dt):  # nearly always one
        z = rate * step
        left = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))
        ahead = first - goal
        first = goal + ahead * left
        second = goal + ((second - goal) + ahead * z) * left
    return first, second
