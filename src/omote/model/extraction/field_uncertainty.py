"""How far a field taken from a face may be off on others (docs/method.md, "What a compound does not say").

What was repaired on the face leaves no trace in the displacement. But a triangle that was turned back stays close to
turning over, so a little more of the same field is repaired there again: by as much, in the mean, as was lost.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import CONTINUOUS_STAGES, LINEAR_INNER_STAGES, SHEET_STAGES, STAGES, run, start

Values = NDArray[np.float64]

# How much of the field is worn; twice what moves there bounds what is wrong on 28 of 29 shapes more than 1 mm off.
_WEIGHTS, _SAFETY = (1.0, 1.1, 1.25), 2.0
# A wrong place lies near a repaired one, not at it, metres.
_AROUND = 0.015
# Less is rounding, metres.
_NOTHING = 1e-5


def measure_uncertainty(space: ParameterSpace, face: Face, taken: Expression, /) -> Values:
    """How far an expression taken from a face may be off on others, estimated, (V,) metres.

    taken: as the face answers it, before its gains are divided out.
    """
    if space.transfer == "paper":
        return np.zeros(space.vertex_count)
    moved: Values = np.max([_measure_repairs(space, face, taken, weight) / weight for weight in _WEIGHTS], axis=0)
    return _spread(space, np.where(moved > _NOTHING, _SAFETY * moved, 0.0))


def _spread(space: ParameterSpace, moved: Values) -> Values:
    """Values (V,) spread over the skin around, less and less; what is inside the mouth says nothing of the lips."""
    result = moved.copy()
    for side in (space.on_sheet, ~space.on_sheet):
        rows, around = np.flatnonzero(moved * side), np.flatnonzero(side)
        if len(rows):
            near = cKDTree(space.points[rows])
            far = cKDTree(space.points[around]).sparse_distance_matrix(near, _AROUND).tocoo()
            np.maximum.at(result, around[far.row], moved[rows[far.col]] * (1.0 - far.data / _AROUND))
    return result


def _measure_repairs(space: ParameterSpace, face: Face, taken: Expression, weight: float) -> Values:
    """How far the stages move the skin that keep it from folding, from the eyeballs and from the mouth, (V,) metres."""
    compiled = compile_expression(space, taken, weight)
    before = run(CONTINUOUS_STAGES, start(space, face, displace_generic(space, compiled), compiled.residual))
    repaired = run(STAGES[len(CONTINUOUS_STAGES) : len(SHEET_STAGES)], before)
    joined = run(STAGES[len(SHEET_STAGES) : len(LINEAR_INNER_STAGES)], repaired)
    placed = run(STAGES[len(LINEAR_INNER_STAGES) :], joined)
    sheet = np.linalg.norm(repaired.sheet - before.sheet, axis=1)[space.welded]
    inner = np.linalg.norm(placed.skin.astype(np.float64) - joined.skin, axis=1)
    inner[space.inner.vertices] /= fit(space, face).scale
    moved: Values = np.where(space.on_sheet, sheet, inner)
    return moved
