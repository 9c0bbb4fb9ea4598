"""How the normals of a skin change with its points."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

Values = NDArray[np.float64]

_LEAST = 1e-15  # square metres


def slope_normals(points: Values, triangles: NDArray[np.integer], /) -> tuple[Values, sparse.csr_array]:
    """Normals (V, 3) of points (V, 3), weighted by area, and how they change with the points: (3 V, 3 V).

    Of a triangle a, b, c the normal is a x b + b x c + c x a: it changes with a by da x (b - c).
    """
    corners = triangles.astype(np.int64).T
    first, second, third = (points[each] for each in corners)
    total, flat = np.zeros(points.shape), np.cross(second - first, third - first)
    for each in corners:
        np.add.at(total, each, flat)
    length = np.linalg.norm(total, axis=1, keepdims=True) + _LEAST
    normals = total / length
    blocks, rows, columns = [], [], []
    for mover, side in zip(corners, (second - third, third - first, first - second), strict=True):
        turn = _cross_matrix(side)
        for receiver in corners:
            normal = normals[receiver]
            along = np.einsum("ti,tij->tj", normal, turn)
            blocks.append(((turn - normal[:, :, None] * along[:, None]) / length[receiver][:, None]).ravel())
            rows.append(np.repeat(_three(receiver).ravel(), 3))
            columns.append(np.repeat(_three(mover), 3, axis=0).ravel())
    where = (np.concatenate(rows), np.concatenate(columns))
    return normals, sparse.csr_array((np.concatenate(blocks), where), shape=(points.size, points.size))


def _three(rows: NDArray[np.int64]) -> NDArray[np.int64]:
    result: NDArray[np.int64] = 3 * rows[:, None] + np.arange(3)
    return result


def _cross_matrix(side: Values) -> Values:
    """Matrices (t, 3, 3) that give the cross product of what they are applied to with sides (t, 3)."""
    x, y, z = side.T
    zero = np.zeros(len(x))
    result: Values = np.stack([np.stack(row, axis=1) for row in ((zero, z, -y), (-z, zero, x), (y, -x, zero))], axis=1)
    return result
