"""Weighted sums of a few large arrays: the blending kernels of all positions (Numba)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numba import float32, njit, types, void
from numpy.typing import NDArray

Floats = NDArray[np.float32]

_READ = types.Array(float32, 1, "C", readonly=True)
_WRITE = types.Array(float32, 1, "C")
_ROWS = types.Array(float32, 2, "C", readonly=True)
_CORNERS = types.Array(types.int32, 2, "C", readonly=True)
_POINTS = types.Array(float32, 2, "C")
_NAMES = types.Array(types.int64, 1, "C", readonly=True)
_BLOCK = 2048  # floats of the sum that stay in the first-level cache while all rows pass by


def weighted_sum(arrays: Sequence[Floats], factors: Sequence[float], *, out: Floats | None = None) -> Floats:
    """The sum of factor times array, for C-contiguous float32 arrays of one shape; `out` is reused where given.

    Raises ValueError on no arrays, on unequal counts or shapes, and on another dtype or memory order.
    """
    _refuse_unlike(arrays, factors)
    total = np.empty(arrays[0].shape, np.float32) if out is None else out
    if total.shape != arrays[0].shape or total.dtype != np.float32 or not total.flags.c_contiguous:
        raise ValueError(f"out is {total.dtype} {total.shape}; expected C-contiguous float32 {arrays[0].shape}")
    flat = total.reshape(-1)
    for first in range(0, len(arrays), 4):
        four = [array.reshape(-1) for array in arrays[first : first + 4]]
        a, b, c, d = four + four[:1] * (4 - len(four))  # an array read again costs no traffic
        wa, wb, wc, wd = [float(factor) for factor in factors[first : first + 4]] + [0.0] * (4 - len(four))
        kernel = blend_four if first == 0 else blend_four_onto
        kernel(a, b, c, d, wa, wb, wc, wd, flat)
    return total


def _refuse_unlike(arrays: Sequence[Floats], factors: Sequence[float]) -> None:
    if not arrays or len(arrays) != len(factors):
        raise ValueError(
            f"{len(arrays)} arrays and {len(factors)} factors; expected one factor per array, at least one"
        )
    for array in arrays:
        if array.dtype != np.float32 or array.shape != arrays[0].shape or not array.flags.c_contiguous:
            raise ValueError(
                f"an array of {array.dtype} {array.shape} among those to blend; "
                f"expected C-contiguous float32 {arrays[0].shape} like the first"
            )


@njit(void(*[_READ] * 4, *[float32] * 4, _WRITE), cache=True, fastmath={"contract"})
def blend_four(
    a: Floats, b: Floats, c: Floats, d: Floats, wa: float, wb: float, wc: float, wd: float, out: Floats
) -> None:  # fmt: skip
    """Writes four arrays (m,), each times its weight, into out (m,)."""
    for i in range(out.size):
        out[i] = wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i]


@njit(void(*[_READ] * 4, *[float32] * 4, _WRITE), cache=True, fastmath={"contract"})
def blend_four_onto(
    a: Floats, b: Floats, c: Floats, d: Floats, wa: float, wb: float, wc: float, wd: float, out: Floats
) -> None:  # fmt: skip
    """Adds four arrays (m,), each times its weight, to out (m,)."""
    for i in range(out.size):
        out[i] += wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i]


@njit(void(_ROWS, _NAMES, _READ, _WRITE), cache=True, fastmath={"contract"})
def sum_rows(table: Floats, rows: NDArray[np.int64], factors: Floats, out: Floats) -> None:
    """Writes the sum of factors (k,) times rows (k,) of table (n, m) into out (m,)."""
    whole = len(rows) - len(rows) % 4
    for start in range(0, out.size, _BLOCK):
        end = min(start + _BLOCK, out.size)
        total = out[start:end]
        total[:] = 0.0
        for r in range(0, whole, 4):
            a, b = table[rows[r], start:end], table[rows[r + 1], start:end]
            c, d = table[rows[r + 2], start:end], table[rows[r + 3], start:end]
            blend_four_onto(a, b, c, d, factors[r], factors[r + 1], factors[r + 2], factors[r + 3], total)
        for r in range(whole, len(rows)):
            one = table[rows[r], start:end]
            blend_four_onto(one, one, one, one, factors[r], 0.0, 0.0, 0.0, total)


@njit(void(_ROWS, _CORNERS, _ROWS, _POINTS), cache=True, fastmath={"contract"})
def gather_rows(points: Floats, indices: NDArray[np.int32], weights: Floats, out: Floats) -> None:
    """Writes into row v of out (V, 3) the weights[v] (V, 3) of the three rows indices[v] (V, 3) of points (n, 3)."""
    for v in range(len(indices)):
        i, j, k = indices[v, 0], indices[v, 1], indices[v, 2]
        a, b, c = weights[v, 0], weights[v, 1], weights[v, 2]
        out[v, 0] = a * points[i, 0] + b * points[j, 0] + c * points[k, 0]
        out[v, 1] = a * points[i, 1] + b * points[j, 1] + c * points[k, 1]
        out[v, 2] = a * points[i, 2] + b * points[j, 2] + c * points[k, 2]
