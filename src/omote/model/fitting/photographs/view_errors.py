"""How far landmarks of a photograph lie from the points of a head that they show, in metres, and how that changes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.photographs.photograph_camera import PhotographCamera

Values = NDArray[np.float64]

POSE = 7
"""A camera changes by a turn (3,), a shift (3,) and the logarithm of its focal length."""


def measure_errors(pixels: Values, camera: PhotographCamera, places: Values, /) -> Values:
    """How far landmarks (p, 3) in pixels lie right, above and before the places (p, 3) of a head, (3 p,) metres.

    A landmark's third coordinate is a depth in the picture's pixels, from wherever: its mean says nothing. Landmark
    models see from afar, so that depth is in pixels of the head's middle.
    """
    seen = camera.view(places)
    scale = -seen[:, 2] / camera.focal
    off = (pixels[:, :2] - camera.project(seen)) * scale[:, None]
    depth = -pixels[:, 2] * scale.mean() - seen[:, 2]
    return np.column_stack([off[:, 0], -off[:, 1], depth - depth.mean()]).ravel()


def change_by_places(camera: PhotographCamera, places: Values, moves: Values, /) -> Values:
    """How the errors change with moves (n, p, 3) of the places (p, 3): (3 p, n)."""
    seen = camera.view(places)
    moved = moves @ camera.rotation.T
    return -_in_picture(seen, moved)


def change_by_pose(camera: PhotographCamera, places: Values, /) -> Values:
    """How the errors change with `PhotographCamera.move`: (3 p, 7)."""
    seen = camera.view(places)
    turned = places @ camera.rotation.T
    turns = np.stack([np.cross(axis, turned) for axis in np.eye(3)])
    shifts = np.broadcast_to(np.eye(3)[:, None], (3, len(places), 3))
    growth = np.column_stack([seen[:, :2], np.zeros(len(seen))])
    return -np.column_stack([_in_picture(seen, np.concatenate([turns, shifts])), growth.ravel()])


def _in_picture(seen: Values, moved: Values) -> Values:
    """How moves (n, p, 3) in the camera's frame show: aside at each point's own depth, and in depth about its mean."""
    aside = moved[..., :2] - seen[:, :2] * (moved[..., 2:] / seen[:, 2:])
    depth = moved[..., 2] - moved[..., 2].mean(axis=1, keepdims=True)
    result: Values = np.concatenate([aside, depth[..., None]], axis=2).reshape(len(moved), -1).T
    return result
