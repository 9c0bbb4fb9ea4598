"""Upper and lower side of lids and lips: control points on one side of an opening do not move the other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from omote.arrays import Indices, Mask, Values
from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

Sides = NDArray[np.int8]

# A triangle is carried on beyond its edge by so much of its weights; what lies farther off goes with the edge.
_BEYOND = 0.5


@weakly_cached
def sides(space: ParameterSpace, /) -> Sides:
    """The side of each line of lids or lips on which each vertex lies: (lines, V), 1 above, -1 below, 0 beside it or
    off the sheet."""
    of_lines = [_of_line(space, line) for line in space.lines]
    return np.stack(of_lines) if of_lines else np.zeros((0, space.vertex_count), np.int8)


def is_across(vertices: Sides, corners: Sides, /) -> Mask:
    """Where a vertex lies across an opening from one of a triangle's corners.

    vertices (lines, ...), corners (lines, ..., 3): their sides, broadcast together.
    """
    return np.asarray((vertices[..., None] * corners < 0).any(axis=(0, -1)), np.bool_)


def nearest_own_side(vertices: Sides, points: Sides, triangles: Indices, corners: Values, where: Values, /) -> Indices:
    """Of a net's triangles (t, 3) the nearest to each vertex that has no corner across an opening: (n,); -1 for none.

    vertices (lines, n), points (lines, p): their sides; corners (t, 3, 2), where (n, 2): on S, theta and h in metres,
    theta of the corners anywhere.
    """
    nearest = np.full(where.shape[0], -1, np.int32)
    for vertex, place in enumerate(where):
        allowed = np.flatnonzero(~is_across(vertices[:, vertex, None], points[:, triangles]))
        if len(allowed):
            nearest[vertex] = allowed[_distance(place, corners[allowed]).argmin()]
    return nearest


def clamp_weights(weights: Values, /) -> Values:
    """Clamps the barycentric weights (n, 3) of points far outside their triangles to the edge."""
    far = weights.min(axis=1) < -_BEYOND
    inside = np.maximum(weights, 0.0)
    return np.where(far[:, None], inside / inside.sum(axis=1, keepdims=True), weights)


def _distance(place: Values, corners: Values) -> Values:
    """How far a point (2,) is from each triangle with corners (t, 3, 2) counter-clockwise; negative inside, as deep."""
    a, b = corners - place, np.roll(corners, -1, axis=1) - place
    along = b - a
    length = np.maximum(np.linalg.norm(along, axis=2), 1e-12)
    share = np.clip(-(a * along).sum(axis=2) / length**2, 0.0, 1.0)
    outside = np.linalg.norm(a + share[..., None] * along, axis=2).min(axis=1)
    left = (a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]) / length
    return np.where((left >= 0).all(axis=1), -left.min(axis=1), outside)


def _of_line(space: ParameterSpace, line: Line) -> Sides:
    """Between the opening's corners the sheet falls into what hangs together with the upper and with the lower half."""
    rim = _rim(space, line)
    turned = wrap(space.theta - space.theta[rim[0]])
    between = space.on_sheet & (turned > turned[rim].min()) & (turned < turned[rim].max())
    corners = space.sheet_triangles
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    edges = edges[between[edges].all(axis=1)]
    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(space.vertex_count,) * 2)
    labels = connected_components(graph, directed=False)[1]
    side = np.zeros(space.vertex_count, np.int8)
    for sign, half in zip((1, -1), chains(space.points, line.loop), strict=True):
        inner = half[between[half]]
        side[between & (labels == np.bincount(labels[inner]).argmax())] = sign
    rest = np.flatnonzero(between & (side == 0))
    sided = np.flatnonzero(side)
    side[rest] = side[sided[cKDTree(space.points[sided]).query(space.points[rest])[1]]]
    return side[space.welded]


def _rim(space: ParameterSpace, line: Line) -> NDArray[np.integer]:
    """The sheet's own edge within a line: the boundary loop that shares most with it, the line itself where none
    does."""
    metric = float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())
    plane = np.stack([space.theta * metric, space.h], axis=1)
    loops = mesh.boundary_loops(space.sheet_triangles, plane, period=2 * np.pi * metric)
    best = max(loops, key=lambda loop: len(np.intersect1d(loop, line.loop)))
    return best if len(np.intersect1d(best, line.loop)) else line.loop
