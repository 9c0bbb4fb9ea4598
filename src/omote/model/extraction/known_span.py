"""The sum of known expressions nearest to a field (docs/method.md, "Which field is meant").

Where a face's map has turned folds back, or pushed a lid off an eyeball, a few dozen vertices of a measured field are
wrong and thousands exact. So the sum makes the least sum of a low power of distances, which such outliers do not pull:
iteratively reweighted least squares (Chartrand & Yin 2008).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

# Distances count from the first, metres, on at first, from the second at the end; so many rounds.
_COARSE, _FINE, _ROUNDS = 1e-3, 1e-7, 20
# The power of distances whose sum is made least: one (least distances) lets a hundred outliers in one
# place pull together, near zero all that counts is how many vertices are explained.
_POWER = 0.1
# Weights that the field does not tell stay small: this share of the mean diagonal.
_RIDGE = 1e-12
# Members whose weight is less than one of these shares of the largest one are left out: the others hold their weights
# better without them.
_CUTS = (0.1, 0.02, 0.004)
# A sum may bring a radius no nearer to the axis than to this share of itself.
_LEAST_RATIO = 0.05


def fit_known(space: ParameterSpace, field: Expression, known: Sequence[Expression], /) -> list[Expression]:
    """Weighted sums of known expressions near a field on the sheet, of few and of all; with what they do to the
    inner skin and the ears.

    Parameters
    ----------
    space : ParameterSpace
        The space of all.
    field : Expression
        What is measured.
    known : sequence of Expression
        Under the same rules; what moves no skin does not count.

    Returns
    -------
    list of Expression
        One for each share of members that is left out; without parts; at rest where none of the known moves any skin.
    """
    rows = np.unique(space.sheet_triangles)
    metric = np.maximum(space.cylinder.unroll(space.points)[2][rows], 1e-3)
    basis = np.stack([_as_metres(each, rows, metric) for each in known])
    sizes = np.sqrt((basis**2).sum(axis=(1, 2)))
    moving = np.flatnonzero(sizes > 1e-6)
    shares = [np.zeros(len(known))]
    if len(moving):
        scaled = basis[moving] / sizes[moving, None, None]
        shares = [np.zeros(len(known)) for _ in (*_CUTS, 0.0)]
        for share, found in zip(shares, _fit_sparsely(scaled, _as_metres(field, rows, metric)), strict=True):
            share[moving] = found / sizes[moving]
    return [_sum_known(space, share, known) for share in shares]


def _sum_known(space: ParameterSpace, share: Values, known: Sequence[Expression]) -> Expression:
    """The sum of expressions, each with its share (k,)."""
    ratio = 1.0 + _add(share, [each.ratio - 1.0 for each in known])
    return Expression(
        _add(share, [each.dtheta for each in known]),
        _add(share, [each.dh for each in known]),
        np.maximum(ratio, _LEAST_RATIO),
        _add(share, [each.residual for each in known]),
        ears=_add(share, [each.ears for each in known]),
        radius=space.radius,
        transfer=space.transfer,
    )


def _add(share: Values, values: Sequence[Values]) -> Values:
    result: Values = np.tensordot(share, np.stack(values), 1)
    return result


def _as_metres(expression: Expression, rows: NDArray[np.int32], metric: Values) -> Values:
    """The field at vertices of the sheet (n, 3): across, up and out, metres."""
    across, out = expression.dtheta[rows] * metric, (expression.ratio[rows] - 1.0) * metric
    return np.stack([across, expression.dh[rows], out], axis=1)


def _fit_sparsely(basis: Values, target: Values) -> list[Values]:
    """Weights (k,) of a basis (k, n, 3) near the target (n, 3): without small members, at each cut, and with all."""
    everything = _fit_robustly(basis, target)
    found = list[Values]()
    for cut in _CUTS:
        few = np.flatnonzero(np.abs(everything) > cut * np.abs(everything).max())
        share: Values = np.zeros(len(basis))
        share[few] = _fit_robustly(basis[few], target)
        found.append(share)
    return [*found, everything]


def _fit_robustly(basis: Values, target: Values) -> Values:
    """The weights (k,) with which the basis (k, n, 3) comes nearest to the target (n, 3), outliers left out."""
    flat = basis.reshape(len(basis), -1)
    share: Values = np.zeros(len(basis))
    weight: Values = np.ones(len(target))
    for floor in np.geomspace(_COARSE, _FINE, _ROUNDS):
        weighted = flat * np.repeat(weight, 3)
        gram = weighted @ flat.T
        gram[np.diag_indices_from(gram)] += _RIDGE * np.trace(gram) / len(gram)
        share[:] = np.linalg.lstsq(gram, weighted @ target.ravel(), rcond=1e-14)[0]
        weight = (_measure_distance(share, basis, target) ** 2 + floor**2) ** (_POWER / 2.0 - 1.0)
    return share


def _measure_distance(share: Values, basis: Values, target: Values) -> Values:
    """What a sum of the basis misses at each vertex, (n,) metres."""
    result: Values = np.linalg.norm(target - np.tensordot(share, basis, 1), axis=1)
    return result
