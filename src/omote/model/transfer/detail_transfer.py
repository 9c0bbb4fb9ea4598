"""Detail transfer: within millimetres a displacement follows the face's triangles (docs/method.md, "Detail transfer").

Added as it is, a displacement keeps its amplitude but creases and folds where the face's triangles are larger, smaller
or rotated; by deformation gradients alone (deformation transfer, Sumner & Popovic 2004) it stays smooth and loses
amplitude. So: the gradients within LENGTH, the displacement beyond (a screened Poisson equation). It is linear in the
source's gradients, so sums of compounds stay as smooth as each.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.model.transfer.fold_repair import SheetGeometry

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

# Where gradients give way to the displacement itself, metres.
LENGTH = 0.002
# What a triangle's gradient may miss without being corrected: people move alike where their triangles differ by so much
# (a fold misses 1). More of either is smoother on strong faces and farther from what people truly do (decision 0153).
TOLERANCE = 0.15
SYMMETRIC = {"SymmetricMode": True}


@dataclass(frozen=True, eq=False)
class DetailSolver:
    """The solved system of one face: (D' A D + M / LENGTH^2) correction = D' A (missing gradients).

    slopes (2 T, n): D on the sheet's vertices used (n,); areas (2 T,) and solver: the factorised matrix; carried
    (T, 3, 2): where the generic face's frames carry the two directions in each triangle's plane.
    """

    geometry: SheetGeometry
    used: Indices
    slopes: sparse.csr_array
    areas: Values
    solver: splu
    carried: Values


def factor_detail(geometry: SheetGeometry, /) -> DetailSolver:
    """The system of a face's sheet, factorised."""
    triangles = geometry.triangles
    used, corners = np.unique(triangles, return_inverse=True)
    values = geometry.gradients.transpose(2, 0, 1)
    rows = np.arange(2 * len(triangles)).reshape(2, -1, 1)
    places = np.broadcast_to(corners.reshape(triangles.shape), values.shape).ravel()
    where = (np.broadcast_to(rows, values.shape).ravel(), places)
    slopes = sparse.coo_array((values.ravel(), where), shape=(2 * len(triangles), len(used))).tocsr()
    area = 0.5 * np.linalg.norm(geometry.normals, axis=1)
    mass = np.bincount(corners.ravel(), np.repeat(area / 3.0, 3))
    areas = np.tile(area, 2)
    matrix = slopes.T @ sparse.diags_array(areas) @ slopes + sparse.diags_array(mass / LENGTH**2)
    carried = np.ascontiguousarray(geometry.inverse_frames @ geometry.plane)
    return DetailSolver(geometry, used.astype(np.int32), slopes, areas, _factor(matrix), carried)


def _factor(matrix: sparse.csr_array) -> splu:
    """The factors of a symmetric positive definite matrix: a minimum degree ordering of its own graph, no pivots."""
    return splu(sparse.csc_array(matrix), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=SYMMETRIC)


def solve_detail(detail: DetailSolver, displacement: Values, moved: Values, gain: Values, /) -> Values:
    """The displacement (V, 3), gain (V,) times as large, with its detail in the face's own triangles.

    moved (V, 3): the generic face wearing the expression. On the generic face itself nothing changes.
    """
    geometry = detail.geometry
    result = displacement * gain[:, None]
    pull = np.zeros_like(result)
    _pull_missing(
        moved, result, gain, geometry.triangles, detail.carried, geometry.gradients, geometry.plane,
        detail.areas, pull,
    )  # fmt: skip
    result[detail.used] += detail.solver.solve(pull[detail.used])
    return result


@njit(cache=True)
def _pull_missing(
    moved: Values, result: Values, gain: Values, triangles: Indices, carried: Values, gradients: Values, plane: Values,
    areas: Values, pull: Values,
) -> None:  # fmt: skip
    """Adds D' A (missing gradients) to pull (V, 3), each triangle's gradient shortened by TOLERANCE (soft
    thresholding)."""
    one, two, up = np.empty(3), np.empty(3), np.empty(3)
    missing = np.empty((2, 3))
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        for c in range(3):
            one[c], two[c] = moved[j, c] - moved[i, c], moved[k, c] - moved[i, c]
        up[0], up[1] = one[1] * two[2] - one[2] * two[1], one[2] * two[0] - one[0] * two[2]
        up[2] = one[0] * two[1] - one[1] * two[0]
        size = np.sqrt(np.sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]))
        share, square = (gain[i] + gain[j] + gain[k]) / 3.0, 0.0
        for d in range(2):
            a, b, n = carried[t, 0, d], carried[t, 1, d], carried[t, 2, d] / size
            x, y, z = gradients[t, 0, d], gradients[t, 1, d], gradients[t, 2, d]
            for c in range(3):
                wanted = share * (one[c] * a + two[c] * b + up[c] * n - plane[t, c, d])
                missing[d, c] = wanted - x * result[i, c] - y * result[j, c] - z * result[k, c]
                square += missing[d, c] * missing[d, c]
        if square <= TOLERANCE * TOLERANCE:
            continue
        weight = areas[t] * (1.0 - TOLERANCE / np.sqrt(square))
        for corner in range(3):
            for c in range(3):
                slopes = gradients[t, corner, 0] * missing[0, c] + gradients[t, corner, 1] * missing[1, c]
                pull[triangles[t, corner], c] += weight * slopes
