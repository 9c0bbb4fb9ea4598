"""The inverse of the smooth map's stages on the sheet (docs/method.md, "The inverse").

Newton's method through the continuous stages, then Anderson acceleration (1965), preconditioned by their Jacobian,
through all of them. Where folds are turned back several displacements give the same sheet: `known` says which is meant,
else the one that bends the sheet, a thin plate, least.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from omote.arrays import Indices, Values
from omote.model.extraction.known_span import KnownSum, fit_known, refine_known
from omote.model.extraction.sheet_field import measure_field
from omote.model.extraction.smooth_map_jacobian import SmoothMapJacobian, linearise_smooth_map
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import generic_face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import CONTINUOUS_STAGES, SHEET_STAGES, Stage, apply_smooth_map
from omote.model.transfer.smooth_map import prepare_smooth_map
from omote.model.weak_cache import weakly_cached

# Newton's method: steps at most, and until it begins again without what is shorter than so many metres; the error in
# metres at which it ends, the shortest share of a step.
_STEPS = 20
_SOON = 10
_CRUMPLED = 0.001
_EXACT = 1e-8
_SHORTEST = 1e-3
# Anderson acceleration: steps at most at each length, and without a nearer one; how many earlier ones it remembers;
# where it ends, metres.
_LENGTHS = (1.0, 0.5)
_MOST = 40
_PATIENCE = 15
_MEMORY = 20
_CLOSE = 2e-6
# Where that is stuck no farther off than so many metres: hops that take away so much of waves shorter than so many
# metres, so far around.
_STUCK = 1e-3
_SHARES = (0.3, 0.6, 1.0, 1.5)
_HOPS = (0.001, 0.002, 0.004)
_AROUND = 0.009
# Of displacements that miss the sheet by less, metres, the smoothest counts.
_GOOD = 2e-5
# A sum of known expressions that misses the sheet by no more, metres, is where the search begins and ends.
_SAME = 2e-4


@dataclass(frozen=True, eq=False)
class SheetBending:
    """The sheet of the generic face as a thin plate.

    positions (n, 3): its vertices at rest, metres; mass (n,): the area of each; laplacian (n, n): times mass.
    """

    positions: Values
    mass: Values
    laplacian: sparse.csr_array
    _solvers: dict[float, splu] = field(default_factory=dict)

    def measure(self, displacement: Values, /) -> float:
        """How much a displacement (n, 3) is bent: its squared Laplacian, integrated."""
        bent = self.laplacian @ displacement
        return float((bent**2 / self.mass[:, None]).sum())

    def smooth(self, displacement: Values, length: float, /) -> Values:
        """The displacement (n, 3) without what is shorter than a length, metres: (M + length^4 B) s = M u."""
        if length not in self._solvers:
            bending = self.laplacian.T @ sparse.diags_array(1.0 / self.mass) @ self.laplacian
            self._solvers[length] = splu(sparse.csc_array(sparse.diags_array(self.mass) + length**4 * bending))
        return self._solvers[length].solve(np.ascontiguousarray(self.mass[:, None] * displacement))

    def smooth_around(self, displacement: Values, vertex: int, length: float, radius: float, /) -> Values:
        """The same (n, 3), smoothed around one vertex only, by a Gaussian bell of so many metres.

        displacement (n, 3): metres; vertex: its row; length: what is shorter goes, metres; radius: of the bell, metres.
        """
        far = ((self.positions - self.positions[vertex]) ** 2).sum(axis=1)
        bell = np.exp(-far / radius**2)[:, None]
        return displacement + bell * (self.smooth(displacement, length) - displacement)


@weakly_cached
def prepare_bending(space: ParameterSpace, /) -> SheetBending:
    """The plate of a space's generic face, assembled at the first call and remembered."""
    ready = prepare_smooth_map(space, generic_face(space))
    detail = ready.detail
    count = len(ready.geometry.triangles)
    place = np.searchsorted(detail.used, ready.geometry.triangles)
    mass = np.bincount(place.ravel(), np.repeat(detail.areas[:count] / 3.0, 3)).astype(np.float64)
    stiffness = detail.slopes.T @ sparse.diags_array(detail.areas) @ detail.slopes
    return SheetBending(ready.generic[detail.used], mass, sparse.csr_array(stiffness))


@dataclass(frozen=True, eq=False)
class SheetGoal:
    """A face's sheet that is to be reached: goal (V, 3) metres; rows (n,): the sheet's vertices, seams welded."""

    space: ParameterSpace
    face: Face
    goal: Values
    rows: Indices

    def spread(self, displacement: Values) -> Values:
        """A displacement (n, 3) of the sheet for all vertices (V, 3)."""
        result = np.zeros_like(self.goal)
        result[self.rows] = displacement
        return result

    def measure_lack(self, displacement: Values, stages: Sequence[Stage] = SHEET_STAGES) -> Values:
        """What a displacement (n, 3) of the generic face lacks to the goal on this one: (n, 3) metres.

        displacement (n, 3): metres; stages: of the map, those on the sheet by default.
        """
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
) -> InverseResult:
    """The displacement of the generic face with which `apply_smooth_map` brings a face's sheet to goal (V, 3), metres.

    Exact where no stage after `CONTINUOUS_STAGES` changes the sheet; elsewhere as near as it comes. known: expressions
    that it may be a sum of. Of two displacements that give the goal the one counts that adds least roughness to them.

    space, face: whose map; goal (V, 3): metres; known: under the space's rules.
    """
    ready = prepare_smooth_map(space, face)
    target = SheetGoal(space, face, goal, ready.detail.used)
    first = goal - ready.positions
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


