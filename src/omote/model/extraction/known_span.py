"""The sum of known expressions nearest to a field (docs/method.md, "Which field is meant").

Where a face's map has turned folds back, or pushed a lid off an eyeball, a few dozen vertices of a measured field are
wrong and thousands exact. So the sum makes the least sum of a low power of distances, which such outliers do not pull:
iteratively reweighted least squares (Chartrand & Yin 2008). The weights of few members are then refined by what the sum
lacks on the face itself, through all stages, where no vertex is wrong: Gauss and Newton's method.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from omote.arrays import Indices, Values
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace

# Distances count from the first, metres, on at first, from the second at the end; so many rounds.
_COARSE = 1e-3
_FINE = 1e-7
_ROUNDS = 20
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


# Gauss and Newton's method: for so many members at most, rounds, the change of a weight that gives a slope, and
# where it ends, metres.
_FEW = 6
_REFINEMENTS = 6
_NUDGE = 2e-4
_CLOSE = 3e-8
# Shares of its step that are tried: a slope that was taken across a jump makes it thirty times too short.
_LENGTHS = (1.0, 0.3, 3.0, 10.0, 30.0)


@dataclass(frozen=True, eq=False)
class KnownSum:
    """A weighted sum of known expressions: members, k of them, their places among all that are known, and their share
    (k,) of it, in a space."""

    space: ParameterSpace
    members: tuple[Expression, ...]
    places: tuple[int, ...]
    share: Values

    @cached_property
    def expression(self) -> Expression:
        """The sum, with what it does to the inner skin and the ears; without parts."""
        none = np.zeros(self.space.vertex_count), np.zeros((len(self.space.inner.vertices), 3)), np.zeros((2, 3))
        ratio = 1.0 + self._add(none[0], [member.ratio - 1.0 for member in self.members])
        return Expression(
            self._add(none[0], [member.dtheta for member in self.members]),
            self._add(none[0], [member.dh for member in self.members]),
            np.maximum(ratio, _LEAST_RATIO),
            self._add(none[1], [member.residual for member in self.members]),
            ears=self._add(none[2], [member.ears for member in self.members]),
            radius=self.space.radius,
            transfer=self.space.transfer,
        )

    def _add(self, nothing: Values, values: Sequence[Values]) -> Values:
        return sum((weight * value for weight, value in zip(self.share, values, strict=True)), nothing)


def fit_known(space: ParameterSpace, field: Expression, known: Sequence[Expression], /) -> list[KnownSum]:
    """Weighted sums of known expressions near a field on the sheet, of few and of all.

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
    list of KnownSum
        One for each share of members that is left out, the fewest members first, none twice; the empty sum where none
        of the known moves any skin.
    """
    rows = np.unique(space.sheet_triangles)
    metric = np.maximum(space.cylinder.unroll(space.points)[2][rows], 1e-3)
    basis = np.stack([_as_metres(expression, rows, metric) for expression in known])
    sizes = np.sqrt((basis**2).sum(axis=(1, 2)))
    moving = np.flatnonzero(sizes > 1e-6)
    if not len(moving):
        return [KnownSum(space, (), (), np.zeros(0))]
    sums = dict[tuple[int, ...], KnownSum]()
    for share in _fit_sparsely(basis[moving] / sizes[moving, None, None], _as_metres(field, rows, metric)):
        chosen = np.flatnonzero(share)
        members = tuple(moving[chosen].tolist())
        weights = share[chosen] / sizes[moving[chosen]]
        sums[members] = KnownSum(space, tuple(known[k] for k in members), members, weights)
    return list(sums.values())


def refine_known(start: KnownSum, measure_lack: Callable[[KnownSum], Values], /) -> KnownSum:
    """A sum of few known expressions with the weights that lack least by measure_lack, (n, 3) metres; others as they
    are.

    Gauss and Newton's method with slopes by finite differences; steps and what they gain count outliers as `fit_known`
    does, since a triangle that folds or does not is a jump.

    start: the sum; measure_lack: gives what a sum lacks, (n, 3) metres.
    """
    best = start
    lack = measure_lack(start)
    for _ in range(_REFINEMENTS if 0 < len(start.members) <= _FEW else 0):
        if np.abs(lack).max() < _CLOSE:
            break
        nudged = [replace(best, share=best.share + _NUDGE * row) for row in np.eye(len(best.share))]
        slopes = np.stack([(lack - measure_lack(trial)) / _NUDGE for trial in nudged])
        plain = np.linalg.lstsq(slopes.reshape(len(slopes), -1).T, lack.ravel(), rcond=None)[0]
        steps = (_fit_robustly(slopes, lack), plain)  # noise of float32 in still skin can hold the first one back
        trials = [replace(best, share=best.share + length * step) for step in steps for length in _LENGTHS]
        nearest, left = min(((trial, measure_lack(trial)) for trial in trials), key=lambda pair: _count(pair[1]))
        if _count(left) >= _count(lack):
            break
        best = nearest
        lack = left
    return best


def _count(lack: Values) -> float:
    """What the fit makes least, of a lack (n, 3)."""
    squared = (lack**2).sum(axis=1) + _FINE**2
    return float((squared ** (_POWER / 2.0)).sum())


def _as_metres(expression: Expression, rows: Indices, metric: Values) -> Values:
    """The field at vertices of the sheet (n, 3): across, up and out, metres."""
    across = expression.dtheta[rows] * metric
    out = (expression.ratio[rows] - 1.0) * metric
    return np.stack([across, expression.dh[rows], out], axis=1)


def _fit_sparsely(basis: Values, target: Values) -> list[Values]:
    """Weights (k,) of a basis (k, n, 3) near the target (n, 3): without small members, at each cut, and with all."""
    everything = _fit_robustly(basis, target)
    weights = list[Values]()
    for cut in _CUTS:
        few = np.flatnonzero(np.abs(everything) > cut * np.abs(everything).max())
        share: Values = np.zeros(len(basis))
        share[few] = _fit_robustly(basis[few], target)
        weights.append(share)
    return [*weights, everything]


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
    return np.linalg.norm(target - np.tensordot(share, basis, 1), axis=1)
