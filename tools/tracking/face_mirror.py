"""Faces seen in a mirror: the left half's points and features for the right half's, and back."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from omote.inputs.camera.face_features import POSE_TERMS

Values = NDArray[np.float64]
Rows = NDArray[np.intp]
ACROSS = np.array([-1.0, 1.0, 1.0])
SKIN = 468
_EYE = 10  # measures of one eye


def find_mirror(face: Values) -> Rows:
    """For each point of a face (478, 3) its partner on the other side: the nearest, one to one."""
    flipped = face * ACROSS
    pairs = np.arange(len(face))
    for rows, others in (((0, SKIN), (0, SKIN)), ((468, 473), (473, 478)), ((473, 478), (468, 473))):
        apart = ((face[slice(*others)][:, None] - flipped[slice(*rows)]) ** 2).sum(-1)
        there, here = linear_sum_assignment(apart)
        pairs[rows[0] + here] = others[0] + there
    return pairs


def mirror_face(faces: Values, pairs: Rows) -> Values:
    """Faces (..., 478, 3) in the mirror.

    faces: x to one side; pairs (478,): the row of each point's other side.
    """
    result: Values = faces[..., pairs, :] * ACROSS
    return result


def mirror_measures() -> tuple[Rows, Values]:
    """Which measure of a face, and with which sign, is each measure of the mirrored one."""
    eye = np.concatenate([np.ones(7), [-1.0, 1.0], [1.0]])
    rows = [*range(_EYE, 2 * _EYE), *range(_EYE), 2 * _EYE]
    first = 2 * _EYE + 1
    rows += [first + 3 * pair + axis for pair in (0, 2, 1, 4, 3) for axis in range(3)]
    return np.array(rows), np.concatenate([eye, eye, [1.0], np.tile(ACROSS, 5)])


def mirror_pose() -> Values:
    """The signs of the terms of a pose: yaw, roll and place right turn round."""
    yaw = -1.0
    pitch = 1.0
    roll = -1.0
    return np.array([yaw, pitch, roll, -1.0, 1.0, 1.0, 1.0, 1.0, 1.0, yaw * pitch, yaw * roll, pitch * roll])


def mirror_features(moved: Values, rest: Values) -> tuple[Rows, Values]:
    """The same for features. moved (k,), rest (m,): the sign of each component, which is even (1) or odd (-1)."""
    measures, signs = mirror_measures()
    first = len(moved)
    rows = np.concatenate(
        [np.arange(first), first + measures, first + len(measures) + np.arange(POSE_TERMS + len(rest))]
    )
    return rows, np.concatenate([moved, signs, mirror_pose(), rest])
