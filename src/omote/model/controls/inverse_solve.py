"""Inverse solve: finds the control vectors that put dragged points at their targets on a face (Broyden's method)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.arrays import Values
from omote.geometry.cylinder import wrap
from omote.model.controls.net_field import NetField
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import apply_expression
from omote.model.transfer.gain_limit import answer_expression
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.pipeline import apply_smooth_map

CLOSE = 4e-5
"""Tolerance of the solve, metres; the promised accuracy is 5e-5."""
MOST = 22
"""Compounds that may be computed at each share of giving way."""

# Where skin folds the map to a face jumps, and a target may lie in the gap. Then the points around the dragged ones
# give way by so much of their change: that moves the gap.
_GIVING = (0.05, 0.1, 0.2, 0.35)
# So many steps are Broyden's, those after them so much of a translation; no step is longer, metres; one whose answer is
# less than this share of it says nothing.
_QUASI = 10
_SHORTER = 0.6
_STRIDE = 0.03
_TELLING = 1e-3
_LEAST_RATIO = 0.05
# No fold holds a point back by so many metres: what still misses by more after so many compounds is out of reach.
_LOST = 0.01
_PATIENCE = 6


@dataclass(frozen=True, eq=False)
class Solution:
    """Vectors (n, 3) of the whole net, how far the worst dragged point is from its target, metres, and how many
    compounds it took."""

    vectors: Values
    miss: float
    compounds: int


def solve_vectors(
    space: ParameterSpace, face: Face, under: Expression, net_field: NetField, vectors: ArrayLike,
    points: Sequence[int], targets: ArrayLike, /,
) -> Solution:  # fmt: skip
    """Solves for vectors with which control points `points` (indices in the net) lie at targets (m, 3), metres, on a
    face.

    space: the space of the generic head; net_field: the net through the control points.

    under: the expression without the net's field; vectors (n, 3): where to start. Only those of the points change, and
    of their neighbours a little where skin folds and nothing else would do; the miss says how well it went.
    Raises ValueError on places that are none, other shapes and numbers that are not finite.
    """
    start = np.array(vectors, np.float64)
    net_field.field(start)
    goal = _validate_targets(net_field, points, targets)
    chosen = np.array(points, np.int64)
    drag = _Drag(space, face, under, net_field, start, chosen)
    return _find_solution(drag, goal)


@dataclass(frozen=True, eq=False)
class _Drag:
    """The system to solve; its unknowns are where the generic head's vertices under the points go, (m, 3) metres: in
    these the map to any face is nearly a translation."""

    space: ParameterSpace
    face: Face
    under: Expression
    net_field: NetField
    start: Values
    chosen: NDArray[np.int64]
    give: float = 0.0

    @cached_property
    def rows(self) -> NDArray[np.int64]:
        """The vertices under the dragged points."""
        return np.array(self.net_field.rows)[self.chosen]

    @cached_property
    def beneath(self) -> Values:
        """The field without the net's (V, 3): dtheta, dh, R - 1."""
        return np.stack([self.under.dtheta, self.under.dh, self.under.ratio - 1.0], axis=1)

    def vectors(self, places: Values) -> Values:
        """The net's vectors (n, 3) with which the generic head's points go to places (m, 3)."""
        theta, h, radius = self.space.cylinder.unroll(places)
        at = self.rows
        there = np.stack([wrap(theta - self.space.theta[at]), h - self.space.h[at], radius / self._radii], axis=1)
        result = self.start.copy()
        result[self.chosen] = there - self.beneath[at]
        if self.give:
            result += self.give * self._around @ (result - self.start)
        return result

    def places(self) -> Values:
        """Where the start puts the points on the generic head, (m, 3)."""
        at = self.rows
        dtheta, dh, over = (self.beneath[at] + self.start[self.chosen]).T
        return self.space.cylinder.roll(self.space.theta[at] + dtheta, self.space.h[at] + dh, over * self._radii)

    def positions_at(self, places: Values) -> Values:
        """Where the points lie on the face, (m, 3), when they are at places on the generic head."""
        dtheta, dh, over = (self.beneath + self.net_field.field(self.vectors(places))).T
        worn = replace(self.under, dtheta=dtheta, dh=dh, ratio=np.maximum(1.0 + over, _LEAST_RATIO))
        compiled = compile_expression(self.space, answer_expression(self.space, self.face.gains, worn))
        if self.space.transfer == "paper":
            return apply_expression(self.space, self.face, compiled)[self.rows].astype(np.float64)
        return apply_smooth_map(self.space, self.face, displace_generic(self.space, compiled))[self.rows]

    @cached_property
    def _around(self) -> Values:
        """How much each point of the net (n, n) goes with the dragged ones that it is joined to: their mean."""
        count = len(self.net_field.rows)
        joined = np.zeros((len(self.net_field.net.theta),) * 2)
        for one, other in ((0, 1), (1, 2), (2, 0)):
            ends = self.net_field.net.triangles[:, [one, other]]
            joined[ends[:, 0], ends[:, 1]] = joined[ends[:, 1], ends[:, 0]] = 1.0
        joined = joined[:count, :count]
        joined[self.chosen] = 0.0
        joined[:, np.setdiff1d(np.arange(count), self.chosen)] = 0.0
        return joined / np.maximum(joined.sum(axis=1, keepdims=True), 1.0)

    @cached_property
    def _radii(self) -> Values:
        return self.space.cylinder.unroll(self.space.points[self.rows])[2]


