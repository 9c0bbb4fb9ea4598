"""Finds the axis of a head, its one-layered skin sheet and the membranes over the sheet's holes
(docs/method.md, "The skin sheet")."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from omote.arrays import Indices, Mask, Points, Triangles, Values
from omote.geometry import mesh
from omote.geometry.cylinder import Cylinder, wrap
from omote.geometry.membrane import close_loop
from omote.geometry.outer_layer import keep_outer_layer
from omote.geometry.proximity import winding_numbers

# A triangle that spans more of the circle than this contains the axis or nearly so: S is not flat there.
_WIDEST = 0.9 * np.pi
# The crown is what is so near to the axis, metres.
CROWN = 0.04


def refuse_degenerate(points: Points, triangles: Triangles, /) -> None:
    """Raises ValueError where a triangle has no area (relative to the mesh's size).

    points: (V, 3), metres; triangles: rows (F, 3) of vertices.
    """
    size = float(np.ptp(points, axis=0).max())
    flat = np.flatnonzero(mesh.areas(points, triangles) <= 1e-13 * size * size)
    if len(flat):
        raise ValueError(
            f"triangle {flat[0]} (vertices {triangles[flat[0]]}) has no area, and {len(flat) - 1} more; "
            "expected a mesh without degenerate triangles: merge or remove them"
        )


def find_axis(points: Points, triangles: Triangles, /) -> tuple[float, float]:
    """(x, z) of a vertical axis inside the skull: the mean centre of slices through the upper half of the largest
    piece.

    points: (V, 3), metres; triangles: rows (F, 3) of vertices.
    """
    labels = mesh.components(mesh.weld(points)[triangles], len(points))
    head = points[labels[mesh.weld(points)] == 0]
    low = head[:, 1].min()
    high = head[:, 1].max()
    centres = []
    for share in np.linspace(0.6, 0.9, 13):
        slice_ = head[np.abs(head[:, 1] - (low + share * (high - low))) < 0.04 * (high - low)]
        if len(slice_):
            centres.append((slice_[:, [0, 2]].min(axis=0) + slice_[:, [0, 2]].max(axis=0)) / 2)
    if not centres:
        raise ValueError(
            f"no vertex lies in the upper half of the mesh, between heights {low:.4g} and {high:.4g}; "
            "expected a head, y up and +z forward"
        )
    x, z = np.mean(centres, axis=0)
    return float(x), float(z)


def refuse_axis_outside(points: Points, corners: Triangles, cylinder: Cylinder, /) -> None:
    """Raises ValueError where the axis does not run inside the head: the winding number of sheet and membranes decides.

    cylinder: the axis of S.

    points (V, 3), corners (L, 3) sheet and membranes. Tried at five heights in the upper half of the sheet, up to the
    crown over the axis: ears may stand higher.
    """
    low = points[corners, 1].min()
    high = _crown_height(points, corners, cylinder)
    heights = low + np.linspace(0.5, 0.85, 5) * (high - low)
    probes = np.stack([np.full(5, cylinder.x), heights, np.full(5, cylinder.z)], axis=1)
    outside = heights[winding_numbers(points[corners], probes) < 0.5]
    if len(outside):
        raise ValueError(
            f"the axis at x = {cylinder.x:.4g}, z = {cylinder.z:.4g} is outside the head at height {outside[0]:.4g}; "
            "expected a head, y up and +z forward, counter-clockwise triangles, that stands around the axis"
        )


def _crown_height(points: Points, corners: Triangles, cylinder: Cylinder) -> float:
    """How high the sheet is near the axis; over all where nothing of its upper half is near."""
    sheet = points[np.unique(corners)]
    near = sheet[np.hypot(sheet[:, 0] - cylinder.x, sheet[:, 2] - cylinder.z) < CROWN, 1]
    highest: float = float(sheet[:, 1].max())
    crown = float(near.max(initial=-np.inf))
    return crown if crown > 0.5 * (highest + float(sheet[:, 1].min())) else highest


def unwrap_corners(theta: Values, corners: Triangles, /) -> Values:
    """theta of each triangle's corners (L, 3), continuous within the triangle across the seam."""
    first = theta[corners[:, :1]]
    return first + wrap(theta[corners] - first)


def cut_sheet(points: Points, corners: Triangles, theta: Values, h: Values, cylinder: Cylinder, /) -> Mask:
    """Cuts the one-layered skin sheet out of a head.

    points: (V, 3), metres; theta: (V,), radians; h: (V,), metres; cylinder: the axis of S.

    corners (F, 3) with seams welded. The sheet is the flood fill, from a forehead triangle, over triangles that face
    outward in S, the outer one wherever two lie over each other: S has one layer. Returns the mask (F,) of the sheet.
    """
    keep = find_outward(theta, h, corners)
    seed = _forehead(points, corners, keep, cylinder)
    keep = _flood(corners, keep, seed)
    metric = float(np.hypot(points[:, 0] - cylinder.x, points[:, 2] - cylinder.z)[corners[keep]].mean())
    keep = _flood(corners, _outermost(points, corners, keep, theta, h, cylinder, metric), seed)
    if keep.sum() < 16:
        raise ValueError(
            f"the skin sheet has {keep.sum()} triangles; "
            "expected a head whose forehead faces +z, wound counter-clockwise"
        )
    return keep


def find_outward(theta: Values, h: Values, corners: Triangles, /) -> Mask:
    """Finds the triangles that have positive area in S and do not hold the axis: (F,).

    theta: (V,), radians; h: (V,), metres; corners: (F, 3) rows of the triangles.
    """
    unrolled = unwrap_corners(theta, corners)
    height = h[corners]
    span = wrap(np.roll(unrolled, -1, axis=1) - unrolled)
    whole = (np.abs(span).max(axis=1) < _WIDEST) & (np.abs(span.sum(axis=1)) < 1.0)
    a, b = unrolled[:, 1:] - unrolled[:, :1], height[:, 1:] - height[:, :1]
    doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return whole & (doubled > 1e-12 * np.ptp(h))


def _forehead(points: Points, corners: Triangles, keep: Mask, cylinder: Cylinder) -> int:
    """The foremost outward triangle that a ray straight ahead meets at three quarters of the largest piece's height."""
    labels = mesh.components(corners, len(points))
    head = np.unique(corners[labels[corners[:, 0]] == 0])
    height = np.quantile(points[head, 1], [0.0, 1.0]) @ [0.25, 0.75]
    relative = points[corners] - [cylinder.x, height, cylinder.z]
    u, w = relative[..., 0], relative[..., 1]
    edges = np.roll(u, -1, axis=1) * np.roll(w, -2, axis=1) - np.roll(u, -2, axis=1) * np.roll(w, -1, axis=1)
    hit = keep & (edges >= 0).all(axis=1) & (relative[..., 2].mean(axis=1) > 0) & (labels[corners[:, 0]] == 0)
    if not hit.any():
        raise ValueError(
            f"no outward triangle lies straight ahead of the axis at x = {cylinder.x:.4g}, z = {cylinder.z:.4g}, "
            f"height {height:.4g}; expected a head, y up and +z forward, wound counter-clockwise"
        )
    return int(np.where(hit, relative[..., 2].mean(axis=1), -np.inf).argmax())


def _flood(corners: Triangles, keep: Mask, seed: int) -> Mask:
    across = mesh.neighbours(corners)
    rows, sides = np.nonzero((across >= 0) & keep[:, None])
    others = across[rows, sides]
    linked = keep[others]
    graph = coo_array((np.ones(linked.sum(), np.int8), (rows[linked], others[linked])), shape=(len(corners),) * 2)
    _, label = connected_components(graph, directed=False)
    return keep & (label == label[seed])


def _outermost(
    points: Points, corners: Triangles, keep: Mask, theta: Values, h: Values, cylinder: Cylinder, metric: float
) -> Mask:
    radius = np.hypot(points[:, 0] - cylinder.x, points[:, 2] - cylinder.z)[corners].mean(axis=1)
    unrolled = unwrap_corners(theta, corners) * metric
    rows = np.flatnonzero(keep)
    left = np.ones(len(rows), np.bool_)
    cell = float(mesh.edge_lengths(points, corners[rows]).mean()) * 2
    keep_outer_layer(unrolled[rows], h[corners[rows]], radius[rows], 2 * np.pi * metric, cell, left)
    result = keep.copy()
    result[rows[~left]] = False
    return result


def close_holes(points: Points, sheet: Triangles, theta: Values, h: Values, cylinder: Cylinder, /) -> Triangles:
    """The membranes (m, 3): triangles over every hole of a sheet (f, 3), seams welded; the rims that go once around the
    axis (neck, crown) stay open.

    points: (V, 3), metres; theta: (V,), radians; h: (V,), metres; cylinder: the axis of S.
    """
    metric = float(np.hypot(points[:, 0] - cylinder.x, points[:, 2] - cylinder.z)[sheet].mean())
    plane = np.stack([theta * metric, h], axis=1)
    membranes = [np.zeros((0, 3), np.int32)]
    for loop in mesh.boundary_loops(sheet, plane, period=2 * np.pi * metric):
        hole = loop[::-1]
        steps = wrap(np.roll(theta[hole], -1) - theta[hole])
        if abs(steps.sum()) > np.pi:
            continue
        around = theta[hole[0]] + np.concatenate([[0.0], np.cumsum(steps[:-1])])
        membranes.append(hole[close_loop(np.stack([around * metric, plane[hole, 1]], axis=1))])
    return np.concatenate(membranes).astype(np.int32)


def bind_islands(
    points: Points, vertices: Indices, sheet: NDArray[np.int64], anchors: Indices, weights: Values, /
) -> tuple[Indices, Values]:
    """Gives vertices that no path along the mesh joins to the sheet (their weights are all zero) their four nearest
    on it.

    points: (V, 3), metres; anchors: (n, ANCHORS) vertices that each of the n vertices follows.
    """
    alone = np.flatnonzero(weights.sum(axis=1) < 0.5)
    if len(alone) == 0:
        return anchors, weights
    distance, nearest = cKDTree(points[sheet]).query(points[vertices[alone]], k=4)
    share = 1.0 / np.maximum(distance, 1e-9)
    anchors = anchors.copy()
    weights = weights.copy()
    anchors[alone[:, None], np.arange(4)] = sheet[nearest]
    weights[alone] = 0.0
    weights[alone[:, None], np.arange(4)] = share / share.sum(axis=1, keepdims=True)
    return anchors, weights
