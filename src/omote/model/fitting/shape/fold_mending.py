"""Mends folded places of a fitted skin by the mean displacement of their rings."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.geometry.laplacian import smoothing_matrix
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

# Triangles lie on each other where they bend by more than 148 degrees.
CREASED = -0.85
# Each round smooths what is folded and so many rings around, one more after every WIDER, and more often each time.
ROUNDS, RINGS, WIDER, PASSES = 60, 1, 6, 3


def find_folds(space: ParameterSpace, guide: Values, skin: Values, /) -> NDArray[np.intp]:
    """The sheet's triangles whose normal on a skin (V, 3) points against that on a guide (V, 3), and those that lie on
    a neighbour as they do not on the guide."""
    sheet = space.sheet_triangles
    before, now = mesh.unit_normals(guide[sheet]), mesh.unit_normals(skin[sheet])
    beside = mesh.neighbours(sheet)
    lying = (_bend(now, beside) < CREASED) & (_bend(before, beside) >= CREASED)
    return np.flatnonzero(((before * now).sum(axis=1) <= 0.0) | lying.any(axis=1))


def _bend(normals: Values, beside: NDArray[np.integer]) -> Values:
    """The cosines (t, 3) between the normals of triangles and those of their neighbours; 1 where there is none."""
    result: Values = np.where(beside >= 0, (normals[:, None] * normals[beside]).sum(axis=2), 1.0)
    return result


def mend_folds(space: ParameterSpace, guide: Values, skin: Values, /) -> Values:
    """A skin (V, 3) without the folds that it has against a guide (V, 3), as far as they can be smoothed away: folded
    places take the mean displacement from the guide of what is around, wider and wider."""
    average = smoothing_matrix(space.triangles, len(skin))
    moves = skin - guide
    for number in range(ROUNDS):
        folded = find_folds(space, guide, guide + moves)
        if not len(folded):
            break
        share = np.zeros(len(skin))
        share[space.sheet_triangles[folded]] = 1.0
        for _ in range(RINGS + number // WIDER):
            share = np.minimum(2.0 * (average @ share), 1.0)
        for _ in range(PASSES + number):
            moves = moves + share[:, None] * (average @ moves - moves)
    result: Values = guide + moves
    return result
