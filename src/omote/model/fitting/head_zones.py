"""How much each vertex of the generic head is fitted by what a scan shows there, and where its openings are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.spatial import cKDTree

from omote.arrays import Mask, Values
from omote.model.fitting.landmarks import find_landmarks
from omote.model.space.head_regions import region_weights
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

EARS = 0.35
NOSTRILS = 0.3
# Lids and lips reach so far from their lines, metres on the generic head, nostrils so far from below the nose's tip.
LIDS = 0.004
LIPS = 0.006
NOSE = 0.009
# From the nose's tip to the nostril of its side, metres.
_NOSTRIL = (0.007, -0.008, -0.010)


@dataclass(frozen=True, eq=False)
class HeadZones:
    """Masks and weights of the generic head's vertices (V,).

    weights: how much what is seen counts; face: without ears, skull and nape; lids, lips, nostrils: around the
    openings.
    """

    weights: Values
    face: Mask
    lids: Mask
    lips: Mask
    nostrils: Mask

    @property
    def closed(self) -> Mask:
        """The sheet's vertices (V,) that lie at no opening."""
        return (self.weights > 0.0) & ~self.lids & ~self.lips & ~self.nostrils


@weakly_cached
def head_zones(space: ParameterSpace, /) -> HeadZones:
    """The zones of a space, found once; ValueError where it names no lids and lips."""
    sheet = space.on_sheet
    points = space.points
    owned = region_weights(space)
    tip = points[find_landmarks(space)["nose_tip"]]
    nostrils = [np.linalg.norm(points - tip - np.multiply(_NOSTRIL, (side, 1, 1)), axis=1) < NOSE for side in (1, -1)]
    weights = sheet * (1.0 - (1.0 - EARS) * owned["ears"])
    nose = sheet & (nostrils[0] | nostrils[1])
    weights[nose] = NOSTRILS
    lids = [line for line in space.lines if line.kind == "lids"]
    lips = [line for line in space.lines if line.kind == "lips"]
    face = sheet & (owned["ears"] + owned["skull"] < 0.3)
    return HeadZones(weights, face, sheet & _near(points, lids, LIDS), sheet & _near(points, lips, LIPS), nose)


def _near(points: Values, lines: list[Line], reach: float) -> Mask:
    away, _ = cKDTree(points[np.concatenate([line.loop for line in lines])]).query(points)
    return np.asarray(away < reach)


def row_matrix(rows: NDArray[np.integer], count: int, /) -> sparse.csr_array:
    """The matrix (k, count) that picks rows (k,)."""
    return sparse.csr_array((np.ones(len(rows)), (np.arange(len(rows)), rows)), shape=(len(rows), count))


def rung_matrix(line: Line, count: int, /) -> sparse.csr_array:
    """The matrix (RUNGS, count) that gives the rungs of a line."""
    rungs, width = line.vertices.shape
    rows = np.repeat(np.arange(rungs), width)
    return sparse.csr_array((line.weights.ravel(), (rows, line.vertices.ravel())), shape=(rungs, count))
