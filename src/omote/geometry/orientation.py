"""Repairs triangles that have turned over, or nearly: position based dynamics (Mueller et al. 2007, section 3.3).

Jacobi iterations with over-relaxation: each triangle with too little area moves its three corners along the gradient of
its area, a corner takes the mean over its triangles. One that lacks next to nothing weighs next to nothing there:
counted in full, it would halve what another wants at once, and a frame would jump. Momentum speeds a few rounds up
(the heavy ball of Polyak 1964). Vertices of other triangles do not move.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from omote.arrays import Indices, Values

OVER_RELAXATION = 1.5
"""A step goes so many times as far as one triangle alone would need (over-relaxation)."""
FULL = 0.05
"""A triangle weighs in full in the mean at a corner from where it lacks so much of its area at rest."""
LEAST_SLOPE = 1e-3
"""The least squared slope of a triangle's area that is divided by, over the root of its squared normal."""


def rest_normals(rest: Values, triangles: Indices) -> tuple[Values, Values]:
    """Normals (t, 3), twice the areas long, and their squared lengths (t,). rest: (V, 3), metres; triangles: (t, 3)."""
    a, b, c = (rest[triangles[:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    return normals, (normals**2).sum(axis=1)


@njit(cache=True)
def area_shares(points: Values, normals: Values, sizes: Values, triangles: Indices) -> Values:
    """What is left of each triangle's area, seen along its normal at rest: (t,), negative where it is turned over.

    points: (m, 3), metres; normals: (t, 3), at rest; sizes: (t,), their squared lengths; triangles: (t, 3).
    """
    left = np.empty(len(triangles))
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        left[t] = _area_share(points[i], points[j], points[k], normals[t]) / sizes[t]
    return left


@njit(cache=True)
def repair_triangles(
    points: Values, normals: Values, sizes: Values, triangles: Indices, goals: Values, rounds: int,
    momentum: float = 0.0,
) -> None:  # fmt: skip
    """Moves points (m, 3), in place, until each triangle keeps its goal (t,) of its area, or the rounds are over.

    goals: (t,), shares.

    normals (t, 3), sizes (t,): at rest, as from `rest_normals`. A vertex takes the mean over its triangles; momentum:
    and so much of its last step, while anything is wanted there.
    """
    push = np.zeros_like(points)
    wanted = np.zeros(len(points))
    step = np.zeros_like(points)
    for _ in range(rounds):
        push[:] = 0.0
        wanted[:] = 0.0
        if not _accumulate(points, normals, sizes, triangles, goals, push, wanted):
            return
        for v in range(len(points)):
            kept = momentum * min(wanted[v], 1.0)
            step[v] *= kept
            if wanted[v] > 0.0:
                step[v] += OVER_RELAXATION / wanted[v] * push[v]
                points[v] += step[v]


@njit(cache=True)
def _accumulate(
    points: Values, normals: Values, sizes: Values, triangles: Indices, goals: Values, push: Values, wanted: Values
) -> bool:
    """Adds the corrections of triangles with too little area to push (m, 3), their weights to wanted (m,); any at
    all?"""
    some = False
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        missing = goals[t] - _area_share(points[i], points[j], points[k], normals[t]) / sizes[t]
        if missing <= 0.0:
            continue
        some = True
        at_j = np.cross(points[k] - points[i], normals[t]) / sizes[t]
        at_k = np.cross(normals[t], points[j] - points[i]) / sizes[t]
        at_i = -at_j - at_k
        slope = (at_i**2).sum() + (at_j**2).sum() + (at_k**2).sum()
        weight = min(missing / FULL, 1.0)
        size = weight * missing / max(slope, LEAST_SLOPE / np.sqrt(sizes[t]))
        push[i] += size * at_i
        push[j] += size * at_j
        push[k] += size * at_k
        wanted[i] += weight
        wanted[j] += weight
        wanted[k] += weight
    return some


@njit(cache=True, inline="always")
def _area_share(a: Values, b: Values, c: Values, normal: Values) -> float:
    x, y, z = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    u, v, w = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    return float((y * w - z * v) * normal[0] + (z * u - x * w) * normal[1] + (x * v - y * u) * normal[2])
