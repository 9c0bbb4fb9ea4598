"""A stream of visemes, of which only the past is known, as a mouth that moves without a jump."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from omote.arrays import Values
from omote.perform.layers.follower import rate_of, steps_of
from omote.perform.limits import FOREVER, check_within
from omote.perform.speech.visemes import FF, PP, SIL, VISEMES, mouth_of

VOWEL_SECONDS = 0.08
CLOSURE_SECONDS = 0.05
"""In which the weight of a viseme goes nine tenths of its way: lips that close are quicker than a jaw that opens."""
_RATES = np.full(len(VISEMES), rate_of(VOWEL_SECONDS))
_RATES[[PP, FF]] = rate_of(CLOSURE_SECONDS)


def _silence() -> Values:
    weights = np.zeros(len(VISEMES))
    weights[SIL] = 1.0
    return weights


@dataclass(frozen=True, eq=False)
class VisemeStream:
    """Weights of the visemes (15,) behind the first and the second filter; begins in silence."""

    first: Values = field(default_factory=_silence)
    second: Values = field(default_factory=_silence)

    @property
    def mouth(self) -> Values:
        """The mouth now, weights of `MOUTH_UNITS`."""
        return mouth_of(self.second)


def check_weights(weights: Values) -> Values:
    """Returns weights of visemes as shares that sum to one; ValueError for other than 15 numbers of 0 to 1."""
    shares = np.asarray(weights, np.float64)
    if shares.shape != (len(VISEMES),):
        raise ValueError(f"the visemes are of the shape {shares.shape}; give 15 weights, of {', '.join(VISEMES)}")
    for viseme, weight in zip(VISEMES, shares.tolist(), strict=True):
        check_within(weight, 0.0, 1.0, f"the weight of the viseme {viseme}")
    return shares


def follow_visemes(stream: VisemeStream, weights: Values, level: float, dt: float) -> VisemeStream:
    """The stream `dt` seconds later, while a classifier gives these weights.

    Parameters
    ----------
    stream : VisemeStream
        As it is.
    weights : array (15,)
        Probabilities in the order of `VISEMES`, 0 to 1 each.
    level : float
        How loud it is, 0 (silence: the mouth goes to rest) to 1 (the visemes in full).
    dt : float
        Seconds since the last weights, 0 or more.

    Returns
    -------
    VisemeStream
        Frozen; neither its value nor its speed jumps.

    Raises
    ------
    ValueError
        On other than 15 weights of 0 to 1, and a level out of 0 to 1.
    """
    dt = check_within(dt, 0.0, FOREVER, "the time step (seconds)")
    goal = check_weights(weights) * check_within(level, 0.0, 1.0, "the level of a voice")
    goal[SIL] += 1.0 - level
    first = stream.first
    second = stream.second
    for step in steps_of(dt):
        z = _RATES * step
        left = 1.0 / (1.0 + z * (1.0 + z * (0.48 + z * 0.235)))
        ahead = first - goal
        first = goal + ahead * left
        second = goal + ((second - goal) + ahead * z) * left
    return VisemeStream(first, second)
