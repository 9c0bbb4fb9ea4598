"""Triangles that are about to turn over are kept from it (position based dynamics: Mueller et al. 2007, section 3.3).

All triangles at once: each that lacks area pulls its three corners along the slopes of its area, a corner takes the
mean of what its triangles want. Nothing else moves, so what is whole stays as it is.
"""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

EAGER = 1.5
"""A step goes so many times as far as one triangle alone would need (over-relaxation)."""
FLATTEST = 1e-3
"""The least squared slope of a triangle's area that is divided by, over the root of its squared normal."""


def rest_normals(rest: Values, triangles: Indices) -> tuple[Values, Values]:
    """Normals (t, 3), twice the areas long, and their squared lengths (t,)."""
    a, b, c = (rest[triangles[:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    return normals, (normals**2).sum(axis=1)


@njit(cache=True)
def shares(points: Values, normals: Values, sizes: Values, triangles: Indices) -> Values:
    """What is left of each triangle's area, seen along its normal at rest: (t,), negative where it is turned over."""
    left = np.empty(len(triangles))
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        left[t] = _share(points[i], points[j], points[k], normals[t]) / sizes[t]
    return left


@njit(cache=True)
def keep_upright(
    points: Values, normals: Values, sizes: Values, triangles: Indices, goals: Values, rounds: int
) -> None:  # fmt: skip
    """Moves points (m, 3), in place, until each triangle keeps its goal (t,) of its area, or the rounds are over.

    normals (t, 3), sizes (t,): at rest, as from `rest_normals`. A vertex takes the mean of what its triangles want.
    """
    push, wanted = np.zeros_like(points), np.zeros(len(points))
    for _ in range(rounds):
        push[:] = 0.0
        wanted[:] = 0.0
        if not _pushed(points, normals, sizes, triangles, goals, push, wanted):
            return
        for v in range(len(points)):
            if wanted[v] > 0.0:
                points[v] += EAGER / wanted[v] * push[v]


@njit(cache=True)
def _pushed(
    points: Values, normals: Values, sizes: Values, triangles: Indices, goals: Values, push: Values, wanted: Values
) -> bool:  # fmt: skip
    """Adds up in push (m, 3) and wanted (m,) what triangles that lack area want; says whether any does."""
    some = False
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        lack = goals[t] - _share(points[i], points[j], points[k], normals[t]) / sizes[t]
        if lack <= 0.0:
            continue
        some = True
        at_j = np.cross(points[k] - points[i], normals[t]) / sizes[t]
        at_k = np.cross(normals[t], points[j] - points[i]) / sizes[t]
        at_i = -at_j - at_k
        slope = (at_i**2).sum() + (at_j**2).sum() + (at_k**2).sum()
        size = lack / max(slope, FLATTEST / np.sqrt(sizes[t]))
        push[i] += size * at_i
        push[j] += size * at_j
        push[k] += size * at_k
        wanted[i] += 1.0
        wanted[j] += 1.0
        wanted[k] += 1.0
    return some


@njit(cache=True, inline="always")
def _share(a: Values, b: Values, c: Values, normal: Values) -> float:
    x, y, z = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    u, v, w = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    return float((y * w - z * v) * normal[0] + (z * u - x * w) * normal[1] + (x * v - y * u) * normal[2])
