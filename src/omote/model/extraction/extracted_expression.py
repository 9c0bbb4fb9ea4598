"""What extraction gives: an expression that says how far it may be off on other faces.

What was repaired on the face leaves no trace in the displacement. But a triangle that was turned back stays close to
turning over, so a little more of the same field is repaired there again: by as much, in the mean, as was lost
(docs/method.md, "What a compound does not say").
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import cKDTree

from omote.arrays import Values
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.head_regions import region_weights
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import CONTINUOUS_STAGES, LINEAR_INNER_STAGES, SHEET_STAGES, STAGES, run, start

LEAST_SAID = 1e-3
"""Metres; uncertainty below it is not told in words: what an extraction may be off on other faces."""
# How much of the field is worn; twice what moves there bounds what is wrong on 28 of 29 shapes more than 1 mm off.
_WEIGHTS = (1.0, 1.1, 1.25)
_SAFETY = 2.0
# A wrong place lies near a repaired one, not at it, metres.
_AROUND = 0.015
# Less is rounding, metres.
_NOTHING = 1e-5


@dataclass(frozen=True, eq=False)
class ExtractedExpression(Expression):
    """An expression taken from a face, with what that face could not tell of it.

    Several fields can give the same displacement of a face, since the map turns folds back, pushes lids off eyeballs
    and the mouth bag behind the lips. It is worn like any expression; sums and edits of it are plain expressions.

    Parameters
    ----------
    dtheta, dh, ratio : array_like, (V,)
        The field on S, as of `omote.Expression`.
    residual : array_like, (inner, 3)
        What the inner skin does beyond it, metres.
    parts : mapping of array_like (n, 3), by the name of a part
        The same of the parts.
    eyes : array_like, (2, 2)
        Turns of the eyeballs, radians.
    radius, transfer, name : str
        The rules under which it was taken; extraction gives no name.
    pupil : float
        Nothing, 0: a displacement does not say it.
    ears : array_like, (2, 3)
        Turns of the ears, radians.
    head : array_like, (3,)
        Turn of the head, radians.
    signed : bool
        Not played below 0: a displacement does not say it.
    complexion : sequence of seven floats
        As at rest: a displacement does not say it.
    uncertainty : ndarray of float64, (V,)
        How far the skin of other faces may be off, metres: 0 where the displacement says it, or a sum of known
        expressions does. An estimate, good on the sheet and low inside the mouth: `benchmarks/extraction.py` says how
        often it holds.

    Examples
    --------
    >>> dog, jaw = cast.faces["dog"], cast.expressions["jawOpen"]
    >>> moved = omote.compound(cast.space, dog, jaw) - dog.positions
    >>> omote.extract(cast.space, dog, moved, known=[jaw]).uncertainty.max()
    np.float64(0.0)

    References
    ----------
    docs/method.md, "What a compound does not say"; docs/decisions/sheet-and-inner-skin.md.
    """

    uncertainty: Values = field(default_factory=lambda: np.zeros(0))


def describe_uncertainty(space: ParameterSpace, taken: ExtractedExpression, /) -> str:
    """What an extracted expression's uncertainty means, in words: how much, and in which region; "" below LEAST_SAID.

    space: of the expression; taken: with its uncertainty.
    """
    worst = int(taken.uncertainty.argmax()) if len(taken.uncertainty) else 0
    if not len(taken.uncertainty) or taken.uncertainty[worst] < LEAST_SAID:
        return ""
    weights = region_weights(space)
    region = max(weights, key=lambda name: float(weights[name][worst]))
    place = "inside the mouth" if not space.on_sheet[worst] and region in ("mouth", "jaw") else f"at the {region}"
    return (
        "several expressions give this shape on this face; on others it may be some "
        f"{1000 * taken.uncertainty[worst]:.1f} mm off {place}"
    )


def measure_uncertainty(space: ParameterSpace, face: Face, taken: Expression, /) -> Values:
    """How far an expression taken from a face may be off on others, estimated, (V,) metres.

    taken: as the face answers it, before its gains are divided out.

    space, face: from which it was taken.
    """
    if space.transfer == "paper":
        return np.zeros(space.vertex_count)
    moved: Values = np.max([_measure_repairs(space, face, taken, weight) / weight for weight in _WEIGHTS], axis=0)
    return _spread(space, np.where(moved > _NOTHING, _SAFETY * moved, 0.0))


def _spread(space: ParameterSpace, moved: Values) -> Values:
    """Values (V,) spread over the skin around, less and less; what is inside the mouth says nothing of the lips."""
    result = moved.copy()
    for side in (space.on_sheet, ~space.on_sheet):
        rows = np.flatnonzero(moved * side)
        around = np.flatnonzero(side)
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
    return np.where(space.on_sheet, sheet, inner)
