"""How far the ears of a face turn in a displacement of its skin, found without any known expression.

An ear turns rigidly about its root: the rotation is that of least squares (Kabsch 1976) on what is all ear. Of the
turns that move an ear so, the least are taken: there are three ways to turn, and two say where its tip goes.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Mask, Values
from omote.model.space.ears import ear_weights, find_ear, rotate_ears
from omote.model.space.face import Face
from omote.model.space.gain import gain_of
from omote.model.space.parameter_space import ParameterSpace

# What is all ear; a rotation below so many radians is none; what undoing one has to leave at most, of squared
# displacements of what is all ear.
_WHOLE = 0.99
_STILL = 2e-3
_LEFT = 0.3
_SIDES = np.eye(2)


def undo_ears(space: ParameterSpace, face: Face, moved: Values, turns: Values, /) -> Values:
    """A displacement (V, 3) of a face with its ears turned back by turns (2, 3), metres.

    space, face: whose ears; moved (V, 3): metres; turns (2, 3): radians.
    """
    rest = face.positions
    return rotate_ears(space, rest, (rest + moved).astype(np.float32), -turns).astype(np.float64) - rest


def fit_ear_turns(space: ParameterSpace, face: Face, moved: Values, /) -> Values:
    """How far the left and the right ear turn back, up and out in a displacement (V, 3) metres: (2, 3) radians.

    Zero for an ear that does not move as a turn moves it, and for a face without a gain for ears, which turns none.

    space, face: whose ears; moved (V, 3): metres.
    """
    turns = np.zeros((2, 3))
    if space.transfer == "paper" or not gain_of(face.gains, "ears"):
        return turns
    for side, weights in enumerate(ear_weights(space)):
        turns[side] = _fit_rigidly(space, face, moved, side, weights > _WHOLE)
    return turns


def _fit_rigidly(space: ParameterSpace, face: Face, moved: Values, side: int, whole: Mask) -> Values:
    """The least turns (3,) of one ear that bring it where its vertices (V,) go, or zeros."""
    rest = face.positions.astype(np.float64)
    ear = find_ear(ear_weights(space)[side], rest)
    if ear is None or whole.sum() < 3 or np.abs(moved[whole]).max() < _STILL * np.ptp(rest[whole], axis=0).max():
        return np.zeros(3)
    rotation, _ = Rotation.align_vectors((rest + moved)[whole] - ear.root, rest[whole] - ear.root)
    ways = np.cross(ear.direction, [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [(1.0, -1.0)[side], 0.0, 0.0]])
    turns: Values = np.linalg.lstsq(ways.T, rotation.as_rotvec(), rcond=None)[0]
    left = undo_ears(space, face, moved, _SIDES[side][:, None] * turns)[whole]
    return turns if (left**2).sum() < _LEFT * (moved[whole] ** 2).sum() else np.zeros(3)
