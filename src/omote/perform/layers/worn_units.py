"""How much of a unit an expression wears already: lids that a smile has half closed have half a blink to go."""

from __future__ import annotations

import math
from collections.abc import Mapping
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.model.space.expression import Expression

HEAD_RADIUS = 0.09
"""Metres from the axis to the skin: what an angle and a ratio of radii are worth beside a height."""
FULL = 1.0

_worn: WeakKeyDictionary[Expression, WeakKeyDictionary[Expression, float]] = WeakKeyDictionary()


def worn_by(unit: Expression, mix: Mapping[str, float], expressions: Mapping[str, Expression]) -> float:
    """How much of a unit a mix of expressions wears, 0 to 1."""
    worn = math.fsum(weight * worn_share(unit, expressions[name]) for name, weight in mix.items())
    return FULL if worn > FULL else max(worn, 0.0)


def worn_share(unit: Expression, expression: Expression) -> float:
    """How much of a unit an expression wears, 0 to 1: its field's share along the unit's, where the unit moves skin.

    Summed exactly (`math.fsum`), so that every machine finds the same.
    """
    known = _worn.get(unit)
    if known is None:
        known = _worn[unit] = WeakKeyDictionary()
    found = known.get(expression)
    if found is None:
        found = known[expression] = _share(unit, expression)
    return found


def _share(unit: Expression, expression: Expression) -> float:
    if np.shape(unit.dh) != np.shape(expression.dh):
        return 0.0
    rows = np.flatnonzero((unit.dh != 0.0) | (unit.dtheta != 0.0) | (unit.ratio != 1.0))
    own, other = _moves(unit, rows), _moves(expression, rows)
    square = math.fsum((own * own).tolist())
    share = math.fsum((own * other).tolist()) / square if square else 0.0
    return FULL if share > FULL else max(share, 0.0)


def _moves(expression: Expression, rows: NDArray[np.intp]) -> NDArray[np.float64]:
    """About how far it moves these rows of the sheet, metres: around, up and out."""
    turned, out = expression.dtheta[rows] * HEAD_RADIUS, (expression.ratio[rows] - 1.0) * HEAD_RADIUS
    return np.concatenate([turned, expression.dh[rows], out])
