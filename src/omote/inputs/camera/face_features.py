"""What the map reads of a face: how its points have moved from rest, how far lids and lips are apart, how it is turned.

All functions take many frames at once: leading axes are frames.
"""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.head_pose import HeadPose
from omote.inputs.camera.landmark_groups import CORNERS, IRISES, LIDS, LIPS_APART, MOUTH_CORNERS

POSE_TERMS = 12


def pose_row(pose: HeadPose) -> Values:
    """Yaw, pitch, roll, place right and up, and logarithm of the size of a head in a picture: (6,)."""
    return np.array([*pose.angles, pose.place[0], pose.place[1], np.log(pose.scale)])


def pose_terms(rows: Values) -> Values:
    """The rows (..., 6) of poses, with squares and products of their angles: (..., POSE_TERMS)."""
    yaw = rows[..., 0:1]
    pitch = rows[..., 1:2]
    roll = rows[..., 2:3]
    products = (yaw * yaw, pitch * pitch, roll * roll, yaw * pitch, yaw * roll, pitch * roll)
    return np.concatenate([rows, *products], axis=-1)


def measures(face: Values) -> Values:
    """Distances on faces (..., 478, 3), in widths of the eye or in sizes of the face: openings along both lids, where
    the irises are between corners and lids, the width of the mouth, and how far its lips are apart: (..., 36)."""
    parts = [part for side in LIDS for part in _eye_measures(face, side)]
    left, right = MOUTH_CORNERS
    parts.append(np.linalg.norm(face[..., left, :] - face[..., right, :], axis=-1)[..., None])
    parts += [face[..., upper, :] - face[..., lower, :] for upper, lower in LIPS_APART]
    return np.concatenate(parts, axis=-1)


def lid_openings(face: Values, side: str) -> Values:
    """How far upper and lower lid are apart along an eye, over its width: (..., 7).

    face: (..., 478, 3); side: Left or Right, the eye.
    """
    upper, lower = LIDS[side]
    return (face[..., upper, 1] - face[..., lower, 1]) / _width(face, side)


def _width(face: Values, side: str) -> Values:
    inner, outer = CORNERS[side]
    result: Values = np.linalg.norm(face[..., inner, :] - face[..., outer, :], axis=-1)[..., None]
    return np.maximum(result, 1e-3)


def _eye_measures(face: Values, side: str) -> tuple[Values, ...]:
    width = _width(face, side)
    (upper, _) = LIDS[side]
    (inner, outer) = CORNERS[side]
    iris = face[..., IRISES[side], :].mean(axis=-2)
    middle = 0.5 * (face[..., inner, :] + face[..., outer, :])
    lid = face[..., upper[2:5], :].mean(axis=-2)
    return lid_openings(face, side), (iris - middle)[..., :2] / width, (lid - iris)[..., 1:2] / width
