"""Tangents: the derivative of a face by the field, with which pages preview a drag (linearisation)."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.model.space.face import Face
from omote.model.space.gain import field_gain
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.smooth_map import prepare_smooth_map


def generic_tangents(space: ParameterSpace, /) -> Values:
    """Where the generic head's vertices go, (3, V, 3): metres per radian of dtheta, per metre of dh, per unit of R - 1;
    zero off the sheet. Its points keep their cylinder coordinates, so these are exact."""
    away = space.points - [space.cylinder.x, 0.0, space.cylinder.z]
    flat = np.zeros(space.vertex_count)
    turning = np.stack([away[:, 2], flat, -away[:, 0]], axis=1)
    rising = np.stack([flat, flat + 1.0, flat], axis=1)
    swelling = np.stack([away[:, 0], flat, away[:, 2]], axis=1)
    return np.stack([turning, rising, swelling]) * space.on_sheet[:, None]


def tangents(space: ParameterSpace, face: Face, /) -> Values:
    """How each vertex of a face's sheet answers to the field there, (3, V, 3): metres per radian of dtheta, metre of dh
    and unit of R - 1; ValueError where the face does not belong to the space."""
    ready = prepare_smooth_map(space, face)
    gain = field_gain(space, face.gains)
    growth = ready.gain if gain is None else ready.gain * gain.skin
    return generic_tangents(space) * growth[:, None]
