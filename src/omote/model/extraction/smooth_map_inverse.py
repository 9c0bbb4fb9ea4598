"""The inverse of the smooth map's stages on the sheet (docs/method.md, "The inverse").

Newton's method through the continuous stages, then Anderson acceleration (1965), preconditioned by their Jacobian,
through all of them. Where folds are turned back several displacements give the same sheet; `known` says which is meant.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from omote.model.extraction.known_span import KnownSum, fit_known, refine_known
from omote.model.extraction.sheet_bending import prepare_bending
from omote.model.extraction.sheet_field import measure_field
from omote.model.extraction.smooth_map_jacobian import SmoothMapJacobian, linearise_smooth_map
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import CONTINUOUS_STAGES, SHEET_STAGES, Stage, apply_smooth_map
from omote.model.transfer.smooth_map import prepare_smooth_map

Values = NDArray[np.float64]

# Newton's method: steps at most, and until it begins again without what is shorter than so many metres; the error in
# metres at which it ends, the shortest share of a step.
_STEPS, _SOON, _CRUMPLED, _EXACT, _SHORTEST = 20, 10, 0.001, 1e-8, 1e-3
# Anderson acceleration: steps at most at each length, and without a nearer one; how many earlier ones it remembers;
# where it ends, metres.
_LENGTHS, _MOST, _PATIENCE, _MEMORY, _CLOSE = (1.0, 0.5), 40, 15, 20, 2e-6
# Where that is stuck no farther off than so many metres: hops that take away so much of waves shorter than so many
# metres, so far around.
_STUCK, _SHARES, _HOPS, _AROUND = 1e-3, (0.3, 0.6, 1.0, 1.5), (0.001, 0.002, 0.004), 0.009
# Of displacements that miss the sheet by less, metres, the smoothest counts.
_GOOD = 2e-5
# A sum of known expressions that misses the sheet by no more, metres, is where the search begins and ends.
_SAME = 2e-4


@dataclass(frozen=True, eq=False)
class Target:
    """A face's sheet that is to be reached: goal (V, 3) metres; rows (n,): the sheet's vertices, seams welded."""

    space: ParameterSpace
    face: Face
    goal: Values
    rows: NDArray[np.int32]

    def spread(self, displacement: Values) -> Values:
        """A displacement (n, 3) of the sheet for all vertices (V, 3)."""
        result = np.zeros_like(self.goal)
        result[self.rows] = displacement
        return result

    def measure_lack(self, displacement: Values, stages: Sequence[Stage] = SHEET_STAGES) -> Values:
        """What a displacement (n, 3) of the generic face lacks to the goal on this one: (n, 3) metres."""
        sheet = apply_smooth_map(self.space, self.face, self.spread(displacement), stages)
        return (self.goal - sheet)[self.rows]


@dataclass(frozen=True, eq=False)
class Root:
    """A displacement (n, 3) of the generic face, and by how much it misses the goal, metres."""

    displacement: Values
    error: float


@dataclass(frozen=True, eq=False)
class InverseResult:
    """A displacement (V, 3) of the generic face, metres; the sum of known expressions that it is near, if any; exact:
    whether it is that sum."""

    displacement: Values
    known: KnownSum | None
    exact: bool = False


def invert_smooth_map(
    space: ParameterSpace, face: Face, goal: Values, known: Sequence[Expression] = (), /
) -> InverseResult:  # fmt: skip
    """The displacement of the generic face with which `apply_smooth_map` brings a face's sheet to goal (V, 3), metres.

    Exact where no stage after `CONTINUOUS_STAGES` changes the sheet; elsewhere as near as it comes. known: expressions
    that it may be a sum of. Of two displacements that give the goal the one counts that adds least roughness to them.
    """
    ready = prepare_smooth_map(space, face)
    target, first = Target(space, face, goal, ready.detail.used), goal - ready.positions
    if np.abs(apply_smooth_map(space, face, first) - goal).max() < _EXACT:
        return InverseResult(first, None)  # on the generic face, and at rest, nothing is changed
    smooth = _solve_newton(target, first[target.rows])
    if not known:
        return _finish(target, _solve_by_hops(target, _solve_all_stages(target, smooth)), None)
    field = measure_field(space, ready.generic, target.spread(smooth)[space.welded])
    sum_of_known = _refine_sums(target, fit_known(space, field, known))
    guess = _displace(target, sum_of_known.expression)
    by_known = _solve_all_stages(target, guess)
    if by_known.error < _GOOD and np.abs(target.measure_lack(guess)).max() < _SAME:
        return _finish(target, by_known, sum_of_known, exact=True)
    return _finish(target, _choose(target, guess, [by_known, _solve_all_stages(target, smooth)]), sum_of_known)


def _choose(target: Target, guess: Values, found: Sequence[Root]) -> Root:
    """Of the roots that give the goal the one that adds least bending to a guess (n, 3); of others the nearest, after
    hops."""
    good = [root for root in found if root.error < _GOOD]
    if not good:
        return _solve_by_hops(target, min(found, key=lambda root: root.error))
    plate = prepare_bending(target.space)
    return min(good, key=lambda root: plate.measure(root.displacement - guess))


def _refine_sums(target: Target, sums: Sequence[KnownSum]) -> KnownSum:
    """The sum of known expressions that lacks least on the face, its weights refined."""

    def measure_lack(each: KnownSum) -> Values:
        return target.measure_lack(_displace(target, each.expression))

    def measure_size(each: KnownSum) -> float:
        return float(np.linalg.norm(measure_lack(each)))

    nearest = min(sums, key=measure_size)
    if np.abs(measure_lack(nearest)).max() < _CLOSE:
        return refine_known(nearest, measure_lack)
    return min([refine_known(each, measure_lack) for each in sums], key=measure_size)


def _displace(target: Target, expression: Expression) -> Values:
    """What an expression does to the generic face's sheet, (n, 3) metres."""
    return displace_generic(target.space, compile_expression(target.space, expression))[target.rows]


