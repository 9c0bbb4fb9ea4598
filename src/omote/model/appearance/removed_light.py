"""Divides soft light out of what a photograph shows of skin: spherical harmonics of the known normals.

Light from afar on skin that scatters it evenly is a polynomial of the second degree in the normal (Ramamoorthi and
Hanrahan 2001, "An efficient representation for irradiance environment maps"). Skin of one colour shows it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.albedo import Light
from omote.model.fitting.soft_light import fit_soft_light, harmonics

Values = NDArray[np.float64]

RANGE = (0.35, 2.5)
"""Shade is divided out between these, its mean being 1: darker and lighter than that is no soft light."""
_DARKEST = 0.004
_STEP = 7  # every so many texels are enough for nine numbers


def remove_light(light: Light, weight: Light, normals: Values, painted: Light, /) -> Light:
    """The linear light (k, k, 3) of texels divided by the shade on them, whose mean stays.

    weight (k, k): how well each is seen; normals (k, k, 3); painted (k, k, 3): linear light of usual skin, whose lips
    and shades are no light. Each colour has a light of its own.
    """
    rows, columns = np.nonzero(weight[::_STEP, ::_STEP] > 0.0)
    if len(rows) < 9 * 9:
        return light
    rows, columns = rows * _STEP, columns * _STEP
    basis = harmonics(normals[rows, columns])
    ratio = np.maximum(light[rows, columns], _DARKEST) / np.maximum(painted[rows, columns], _DARKEST)
    result = light.copy()
    used = weight > 0.0
    everywhere = harmonics(normals[used])
    for channel in range(3):
        answer = fit_soft_light(basis, ratio[:, channel].astype(np.float64), weight[rows, columns].astype(np.float64))
        even = float((weight[rows, columns] * (basis @ answer)).sum() / weight[rows, columns].sum())
        shade = np.clip(everywhere @ answer / max(even, _DARKEST), *RANGE)
        result[used, channel] = light[used, channel] / shade
    return result