def _find_solution(drag: _Drag, goal: Values) -> Solution:
    """Solves with more and more giving way of the neighbours, until the goal is met; else returns the nearest."""
    best = _solve_broyden(drag, goal)
    count = best.compounds
    for give in _GIVING:
        if not CLOSE < best.miss <= _LOST or not drag._around.any():
            break
        solution = _solve_broyden(replace(drag, give=give), goal)
        count += solution.compounds
        best = min(best, solution, key=lambda one: one.miss)
    return replace(best, compounds=count)


def _solve_broyden(drag: _Drag, goal: Values) -> Solution:
    """Broyden's method (1965) on the places, from the answer of a translation; when that does not end, shorter steps
    of the translation itself, which a jump of the map does not lead astray. A goal out of reach is soon given up."""
    places = drag.places()
    answer = np.eye(goal.size)
    lack = (goal - drag.positions_at(places)).ravel()
    best = places
    least = _worst(lack)
    count = 1
    vain = 0
    while least > CLOSE and count < MOST and (least <= _LOST or vain < _PATIENCE):
        quasi = count < _QUASI
        step = answer @ lack if quasi else _SHORTER * lack
        step *= min(1.0, _STRIDE / max(_worst(step), 1e-12))
        places = places + step.reshape(-1, 3)
        after = (goal - drag.positions_at(places)).ravel()
        count += 1
        if quasi:
            answer = _update_inverse(answer, step, lack - after)
        lack = after
        vain = vain + 1
        if _worst(lack) < least:
            best = places
            least = _worst(lack)
            vain = 0
    return Solution(drag.vectors(best), least, count)


def _update_inverse(answer: Values, step: Values, change: Values) -> Values:
    """The inverse Jacobian after a step that changed the lack so; as it was where the step says nothing."""
    along = step @ answer
    scale = float(along @ change)
    if abs(scale) < _TELLING * float(step @ step):
        return answer
    return answer + np.outer(step - answer @ change, along) / scale


def _worst(lack: Values) -> float:
    return float(np.linalg.norm(lack.reshape(-1, 3), axis=1).max(initial=0.0))


def _validate_targets(net_field: NetField, points: Sequence[int], targets: ArrayLike) -> Values:
    for point in points:
        if isinstance(point, bool) or not 0 <= point < len(net_field.rows):
            raise ValueError(f"control point {point!r} does not exist; expected 0 to {len(net_field.rows) - 1}")
    if len(set(points)) < len(points):
        raise ValueError(f"control points {list(points)} are dragged; expected each of them once")
    goal = np.asarray(targets, np.float64)
    if goal.shape != (len(points), 3) or not np.isfinite(goal).all():
        raise ValueError(f"targets have shape {goal.shape}; expected finite metres ({len(points)}, 3)")
    return goal
