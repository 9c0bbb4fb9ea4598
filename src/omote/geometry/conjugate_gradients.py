"""Least squares on the gradients of a patch of triangles, by preconditioned conjugate gradients.

Written as plain loops: numba compiles them in a quarter of the time that array expressions take, to the same bits.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from omote.arrays import Indices, Values

_ITERATIONS = 80
_SMALLEST = 1e-10  # of the energy at the start


@njit(cache=True)
def solve_conjugate_gradients(
    pull: Values, diagonal: Values, shift: float, corners: Indices, slopes: Values, weights: Values, /
) -> Values:
    """Solves (G^T W G + shift) x = pull for the vertices of a patch, preconditioned by the diagonal.

    Parameters
    ----------
    pull : the right side (U, 3).
    diagonal : the diagonal of the matrix (U,), above 0.
    shift : what is added to each diagonal entry; it anchors the vertices where they are.
    corners : the unknowns at the corners of each triangle (P, 3); -1 is a vertex that is held.
    slopes : the derivative of each corner's hat function along two directions in the plane (P, 3, 2).
    weights : the weight of each triangle (P,).

    Returns
    -------
    The solution (U, 3), after at most 80 steps (Hestenes and Stiefel 1952).
    """
    shape = pull.shape
    rest = pull.copy()
    x = np.zeros(shape)
    applied = np.empty(shape)
    scaled = np.empty(shape)
    direction = np.zeros(shape)
    _scale_rows(rest, diagonal, scaled)
    _add_scaled(1.0, scaled, direction)
    energy = _dot(rest, scaled)
    goal = _SMALLEST * energy
    for _ in range(_ITERATIONS):
        if energy <= goal:
            break
        _apply_matrix(direction, shift, corners, slopes, weights, applied)
        share = energy / _dot(direction, applied)
        _add_scaled(share, direction, x)
        _add_scaled(-share, applied, rest)
        _scale_rows(rest, diagonal, scaled)
        after = _dot(rest, scaled)
        _turn_direction(scaled, after / energy, direction)
        energy = after
    return x


@njit(cache=True)
def _apply_matrix(x: Values, shift: float, corners: Indices, slopes: Values, weights: Values, out: Values) -> None:
    for v in range(len(x)):
        for c in range(3):
            out[v, c] = shift * x[v, c]
    slope = np.empty(3)
    for n in range(len(corners)):
        for d in range(2):
            _gather_slope(n, d, corners, slopes, x, slope)
            _scatter_slope(n, d, corners, slopes, weights, slope, out)


@njit(cache=True)
def _gather_slope(n: int, d: int, corners: Indices, slopes: Values, x: Values, slope: Values) -> None:
    for c in range(3):
        slope[c] = 0.0
    for k in range(3):
        p = corners[n, k]
        if p >= 0:
            for c in range(3):
                slope[c] += slopes[n, k, d] * x[p, c]


@njit(cache=True)
def _scatter_slope(
    n: int, d: int, corners: Indices, slopes: Values, weights: Values, slope: Values, out: Values
) -> None:
    for k in range(3):
        p = corners[n, k]
        if p >= 0:
            for c in range(3):
                out[p, c] += weights[n] * slopes[n, k, d] * slope[c]


@njit(cache=True)
def _dot(a: Values, b: Values) -> float:
    total = 0.0
    for v in range(len(a)):
        for c in range(3):
            total += a[v, c] * b[v, c]
    return total


@njit(cache=True)
def _scale_rows(rest: Values, diagonal: Values, out: Values) -> None:
    for v in range(len(rest)):
        inverse = 1.0 / diagonal[v]
        for c in range(3):
            out[v, c] = rest[v, c] * inverse


@njit(cache=True)
def _add_scaled(share: float, other: Values, x: Values) -> None:
    for v in range(len(x)):
        for c in range(3):
            x[v, c] += share * other[v, c]


@njit(cache=True)
def _turn_direction(scaled: Values, share: float, direction: Values) -> None:
    for v in range(len(scaled)):
        for c in range(3):
            direction[v, c] = scaled[v, c] + share * direction[v, c]
