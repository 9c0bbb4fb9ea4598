"""Divides soft light out of what a photograph shows of skin: spherical harmonics of the known normals.

Light from afar on skin that scatters it evenly is a polynomial of the second degree in the normal (Ramamoorthi and
Hanrahan 2001, "An efficient representation for irradiance environment maps"). Skin of one colour shows it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.albedo import Light

Values = NDArray[np.float64]

ROUNDS = 6
RIDGE = 0.001
"""Of the light's uneven parts, beside its even one, as a share of what shows them."""
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
        answer = _fit(basis, ratio[:, channel].astype(np.float64), weight[rows, columns].astype(np.float64))
        even = float((weight[rows, columns] * (basis @ answer)).sum() / weight[rows, columns].sum())
        shade = np.clip(everywhere @ answer / max(even, _DARKEST), *RANGE)
        result[used, channel] = light[used, channel] / shade
    return result


def harmonics(normals: Values, /) -> Values:
    """The nine real spherical harmonics up to the second degree at unit normals (n, 3), not normed: (n, 9)."""
    x, y, z = normals.T
    return np.stack([np.ones(len(x)), x, y, z, x * y, y * z, x * z, x * x - y * y, 3.0 * z * z - 1.0], axis=1)


def _fit(basis: Values, ratio: Values, weight: Values) -> Values:
    """The weights (9,) of harmonics that explain ratios (n,), those far off counted less (Tukey)."""
    share = weight.copy()
    for _ in range(ROUNDS):
        matrix = (basis.T * share) @ basis
        penalty = RIDGE * np.trace(matrix) / 9.0 * np.diag([0.0, *np.ones(8)])
        answer: Values = np.linalg.solve(matrix + penalty, (basis.T * share) @ ratio)
        off = ratio - basis @ answer
        wide = 4.0 * float(np.median(np.abs(off))) + 1e-9
        share = weight * np.maximum(1.0 - (off / wide) ** 2, 0.0) ** 2
    return answer
