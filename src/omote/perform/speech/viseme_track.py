"""Visemes of which the times are known, as a mouth at any instant: what comes shapes what is (coarticulation)."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from omote.arrays import Values
from omote.perform.easing import EASINGS
from omote.perform.limits import check_within
from omote.perform.speech.visemes import FF, PP, SIL, VISEMES, mouth_of

LONGEST_SPEECH = 600.0
"""Seconds."""
MOST_VISEMES = 8000
LEAD_SECONDS = 0.15
"""How long before its time a mouth begins to form the first viseme, and so the least that a speech begins before."""
VOWEL_LEAD = 0.13
VOWEL_LAG = 0.07
CONSONANT_LEAD = 0.07
CONSONANT_LAG = 0.05
SILENCE_LEAD = 0.08
SILENCE_LAG = 0.0
"""How long before a viseme a mouth begins to form it, and how long after it that is seen, seconds."""
INSET = 0.3
LONGEST_INSET = 0.05
"""A viseme is in full this share of its length within its borders, at most so many seconds."""
CLOSER = 1.5
YIELD = 0.9
"""How much more a closure weighs, and how much all else yields to it while it lasts."""
CLOSURE_EDGE = 0.03
_BEFORE = 4
_AFTER = 5
"""Visemes around an instant that can be seen in it; one lasts 10 ms at least, and shorter ones are hardly seen."""
_VOWELS = frozenset(VISEMES.index(name) for name in ("aa", "E", "I", "O", "U"))
_RISE = EASINGS["smooth"]


@dataclass(frozen=True)
class VisemeTrack:
    """Visemes one after the other.

    Parameters
    ----------
    starts : tuple of float
        When each begins, seconds, none before the last; it lasts until the next does.
    visemes : tuple of int
        Places among `VISEMES`.
    seconds : float
        The end of the last, to 600.

    Raises
    ------
    ValueError
        On times that go back or beyond, on places that there are not, on other than one time for each.
    TypeError
        On what is no number.
    """

    starts: tuple[float, ...]
    visemes: tuple[int, ...]
    seconds: float

    def __post_init__(self) -> None:
        """Rejects what cannot be spoken."""
        if len(self.starts) != len(self.visemes):
            raise ValueError(f"{len(self.starts)} times came for {len(self.visemes)} visemes; send one for each")
        if len(self.starts) > MOST_VISEMES:
            raise ValueError(f"the speech has {len(self.starts)} visemes; at most {MOST_VISEMES}: say it in parts")
        before = 0.0
        for place, at in enumerate(self.starts):
            check_within(at, 0.0, LONGEST_SPEECH, f"the time of viseme {place + 1} (seconds)")
            if at < before:
                raise ValueError(f"the time of viseme {place + 1} is {at:g} s, before the last one's {before:g} s")
            before = at
        for viseme in self.visemes:
            if viseme not in range(len(VISEMES)):
                raise ValueError(f"there is no viseme {viseme}; expected 0 to {len(VISEMES) - 1}")
        check_within(self.seconds, before, LONGEST_SPEECH, "the length of a speech (seconds)")


EMPTY_TRACK = VisemeTrack((), (), 0.0)


def mouth_at(track: VisemeTrack, time: float) -> Values:
    """The mouth at a time, weights of `MOUTH_UNITS`.

    Each viseme weighs what a smooth curve says that begins before it and ends after it, sooner for vowels than for
    consonants; while lips are to be closed all else yields, so that they are, however short that is.

    Parameters
    ----------
    track : VisemeTrack
        What is said.
    time : float
        Seconds since its beginning; before and after it the mouth goes from and to rest.

    Returns
    -------
    array (len(MOUTH_UNITS),)
        Weights 0 to 1, without a jump in time.

    References
    ----------
    Cohen, M. M., and Massaro, D. W. (1993): Modeling coarticulation in synthetic visual speech.
    """
    weights = np.zeros(len(VISEMES))
    closers = np.zeros(len(VISEMES))
    closed = 0.0
    for viseme, start, end in _around(track, time):
        weight = _weight(viseme, start, end, time)
        if viseme in (PP, FF):
            closers[viseme] += CLOSER * weight
            inset = _inset(start, end)
            edges = start - CLOSURE_EDGE, start + inset, end - inset, end + CLOSURE_EDGE
            closed = max(closed, _bump(time, *edges))
        else:
            weights[viseme] += weight
    return mouth_of(weights * (1.0 - YIELD * closed) + closers)


def _around(track: VisemeTrack, time: float) -> Iterator[tuple[int, float, float]]:
    """The visemes near a time, with their begins and ends; silence before the first and after the last."""
    starts = track.starts
    count = len(track.starts)
    here = bisect_right(starts, time) - 1
    if here < _BEFORE:
        yield SIL, -LONGEST_SPEECH, starts[0] if starts else track.seconds
    for place in range(max(here - _BEFORE, 0), min(here + _AFTER, count)):
        yield track.visemes[place], starts[place], starts[place + 1] if place + 1 < count else track.seconds
    if here + _AFTER >= count:
        yield SIL, track.seconds, 2.0 * LONGEST_SPEECH


def _weight(viseme: int, start: float, end: float, time: float) -> float:
    lead = CONSONANT_LEAD
    lag = CONSONANT_LAG
    if viseme in _VOWELS:
        lead = VOWEL_LEAD
        lag = VOWEL_LAG
    elif viseme == SIL:
        lead = SILENCE_LEAD
        lag = SILENCE_LAG
    inset = _inset(start, end)
    return _bump(time, start - lead, start + inset, end - inset, end + lag)


def _inset(start: float, end: float) -> float:
    return min(INSET * (end - start), LONGEST_INSET)


def _bump(time: float, begins: float, full: float, fades: float, ends: float) -> float:
    """0, rising to 1, falling to 0, without a kink."""
    if not begins < time < ends:
        return 0.0
    if time < full:
        return _RISE.value((time - begins) / (full - begins))
    return 1.0 if time <= fades else 1.0 - _RISE.value((time - fades) / (ends - fades))
