"""Strain of a surface: how far each of its places is pressed together or drawn out, and which way.

With F the gradient of places now by places at rest in a triangle, U the symmetric root of F'F, the strain (Biot's) is
E = U - 1, a symmetric 2 x 2 matrix in the triangle's own frame: the first axis level, the second upright. A vertex has
the mean of the triangles around it, by their areas at rest.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Indices, Values

UP = np.array([0.0, 1.0, 0.0])
LEVEL_LEAST = 1e-3
"""Sine of the angle between a normal and upright below which no direction of a triangle is level: x stands for it."""


def fans_of(triangles: Indices, asked: NDArray[np.bool_], /) -> Indices:
    """The triangles (T, 3) of which every corner is asked (V,): those that the mean at a vertex is of."""
    kept: Indices = triangles[asked[triangles].all(axis=1)]
    return kept


def vertex_strain(rest: Values, now: Values, triangles: Indices, /) -> Values:
    """The strain of each vertex (V, 3): level, mixed and upright; 0 where no triangle is.

    rest, now: (V, 3) positions, metres; triangles: (T, 3).
    """
    strains, areas = triangle_strain(rest, now, triangles)
    total = np.zeros((len(rest), 4))
    values = np.concatenate([strains * areas[:, None], areas[:, None]], axis=1)
    for corner in range(3):
        np.add.at(total, triangles[:, corner], values)
    return total[:, :3] / np.maximum(total[:, 3:], 1e-20)


def triangle_strain(rest: Values, now: Values, triangles: Indices, /) -> tuple[Values, Values]:
    """The strain of each triangle (T, 3): level, mixed and upright, and twice its area at rest (T,), square metres.

    rest, now: (V, 3) positions, metres; triangles: (T, 3).
    """
    first, second = (np.asarray(rest[triangles[:, k]] - rest[triangles[:, 0]], np.float64) for k in (1, 2))
    moved = [np.asarray(now[triangles[:, k]] - now[triangles[:, 0]], np.float64) for k in (1, 2)]
    facing = np.cross(first, second)
    doubled = np.linalg.norm(facing, axis=1)
    normal = facing / np.maximum(doubled, 1e-20)[:, None]
    level = np.cross(UP, normal)
    level = np.where(np.linalg.norm(level, axis=1)[:, None] < LEVEL_LEAST, [1.0, 0.0, 0.0], level)
    level /= np.linalg.norm(level, axis=1)[:, None]
    upright = np.cross(normal, level)
    a, c = (np.einsum("ij,ij->i", edge, level) for edge in (first, second))
    b, d = (np.einsum("ij,ij->i", edge, upright) for edge in (first, second))
    turn = np.maximum(a * d - b * c, 1e-20)
    x = (d[:, None] * moved[0] - b[:, None] * moved[1]) / turn[:, None]
    y = (a[:, None] * moved[1] - c[:, None] * moved[0]) / turn[:, None]
    xx, xy, yy = (np.einsum("ij,ij->i", one, other) for one, other in ((x, x), (x, y), (y, y)))
    root = np.sqrt(np.maximum(xx * yy - xy * xy, 0.0))
    scale = np.sqrt(np.maximum(xx + yy + 2.0 * root, 1e-20))
    return np.stack([(xx + root) / scale - 1.0, xy / scale, (yy + root) / scale - 1.0], axis=1), doubled


def compression(strain: Values, /) -> Values:
    """How far each place is pressed together where it is most, 0 or more (V,). strain: (V, 3)."""
    level, mixed, upright = strain.T
    half = 0.5 * (level + upright)
    apart = np.hypot(0.5 * (level - upright), mixed)
    return np.maximum(apart - half, 0.0)
