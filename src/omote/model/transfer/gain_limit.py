"""Limits gains where they would fold the generic face, or push lids and lips through each other or into an eyeball
(docs/method.md, "Where gains give way")."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from omote.arrays import Mask, Values
from omote.geometry.laplacian import smoothing_matrix
from omote.model.space.expression import Expression
from omote.model.space.face_fit import generic_face
from omote.model.space.gain import FieldGain, Gain, answer, field_gain, multiply_field
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.eyeball_clearance import measure_depth
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map
from omote.model.weak_cache import weakly_cached

# A round takes so much of what is left of a gain where it does harm, less in the rings around: at first so many, one
# more with each round. After the last round nothing is left of it on this face and expression.
STEP = 0.25
RINGS = 4
BACKTRACKING_ROUNDS = 40
# What lids and lips may cross, and skin lie in an eyeball, more than without the gain, metres.
SLACK_METRES = 1e-4


def answer_expression(space: ParameterSpace, gains: Sequence[Gain], expression: Expression, /) -> Expression:
    """The expression as a face with these gains answers it (`omote.model.space.gain.answer`), the gains limited to what
    the generic face can wear; the expression itself where they change nothing.

    Under transfer="paper", where nothing is repaired, gains are not limited.
    """
    gain = field_gain(space, gains, expression.name) if space.transfer == "smooth" else None
    return answer(space, gains, expression, None if gain is None else limit_gain(space, gain, expression))


def limit_gain(space: ParameterSpace, gain: FieldGain, expression: Expression, /) -> FieldGain:
    """The gain, nearer to 1 where an expression would do harm with it and does none without; the same where none does.

    space: the space of the generic head.

    Backtracking, vertex by vertex: the generic face wears the expression so; around triangles that are turned over,
    lids and lips that cross and skin in an eyeball, all compared with the face that wears it without a gain, a share of
    what the gain adds is taken away, smoothly, until nothing is left to do.
    """
    ready = prepare_smooth_map(space, generic_face(space))
    plain = ready.generic + displace_generic(space, compile_expression(space, expression))
    kept = np.ones(space.vertex_count)
    limited = gain
    for number in range(BACKTRACKING_ROUNDS):
        worn = compile_expression(space, multiply_field(space, expression, limited))
        harmed = find_harm(ready, plain, ready.generic + displace_generic(space, worn))
        if not harmed.any():
            return limited
        kept *= 1.0 - STEP * _spread(space, harmed, RINGS + number)
        limited = _keep(space, gain, kept)
    return _keep(space, gain, np.zeros_like(kept))


def find_harm(ready: SmoothMap, plain: Values, worn: Values, /) -> Mask:
    """The vertices (V,) of the generic face's sheet that a gain harms: worn (V, 3) with it, plain (V, 3) without.

    ready: the smooth map to the generic face itself.

    A vertex counts where a triangle on it is turned over, its lid or lip crosses the other or it lies in an eyeball,
    and more so than at rest and on the plain one.
    """
    harmed = np.zeros(len(worn), np.bool_)
    harmed[ready.geometry.triangles[find_folds(ready.geometry, worn, plain)]] = True
    for contact in ready.contacts:
        open_plain, now = ((contact.source * contact.line.rungs(points)).sum(axis=1) for points in (plain, worn))
        allowed = np.minimum(np.minimum(open_plain, contact.there), 0.0)
        harmed[contact.line.vertices[now < allowed - SLACK_METRES]] = True
    for clearance in ready.clearances:
        ball = clearance.source
        near = clearance.near
        allowed = np.maximum(measure_depth(ball, plain[near]), measure_depth(ball, clearance.rest))
        harmed[near[measure_depth(ball, worn[near]) > allowed + SLACK_METRES]] = True
    return harmed


@weakly_cached
def _rings(space: ParameterSpace) -> sparse.csr_array:
    return smoothing_matrix(space.sheet_triangles, space.vertex_count)


def _spread(space: ParameterSpace, marked: Mask, rings: int) -> Values:
    """1 at marked vertices, less in so many rings around, (V,)."""
    result = marked.astype(np.float64)
    for _ in range(rings):
        result = np.maximum(result, _rings(space) @ result)
    return result


def _keep(space: ParameterSpace, gain: FieldGain, kept: Values) -> FieldGain:
    """The gain with a share (V,) kept of what it adds; inner skin and parts keep what their anchors do."""
    inner = space.inner
    lost = 1.0 - kept[space.welded]
    lost[inner.vertices] = _mean(inner.weights, lost[inner.anchors])
    parts = {
        name: gain.parts[name] - _mean(part.weights, lost[part.anchors]) * (gain.parts[name] - 1.0)
        for name, part in space.parts.items()
    }
    return FieldGain(gain.skin - lost * (gain.skin - 1.0), parts)


def _mean(weights: NDArray[np.floating], values: Values) -> Values:
    """Means of values (n, k) by weights (n, k); 0 where nothing weighs."""
    total = weights.sum(axis=1)
    return (weights * values).sum(axis=1) / np.where(total > 0, total, 1.0)
