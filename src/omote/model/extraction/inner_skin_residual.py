"""The inner skin's own motion, through the fit of the mouth bag (docs/method.md, "The inverse").

What the bag is pushed by depends on the face, so of all residuals that give the goal the one is taken that asks least
of other faces: it starts from the sum of known expressions and changes only what the goal needs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from omote.arrays import Floats, Values
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import apply_expression
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import LINEAR_INNER_STAGES, SHEET_STAGES, STAGES, run, start

INNER_STAGES = STAGES[len(SHEET_STAGES) :]
"""The stages that move the inner skin behind a sheet that is done."""
# Steps at most; where they end, metres; what is further off than the second is not reached from this start.
_STEPS = 20
_CLOSE = 1e-6
_GOOD = 1e-5


def solve_inner_residual(
    space: ParameterSpace, face: Face, bare: Expression, goal: Values, known: Expression | None, /
) -> Values:
    """The residual (inner, 3) with which a face wearing a field has its inner skin at goal (inner, 3), metres.

    bare: the field without a residual; known: an expression that it should resemble.

    space, face: which wears it; goal (inner, 3): metres.
    """
    inner = space.inner.vertices
    scale = fit(space, face).scale[:, None].astype(np.float64)
    if space.transfer == "paper":
        worn = apply_expression(space, face, compile_expression(space, bare)).astype(np.float64)[inner]
        return (goal - worn) / scale
    sheet = run(
        SHEET_STAGES, start(space, face, displace_generic(space, compile_expression(space, bare)), _still(bare))
    )

    def lack(residual: Values) -> Values:
        moved = run(INNER_STAGES, replace(sheet, residual=residual.astype(np.float32)))
        return (goal - moved.skin[inner]) / scale

    before_bag = run(LINEAR_INNER_STAGES[len(SHEET_STAGES) :], sheet).skin[inner]
    linear: Values = (goal - before_bag) / scale
    return linear if known is None else _approach(lack, known.residual, linear)


def _approach(lack: Callable[[Values], Values], start: Values, otherwise: Values) -> Values:
    """The residual (inner, 3) without lack that fixed-point steps from start come to, or the other one."""
    residual = start
    best = otherwise
    least = _GOOD
    for _ in range(_STEPS):
        missing = lack(residual)
        error = float(np.abs(missing).max())
        if error < least:
            best = residual
            least = error
        if error < _CLOSE:
            break
        residual = residual + missing
    return best


def _still(bare: Expression) -> Floats:
    return np.zeros_like(bare.residual, dtype=np.float32)
