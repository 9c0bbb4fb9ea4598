"""Ears that turn about their roots, as eyeballs turn about their centres: back, up and out, whatever way they hang."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Floats, Values
from omote.geometry.laplacian import smoothing_matrix
from omote.geometry.orientation import area_shares, repair_triangles, rest_normals
from omote.geometry.ramp import smooth_ramp
from omote.model.space.head_regions import eye_frame
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

# In distances between the eyes, from the point midway between them: the height over a plane (x, z, constant) on which
# an ear's root and the skull behind it stand, and from where to where it makes an ear; the same of y, below and above.
# The border is then spread over so many rings of the mesh; less than the first share of an ear is skull, more than the
# second is ear.
_PLANE = (2.86, -0.38, -3.64)
_HEIGHT = (0.05, 0.12)
_LOW = (-1.15, -0.95)
_HIGH = (0.42, 0.62)
_RINGS = 10
_NOTHING = 0.05
_WHOLE = 0.7
_SIDES = (1.0, -1.0)
_SMALL = 1e-9
# Where an ear that turns folds: the share of its area that a triangle gets, and steps at most.
_REPAIRED_AREA = 0.05
_STEPS = 200
# Rounds at most until neither way of a signed turn folds; those of the cast take 3.
_BOTH_WAYS = 40


@dataclass(frozen=True, eq=False)
class Ear:
    """An ear of a face: root (3,) metres, about which it turns, and the unit direction (3,) from there to its tip."""

    root: Values
    direction: Values


@weakly_cached
def ear_weights(space: ParameterSpace, /) -> Values:
    """How far each vertex of the skin turns with the left and with the right ear, (2, V) from 0 (skull) to 1 (ear).

    Raises ValueError where the space has no two eyeballs, by which the head is measured.
    """
    middle, unit = eye_frame(space)
    x, y, z = ((space.points - middle) / unit).T
    spread = smoothing_matrix(space.welded[space.triangles], space.vertex_count)
    tall = smooth_ramp(*_LOW, y) * (1.0 - smooth_ramp(*_HIGH, y))
    sides = [tall * smooth_ramp(*_HEIGHT, _PLANE[0] * side * x + _PLANE[1] * z + _PLANE[2]) for side in _SIDES]
    weights = np.stack(sides, axis=1)
    for _ in range(_RINGS):
        weights = spread @ weights
    return smooth_ramp(_NOTHING, _WHOLE, weights[space.welded].T)


def find_ear(weights: Values, rest: Values, /) -> Ear | None:
    """The ear on a face at rest, (V, 3) metres, from its weights (V,); None where the head has none there.

    Its root is the middle of the skin between skull and ear.
    """
    border = weights * (1.0 - weights)
    if border.sum() < _SMALL:
        return None
    root = border @ rest / border.sum()
    away = weights @ rest / weights.sum() - root
    length = float(np.linalg.norm(away))
    return Ear(root, away / length) if length > _SMALL else None


def turn_ears(
    space: ParameterSpace, rest: Floats, skin: Floats, turns: Values, /, *, signed: bool = False
) -> Floats:  # fmt: skip
    """The skin (V, 3) of a face at rest (V, 3) with its ears turned (`rotate_ears`), metres, float32; triangles between
    skull and ear that this turns over are brought back by position based dynamics (Mueller et al. 2007).

    space: the space of the generic head. signed: what ears do is played below 0 too: they go as far the one way as the
    other, and neither way turns triangles over.
    """
    moved = rotate_ears(space, rest, skin, turns).astype(np.float64)
    still = skin.astype(np.float64)
    if signed:
        moved = still + 0.5 * (moved - rotate_ears(space, rest, skin, -turns))
    for weights, (_, axis) in rotations(space, rest, turns):
        folds = _repair_folds(space, rest.astype(np.float64), still, moved, weights, axis)
        for _ in range(_BOTH_WAYS if signed else 0):
            opposite = 2.0 * still - moved
            folds |= _repair_folds(space, rest.astype(np.float64), still, opposite, weights, -axis)
            moved = 2.0 * still - opposite
            if not folds:
                break
            folds = _repair_folds(space, rest.astype(np.float64), still, moved, weights, axis)
    return np.where(space.on_sheet[:, None], moved[space.welded], moved).astype(np.float32)


def rotate_ears(space: ParameterSpace, rest: Floats, skin: Floats, turns: Values, /) -> Floats:
    """The skin (V, 3) of a face at rest (V, 3) with its ears rotated, metres, float32; by minus the turns, back again.

    space: the space of the generic head.

    turns (2, 3): how far the left and the right one go back, up and out, radians: each is a rotation about the root,
    at right angles to the ear and to the way it goes. An ear that already points there does not turn, one across it
    turns the whole angle (the sine of what is between them, so nothing jumps).
    """
    moved = skin.astype(np.float64)
    for weights, (root, axis) in rotations(space, rest, turns):
        rows = np.flatnonzero(weights)
        moved[rows] = root + Rotation.from_rotvec(weights[rows, None] * axis).apply(moved[rows] - root)
    return moved.astype(np.float32)


def rotations(space: ParameterSpace, rest: Floats, turns: Values, /) -> list[tuple[Values, tuple[Values, Values]]]:
    """Of each ear that turns: the weights (V,), its root (3,) and the rotation vector (3,).

    space: the space of the generic head; rest: (V, 3), metres.
    """
    ears = []
    for weights, side, turn in zip(ear_weights(space), _SIDES, turns, strict=True):
        ear = find_ear(weights, rest.astype(np.float64)) if turn.any() else None
        if ear is not None:
            ways = np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [side, 0.0, 0.0]])
            ears.append((weights, (ear.root, turn @ np.cross(ear.direction, ways))))
    return ears


def _repair_folds(
    space: ParameterSpace, rest: Values, skin: Values, moved: Values, weights: Values, axis: Values
) -> bool:
    """Brings triangles that turn over between skin and moved (V, 3) back in moved, in place; their normals at rest turn
    with them. Returns whether any did."""
    corners = space.sheet_triangles[(weights[space.sheet_triangles] > 0).any(axis=1)]
    normals, sizes = rest_normals(rest, corners)
    turned = Rotation.from_rotvec(weights[corners].mean(axis=1)[:, None] * axis).apply(normals)
    before = area_shares(skin, normals, sizes, corners)
    after = area_shares(moved, turned, sizes, corners)
    if ((after < 0) & (before >= 0)).any():
        goals = np.where(before < 0, -np.inf, np.minimum(_REPAIRED_AREA, before))
        repair_triangles(moved, turned, sizes, corners, goals, _STEPS)
        return True
    return False
