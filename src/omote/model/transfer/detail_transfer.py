"""Detail transfer: within millimetres a displacement follows the face's triangles (docs/method.md, "Detail transfer").

Added as it is, a displacement keeps its amplitude but creases and folds where the face's triangles are larger, smaller
or rotated; by deformation gradients alone (deformation transfer, Sumner & Popovic 2004) it stays smooth and loses
amplitude. So: the gradients within LENGTH, the displacement beyond (a screened Poisson equation). It is linear in the
source's gradients, so sums of compounds stay as smooth as each.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.model.transfer.fold_repair import SheetGeometry, triangle_frames

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

# Where gradients give way to the displacement itself, metres.
LENGTH = 0.002
# What a triangle's gradient may miss without being corrected: people move alike where their triangles differ by so much
# (a fold misses 1). More of either is smoother on strong faces and farther from what people truly do (decision 0153).
TOLERANCE = 0.2


@dataclass(frozen=True, eq=False)
class DetailSolver:
    """The solved system of one face: (D' A D + M / LENGTH^2) correction = D' A (missing gradients).

    slopes (2 T, n): D on the sheet's vertices used (n,); areas (2 T,) and solver: the factorised matrix.
    """

    geometry: SheetGeometry
    used: Indices
    slopes: sparse.csr_array
    areas: Values
    solver: splu


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
    return DetailSolver(geometry, used.astype(np.int32), slopes, areas, splu(sparse.csc_array(matrix)))


def solve_detail(detail: DetailSolver, displacement: Values, moved: Values, gain: Values, /) -> Values:
    """The displacement (V, 3), gain (V,) times as large, with its detail in the face's own triangles.

    moved (V, 3): the generic face wearing the expression. On the generic face itself nothing changes.
    """
    geometry = detail.geometry
    change = triangle_frames(moved, geometry.triangles) @ geometry.inverse_frames - np.eye(3)
    change *= gain[geometry.triangles].mean(axis=1)[:, None, None]
    wanted = (change @ geometry.plane).transpose(2, 0, 1).reshape(-1, 3)
    result = displacement * gain[:, None]
    missing = _soft_threshold(wanted - detail.slopes @ result[detail.used])
    pull = detail.slopes.T @ (detail.areas[:, None] * missing)
    result[detail.used] += detail.solver.solve(np.ascontiguousarray(pull))
    return result


def _soft_threshold(missing: Values) -> Values:
    """Gradients (2 T, 3) shortened by TOLERANCE, triangle by triangle (soft thresholding)."""
    both = missing.reshape(2, -1, 3)
    size = np.sqrt((both**2).sum(axis=(0, 2)))
    share = np.maximum(0.0, 1.0 - TOLERANCE / np.maximum(size, 1e-12))
    result: Values = (both * share[:, None]).reshape(-1, 3)
    return result
