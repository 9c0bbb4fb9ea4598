"""Keeps teeth and gums behind the skin of a compound (docs/method.md, "Teeth behind the skin").

Level rays from outside find the foremost skin before each vertex of the rows of teeth, or the membrane of the open
mouth, out of which no tooth stands either. What is not deep enough goes back along the skin's normal, its row with it,
less and less. The depth that is asked for does not depend on the expression, so a face at rest stays, except where its
teeth are out of its skin.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Floats, Indices, Mask, Rows, Values
from omote.geometry import mesh
from omote.geometry.proximity import cast_level_rays, measure_outside
from omote.geometry.ramp import smooth_ramp
from omote.model.space.face_fit import FittedFace
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.gum_line import GUMS
from omote.model.transfer.mouth_bag import find_mouth_bag
from omote.model.weak_cache import weakly_cached, weakly_cached_with

# Teeth stay so far behind the skin, metres, or as far as they are at rest: sums add what compounds leave.
CLEAR_METRES = 0.0005
# Skin is looked for up to so far before and behind a vertex, metres: farther behind are throat and nape.
NEAR_METRES = 0.012
# Skin that a ray only grazes, by a smaller cosine, says nothing of what lies behind it.
LEAST_COSINE = 0.1
# Where no ray tells, teeth that stand out of the nearest skin or membrane by up to this, metres, go back to it.
PASSED_METRES = 0.004
# A push takes what is nearer along, less toward SPREAD_METRES, metres: a row bends, no tooth does.
SPREAD_METRES = 0.02
PUSH_ROUNDS = 8
EXACT = 1e-5
# Skin that has moved by less, metres, is at rest.
STILL_METRES = 1e-5


@dataclass(frozen=True, eq=False)
class _Teeth:
    """Both rows of teeth of a space, one after another (n,): around (t, 3): the skin and, from the skin-th on, the
    membranes before them; region (k,): the vertices of these; shares (n, n): how much one goes with another."""

    around: Indices
    skin: int
    region: Indices
    shares: Values


def keep_teeth_inside(
    space: ParameterSpace, fitted: FittedFace, skin: Floats, parts: Mapping[str, Floats], /,
    clearance: float = CLEAR_METRES,
) -> dict[str, Floats]:  # fmt: skip
    """The parts of a face whose skin has moved to (V, 3), teeth and gums behind it; the generic face's own are the
    source and stay.

    space: the space of the generic head; fitted: the face, fitted; clearance: how far behind, metres, or as far as they
    are at rest where that is less.
    """
    rows = _find_rows(space)
    result = dict(parts)
    if rows is None or np.array_equal(fitted.positions, space.points.astype(np.float32)):
        return result
    wanted, inside = _limit_depths(space, fitted)
    if inside and np.abs(skin[rows.region] - fitted.positions[rows.region]).max() < STILL_METRES:
        return result
    teeth = np.concatenate([parts[name] for name in GUMS]).astype(np.float64)
    placed = push_teeth(space, rows, np.minimum(wanted, clearance), skin.astype(np.float64), teeth)
    if placed is not teeth:
        starts = np.cumsum([len(parts[name]) for name in GUMS])[:-1]
        result |= dict(zip(GUMS, (part.astype(np.float32) for part in np.split(placed, starts)), strict=True))
    return result


def push_teeth(space: ParameterSpace, rows: _Teeth, wanted: Values, skin: Values, teeth: Values, /) -> Values:
    """Where teeth (n, 3) go to lie as far as wanted (n,) behind the skin (V, 3); themselves where they do.

    space: the space of the generic head; rows: the teeth, and the skin that they stay behind.
    """
    result = teeth
    for _ in range(PUSH_ROUNDS):
        depth, inward, doubtful = measure_teeth(space, rows, skin, result)
        push = np.maximum(wanted - depth, 0.0)
        _push_doubtful(rows, skin, result, push, inward, np.flatnonzero(doubtful & (push <= 0.0)))
        if push.max() < EXACT:
            break
        goes = rows.shares * push
        most = goes.argmax(axis=1)
        result = result + np.take_along_axis(goes, most[:, None], axis=1) * inward[most]
    return result


def _push_doubtful(rows: _Teeth, skin: Values, teeth: Values, push: Values, inward: Values, doubtful: Rows) -> None:
    """Puts into pushes (n,) and their ways (n, 3) those of doubtful teeth that are outside: to the nearest surface."""
    if len(doubtful) == 0:
        return
    away, back = measure_outside(skin[rows.around], teeth[doubtful], PASSED_METRES)
    out = away > EXACT
    push[doubtful[out]] = away[out]
    inward[doubtful[out]] = back[out]


def measure_teeth(space: ParameterSpace, rows: _Teeth, skin: Values, teeth: Values, /) -> tuple[Values, Values, Mask]:
    """How far behind the skin (V, 3) teeth (n, 3) lie, (n,) metres along its normal, less than zero in front of it,
    infinite where none is before them; behind a membrane CLEAR_METRES more. And the way to go deeper, (n, 3); and where
    the ray leaves a doubt, (n,): it grazes skin, or meets a membrane, which may lie in folds before other skin.

    space: the space of the generic head; rows: the teeth, and the skin that they stay behind.
    """
    ahead = space.cylinder.outward(teeth)
    far, at = cast_level_rays(skin, rows.around, teeth + NEAR_METRES * ahead, -ahead)
    normal = mesh.unit_normals(skin[rows.around[at]])
    met = (ahead * normal).sum(axis=1)
    before = far < 2.0 * NEAR_METRES
    membrane = at >= rows.skin
    squarely = before & (met > LEAST_COSINE)
    depth = (NEAR_METRES - np.where(squarely, far, 0.0)) * met + np.where(membrane, CLEAR_METRES, 0.0)
    return np.where(squarely, depth, np.inf), -normal, before & (membrane | ~squarely)


def are_teeth_inside(space: ParameterSpace, fitted: FittedFace, /) -> bool:
    """Whether the teeth of a face at rest lie behind its skin; so they do where a space has none.

    space: the space of the generic head; fitted: the face, fitted.
    """
    return _find_rows(space) is None or _limit_depths(space, fitted)[1]


@weakly_cached_with
def _limit_depths(space: ParameterSpace, fitted: FittedFace) -> tuple[Values, bool]:
    """How far behind the skin the teeth of a face have to lie, (n,) metres: no farther than at rest, but behind it;
    and whether they lie so at rest."""
    rows = _find_rows(space)
    assert rows is not None
    teeth = np.concatenate([fitted.parts[name] for name in GUMS]).astype(np.float64)
    depth, _, _ = measure_teeth(space, rows, fitted.positions.astype(np.float64), teeth)
    return np.minimum(np.maximum(depth, 0.0), CLEAR_METRES), bool((depth >= 0.0).all())


@weakly_cached
def _find_rows(space: ParameterSpace) -> _Teeth | None:
    """The rows of teeth of a space, remembered as long as it lives; None where it has no mouth bag or no teeth."""
    bag = find_mouth_bag(space)
    if bag is None or not all(name in space.parts for name in GUMS):
        return None
    around = np.concatenate([bag.skin, bag.membranes]).astype(np.int32)
    return _Teeth(around, len(bag.skin), np.unique(around), _shares(space))


def _shares(space: ParameterSpace) -> Values:
    """How much each vertex goes with another of its own row, by their distance on the generic face: (n, n)."""
    points = np.concatenate([space.parts[name].points for name in GUMS])
    row = np.repeat(np.arange(len(GUMS)), [len(space.parts[name].points) for name in GUMS])
    away = np.linalg.norm(points[:, None] - points, axis=2)
    return np.where(row[:, None] == row, 1.0 - smooth_ramp(0.0, SPREAD_METRES, away), 0.0)
