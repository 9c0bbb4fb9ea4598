"""All macros of a character at once (Numba): what each of their targets gives, tick by tick, and their sums. Of
+ - * / alone, each rounded as IEEE 754 says, so that a show replays bit for bit on any machine."""

from __future__ import annotations

import numpy as np
from numba import boolean, float64, int64, njit, types, void
from numpy.typing import NDArray

from omote.arrays import Values
from omote.perform.layers.follower import NEAR
from omote.perform.layers.layer_kernels import left_after
from omote.perform.mappings.soft_limit import soft_sum

_READ = types.Array(float64, 1, "C", readonly=True)
_READ_ROWS = types.Array(float64, 2, "C", readonly=True)
_PLACES = types.Array(int64, 1, "C", readonly=True)
_PLACE_ROWS = types.Array(int64, 2, "C", readonly=True)
_WRITE = types.Array(float64, 1, "C")
_WRITE_ROWS = types.Array(float64, 2, "C")


@njit(
    "UniTuple(float64, 2)(float64, float64, float64, float64, float64, float64, int64)", cache=True, error_model="numpy"
)
def follow_pair(
    first: float, second: float, goal: float, rise: float, fall: float, step: float, count: int
) -> tuple[float, float]:
    """Two filters in a row some steps later, between what they were (first, second) and the goal: each has the rate of
    a rise or of a fall (1/s, 0 at once) by where it goes itself, so that it changes while it stands, without a kink.

    step: seconds; count: how many of them. Of the first filter a step leaves a part of its distance, of the second
    what both leave of it; what is near its goal is there.
    """
    for _ in range(count):
        ahead = first - goal
        lead = rise if goal > first else fall
        z = share = 0.0
        before = goal
        if lead != 0.0:
            z = lead * step
            share = left_after(z)
            before = first
        behind = rise if (before if before != second else goal) > second else fall
        first = goal + ahead * share
        if behind != 0.0:
            y = behind * step
            left = left_after(y)
            second = goal + (second - goal) * left
            if share != 0.0:
                chord = 1.0 + 0.48 * (z + y) + 0.235 * (z * z + z * y + y * y)
                second += ahead * y * chord * share * left
        else:
            second = first
        if abs(first - goal) + abs(second - goal) < NEAR:
            first = second = goal
    return first, second


@njit(boolean(_READ_ROWS, _READ, _READ, float64, int64, _WRITE_ROWS), cache=True, error_model="numpy")
def follow_pairs(pairs: Values, goals: Values, rates: Values, step: float, count: int, later: Values) -> bool:
    """Writes pairs (n, 2) some steps later into later (n, 2); whether one has moved. goals, rates (n,): of each, both
    ways; step, count: as of `follow_pair`."""
    moves = False
    for i in range(len(pairs)):
        first, second = pairs[i]
        if first != goals[i] or second != goals[i]:
            first, second = follow_pair(first, second, goals[i], rates[i], rates[i], step, count)
            moves = True
        later[i, 0] = first
        later[i, 1] = second
    return moves


@njit(float64(_READ_ROWS, int64, int64, float64), cache=True, error_model="numpy")
def curve_value(pieces: Values, begin: int, end: int, at: float) -> float:
    """What a curve of the pieces (k, 9) from begin to end gives, as of `monotone_curve.value_of`; at: 0 to 1."""
    for i in range(begin, end):
        if at < pieces[i, 0]:
            part = (at - pieces[i, 1]) * pieces[i, 2]
            gives = pieces[i, 3] + part * (pieces[i, 4] + part * (pieces[i, 5] + part * pieces[i, 6]))
            return float(min(max(gives, pieces[i, 7]), pieces[i, 8]))
    return float(pieces[end - 1, 8]) if end > begin else at


@njit(
    boolean(
        _READ, types.Array(boolean, 1, "C", readonly=True), _READ_ROWS, _PLACES, _READ, _READ_ROWS, _PLACE_ROWS,
        _READ_ROWS, _READ_ROWS, float64, int64, _WRITE_ROWS,
    ),
    cache=True,
    error_model="numpy",
)  # fmt: skip
def follow_targets(
    values: Values,
    moved: NDArray[np.bool_],
    given: Values,
    owners: NDArray[np.int64],
    lows: Values,
    spans: Values,
    runs: NDArray[np.int64],
    pieces: Values,
    rates: Values,
    step: float,
    count: int,
    later: Values,
) -> bool:
    """Writes what each target gives some steps later into later (m, 2); whether one of them has moved.

    values, moved (n,): of the macros, where they are, and whether a hand has moved them; given (m, 2): of their targets
    now; owners (m,): the macro of each; lows (m,), spans (m, 2): what it gives in the middle, and how far it goes from
    there above and below, not a number where it stays; runs (m, 4): where its curves above and below begin and end in
    pieces (k, 9); rates (m, 2): of its rise and its fall (1/s); step, count: as of `follow_pair`.
    """
    moves = False
    for i in range(len(given)):
        first, second = given[i]
        if moved[owners[i]]:
            value = values[owners[i]]
            half = 1 if value < 0.0 else 0
            goal = lows[i]
            if spans[i, half] == spans[i, half]:
                goal += spans[i, half] * curve_value(pieces, runs[i, 2 * half], runs[i, 2 * half + 1], abs(value))
            if first != goal or second != goal:
                first, second = follow_pair(first, second, goal, rates[i, 0], rates[i, 1], step, count)
                moves = True
        later[i, 0] = first
        later[i, 1] = second
    return moves


@njit(void(_READ, _READ, _PLACES, _PLACES, _READ_ROWS, _WRITE), cache=True, error_model="numpy")
def sum_sources(
    values: Values,
    own: Values,
    order: NDArray[np.int64],
    begins: NDArray[np.int64],
    limits: Values,
    sums: Values,
) -> None:
    """Writes what each target has of all its sources, softly limited, into sums (t,).

    values (m,): what each source gives; own (t,): what faders hold of each target; order (m,): the sources by target,
    begins (t + 1,): where those of each begin in it; limits (t, 2): the lowest and the highest of each.
    """
    row = np.empty(len(values) + 1)
    for i in range(len(own)):
        row[0] = own[i]
        count = 1
        for place in range(begins[i], begins[i + 1]):
            row[count] = values[order[place]]
            count += 1
        sums[i] = soft_sum(row[:count], limits[i, 0], limits[i, 1])
