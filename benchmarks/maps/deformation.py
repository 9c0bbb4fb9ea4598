"""Deformation transfer (Sumner & Popovic 2004), written here as a peer, factored once per face."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.geometry import mesh

Values = NDArray[np.float64]
Indices = NDArray[np.int32]


class DeformationTransfer:
    """Carries displacements of one mesh to another of the same topology by each triangle's deformation gradient.

    The fourth vertex of each triangle (section 3.1) is eliminated: what remains are the gradients in the triangle's
    plane, weighted by area as usual since Botsch et al. (2006). source, target (V, 3), triangles (T, 3); held (h,):
    vertices that stay, the rims where the head was cut.
    """

    def __init__(self, source: Values, target: Values, triangles: Indices, held: Indices) -> None:
        self._source = source
        self._target = target
        self._triangles = triangles
        self._inverse = np.linalg.inv(_frames(source, triangles))
        slopes, self._plane = _slopes(target, triangles, len(target))
        self._area = np.tile(0.5 * np.linalg.norm(_normals(target, triangles), axis=1), 2)
        self._free = np.setdiff1d(np.unique(triangles), held)
        self._of_free = sparse.csr_array(slopes[:, self._free])
        self._of_held = slopes @ _without(target, self._free)
        weighted = self._of_free.T @ sparse.diags_array(self._area) @ self._of_free
        self._solver = splu(sparse.csc_array(weighted))

    def __call__(self, displacement: Values) -> Values:
        """The target (V, 3) deformed as the source is by a displacement (V, 3); vertices of no triangle are still."""
        gradients = _frames(self._source + displacement, self._triangles) @ self._inverse
        wanted = (gradients @ self._plane).transpose(2, 0, 1).reshape(-1, 3)
        found = self._target.copy()
        pull = self._of_free.T @ (self._area[:, None] * (wanted - self._of_held))
        found[self._free] = self._solver.solve(np.ascontiguousarray(pull))
        return found


def rims(triangles: Indices) -> Indices:
    """The vertices (h,) on the boundary of a surface whose openings are closed: where the head was cut."""
    return np.unique(mesh.boundary_edges(triangles)).astype(np.int32)


def _normals(points: Values, triangles: Indices) -> Values:
    a, b, c = points[triangles].transpose(1, 0, 2)
    result: Values = np.cross(b - a, c - a)
    return result


def _frames(points: Values, triangles: Indices) -> Values:
    """V of equation 3: two edges and the normal over the root of its length, as columns (T, 3, 3)."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normal = _normals(points, triangles)
    normal /= np.sqrt(np.linalg.norm(normal, axis=1, keepdims=True))
    return np.stack([b - a, c - a, normal], axis=2)


def _slopes(points: Values, triangles: Indices, count: int) -> tuple[sparse.csr_array, Values]:
    """Two rows a triangle (2 T, V) that read a slope in its plane, and the directions of that plane (T, 3, 2)."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    edges = np.stack([b - a, c - a], axis=2)
    plane, upper = np.linalg.qr(edges)
    of_both = np.linalg.inv(upper)  # slopes = [f_b - f_a, f_c - f_a] @ inverse
    of_corners = np.concatenate([-of_both.sum(axis=1, keepdims=True), of_both], axis=1)
    rows = np.arange(2 * len(triangles)).reshape(2, -1, 1).repeat(3, axis=2)
    values = of_corners.transpose(2, 0, 1)
    cols = np.broadcast_to(triangles, values.shape)
    shape = (2 * len(triangles), count)
    return sparse.coo_array((values.ravel(), (rows.ravel(), cols.ravel())), shape=shape).tocsr(), plane


def _without(points: Values, rows: Indices) -> Values:
    result = points.copy()
    result[rows] = 0.0
    return result
