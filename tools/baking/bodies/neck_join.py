"""How what a head's edge is off a body's own spreads over the neck and shoulders: biharmonic shares, found once."""

from __future__ import annotations

import numpy as np
from scipy.sparse.csgraph import dijkstra

from omote.geometry.laplacian import bending_energy, factor_symmetric
from omote.geometry.mesh import edge_graph
from tools.baking.bodies.figure_cut import FigureCut
from tools.baking.heads.basemesh import Floats, Ints

REACH = 0.16
"""Metres along the skin from the rim, on the generic body (1.67 m), to which a head moves it: at 16 cm no mix of the
cast's heads and bodies folds; a harmonic join over the same way folds 38 times in a thousand."""


def find_join(cut: FigureCut, points: Floats) -> tuple[Ints, Floats]:
    """The rows of the body (0 is its first) that follow the head's edge, and their shares of it (n, e).

    Between the edge, which moves as it does, and the rows beyond `REACH`, which stay, the skin bends as little as it
    can (squared Laplacian, masses of the generic body).

    cut: of the figure; points (V + B, 3): the generic figure, metres.
    """
    way = dijkstra(edge_graph(points, cut.triangles), indices=cut.edge[: cut.rim], min_only=True, directed=False)
    free = np.flatnonzero(way < REACH)
    free = free[free >= cut.head_rows].astype(np.int32)
    used = np.union1d(cut.triangles, _above(cut))
    triangles = cut.all_triangles[np.isin(cut.all_triangles, used).all(axis=1)]
    energy, _ = bending_energy(points, triangles)
    solver = factor_symmetric(energy[free][:, free])
    shares = solver.solve(-energy[free][:, cut.edge].toarray())
    return (free - cut.head_rows).astype(np.int32), np.asarray(shares)


def _above(cut: FigureCut) -> Ints:
    """The head's edge and the ring of rows above it: what bends with the skin near the rim."""
    triangles = cut.all_triangles
    touching = triangles[np.isin(triangles, cut.edge).any(axis=1)]
    return np.unique(touching)
