"""Loops over all followers of a character's layers (Numba): vectors of some hundred numbers, of which NumPy takes
longer to make each than to sum it. Of + - * / alone, each rounded as IEEE 754 says, so that a show replays bit for bit
on any machine."""

from __future__ import annotations

import numpy as np
from numba import boolean, float64, int64, njit, types, void
from numpy.typing import NDArray

from omote.arrays import Values

_READ = types.Array(float64, 1, "C", readonly=True)
_READ_ROWS = types.Array(float64, 2, "C", readonly=True)
_WRITE = types.Array(float64, 1, "C")
_WRITE_ROWS = types.Array(float64, 2, "C")
_PLACES = types.Array(int64, 1, "C", readonly=True)
_WRITE_PLACES = types.Array(int64, 2, "C")
SKIPS, OFFSETS, REPLACES, FILLS = range(4)
"""What a layer does to what lies below it (`mix_streams`)."""


@njit(float64(float64), cache=True, error_model="numpy")
def left_after(z: float) -> float:
    """The part of a distance that a filter leaves of it in a step; z: its rate times the step, as of `follower`."""
    return 1.0 / (((z * 0.235 + 0.48) * z + 1.0) * z + 1.0)


@njit(void(*[_READ] * 5, *[float64] * 3, _WRITE, _WRITE), cache=True, error_model="numpy")
def follow_all(
    first: Values,
    second: Values,
    goal: Values,
    rate: Values,
    haste: Values,
    dt: float,
    jump: float,
    near: float,
    later_first: Values,
    later_second: Values,
) -> None:
    """Writes what both filters of each follower give `dt` seconds later into later_first and later_second (n,).

    first, second, goal, rate, haste (n,): as of `follower.follow`; jump: what slows the haste at a distance; near:
    what is nearer to its goal is there.
    """
    for i in range(goal.size):
        ahead = first[i] - goal[i]
        behind = second[i] - goal[i]
        square = ahead * ahead
        z = (haste[i] * abs(ahead) / (jump * square * square + 1.0) + rate[i]) * dt
        left = left_after(z)
        behind = goal[i] + (behind + ahead * z) * left
        ahead = goal[i] + ahead * left
        if abs(ahead - goal[i]) + abs(behind - goal[i]) < near:
            ahead = goal[i]
            behind = goal[i]
        later_first[i] = ahead
        later_second[i] = behind


@njit(void(_READ_ROWS, _READ_ROWS, _PLACES, _PLACES, _PLACES, *[_READ] * 4, _WRITE), cache=True, error_model="numpy")
def mix_streams(
    streams: Values,
    shares: Values,
    parts: NDArray[np.int64],
    rules: NDArray[np.int64],
    rows: NDArray[np.int64],
    hold: Values,
    hands: Values,
    lowest: Values,
    highest: Values,
    mixed: Values,
) -> None:
    """Writes all layers mixed, lowest first, and what hands hold over them, into mixed (width,): within the ranges.

    streams (n, width): of the driven layers; shares (8, 7): how much of each layer shows on each part; parts (width,):
    of each column; rules (n,): what each driven layer does; rows (n + 1,): of the driven layers and of the hands among
    the shares; hold, hands (width,): what hands hold, and how much; lowest, highest (width,): the ranges.
    """
    count = rules.size
    for c in range(mixed.size):
        value = 0.0
        for i in range(count):
            share = shares[rows[i], parts[c]]
            if rules[i] == REPLACES:
                value = (1.0 - share) * value + share * streams[i, c]
            elif rules[i] == OFFSETS:
                value = value + share * streams[i, c]
            elif rules[i] == FILLS:
                value = value + share * streams[i, c] * (1.0 - value)
        share = shares[rows[count], parts[c]] * hold[c]
        value = (1.0 - share) * value + share * hands[c]
        mixed[c] = max(min(value, highest[c]), lowest[c])


@njit(void(_READ_ROWS, int64, _WRITE_PLACES, _WRITE_ROWS), cache=True, error_model="numpy")
def find_strongest(streams: Values, count: int, places: NDArray[np.int64], values: Values) -> None:
    """Writes the columns of the largest values of each row into places (n, k), the largest first, of equals the first;
    and what they are into values (n, k).

    streams (n, width): all values; count: how many columns of each row to look at, k or more.
    """
    for i in range(places.shape[0]):
        found = 0
        for c in range(count):
            size = abs(streams[i, c])
            at = found
            while at > 0 and size > abs(streams[i, places[i, at - 1]]):
                at -= 1
            if at == places.shape[1]:
                continue
            found = min(found + 1, places.shape[1])
            for later in range(found - 1, at, -1):
                places[i, later] = places[i, later - 1]
            places[i, at] = c
        for at in range(found):
            values[i, at] = streams[i, places[i, at]]


@njit(
    void(_WRITE, types.Array(boolean, 1, "C", readonly=True), _PLACES, _READ, _PLACES, _READ),
    cache=True,
    error_model="numpy",
)
def write_stream(
    stream: Values,
    own: NDArray[np.bool_],
    places: NDArray[np.int64],
    values: Values,
    turns: NDArray[np.int64],
    turned: Values,
) -> None:
    """Writes a frame of a source into the columns of a layer that show it; what it does not send there is at rest.

    stream (width,): the values of the columns, written; own (width,): which of them show the source; places (k,),
    values (k,): of its channels; turns (t,), turned (t,): of its head and its gaze, after those.
    """
    for c in range(stream.size):
        if own[c]:
            stream[c] = 0.0
    for i in range(places.size):
        if own[places[i]]:
            stream[places[i]] = values[i]
    for i in range(turns.size):
        if own[turns[i]]:
            stream[turns[i]] = turned[i]
