"""Mesh Laplacians: cotangent weights, one-ring smoothing, harmonic extension of values from anchors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Indices, Mask, Points, Triangles, Values
from omote.geometry.mesh import areas

# Anchors per extended vertex: the harmonic weights beyond the largest ten change nothing one can see.
ANCHORS = 10
_BLOCK = 64


def cotangents(points: Points, triangles: Triangles, /) -> sparse.csr_array:
    """Symmetric positive edge weights (V, V): cotangents, kept above a small share of their mean so that weights
    stay positive.

    points: (V, 3), metres; triangles: rows (F, 3) of vertices.
    """
    rows = []
    cols = []
    values = []
    for corner in range(3):
        tip = triangles[:, corner]
        a = triangles[:, (corner + 1) % 3]
        b = triangles[:, (corner + 2) % 3]
        u, v = points[a] - points[tip], points[b] - points[tip]
        twice_area = np.maximum(np.linalg.norm(np.cross(u, v), axis=1), 1e-30)
        cotangent = np.clip((u * v).sum(axis=1) / twice_area, 0.05, 20.0)
        rows += [a, b]
        cols += [b, a]
        values += [cotangent, cotangent]
    shape = (len(points), len(points))
    return sparse.coo_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(cols))), shape=shape).tocsr()


def bending_energy(points: Points, triangles: Triangles, /) -> tuple[sparse.csr_array, Values]:
    """The bending of a thin plate with points (V, 3) as a quadratic form (V, V), and the area of each vertex (V,).

    triangles: rows (F, 3) of vertices.
    """
    links = cotangents(points, triangles)
    laplacian = sparse.csr_array(sparse.diags_array(links.sum(axis=1)) - links)
    area = np.zeros(len(points))
    np.add.at(area, triangles.ravel(), np.repeat(areas(points, triangles) / 3.0, 3))
    return sparse.csr_array(laplacian.T @ sparse.diags_array(1.0 / np.maximum(area, 1e-12)) @ laplacian), area


def smoothing_matrix(triangles: Triangles, vertex_count: int, /) -> sparse.csr_array:
    """The matrix (V, V) that averages each vertex with its one-ring; a lone vertex keeps its value.

    triangles: rows (F, 3) of vertices; vertex_count: V.
    """
    a, b = triangles.ravel(), np.roll(triangles, 1, axis=1).ravel()
    ones = np.ones(2 * len(a))
    graph = sparse.coo_array((ones, (np.r_[a, b], np.r_[b, a])), shape=(vertex_count, vertex_count)).tocsr()
    graph.data[:] = 1.0
    graph = (graph + sparse.eye_array(vertex_count, format="csr")).tocsr()
    return sparse.csr_array(sparse.diags_array(1.0 / graph.sum(axis=1)) @ graph)


def harmonic_weights(points: Points, triangles: Triangles, free: Mask, anchors: Indices, /) -> tuple[Indices, Values]:
    """Extends values at anchors over the free vertices, each as an average of at most ANCHORS anchors.

    points: (V, 3), metres; triangles: rows (F, 3) of vertices.

    free (V,) marks vertices to extend to; anchors (A,) are fixed vertices. Harmonic (cotangent) weights, cut softly:
    the next-largest weight is subtracted from those kept, so that the cut moves nothing suddenly. Returns anchors'
    vertex indices (n, ANCHORS) and weights (n, ANCHORS) for the n free vertices, rows summing to one (to zero where no
    anchor can be reached along the mesh).
    """
    columns = np.flatnonzero(free)
    keep = min(ANCHORS, len(anchors))
    if len(columns) == 0 or keep == 0:
        return np.zeros((len(columns), ANCHORS), np.int32), np.zeros((len(columns), ANCHORS))
    weights = cotangents(points, triangles)
    inner = weights[columns][:, columns]
    outer = sparse.csc_array(weights[columns][:, anchors])
    # The tiny pull to zero keeps islands without an anchor solvable; they answer zero.
    diagonal = weights[columns].sum(axis=1) + 1e-9
    solver = factor_symmetric(sparse.diags_array(diagonal) - inner)
    best, owner = _largest(solver, outer, keep)
    return _cut_softly(best, owner, anchors)


def factor_symmetric(matrix: sparse.csr_array, /) -> splu:
    """The factors of a symmetric positive definite matrix, by a minimum degree ordering of its own graph."""
    return splu(sparse.csc_array(matrix), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})


def _largest(solver: splu, outer: sparse.csc_array, keep: int) -> tuple[Values, NDArray[np.int64]]:
    """The keep + 1 largest harmonic weights per row and the anchor columns they belong to, block by block."""
    rows, count = outer.shape
    best = np.zeros((rows, keep + 1))
    owner = np.zeros((rows, keep + 1), dtype=np.int64)
    for begin in range(0, count, _BLOCK):
        block = solver.solve(outer[:, begin : begin + _BLOCK].toarray())
        names = np.broadcast_to(np.arange(begin, begin + block.shape[1]), block.shape)
        both = np.concatenate([best, block], axis=1)
        both_names = np.concatenate([owner, names], axis=1)
        top = np.argpartition(-both, keep, axis=1)[:, : keep + 1]
        best = np.take_along_axis(both, top, axis=1)
        owner = np.take_along_axis(both_names, top, axis=1)
    order = np.argsort(-best, axis=1, kind="stable")
    return np.take_along_axis(best, order, axis=1), np.take_along_axis(owner, order, axis=1)


def _cut_softly(best: Values, owner: NDArray[np.int64], anchors: Indices) -> tuple[Indices, Values]:
    keep = best.shape[1] - 1
    cut = best[:, :keep] - best[:, keep:]
    total = cut.sum(axis=1, keepdims=True)
    reached = best.sum(axis=1, keepdims=True) > 1e-6
    weights = np.zeros((len(best), ANCHORS))
    names = np.zeros((len(best), ANCHORS), np.int32)
    even = np.full_like(cut, 1.0 / keep)
    weights[:, :keep] = np.where(reached, np.where(total > 1e-12, cut / np.maximum(total, 1e-12), even), 0.0)
    names[:, :keep] = anchors[owner[:, :keep]]
    return names, weights
