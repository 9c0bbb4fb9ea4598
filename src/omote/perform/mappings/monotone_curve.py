"""Curves through a few knots that never go beyond two neighbours: monotone cubics of + - * / and a root alone, so that
a show replays bit for bit on any machine.

References
----------
F. N. Fritsch, R. E. Carlson: Monotone piecewise cubic interpolation. SIAM J. Numer. Anal. 17 (1980), 238-246.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from omote.perform.limits import check_within

Knot = tuple[float, float]
Knots = tuple[Knot, ...]
STRAIGHT: Knots = ((0.0, 0.0), (1.0, 1.0))
FEWEST_KNOTS = 2
MOST_KNOTS = 7
NEAREST_KNOTS = 0.01
"""How near two knots may be: nearer, a hand would meet a step."""
Pieces = tuple[tuple[float, float, float, float, float, float, float, float, float], ...]
FLAT = 1e-9
"""What rises by less over the whole way is flat."""
STEEPEST = 3.0
"""The radius of the circle, in slopes of the chord, within which a cubic between two knots is monotone."""


def check_knots(knots: Sequence[Sequence[float]], what: str) -> Knots:
    """Returns the knots of a curve; ValueError, TypeError where there is none through them. what: what messages call
    it.

    knots: where the hand is, 0 to 1, and the part of the way that it gives there, 0 to 1; from (0, 0) to where the
    hand is at 1.
    """
    if not FEWEST_KNOTS <= len(knots) <= MOST_KNOTS:
        raise ValueError(f"{what} has {len(knots)} knots; give {FEWEST_KNOTS} to {MOST_KNOTS}")
    checked = []
    for knot in knots:
        if len(knot) != len(STRAIGHT[0]):
            raise ValueError(f"a knot of {what} is {list(knot)!r:.80}; give where the hand is, and what it gives")
        at, gives = (check_within(number, 0.0, 1.0, f"a knot of {what}") for number in knot)
        checked.append((at, gives))
    if checked[0] != (0.0, 0.0) or checked[-1][0] != 1.0:
        raise ValueError(
            f"{what} goes from {checked[0]} to {checked[-1]}; it must begin at (0, 0) and end where the hand is at 1"
        )
    for (before, _), (after, _) in pairwise(checked):
        if after - before < NEAREST_KNOTS:
            raise ValueError(f"{what} has knots at {before:g} and {after:g}; each must be {NEAREST_KNOTS} further on")
    return tuple(checked)


def curve_at(knots: Knots, at: float) -> float:
    """What a curve gives where the hand is at some place: between what the two knots beside it give.

    knots: checked; at: 0 to 1.
    """
    return value_of(pieces_of(knots), at)


def value_of(pieces: Pieces, at: float) -> float:
    """What a curve of some pieces gives where the hand is at some place, 0 to 1; none are a straight line."""
    for piece in pieces:
        if at < piece[0]:
            _, begin, per_width, constant, first, second, third, low, high = piece
            part = (at - begin) * per_width
            gives = constant + part * (first + part * (second + part * third))
            return low if gives < low else min(gives, high)
    return pieces[-1][-1] if pieces else at


def pieces_of(knots: Knots) -> Pieces:
    """The pieces of a curve, in their order: each its end, its begin, one over its width, the coefficients of its
    cubic from the constant on, and the lower and the higher value at its ends; then the end, as a piece without a
    width. None of a straight line.

    knots: checked.
    """
    if knots == STRAIGHT:
        return ()
    slopes = slopes_at(knots)
    pieces = []
    for ((begin, low), (end, high)), (leaves, comes) in zip(pairwise(knots), pairwise(slopes), strict=True):
        width = end - begin
        rise = high - low
        first = leaves * width
        last = comes * width
        second = 3.0 * rise - 2.0 * first - last
        third = first + last - 2.0 * rise
        pieces.append((end, begin, 1.0 / width, low, first, second, third, min(low, high), max(low, high)))
    last = knots[-1][1]
    return (*pieces, (1.0, 1.0, 0.0, last, 0.0, 0.0, 0.0, last, last))


def slopes_at(knots: Knots) -> list[float]:
    """The slope of a curve at each knot, as Fritsch and Carlson choose it: the mean of both chords, none at a peak,
    and never so steep that the curve would turn between two knots. knots: checked."""
    chords = [(high - low) / (end - begin) for (begin, low), (end, high) in pairwise(knots)]
    inner = [0.0 if before * after <= 0.0 else (before + after) / 2.0 for before, after in pairwise(chords)]
    slopes = [chords[0], *inner, chords[-1]]
    for place, chord in enumerate(chords):
        if abs(chord) < FLAT:  # and a slope over it might be more than a number holds
            slopes[place] = slopes[place + 1] = 0.0
            continue
        leaves = slopes[place] / chord
        comes = slopes[place + 1] / chord
        steepness = math.sqrt(leaves * leaves + comes * comes)
        if steepness > STEEPEST:
            slopes[place] = STEEPEST / steepness * leaves * chord
            slopes[place + 1] = STEEPEST / steepness * comes * chord
    return slopes
