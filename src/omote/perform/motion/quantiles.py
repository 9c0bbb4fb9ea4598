"""The statistics of automatic motion, each as a table of quantiles (inverse distribution), with its source.

Tables are rounded when they are made, so that no platform's exp or log shows in a replay; between two entries a
quantile is linear.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

ENTRIES = 64
LOWEST = 0.002
HIGHEST = 0.998
"""The quantiles at the ends of a table: what is rarer does not come."""


@dataclass(frozen=True)
class Quantiles:
    """A distribution by its quantiles at even steps."""

    values: tuple[float, ...]

    def __post_init__(self) -> None:
        """Rejects what is no inverse distribution."""
        if len(self.values) < 2 or list(self.values) != sorted(self.values):
            raise ValueError(f"the quantiles are {self.values}; expected two or more, rising")

    def at(self, share: float) -> float:
        """The value that a share (0 to 1) of all lies below."""
        place = share * (len(self.values) - 1)
        below = min(int(place), len(self.values) - 2)
        low = self.values[below]
        high = self.values[below + 1]
        return low + (high - low) * (place - below)

    @property
    def mean(self) -> float:
        """The mean of all values."""
        inner = math.fsum(self.values[1:-1])
        return (inner + (self.values[0] + self.values[-1]) / 2.0) / (len(self.values) - 1)


def lognormal(mean: float, spread: float, low: float, high: float) -> Quantiles:
    """The quantiles of a lognormal distribution of a mean, `spread` wide (of the logarithm), kept within two ends.

    low: the least value; high: the largest value.
    """
    centre = math.log(mean) - spread * spread / 2.0
    normal = NormalDist(centre, spread)
    return Quantiles(tuple(round(min(max(math.exp(normal.inv_cdf(share)), low), high), 6) for share in _shares()))


def even(low: float, high: float) -> Quantiles:
    """The quantiles of an even distribution. low: the least value; high: the largest value."""
    return Quantiles((low, high))


def _shares() -> list[float]:
    return [LOWEST + (HIGHEST - LOWEST) * place / (ENTRIES - 1) for place in range(ENTRIES)]


BLINK_PAUSE = lognormal(8.0, 0.8, 0.6, 40.0)
"""Seconds until somebody blinks whom no shift of the gaze makes blink; with those that do, 17 a minute at rest
(Bentivoglio et al. 1997, *Movement Disorders* 12)."""
SPEECH_BLINKS = 2.6
"""How much sooner that is for somebody who speaks: 26 a minute in all (the same)."""
BLINK_DOWN = even(0.10, 0.15)
BLINK_UP = even(0.20, 0.25)
"""Seconds in which lids close and open (VanderWerf et al. 2003, *Journal of Neurophysiology* 89)."""
BLINK_DEPTH = Quantiles((0.55, 0.9, 1.0, 1.0, 1.0, 1.0))
"""How far lids close: some blinks are incomplete."""
CONTACT_SPELL = lognormal(2.6, 0.5, 1.0, 5.0)
AWAY_SPELL = lognormal(1.5, 0.6, 0.5, 4.0)
"""Seconds of eye contact, and of looking elsewhere (Argyle and Ingham 1972: mutual gaze of 1 to 5 s)."""
MUTUAL_SPELL = lognormal(2.7, 0.45, 1.15, 4.9)
"""Seconds for which two who look at one another meet each other's eyes (the same)."""
CONTACT_FIXATION = lognormal(0.9, 0.5, 0.25, 3.0)
AWAY_FIXATION = lognormal(0.6, 0.5, 0.2, 2.5)
"""Seconds that the eyes rest between two saccades."""
CONTACT_STEP = even(0.4, 2.4)
"""Degrees from the point that is looked at: the eyes go between the eyes and the mouth of another."""
AWAY_STEP = lognormal(13.0, 0.5, 4.0, 32.0)
"""Degrees by which somebody looks away (Lee, Badler and Badler 2002, "Eyes alive": conversational saccades)."""
BREATH = lognormal(4.3, 0.08, 3.75, 5.0)
"""Seconds of a breath: 12 to 16 a minute."""
