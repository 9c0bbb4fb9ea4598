"""The maps that are compared, each prepared once per face: a unit's name in, the face's positions out."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.deformation import DeformationTransfer, rims
from benchmarks.maps.source import Source
from omote.model.space.face import Face
from omote.model.transfer.compound import apply_expression
from omote.model.transfer.smooth_map import prepare_smooth_map

Values = NDArray[np.float64]
Map = Callable[[str], Values]


def add_deltas(source: Source, face: Face) -> Map:
    """Added deltas: what blendshape tools do."""
    positions = face.positions.astype(np.float64)
    return lambda unit: positions + source.moves[unit]


def deformation(source: Source, face: Face) -> Map:
    """Deformation transfer after Sumner & Popovic (2004)."""
    held = rims(source.space.location_triangles)
    solver = DeformationTransfer(source.positions, face.positions.astype(np.float64), source.sheet, held)
    return lambda unit: solver(source.moves[unit])


def plain(source: Source, face: Face) -> Map:
    """The paper's map as it stands: located on S once for all faces, one gather (section 2.2)."""
    reference = source.cast.under("paper")
    return lambda unit: apply_expression(reference.space, face, source.compiled[unit]).astype(np.float64)


def smooth(source: Source, face: Face) -> Map:
    """Ours: contact kept, nothing folded (docs/method.md, "The smooth map")."""
    prepare_smooth_map(source.space, face)
    return lambda unit: apply_expression(source.space, face, source.compiled[unit]).astype(np.float64)


DELTAS = "added deltas"
DEFORMATION = "deformation transfer"
PAPER = "the paper's map"
OURS = "ours"
METHODS: dict[str, Callable[[Source, Face], Map]] = {
    DELTAS: add_deltas,
    DEFORMATION: deformation,
    PAPER: plain,
    OURS: smooth,
}
