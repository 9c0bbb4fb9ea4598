"""What is on air as weights of ARKit's units: channels, and what the mix of expressions wears of each."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.optimize import nnls

from omote.arrays import Values
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.model.known_names import NEUTRAL
from omote.model.space.expression import Expression
from omote.perform.channels import GAZE_UNITS

HEAD_RADIUS = 0.09
"""Metres: what an angle and a ratio of radii are worth beside a height."""
LEAST_WEIGHT = 0.02
"""Of a unit that an expression wears; less is the noise of the fit."""


class UnitWeights:
    """The units of a cast, and how each expression is made of them as nearly as it can be.

    The weights are those at least 0 by which the sum of the units' moves comes nearest to the expression's (Lawson and
    Hanson's NNLS on the normal equations' factor). An expression is fitted when it is first on air: a millisecond. The
    units that turn the eyes are left out: of the skin they move a little of the lids, in which they cancel each other.
    """

    def __init__(self, expressions: Mapping[str, Expression]) -> None:
        self.names = tuple(name for name in ARKIT_NAMES if name in expressions and name not in GAZE_UNITS)
        self._expressions = expressions
        self._fitted = dict[str, Mapping[str, float]]()
        moves = [_moves(expressions[name]) for name in self.names]
        self._moves = np.stack(moves) if moves else np.zeros((0, 0))
        gram = self._moves @ self._moves.T
        self._factor: Values = (
            np.linalg.cholesky(gram + 1e-9 * np.trace(gram) * np.eye(len(gram))) if len(gram) else gram
        )

    def weigh(self, mix: Mapping[str, float], channels: Mapping[str, float]) -> dict[str, float]:
        """The weight of each of ARKit's 52 units, 0 to 1, in the order of `ARKIT_NAMES`; those that the cast lacks are
        at 0.

        mix: how much of each expression is worn; channels: weights over it, by name.
        """
        totals = {name: channels.get(name, 0.0) for name in ARKIT_NAMES}
        for expression, share in mix.items():
            for name, weight in self._fit(expression).items():
                totals[name] += share * weight
        return {name: min(1.0, max(0.0, weight)) for name, weight in totals.items()}

    def _fit(self, name: str) -> Mapping[str, float]:
        if name not in self._fitted:
            self._fitted[name] = self._solve(name)
        return self._fitted[name]

    def _solve(self, name: str) -> Mapping[str, float]:
        if name in ARKIT_NAMES:
            return {name: 1.0}
        wanted = _moves(self._expressions[name]) if name != NEUTRAL and name in self._expressions else np.zeros(0)
        if not self.names or len(wanted) != self._moves.shape[1]:  # SciPy's solver ends the process on an empty matrix
            return {}
        weights, _ = nnls(self._factor.T, np.linalg.solve(self._factor, self._moves @ wanted))
        return {unit: float(weight) for unit, weight in zip(self.names, weights, strict=True) if weight > LEAST_WEIGHT}


def _moves(expression: Expression) -> Values:
    """About how far an expression moves the skin, metres: around, up and out, row after row of the sheet."""
    turned = expression.dtheta * HEAD_RADIUS
    out = (expression.ratio - 1.0) * HEAD_RADIUS
    return np.concatenate([turned, expression.dh, out]).astype(np.float64)
