"""Weighted sums of a few large arrays (Numba): eq. 3 of Arai (1993) for all positions at once, of any many terms."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numba import float32, njit, types, void
from numpy.typing import NDArray

from omote.arrays import Floats

_READ = types.Array(float32, 1, "C", readonly=True)
_WRITE = types.Array(float32, 1, "C")
_ROWS = types.Array(float32, 2, "C", readonly=True)
_NAMES = types.Array(types.int64, 1, "C", readonly=True)
_BLOCK = 2048  # floats of the sum that stay in the first-level cache while all rows pass by


def weighted_sum(terms: Sequence[tuple[float, Floats]]) -> Floats:
    """The sum of factor times array: eq. 3, where the factors are s_i t_j and the arrays the compounds P_ij.

    terms: at least one; arrays are C-contiguous float32, all of one shape. ValueError on anything else.
    """
    if not terms:
        raise ValueError("there is nothing to blend; give at least one factor and its array")
    shape = terms[0][1].shape
    for _, array in terms:
        if array.dtype != np.float32 or array.shape != shape or not array.flags.c_contiguous:
            raise ValueError(
                f"an array of {array.dtype} {array.shape} among those to blend; "
                f"expected C-contiguous float32 {shape} like the first"
            )
    total = np.empty(shape, np.float32)
    flat = total.reshape(-1)
    for first in range(0, len(terms), 4):
        four = [*terms[first : first + 4]]
        four += [(0.0, four[0][1])] * (4 - len(four))  # an array read again costs no traffic
        kernel = blend_four if first == 0 else blend_four_onto
        a, b, c, d = (array.reshape(-1) for _, array in four)
        wa, wb, wc, wd = (float(factor) for factor, _ in four)
        kernel(a, b, c, d, wa, wb, wc, wd, flat)
    return total


@njit(void(*[_READ] * 4, *[float32] * 4, _WRITE), cache=True, fastmath={"contract"})
def blend_four(
    a: Floats, b: Floats, c: Floats, d: Floats, wa: float, wb: float, wc: float, wd: float, out: Floats
) -> None:
    """Writes four arrays a, b, c, d (m,), each times its weight wa, wb, wc, wd, into out (m,)."""
    for i in range(out.size):
        out[i] = wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i]


@njit(void(*[_READ] * 4, *[float32] * 4, _WRITE), cache=True, fastmath={"contract"})
def blend_four_onto(
    a: Floats, b: Floats, c: Floats, d: Floats, wa: float, wb: float, wc: float, wd: float, out: Floats
) -> None:
    """Adds four arrays a, b, c, d (m,), each times its weight wa, wb, wc, wd, to out (m,)."""
    for i in range(out.size):
        out[i] += wa * a[i] + wb * b[i] + wc * c[i] + wd * d[i]


@njit(void(_ROWS, _NAMES, _READ, _WRITE), cache=True, fastmath={"contract"})
def sum_rows(table: Floats, rows: NDArray[np.int64], factors: Floats, out: Floats) -> None:
    """Writes the sum of factors (k,) times rows (k,), numbers of rows of table (n, m), into out (m,)."""
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
            last = table[rows[r], start:end]
            blend_four_onto(last, last, last, last, factors[r], 0.0, 0.0, 0.0, total)
