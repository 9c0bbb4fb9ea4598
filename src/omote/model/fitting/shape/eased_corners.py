"""Slides skin around the inner corners of the eyes along itself until its triangles are shaped as the generic head's.

Identity modes and matches say where a surface is and little about where along it a vertex belongs: people's corners
came out twice as long and a quarter as wide as the generic ones, and a shape that folds nothing there folds the generic
head, where those triangles are shorter.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.geometry import mesh
from omote.geometry.laplacian import bending_energy
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.shape.fold_mending import find_folds
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import fit_similarity

Values = NDArray[np.float64]

# So near to a corner skin slides freely, so far from it not at all; the generic head is laid on what is around, metres.
NEAR, FAR, AROUND = 0.010, 0.024, 0.03
# The stiffness as a length, metres, beside the skin's own planes.
LENGTH = 0.003
# How strong a vertex is held where it is, beside its plane: near corners, on the lids' lines, far from corners.
FREE, ON_LINE, HELD = 0.02, 1.0, 10.0


def ease_corners(space: ParameterSpace, skin: Values, /) -> Values:
    """A skin (V, 3), metres, that bends near the inner corners of the eyes from the generic head as little as it can
    while it stays on its planes; far from them the same."""
    return _ease(space, skin, _measure_distances(space).min(axis=1))


def ease_folded_corners(space: ParameterSpace, guide: Values, skin: Values, /) -> Values:
    """A skin (V, 3) eased at those inner corners of eyes that fold against a guide (V, 3); the same where none does.

    What smooths folds away would squeeze a corner to a fifth of its size.
    """
    away = _measure_distances(space)
    folded = np.unique(space.sheet_triangles[find_folds(space, guide, skin)])
    corners = (away[folded] < NEAR).any(axis=0)
    return _ease(space, skin, away[:, corners].min(axis=1)) if corners.any() else skin


def _ease(space: ParameterSpace, skin: Values, away: Values) -> Values:
    """A skin (V, 3) eased where it is not far away from a corner: (V,), metres."""
    share = np.clip((away - NEAR) / (FAR - NEAR), 0.0, 1.0)
    share = share * share * (3.0 - 2.0 * share)
    home = fit_similarity(space.points, skin, np.where(away < AROUND, 1.0, 1e-6))(space.points)
    energy, area = bending_energy(home, space.triangles)
    hold = FREE + HELD * share**2
    for line in space.lines:
        hold[line.loop] += ON_LINE
    moving = np.flatnonzero(share < 1.0)
    held = _hold_planes(mesh.normals(skin, space.triangles)[moving], hold[moving], np.maximum(area[moving], 1e-10))
    stiff = LENGTH**4 * energy
    system = held + sparse.kron(stiff[moving][:, moving], sparse.eye_array(3))
    side = -(stiff @ (skin - home))[moving].ravel()
    factor = splu(sparse.csc_array(system), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
    result = skin.copy()
    result[moving] += factor.solve(side).reshape(-1, 3)
    return result


def _measure_distances(space: ParameterSpace) -> Values:
    """How far each vertex of the generic head is from the inner corners of the eyes, (V, 2), metres."""
    corners = [row for name, row in find_landmarks(space).items() if name.endswith("_eye_inner")]
    result: Values = np.linalg.norm(space.points[:, None] - space.points[corners], axis=2)
    return result


def _hold_planes(normals: Values, hold: Values, area: Values) -> sparse.bsr_array:
    """The matrix (3 n, 3 n) that holds vertices in planes with normals (n, 3), and by hold (n,) where they are."""
    count = len(normals)
    blocks = normals[:, :, None] * normals[:, None, :] + np.eye(3) * hold[:, None, None]
    return sparse.bsr_array(
        (area[:, None, None] * blocks, np.arange(count), np.arange(count + 1)), shape=(3 * count, 3 * count)
    )
