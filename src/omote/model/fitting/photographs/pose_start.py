"""The first guess of a photograph's camera: as if it had been taken from afar."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.photographs.photograph import FILM, Photograph
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.space.similarity import fit_similarity

Values = NDArray[np.float64]

FOCAL = 1.2
"""Widths of the longer side: what most photographs of heads are taken with."""
FOCAL_SPREAD, KNOWN_SPREAD = 0.4, 0.03
"""Of the logarithm of a focal length that nobody told, and of one that a file tells."""
_AFAR_ROUNDS = 40


def usual_focal(photograph: Photograph, /) -> float:
    """The focal length in pixels: as the file says, else as usual."""
    longer = max(photograph.width, photograph.height)
    return longer * (FOCAL if photograph.focal is None else photograph.focal / FILM)


def start_camera(photograph: Photograph, places: Values, /) -> PhotographCamera:
    """The camera from which points (p, 3) of a usual head lie as the photograph's landmarks do."""
    pixels = photograph.landmarks[: len(places)]
    upright = np.column_stack([pixels[:, 0], -pixels[:, 1], np.zeros(len(pixels))])
    if photograph.has_depth:
        upright[:, 2] = -pixels[:, 2]
    else:
        upright[:, 2] = _guess_depth(upright[:, :2], places)
    pose = fit_similarity(places, upright, np.ones(len(places)))
    focal = usual_focal(photograph)
    away = focal / pose.scale
    aside = (pose.shift[:2] - [0.5 * photograph.width, -0.5 * photograph.height]) / pose.scale
    shift = np.array([aside[0], aside[1], -away])
    return PhotographCamera(pose.rotation, shift, focal, photograph.width, photograph.height)


def _guess_depth(flat: Values, places: Values) -> Values:
    """Depths (p,) of points whose places in the picture (p, 2) are known, as a usual head turned the same way has."""
    depth = np.zeros(len(flat))
    for _ in range(_AFAR_ROUNDS):
        pose = fit_similarity(places, np.column_stack([flat, depth]), np.ones(len(flat)))
        depth = pose(places)[:, 2]
    return depth
