"""Which place of a scan's skin each vertex of a fitted face is: by place, normal, and the side of every slit.

On which side of a slit between lids or lips a point lies is told by the way along the skin, for both may touch.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import cKDTree

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.geometry.proximity import nearest_weights
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace

Edges = NDArray[np.integer]

# Sides are told so far from a line, metres; those of the other skin start from what lies so far from ours.
SLIT_REACH = 0.014
SEEDS = (0.003, 0.008)
# A point has a side where the way to one side is shorter than to the other by this share of both; a seed, by more.
SIDE_CLEAR = 0.4
SEED_SURE = 0.5
# Near its corners a line has no sides, this share of its length at each end.
CORNERS = 0.12
# A normal that is the other way round is as far as twice so many metres: the face lies on the scan already, and where
# lids curl a stronger pull to what looks the same way slides along them.
TURN = 0.0007
# Of so many samples nearest in place and way, the triangles are looked at.
CANDIDATES = 6
# A match farther than this, metres, says nothing; normals of one lie within 90 degrees, for the rim of a lid turns by
# as much from one row to the next.
FAR = 0.0025
ALIKE = 0.0


def our_sides(space: ParameterSpace, line: Line, skin: Values, /) -> tuple[Values, Values]:
    """How clearly each vertex of a skin (V, 3) is above a line (1) or below it (-1), (V,), and how far it is from it
    along the skin, metres (V,).

    space, line: the slit and whose it is; skin (V, 3): metres.
    """
    graph = mesh.edge_graph(skin, space.sheet_triangles)
    halves = []
    for chain in chains(space.points, line.loop):
        cut = max(int(CORNERS * len(chain)), 1)
        halves.append(np.asarray(chain[cut:-cut], np.intp))
    return _compare_ways(graph, halves[0], halves[1], 2.0 * SLIT_REACH)


def other_sides(
    sides: Values, away: Values, skin: Values, points: Values, graph: sparse.csr_array, used: Rows, /
) -> Values:
    """How clearly each point (n, 3) of another skin is above a line or below it, (n,): from where our skin's sides
    (V,), so far away (V,) from the line, are sure, along edges of a graph (n, n) over its used rows.

    sides (V,), away (V,), skin (V, 3): of our skin, metres; points (n, 3): metres; graph (n, n), used (k,): edges, and
    the rows that they join.
    """
    near = (away > SEEDS[0]) & (away < SEEDS[1])
    tree = cKDTree(points[used])
    seeds = []
    for way in (1.0, -1.0):
        rows = np.flatnonzero(near & (way * sides > SEED_SURE))
        seeds.append(np.unique(used[tree.query(skin[rows], workers=1)[1]]) if len(rows) else np.zeros(0, np.intp))
    both = np.intersect1d(seeds[0], seeds[1])
    above, below = (np.setdiff1d(rows, both) for rows in seeds)
    if not len(above) or not len(below):
        return np.zeros(len(points))
    return _compare_ways(graph, above, below, 3.0 * SLIT_REACH)[0]


def _compare_ways(graph: sparse.csr_array, above: Rows, below: Rows, limit: float) -> tuple[Values, Values]:
    """How much nearer each row is to those above than to those below, of both, and how far from either."""
    up, down = (
        np.minimum(dijkstra(graph, directed=False, indices=rows, min_only=True, limit=limit), limit)
        for rows in (above, below)
    )
    return (down - up) / np.maximum(down + up, 1e-9), np.minimum(up, down)


@dataclass(frozen=True, eq=False)
class Correspondence:
    """For each vertex of our skin (V,): the corners (V, 3) of a scan's triangle, weights (V, 3) of them, and how sure
    that is (V,), 0 to 1."""

    corners: Rows
    weights: Values
    sure: Values

    def carry(self, moves: Values, /) -> Values:
        """What a displacement (n, 3) of the scan does at each vertex, (V, 3)."""
        return np.einsum("vk,vkc->vc", self.weights, moves[self.corners])


def correspond(
    space: ParameterSpace, skin: Values, points: Values, triangles: NDArray[np.integer], surface: ScanSurface, /
) -> Correspondence:
    """Where the vertices of a fitted skin (V, 3) lie on a scan (n, 3), (t, 3) in the same frame, of which a surface
    shows the skin.

    space, skin (V, 3): the face, metres; points (n, 3), triangles (t, 3): the scan; surface: samples of its skin.
    """
    normals = mesh.normals(skin, space.triangles)
    count = space.vertex_count
    rows = np.flatnonzero(space.on_sheet)
    owner = _nearest(space, skin, normals, points, triangles, surface, rows)
    corners = triangles[owner].astype(np.intp)
    weights, off = nearest_in(points[corners], skin[rows])
    across = mesh.unit_normals(points[corners])
    alike = (across * normals[rows]).sum(axis=1)
    sure = np.where(alike > ALIKE, (1.0 - np.minimum(np.linalg.norm(off, axis=1) / FAR, 1.0) ** 2) ** 2, 0.0)
    correspondence = Correspondence(np.zeros((count, 3), np.intp), np.zeros((count, 3)), np.zeros(count))
    correspondence.corners[rows], correspondence.weights[rows], correspondence.sure[rows] = corners, weights, sure
    return correspondence


def _nearest(
    space: ParameterSpace, skin: Values, normals: Values, points: Values, triangles: NDArray[np.integer],
    surface: ScanSurface, rows: Rows,
) -> Rows:  # fmt: skip
    """The triangle of the scan nearest to each row of the skin; beside a slit, of those on its side."""
    owner = _search(surface, np.arange(len(surface.points)), points, triangles, skin[rows], normals[rows])
    joined = mesh.weld(points)
    welded = joined[triangles[np.unique(surface.triangle)]]
    graph = mesh.edge_graph(points, welded)
    used = np.unique(welded)
    for line in space.lines:
        sides, away = our_sides(space, line, skin)
        others = other_sides(sides, away, skin, points, graph, used)
        sampled = others[joined[triangles[surface.triangle]]].mean(axis=1)
        for way in (1.0, -1.0):
            mine = np.flatnonzero((away[rows] < SLIT_REACH) & (way * sides[rows] > SIDE_CLEAR))
            allowed = np.flatnonzero(way * sampled > -SIDE_CLEAR)
            if len(mine) and len(allowed):
                owner[mine] = _search(surface, allowed, points, triangles, skin[rows[mine]], normals[rows[mine]])
    return owner


def _search(
    surface: ScanSurface, allowed: Rows, points: Values, triangles: NDArray[np.integer], asked: Values, normals: Values
) -> Rows:
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
    that is, (m, 3) (Ericson 2005, section 5.1.5).

    corners (m, 3, 3), asked (m, 3): metres.
    """
    weights = nearest_weights(corners, asked)
    return weights, asked - np.einsum("mk,mkc->mc", weights, corners)
