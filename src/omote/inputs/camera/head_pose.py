"""Where a head is in a picture, and what is left of its points when that is undone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from omote.arrays import Values
from omote.inputs.camera.landmark_frame import LANDMARKS, LandmarkFrame
from omote.inputs.camera.landmark_groups import STEADY
from omote.inputs.trackers.head_angles import HeadAngles
from omote.model.space.similarity import fit_similarity

ROUNDS = 4
DEPTH = 0.55
"""Of the model's z, so that heads turn as far as they do."""
LENS = 1.2
"""Focal length of a camera that nobody knows, in widths of its picture."""
_PRIOR = np.full(LANDMARKS, 0.05)
_PRIOR[STEADY] = 1.0
_PRIOR[468:] = 0.0
LOOSE = 0.02
"""A point that has moved so far, in sizes of the face, counts half."""


@dataclass(frozen=True, eq=False)
class HeadPose:
    """A similarity: points of a picture are scale * rotation @ point + place. rotation (3, 3), place (3,)."""

    scale: float
    rotation: Values
    place: Values

    @property
    def angles(self) -> HeadAngles:
        """Yaw, pitch and roll in our signs, radians."""
        r = self.rotation
        pitch = math.asin(max(-1.0, min(1.0, float(r[1, 2]))))
        return math.atan2(float(r[0, 2]), float(r[2, 2])), pitch, -math.atan2(float(r[1, 0]), float(r[1, 1]))

    def undo(self, points: Values) -> Values:
        """The points (n, 3) of a picture as they lie on the head."""
        result: Values = (points - self.place) @ self.rotation / self.scale
        return result


def metric_points(frame: LandmarkFrame) -> Values:
    """The points (478, 3) of a frame in our axes and units of the picture's width: x to the performer's left, y up, z
    to the camera; (0, 0) the middle of the picture. ValueError where no face was found."""
    if frame.points is None:
        raise ValueError("no face was found in this frame; ask `found` first")
    points = frame.points.astype(np.float64)
    high = frame.height / frame.width
    depth = -DEPTH * points[:, 2]
    near = 1.0 - depth / LENS  # what is near looks large: perspective is undone
    return np.stack([(points[:, 0] - 0.5) * near, high * (0.5 - points[:, 1]) * near, depth], axis=1)


def normal_face(points: Values) -> Values:
    """A face at rest (478, 3) about its middle, in units of its own size (root mean square of the steady points)."""
    steady = points[STEADY]
    centred = points - steady.mean(axis=0)
    result: Values = centred / np.sqrt((centred[STEADY] ** 2).sum(axis=1).mean())
    return result


def fit_pose(points: Values, rest: Values) -> HeadPose:
    """The similarity that carries a face at rest (478, 3) to the points (478, 3) of a picture.

    Steady points count most, and points count less the further they have moved (iteratively reweighted least squares).
    """
    weights = _PRIOR
    for _ in range(ROUNDS):
        fitted = fit_similarity(rest, points, weights)
        pose = HeadPose(fitted.scale, fitted.rotation, fitted.shift)
        left = np.linalg.norm(pose.undo(points) - rest, axis=1)
        weights = _PRIOR / (1.0 + (left / LOOSE) ** 2)
    return pose
