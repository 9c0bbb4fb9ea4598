"""Keeps the skirt of the package off the legs and hips of a body, as it was modelled."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial import cKDTree

from omote.geometry import mesh
from tools.baking.bodies.figure_cut import FigureCut
from tools.baking.heads.basemesh import Floats

OFF = 0.012
"""Metres between skirt and skin at least: cloth of the body lies between them, up to 8 mm thick under a sash."""
ROUNDS = 6
"""Of pushing outward, each followed by a step of smoothing what was moved."""


def stand_off(rows: Floats, cut: FigureCut) -> Floats:
    """The rows of the skirt (s, 3), pushed out of the body where they lie in it or too near; rows (V + B, 3) metres."""
    first = int(cut.skirt.min())
    corners = cut.all_triangles
    normals = mesh.normals(rows[:first], corners)
    below = np.arange(cut.head_rows, first)
    tree = cKDTree(rows[below])
    skirt = rows[first:].copy()
    middles = _middles(cut.skirt - first, len(skirt))
    for _ in range(ROUNDS):
        near = below[tree.query(skirt)[1]]
        short = np.maximum(OFF - ((skirt - rows[near]) * normals[near]).sum(axis=1), 0.0)[:, None]
        pushed = short * normals[near] * [1.0, 0.0, 1.0]
        skirt += 0.5 * (pushed + middles @ pushed)
    return skirt


def _middles(triangles: np.ndarray, count: int) -> csr_array:
    """The matrix that takes rows to the mean of their neighbours."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    pairs = np.unique(np.concatenate([edges, edges[:, ::-1]]), axis=0)
    degrees = np.bincount(pairs[:, 0], minlength=count)
    return csr_array((1.0 / degrees[pairs[:, 0]], (pairs[:, 0], pairs[:, 1])), shape=(count, count))
