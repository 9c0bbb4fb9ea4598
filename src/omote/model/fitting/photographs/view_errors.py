"""How far landmarks of a photograph lie from the points of a head that they show, in metres, and how that changes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.photographs.photograph_camera import PhotographCamera

Values = NDArray[np.float64]

POSE = 7
"""A camera changes by a turn (3,), a shift (3,) and the logarithm of its focal length."""


def measure_errors(pixels: Values, camera: PhotographCamera, places: Values, /) -> Values:
    """How far landmarks (p, 2) in pixels lie right of and above the places (p, 3) of a head, at their depth, (2 p,)
    metres."""
    seen = camera.view(places)
    off = (pixels - camera.project(seen)) * (-seen[:, 2:] / camera.focal)
    result: Values = (off * [1.0, -1.0]).ravel()
    return result


def change_by_places(camera: PhotographCamera, places: Values, moves: Values, /) -> Values:
    """How the errors change with moves (n, p, 3) of the places (p, 3): (2 p, n)."""
    seen = camera.view(places)
    moved = moves @ camera.rotation.T
    return -_in_picture(seen, moved)


def change_by_pose(camera: PhotographCamera, places: Values, /) -> Values:
    """How the errors change with `PhotographCamera.move`: (2 p, 7)."""
    seen = camera.view(places)
    turned = places @ camera.rotation.T
    turns = np.stack([np.cross(axis, turned) for axis in np.eye(3)])
    shifts = np.broadcast_to(np.eye(3)[:, None], (3, len(places), 3))
    return -np.column_stack([_in_picture(seen, np.concatenate([turns, shifts])), seen[:, :2].ravel()])


def _in_picture(seen: Values, moved: Values) -> Values:
    """How moves (n, p, 3) in the camera's frame show at each point's own depth: (2 p, n)."""
    aside = moved[..., :2] - seen[:, :2] * (moved[..., 2:] / seen[:, 2:])
    result: Values = aside.reshape(len(moved), -1).T
    return result
