"""Which place of a scan's skin each vertex of a fitted face is: by place, normal, and the side of every slit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.geometry import mesh
from omote.model.fitting.foreign.slit_sides import CLEAR, REACH, edge_graph, other_sides, our_sides
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
Rows = NDArray[np.intp]

# A normal that is the other way round is as far as twice so many metres: the face lies on the scan already, and where
# lids curl a stronger pull to what looks the same way slides along them.
TURN = 0.0007
# Of so many samples nearest in place and way, the triangles are looked at.
CANDIDATES = 6
# A match farther than this, metres, says nothing; normals of one lie within 90 degrees, for the rim of a lid turns by
# as much from one row to the next.
FAR, ALIKE = 0.0025, 0.0


@dataclass(frozen=True, eq=False)
class Correspondence:
    """For each vertex of our skin (V,): the corners (V, 3) of a scan's triangle, weights (V, 3) of them, and how sure
    that is (V,), 0 to 1."""

    corners: Rows
    weights: Values
    sure: Values

    def carry(self, moves: Values, /) -> Values:
        """What a displacement (n, 3) of the scan does at each vertex, (V, 3)."""
        result: Values = np.einsum("vk,vkc->vc", self.weights, moves[self.corners])
        return result


def correspond(
    space: ParameterSpace, skin: Values, points: Values, triangles: NDArray[np.integer], surface: ScanSurface, /
) -> Correspondence:  # fmt: skip
    """Where the vertices of a fitted skin (V, 3) lie on a scan (n, 3), (t, 3) in the same frame, of which a surface
    shows the skin."""
    normals, count = mesh.normals(skin, space.triangles), space.vertex_count
    rows = np.flatnonzero(space.on_sheet)
    owner = _nearest(space, skin, normals, points, triangles, surface, rows)
    corners = triangles[owner].astype(np.intp)
    weights, off = nearest_in(points[corners], skin[rows])
    across = mesh.unit_normals(points[corners])
    alike = (across * normals[rows]).sum(axis=1)
    sure = np.where(alike > ALIKE, (1.0 - np.minimum(np.linalg.norm(off, axis=1) / FAR, 1.0) ** 2) ** 2, 0.0)
    found = Correspondence(np.zeros((count, 3), np.intp), np.zeros((count, 3)), np.zeros(count))
    found.corners[rows], found.weights[rows], found.sure[rows] = corners, weights, sure
    return found


def _nearest(
    space: ParameterSpace, skin: Values, normals: Values, points: Values, triangles: NDArray[np.integer],
    surface: ScanSurface, rows: Rows,
) -> Rows:  # fmt: skip
    """The triangle of the scan nearest to each row of the skin; beside a slit, of those on its side."""
    owner = _search(surface, np.arange(len(surface.points)), points, triangles, skin[rows], normals[rows])
    joined = mesh.weld(points)
    welded = joined[triangles[np.unique(surface.triangle)]]
    graph, used = edge_graph(points, welded), np.unique(welded)
    for line in space.lines:
        sides, away = our_sides(space, line, skin)
        others = other_sides(sides, away, skin, points, graph, used)
        sampled = others[joined[triangles[surface.triangle]]].mean(axis=1)
        for way in (1.0, -1.0):
            mine = np.flatnonzero((away[rows] < REACH) & (way * sides[rows] > CLEAR))
            allowed = np.flatnonzero(way * sampled > -CLEAR)
            if len(mine) and len(allowed):
                owner[mine] = _search(surface, allowed, points, triangles, skin[rows[mine]], normals[rows[mine]])
    return owner


def _search(
    surface: ScanSurface, allowed: Rows, points: Values, triangles: NDArray[np.integer], asked: Values, normals: Values
) -> Rows:  # fmt: skip
    """The triangle of some samples that is nearest in place and way to points (m, 3) with normals (m, 3)."""
    tree = cKDTree(np.hstack([surface.points, TURN * surface.normals])[allowed])
    _, near = tree.query(np.hstack([asked, TURN * normals]), k=CANDIDATES, workers=1)
    owners = surface.triangle[allowed[np.minimum(near, len(allowed) - 1)]]
    corners = points[triangles[owners]]
    turned = (mesh.unit_normals(corners.reshape(-1, 3, 3)).reshape(*owners.shape, 3) - normals[:, None]) * TURN
    _, off = nearest_in(corners.reshape(-1, 3, 3), np.repeat(asked, CANDIDATES, axis=0))
    cost = (off**2).sum(axis=1).reshape(owners.shape) + (turned**2).sum(axis=2)
    return np.asarray(np.take_along_axis(owners, cost.argmin(axis=1)[:, None], axis=1)[:, 0], np.intp)


def nearest_in(corners: Values, asked: Values, /) -> tuple[Values, Values]:
    """The weights (m, 3) of the place in each triangle (m, 3, 3) that is nearest to a point (m, 3), and how far off
    that is, (m, 3) (Ericson 2005, section 5.1.5)."""
    a = corners[:, 0]
    u, v, p = corners[:, 1] - a, corners[:, 2] - a, asked - a
    uu, uv, vv = (u * u).sum(1), (u * v).sum(1), (v * v).sum(1)
    up, vp = (u * p).sum(1), (v * p).sum(1)
    area = np.maximum(uu * vv - uv * uv, 1e-30)
    inside = np.stack([(vv * up - uv * vp) / area, (uu * vp - uv * up) / area], axis=1)
    zero, one = np.zeros(len(a)), np.ones(len(a))
    on_u = np.clip(up / np.maximum(uu, 1e-30), 0.0, 1.0)
    on_v = np.clip(vp / np.maximum(vv, 1e-30), 0.0, 1.0)
    over = np.clip(((v - u) * (p - u)).sum(1) / np.maximum(((v - u) ** 2).sum(1), 1e-30), 0.0, 1.0)
    edges = np.stack([np.stack(pair, axis=1) for pair in ((on_u, zero), (zero, on_v), (one - over, over))])
    off = p - edges[..., :1] * u - edges[..., 1:] * v
    best = (off**2).sum(axis=2).argmin(axis=0)
    good = (inside >= 0.0).all(axis=1) & (inside.sum(axis=1) <= 1.0)
    chosen = np.where(good[:, None], inside, edges[best, np.arange(len(a))])
    weights = np.column_stack([1.0 - chosen.sum(axis=1), chosen])
    return weights, asked - np.einsum("mk,mkc->mc", weights, corners)
