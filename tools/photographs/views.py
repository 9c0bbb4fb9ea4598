"""Cameras before a head, as people hold them for photographs."""

from __future__ import annotations

import numpy as np

from omote.model.fitting.photographs.photograph import PhotographCamera
from tools.tracking.picture import turn

FOCALS = (0.65, 2.2)
"""Of a lens, in widths of the picture: phones held near to portraits from afar."""
FILLS = (0.4, 0.8)
HEIGHT = 0.24
NEAREST = 0.35
MIDDLE = np.array([0.0, -0.005, 0.06])
"""What is brought to the middle of the picture, metres."""


def random_focal(draw: np.random.Generator) -> float:
    """A focal length in widths of the picture."""
    return float(np.exp(draw.uniform(*np.log(FOCALS))))


def camera_at(
    draw: np.random.Generator, yaw: float, pitch: float, roll: float, focal: float, side: int
) -> PhotographCamera:
    """A camera of a square picture to which the head turns these angles (radians), the head somewhere in its middle."""
    distance = max(focal * HEIGHT / draw.uniform(*FILLS), NEAREST) + MIDDLE[2]
    rotation = turn("z", -roll) @ turn("x", -pitch) @ turn("y", yaw)
    aside = draw.normal(0.0, 0.03, 2) * distance / focal
    shift = np.array([aside[0], aside[1], -distance]) - rotation @ MIDDLE
    return PhotographCamera(rotation, shift, focal * side, side, side)
