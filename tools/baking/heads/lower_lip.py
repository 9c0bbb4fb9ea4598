"""Rounds the lower lip of the open jaw: the published unit draws it down as a V, by the most at its middle."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

from omote.geometry import mesh
from omote.geometry.ramp import smooth_ramp
from omote.model.space.lid_lip_lines import chains
from omote.model.space.parameter_space import ParameterSpace
from tools.baking.expressions import PERFORMED, unit_weights
from tools.baking.heads.basemesh import Floats, Ints
from tools.baking.heads.moves import Move

UNIT = "jawOpen"
# Along the mesh from the lower lip's line, metres: up to the first the skin goes along in full, from the second on not.
# Between lie the lip's red and the chin.
WHOLE = 0.010
REACH = 0.035
# What is a parabola at 2, and rounder above: the drop from corner to middle is 1 - |x|^ROUND of the half width.
ROUND = 2.3


def round_lower_lip(space: ParameterSpace, moves: Mapping[str, Move]) -> dict[str, Move]:
    """The moves with the lower lip of jawOpen round instead of pointed, and so in what is performed with it.

    Corners and middle go as far as before; between them the lip goes deeper, and the skin around it with it.

    space: of the generic face; moves: by expression.
    """
    halves = chains(space.points, space.welded[next(line.loop for line in space.lines if line.kind == "lips")])
    deeper = measure_missing_drop(space.points[halves[1]], moves[UNIT].skin[halves[1]])
    down = np.interp(space.points[:, 0], space.points[halves[1], 0], deeper, left=0.0, right=0.0)
    extra = np.zeros((space.vertex_count, 3))
    extra[:, 1] = -down * _share_of_lower_lip(space, *halves)
    weights = {UNIT: 1.0, **{name: unit_weights(recipe).get(UNIT, 0.0) for name, recipe in PERFORMED.items()}}
    return {name: Move(move.skin + weights.get(name, 0.0) * extra, move.parts) for name, move in moves.items()}


def measure_missing_drop(line: Floats, moved: Floats) -> Floats:
    """How much deeper each point of a lip's line (n, 3), from corner to corner, has to go than by displacements (n, 3)
    for a round lip, (n,) metres, never less than nothing.

    line, moved: metres.
    """
    x = line[:, 0]
    drop = -moved[:, 1]
    corner = 0.5 * (drop[0] + drop[-1])
    middle = drop.max()
    half = np.abs(2.0 * (x - x[0]) / (x[-1] - x[0]) - 1.0)
    missing: Floats = np.maximum(corner + (middle - corner) * (1.0 - half**ROUND) - drop, 0.0)
    missing[[0, -1]] = 0.0
    return missing


def _share_of_lower_lip(space: ParameterSpace, upper: Ints, lower: Ints) -> Floats:
    """How far each vertex goes with the lower lip, (V,): in full beside it, not where the upper one is nearer."""
    edges = mesh.edges(space.welded[space.triangles]).astype(np.int64)
    lengths = np.linalg.norm(space.points[edges[:, 0]] - space.points[edges[:, 1]], axis=1)
    graph = coo_array((lengths, (edges[:, 0], edges[:, 1])), shape=(space.vertex_count, space.vertex_count)).tocsr()
    up, down = (
        dijkstra(graph, directed=False, indices=half[1:-1], min_only=True, limit=2.0 * REACH)[space.welded]
        for half in (upper, lower)
    )
    share = 1.0 - smooth_ramp(WHOLE, REACH, np.minimum(down, REACH))
    result: Floats = np.where(down < up, share, 0.0)
    return result
