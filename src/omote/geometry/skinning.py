"""Skinning: the rows of a mesh follow its bones, by linear blending, by dual quaternions, or by a share of both."""

from __future__ import annotations

import numpy as np
from numba import njit
from scipy.spatial.transform import Rotation

from omote.arrays import Floats, Indices, Points, Values


def skin(
    points: Points, bones: Indices, weights: Floats, shares: Floats, turns: Values, shifts: Points, /
) -> Points:  # fmt: skip
    """The rows of a mesh (n, 3) where its bones have moved.

    Each row is `share` times what dual quaternions make of it and the rest what linear blending does: the first keep a
    twisted or bent limb round, the second does not swell where limbs part from the trunk.

    points (n, 3): at rest; bones (n, k), weights (n, k): which bones move a row, and how much each, sum one;
    shares (n,): 0 to 1; turns (J, 3, 3): rotation of each bone; shifts (J, 3): where it moves the origin.

    Returns
    -------
    ndarray (n, 3)
        In the unit of the points.

    References
    ----------
    L. Kavan, S. Collins, J. Zara, C. O'Sullivan, Skinning with dual quaternions, I3D 2007.
    """
    quaternions = Rotation.from_matrix(turns).as_quat()
    moved = np.empty_like(points, dtype=np.float64)
    _skin(points, bones, weights, shares, turns, shifts, quaternions, _dual_parts(quaternions, shifts), moved)
    return moved


def _dual_parts(quaternions: Values, shifts: Points) -> Values:
    """The dual part (J, 4) of each bone's dual quaternion, half of shift times rotation; x, y, z, w."""
    x, y, z = shifts.T
    qx, qy, qz, qw = quaternions.T
    return 0.5 * np.stack(
        [
            x * qw + y * qz - z * qy,
            y * qw + z * qx - x * qz,
            z * qw + x * qy - y * qx,
            -x * qx - y * qy - z * qz,
        ],
        axis=1,
    )


@njit(cache=True)
def _skin(points, bones, weights, shares, turns, shifts, real, dual, moved):  # type: ignore[no-untyped-def]
    """Fills moved (n, 3); real, dual (J, 4): dual quaternions of the bones."""
    for row in range(len(points)):
        share = shares[row]
        moved[row] = 0.0
        if share < 1.0:
            _blend_linearly(points[row], bones[row], weights[row], turns, shifts, 1.0 - share, moved[row])
        if share > 0.0:
            _blend_dual(points[row], bones[row], weights[row], real, dual, share, moved[row])


@njit(cache=True)
def _blend_linearly(point, bones, weights, turns, shifts, share, moved):  # type: ignore[no-untyped-def]
    for place in range(len(bones)):
        weight = share * weights[place]
        if weight != 0.0:
            turn = turns[bones[place]]
            for axis in range(3):
                moved[axis] += weight * (
                    turn[axis, 0] * point[0]
                    + turn[axis, 1] * point[1]
                    + turn[axis, 2] * point[2]
                    + shifts[bones[place], axis]
                )


@njit(cache=True)
def _blend_dual(point, bones, weights, real, dual, share, moved):  # type: ignore[no-untyped-def]
    """Quaternions of the other half of the sphere are turned to the first bone's: a row goes the shorter way."""
    a = np.zeros(4)
    b = np.zeros(4)
    first = bones[0]
    for place in range(len(bones)):
        bone = bones[place]
        weight = weights[place]
        if weight != 0.0:
            if (real[first] * real[bone]).sum() < 0.0:
                weight = -weight
            for axis in range(4):
                a[axis] += weight * real[bone, axis]
                b[axis] += weight * dual[bone, axis]
    length = np.sqrt((a * a).sum())
    a /= length
    b /= length
    x, y, z, w = a
    # p + 2 r x (r x p + w p) + 2 (w d - d_w r + r x d), of the real part (r, w) and the dual part (d, d_w)
    ux = y * point[2] - z * point[1] + w * point[0]
    uy = z * point[0] - x * point[2] + w * point[1]
    uz = x * point[1] - y * point[0] + w * point[2]
    moved[0] += share * (point[0] + 2.0 * (y * uz - z * uy) + 2.0 * (w * b[0] - b[3] * x + y * b[2] - z * b[1]))
    moved[1] += share * (point[1] + 2.0 * (z * ux - x * uz) + 2.0 * (w * b[1] - b[3] * y + z * b[0] - x * b[2]))
    moved[2] += share * (point[2] + 2.0 * (x * uy - y * ux) + 2.0 * (w * b[2] - b[3] * z + x * b[1] - y * b[0]))