def _finish(target: Target, root: Root, known: KnownSum | None, *, exact: bool = False) -> InverseResult:
    return InverseResult(target.spread(root.displacement)[target.space.welded], known, exact)


def _solve_newton(target: Target, start: Values) -> Values:
    """Where the continuous stages give the goal, or the nearest that Newton's method came to it: (n, 3).

    A start from which it does not arrive soon is a crumpled one, from which it may arrive at a crumpled displacement
    that gives the goal too: then it begins again from the smooth part of where it came to.
    """
    displacement, lack = _step_newton(target, start, _SOON)
    if np.abs(lack).max() < _EXACT:
        return displacement
    smooth = prepare_bending(target.space).smooth(displacement, _CRUMPLED)
    again, left = _step_newton(target, smooth, _STEPS)
    return again if np.linalg.norm(left) < max(float(np.linalg.norm(lack)), _EXACT) else displacement


def _step_newton(target: Target, start: Values, steps: int) -> tuple[Values, Values]:
    """Where so many steps of Newton's method lead, (n, 3), and what that lacks, (n, 3)."""
    displacement, lack = start, target.measure_lack(start, CONTINUOUS_STAGES)
    jacobian, last = None, np.inf
    for _ in range(steps):
        size = float(np.linalg.norm(lack))
        if np.abs(lack).max() < _EXACT:
            break
        if jacobian is None or size > 0.3 * last:  # else the former one still serves
            jacobian = _linearise(target, displacement)
        last, step, length = size, _precondition(jacobian, lack), 1.0
        while True:
            trial = target.measure_lack(displacement + length * step, CONTINUOUS_STAGES)
            if np.linalg.norm(trial) < size or length < _SHORTEST:
                break
            length /= 2
        if np.linalg.norm(trial) >= size:
            break
        displacement, lack = displacement + length * step, trial
    return displacement, lack


def _linearise(target: Target, displacement: Values) -> SmoothMapJacobian | None:
    try:
        return linearise_smooth_map(target.space, target.face, target.spread(displacement))
    except RuntimeError:  # singular, as it can be at shapes that no face has
        return None


def _precondition(jacobian: SmoothMapJacobian | None, lack: Values) -> Values:
    return 0.5 * lack if jacobian is None else jacobian.solve(lack)


def _solve_all_stages(target: Target, start: Values) -> Root:
    """The nearest to the goal that Anderson acceleration comes through all stages: whole steps, then shorter ones."""
    best = Root(start, float(np.abs(target.measure_lack(start)).max()))
    for length in _LENGTHS:
        if best.error < _GOOD:
            break
        jacobian = _linearise(target, best.displacement)
        best = _accelerate(target, best, jacobian, length)
    return best


def _solve_by_hops(target: Target, best: Root) -> Root:
    """The nearest to the goal after hops from where acceleration was stuck, each smoothed around the vertex that lacks
    most: basin hopping (Wales & Doye 1997), without chance."""
    jacobian = _linearise(target, best.displacement)
    for wave, share in product(_HOPS, _SHARES):
        if best.error < _GOOD or best.error > _STUCK:
            break
        near = _accelerate(target, _hop(target, best, wave, share), jacobian, 1.0)
        best = min(best, near, key=lambda root: root.error)
    return best


def _hop(target: Target, root: Root, wave: float, share: float) -> Root:
    """A root moved so far toward what it is without waves so short, metres, around the vertex that lacks most."""
    lack = target.measure_lack(root.displacement)
    worst = int((lack**2).sum(axis=1).argmax())
    smooth = prepare_bending(target.space).smooth_around(root.displacement, worst, wave, _AROUND)
    moved = root.displacement + share * (smooth - root.displacement)
    return Root(moved, float(np.abs(target.measure_lack(moved)).max()))


def _accelerate(target: Target, best: Root, jacobian: SmoothMapJacobian | None, length: float) -> Root:
    displacement = best.displacement
    steps, changes = list[Values](), list[Values]()
    before: tuple[Values, Values] | None = None
    since = 0
    for _ in range(_MOST):
        lack = target.measure_lack(displacement)
        error = float(np.abs(lack).max())
        best, since = (Root(displacement, error), 0) if error < best.error else (best, since + 1)
        if error < _CLOSE or since > _PATIENCE:
            break
        if before is not None:
            steps, changes = [*steps, before[0]][-_MEMORY:], [*changes, lack - before[1]][-_MEMORY:]
        back, unexplained = _combine(lack, steps, changes)
        step = length * _precondition(jacobian, unexplained) - back
        before = (step, lack)
        displacement = displacement + step
    return best


def _combine(lack: Values, steps: list[Values], changes: list[Values]) -> tuple[Values, Values]:
    """The combination of earlier steps whose changes explain a lack best, and what of it they do not explain."""
    if not steps:
        return np.zeros_like(lack), lack
    known = np.stack(changes)
    share, *_ = np.linalg.lstsq(known.reshape(len(known), -1).T, lack.ravel(), rcond=1e-10)
    return np.tensordot(share, np.stack(steps), 1), lack - np.tensordot(share, known, 1)
