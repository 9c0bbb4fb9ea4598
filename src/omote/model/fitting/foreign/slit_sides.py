"""On which side of a slit between lids or lips points lie: by the way along the skin, for both may touch."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import cKDTree

from omote.model.space.lid_lip_lines import Line, chains
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]
Indices = NDArray[np.intp]
Edges = NDArray[np.integer]

# Sides are told so far from a line, metres; those of the other skin start from what lies so far from ours.
REACH, SEEDS = 0.014, (0.003, 0.008)
# A point has a side where the way to one side is shorter than to the other by this share of both; a seed, by more.
CLEAR, SURE = 0.4, 0.5
# Near its corners a line has no sides, this share of its length at each end.
CORNERS = 0.12


def edge_graph(points: Values, triangles: Edges, /) -> sparse.csr_array:
    """The graph (n, n) of a mesh's edges with their lengths, metres."""
    ends = np.unique(
        np.sort(np.stack([triangles, np.roll(triangles, 1, axis=1)], axis=2).reshape(-1, 2), axis=1), axis=0
    )
    lengths = np.maximum(np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1), 1e-9)
    return sparse.csr_array(sparse.coo_array((lengths, (ends[:, 0], ends[:, 1])), shape=(len(points), len(points))))


def our_sides(space: ParameterSpace, line: Line, skin: Values, /) -> tuple[Values, Values]:
    """How clearly each vertex of a skin (V, 3) is above a line (1) or below it (-1), (V,), and how far it is from it
    along the skin, metres (V,)."""
    graph = edge_graph(skin, space.sheet_triangles)
    halves = []
    for chain in chains(space.points, line.loop):
        cut = max(int(CORNERS * len(chain)), 1)
        halves.append(np.asarray(chain[cut:-cut], np.intp))
    return _compare(graph, halves[0], halves[1], 2.0 * REACH)


def other_sides(
    sides: Values, away: Values, skin: Values, points: Values, graph: sparse.csr_array, used: Indices, /
) -> Values:  # fmt: skip
    """How clearly each point (n, 3) of another skin is above a line or below it, (n,): from where our skin's sides
    (V,), so far away (V,) from the line, are sure, along edges of a graph (n, n) over its used rows."""
    near = (away > SEEDS[0]) & (away < SEEDS[1])
    tree, found = cKDTree(points[used]), []
    for way in (1.0, -1.0):
        rows = np.flatnonzero(near & (way * sides > SURE))
        found.append(np.unique(used[tree.query(skin[rows], workers=1)[1]]) if len(rows) else np.zeros(0, np.intp))
    both = np.intersect1d(found[0], found[1])
    above, below = (np.setdiff1d(rows, both) for rows in found)
    if not len(above) or not len(below):
        return np.zeros(len(points))
    return _compare(graph, above, below, 3.0 * REACH)[0]


def _compare(graph: sparse.csr_array, above: Indices, below: Indices, limit: float) -> tuple[Values, Values]:
    """How much nearer each row is to those above than to those below, of both, and how far from either."""
    up, down = (
        np.minimum(dijkstra(graph, directed=False, indices=rows, min_only=True, limit=limit), limit)
        for rows in (above, below)
    )
    return (down - up) / np.maximum(down + up, 1e-9), np.minimum(up, down)