def _choose(target: SheetGoal, guess: Values, roots: Sequence[Root]) -> Root:
    """Of the roots that give the goal the one that adds least bending to a guess (n, 3); of others the nearest, after
    hops."""
    good = [root for root in roots if root.error < _GOOD]
    if not good:
        return _solve_by_hops(target, min(roots, key=lambda root: root.error))
    plate = prepare_bending(target.space)
    return min(good, key=lambda root: plate.measure(root.displacement - guess))


def _refine_sums(target: SheetGoal, sums: Sequence[KnownSum]) -> KnownSum:
    """The sum of known expressions that lacks least on the face, its weights refined."""

    def measure_lack(known: KnownSum) -> Values:
        return target.measure_lack(_displace(target, known.expression))

    def measure_size(known: KnownSum) -> float:
        return float(np.linalg.norm(measure_lack(known)))

    nearest = min(sums, key=measure_size)
    if np.abs(measure_lack(nearest)).max() < _CLOSE:
        return refine_known(nearest, measure_lack)
    return min([refine_known(known, measure_lack) for known in sums], key=measure_size)


def _displace(target: SheetGoal, expression: Expression) -> Values:
    """What an expression does to the generic face's sheet, (n, 3) metres."""
    return displace_generic(target.space, compile_expression(target.space, expression))[target.rows]


def _finish(target: SheetGoal, root: Root, known: KnownSum | None, *, exact: bool = False) -> InverseResult:
    return InverseResult(target.spread(root.displacement)[target.space.welded], known, exact)


def _solve_newton(target: SheetGoal, start: Values) -> Values:
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


def _step_newton(target: SheetGoal, start: Values, steps: int) -> tuple[Values, Values]:
    """Where so many steps of Newton's method lead, (n, 3), and what that lacks, (n, 3)."""
    displacement = start
    lack = target.measure_lack(start, CONTINUOUS_STAGES)
    jacobian = None
    last = np.inf
    for _ in range(steps):
        size = float(np.linalg.norm(lack))
        if np.abs(lack).max() < _EXACT:
            break
        if jacobian is None or size > 0.3 * last:  # else the former one still serves
            jacobian = _linearise(target, displacement)
        last = size
        step = _precondition(jacobian, lack)
        length = 1.0
        while True:
            trial = target.measure_lack(displacement + length * step, CONTINUOUS_STAGES)
            if np.linalg.norm(trial) < size or length < _SHORTEST:
                break
            length /= 2
        if np.linalg.norm(trial) >= size:
            break
        displacement = displacement + length * step
        lack = trial
    return displacement, lack


def _linearise(target: SheetGoal, displacement: Values) -> SmoothMapJacobian | None:
    try:
        return linearise_smooth_map(target.space, target.face, target.spread(displacement))
    except RuntimeError:  # singular, as it can be at shapes that no face has
        return None


def _precondition(jacobian: SmoothMapJacobian | None, lack: Values) -> Values:
    return 0.5 * lack if jacobian is None else jacobian.solve(lack)


def _solve_all_stages(target: SheetGoal, start: Values) -> Root:
    """The nearest to the goal that Anderson acceleration comes through all stages: whole steps, then shorter ones."""
    best = Root(start, float(np.abs(target.measure_lack(start)).max()))
    for length in _LENGTHS:
        if best.error < _GOOD:
            break
        jacobian = _linearise(target, best.displacement)
        best = _accelerate(target, best, jacobian, length)
    return best


def _solve_by_hops(target: SheetGoal, best: Root) -> Root:
    """The nearest to the goal after hops from where acceleration was stuck, each smoothed around the vertex that lacks
    most: basin hopping (Wales & Doye 1997), without chance."""
    jacobian = _linearise(target, best.displacement)
    for wave, share in product(_HOPS, _SHARES):
        if best.error < _GOOD or best.error > _STUCK:
            break
        near = _accelerate(target, _hop(target, best, wave, share), jacobian, 1.0)
        best = min(best, near, key=lambda root: root.error)
    return best


def _hop(target: SheetGoal, root: Root, wave: float, share: float) -> Root:
    """A root moved so far toward what it is without waves so short, metres, around the vertex that lacks most."""
    lack = target.measure_lack(root.displacement)
    worst = int((lack**2).sum(axis=1).argmax())
    smooth = prepare_bending(target.space).smooth_around(root.displacement, worst, wave, _AROUND)
    moved = root.displacement + share * (smooth - root.displacement)
    return Root(moved, float(np.abs(target.measure_lack(moved)).max()))


def _accelerate(target: SheetGoal, best: Root, jacobian: SmoothMapJacobian | None, length: float) -> Root:
    displacement = best.displacement
    steps = list[Values]()
    changes = list[Values]()
    before: tuple[Values, Values] | None = None
    since = 0
    for _ in range(_MOST):
        lack = target.measure_lack(displacement)
        error = float(np.abs(lack).max())
        best, since = (Root(displacement, error), 0) if error < best.error else (best, since + 1)
        if error < _CLOSE or since > _PATIENCE:
            break
        if before is not None:
            steps = [*steps, before[0]][-_MEMORY:]
            changes = [*changes, lack - before[1]][-_MEMORY:]
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
