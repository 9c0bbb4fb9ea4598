"""Breath, and the noise of what is never quite still."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from omote.perform.easing import EASINGS
from omote.perform.motion.counter_hash import uniform
from omote.perform.motion.quantiles import BREATH

_BREATH = 21
_NOISE = 100
INHALE = 0.4
"""The share of a breath in which the air comes in."""
_CHEST = EASINGS["smooth"]
OCTAVES = tuple(enumerate(((7.1, 0.6), (2.3, 0.3), (0.9, 0.1))))
"""Seconds between two values of noise, and the share of each."""
LONGEST_GAP = 60.0
"""Seconds; after a longer step of time a new breath begins."""
BREATH_CHANNELS: Mapping[str, float] = {"noseSneerLeft": 0.03, "noseSneerRight": 0.03, "jawOpen": 0.012}
"""What a whole breath adds."""
NOISE_CHANNELS: Mapping[str, tuple[int, float]] = {
    "browInnerUp": (0, 0.035), "browOuterUpLeft": (0, 0.03), "browOuterUpRight": (1, 0.03),
    "cheekSquintLeft": (1, 0.02), "cheekSquintRight": (2, 0.02), "mouthPressLeft": (3, 0.03),
    "mouthPressRight": (3, 0.03), "mouthStretchLeft": (2, 0.02), "mouthStretchRight": (3, 0.02),
}  # fmt: skip
"""Which noise moves each channel, and how far it takes it, up and down."""
NOISES = 4
"""How many there are; those behind them turn the head."""
BREATH_PITCH = 0.4 * math.pi / 180.0
NOISE_HEAD = (1.1 * math.pi / 180.0, 0.8 * math.pi / 180.0, 0.6 * math.pi / 180.0)
"""Radians: what a whole breath lifts the head by, and how far noise turns it (yaw, pitch, roll)."""


@dataclass(frozen=True)
class Breath:
    """The breath that is drawn: which, when it began, how long it takes (seconds)."""

    count: int = 0
    began: float = 0.0
    seconds: float = BREATH.mean


def advance_breath(breath: Breath, seed: int, now: float) -> Breath:
    """The breath that is drawn at `now`. seed: the character's."""
    if now - breath.began > LONGEST_GAP:
        breath = Breath(breath.count, now - breath.seconds, breath.seconds)
    while now >= breath.began + breath.seconds:
        count = breath.count + 1
        breath = Breath(count, breath.began + breath.seconds, BREATH.at(uniform(seed, _BREATH, count)))
    return breath


def air(breath: Breath, now: float) -> float:
    """How much air is in, 0..1. breath: the one that is drawn; now: seconds."""
    share = min(max((now - breath.began) / breath.seconds, 0.0), 1.0)
    return _CHEST.value(share / INHALE) if share < INHALE else 1.0 - _CHEST.value((share - INHALE) / (1.0 - INHALE))


def noise(seed: int, kind: int, now: float) -> float:
    """Smooth noise at a time (seconds), -1..1, which never repeats.

    seed: the character's; kind: which of the character's noises; now: seconds.

    References
    ----------
    Value noise on a line: K. Perlin 1985, with the fade of 2002 (no acceleration jumps).
    """
    total = 0.0
    first = _NOISE + 8 * kind
    for at, (every, share) in OCTAVES:
        place = now / every
        below = math.floor(place)
        low, rise = _corners(seed, first + at, below)
        x = place - below
        total += share * (low + rise * (x * x * x * (10.0 + x * (6.0 * x - 15.0))))  # the fade, as `_CHEST`
    return total


@lru_cache(maxsize=1024)
def _corners(seed: int, kind: int, count: int) -> tuple[float, float]:
    """The value from which noise goes, -1..1, and how far it goes to the next."""
    low = 2.0 * uniform(seed, kind, count) - 1.0
    return low, 2.0 * uniform(seed, kind, count + 1) - 1.0 - low
