"""The maps that are compared: all units of a pair in, what they make of them on its face out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.deformation import DeformationTransfer, rims
from benchmarks.truths.pair import Carrier, Pair
from omote.model.extraction.extract import extract
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer import pipeline
from omote.model.transfer.compound import compound

Values = NDArray[np.float64]


def add_deltas(pair: Pair) -> Mapping[str, Values]:
    """Added deltas: what blendshape tools do."""
    return pair.given


def deform(pair: Pair) -> Mapping[str, Values]:
    """Deformation transfer after Sumner & Popovic (2004), of the sheet; skin off it is added."""
    space = pair.space
    rest = pair.face.positions.astype(np.float64)
    source = pair.source.positions.astype(np.float64)
    solver = DeformationTransfer(source, rest, space.sheet_triangles, rims(space.location_triangles))
    on = space.on_sheet[:, None]
    return {unit: np.where(on, (solver(moved) - rest)[space.welded], moved) for unit, moved in pair.given.items()}


def carry_by_paper(pair: Pair) -> Mapping[str, Values]:
    """The paper's map, both ways (section 2.2)."""
    return _carry_fields(pair, pair.space.under("paper"))


def carry(pair: Pair) -> Mapping[str, Values]:
    """Ours: extracted on the one, worn by the other."""
    return _carry_fields(pair, pair.space)


def carry_without_space(pair: Pair) -> Mapping[str, Values]:
    """Ours without extraction: the source stands in for the generic face, and what it does is carried at once."""
    space = as_generic(pair.space, pair.source)
    return {unit: _carry_once(space, pair.face, moved) for unit, moved in pair.given.items()}


def as_generic(space: ParameterSpace, face: Face) -> ParameterSpace:
    """The space with another face as the generic one; S stays, which nothing asks that begins with a displacement."""
    parts = {
        name: replace(part, points=face.parts[name].astype(np.float64)) if name in face.parts else part
        for name, part in space.parts.items()
    }
    return replace(space, points=face.positions.astype(np.float64), parts=MappingProxyType(parts))


def _carry_once(space: ParameterSpace, face: Face, moved: Values) -> Values:
    inner = space.inner
    sheet = (moved * space.on_sheet[:, None])[space.welded]
    residual = moved[inner.vertices] - np.einsum("nk,nkc->nc", inner.weights, sheet[inner.anchors])
    state = pipeline.start(space, face, sheet, residual.astype(np.float32))
    return pipeline.run(pipeline.STAGES, state).skin.astype(np.float64) - face.positions


def _carry_fields(pair: Pair, space: ParameterSpace) -> Mapping[str, Values]:
    fields: dict[str, Expression] = {
        unit: extract(space, pair.source, moved, parts=pair.parts.get(unit, {})) for unit, moved in pair.given.items()
    }
    rest = pair.face.positions
    return {unit: compound(space, pair.face, field).astype(np.float64) - rest for unit, field in fields.items()}


DELTAS = "added deltas"
OURS = "ours"
ALONE = "ours without extraction"
CARRIERS: Mapping[str, Carrier] = {
    DELTAS: add_deltas,
    "deformation transfer": deform,
    "the paper's map": carry_by_paper,
    ALONE: carry_without_space,
    OURS: carry,
}
