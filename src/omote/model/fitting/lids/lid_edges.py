"""Lids of a head that is fitted go where the edges of the scan's are seen.

Planes of a surface do not say where along it a lid ends: on narrow eyes lines of lids came out up to four millimetres
above the edge, on the lid's skin. So near the end the plate is pulled: each rung's ends to where, on the scan, they are
to what is seen through the opening as on the generic head.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from omote.arrays import Rows, Values
from omote.model.fitting.lids.scan_slits import find_edges, find_slit
from omote.model.fitting.plate_fit import Hold
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import ScanSurface, whole_sheets
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity

# How strong an end of a rung is pulled, in the plate's own vertices.
STRENGTH = 4.0


@dataclass(frozen=True, eq=False)
class LidEdges:
    """Where lids of a scan end: points (n, 3), metres, and triangles (t, 3) of its skin; usual: for each line of lids,
    between which shares of its rungs (RUNGS, 2) one sees through on the generic head."""

    points: Values
    triangles: NDArray[np.integer]
    usual: tuple[tuple[Line, Values], ...]

    def find_pulls(self, skin: Values, /) -> list[Hold]:
        """What pulls the lids of a skin (V, 3) that lies near the scan; nothing where it shows no opening."""
        return [hold for line, usual in self.usual for hold in self._pull(line, usual, skin)]

    def _pull(self, line: Line, usual: Values, skin: Values) -> list[Hold]:
        slit = find_slit(line, skin, self.points, self.triangles)
        edges = find_edges(slit, self.points)
        seen = np.flatnonzero(np.isfinite(edges).all(axis=(1, 2)) & np.isfinite(usual).all(axis=1))
        if not slit.known or not len(seen):
            return []
        below, above = edges[seen].transpose(1, 0, 2)
        rungs = (above - below) / np.diff(usual[seen])
        lower = below - usual[seen, :1] * rungs
        return [
            Hold(_pick_ends(line, seen, ends, len(skin)), places, np.full(len(seen), STRENGTH))
            for ends, places in ((slice(0, 2), lower + rungs), (slice(2, 4), lower))
        ]


def see_lid_edges(space: ParameterSpace, scan: Scan, placement: Similarity, skin: ScanSurface, /) -> LidEdges | None:
    """The edges of a scan's lids, to be looked for; None for a cloud without triangles.

    space: of the head; scan, placement: where it lies; skin: the samples of its skin.
    """
    if scan.triangles is None or not len(scan.triangles):
        return None
    points = placement(scan.positions)
    triangles = np.asarray(scan.triangles)
    lines = [line for line in space.lines if line.kind == "lids"]
    usual = [(line, find_slit(line, space.points, space.points, space.triangles).open) for line in lines]
    return LidEdges(points, triangles[whole_sheets(points, triangles, skin)], tuple(usual))


def _pick_ends(line: Line, rungs: Rows, ends: slice, count: int) -> sparse.csr_array:
    """The matrix (k, count) that gives the upper or the lower ends of some rungs (k,)."""
    columns = line.vertices[rungs, ends].ravel()
    weights = np.abs(line.weights[rungs, ends]).ravel()
    rows = np.repeat(np.arange(len(rungs)), 2)
    return sparse.csr_array((weights, (rows, columns)), shape=(len(rungs), count))
