"""Light from afar on skin that scatters it evenly: a polynomial of the second degree in the normal.

Ramamoorthi and Hanrahan (2001), "An efficient representation for irradiance environment maps".
"""

from __future__ import annotations

import numpy as np

from omote.arrays import Values

ROUNDS = 6
RIDGE = 0.001
"""Of the light's uneven parts, beside its even one, as a share of what shows them."""


def harmonics(normals: Values, /) -> Values:
    """The nine real spherical harmonics up to the second degree at unit normals (n, 3), not normed: (n, 9)."""
    x, y, z = normals.T
    return np.stack([np.ones(len(x)), x, y, z, x * y, y * z, x * z, x * x - y * y, 3.0 * z * z - 1.0], axis=1)


def slope_harmonics(normals: Values, /) -> Values:
    """How the harmonics change with the normals (n, 3), as if these had any length: (n, 9, 3)."""
    x, y, z = normals.T
    zero = np.zeros(len(x))
    one = np.ones(len(x))
    rows = (
        (zero, zero, zero), (one, zero, zero), (zero, one, zero), (zero, zero, one), (y, x, zero), (zero, z, y),
        (z, zero, x), (2.0 * x, -2.0 * y, zero), (zero, zero, 6.0 * z),
    )  # fmt: skip
    return np.stack([np.stack(row, axis=1) for row in rows], axis=1)


def fit_soft_light(basis: Values, ratio: Values, weight: Values, /) -> Values:
    """The weights (9,) of harmonics that explain ratios (n,), those far off counted less (Tukey).

    basis (n, 9): harmonics; ratio (n,): of light seen to light expected; weight (n,): how much each counts.
    """
    share = weight.copy()
    for _ in range(ROUNDS):
        matrix = (basis.T * share) @ basis
        penalty = RIDGE * np.trace(matrix) / 9.0 * np.diag([0.0, *np.ones(8)])
        answer: Values = np.linalg.solve(matrix + penalty, (basis.T * share) @ ratio)
        off = ratio - basis @ answer
        wide = 4.0 * float(np.median(np.abs(off))) + 1e-9
        share = weight * np.maximum(1.0 - (off / wide) ** 2, 0.0) ** 2
    return answer
