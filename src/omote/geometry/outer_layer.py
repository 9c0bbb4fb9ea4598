"""Finds the outer layer of a periodic strip: the triangles that are visible from outside along the radius."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Values = NDArray[np.float64]


@njit(cache=True)
def keep_outer_layer(
    theta: Values, h: Values, radius: Values, width: float, cell: float, keep: NDArray[np.bool_]
) -> None:  # fmt: skip
    """Clears keep where a triangle of a periodic strip is covered by one of larger radius.

    theta, h (F, 3) unwrapped corners scaled to metres, period width; radius (F,) of each triangle; cell: the size of a
    cell of the grid in which neighbours are looked up.
    """
    columns, lowest = max(1, int(width / cell)), h.min()
    first = np.full((columns, int((h.max() - lowest) / cell) + 1), -1, np.int64)
    links, used = np.empty((len(theta) * 16, 2), np.int64), 0
    for t in np.argsort(-radius):
        c0, c1 = int(np.floor(theta[t].min() / width * columns)), int(np.floor(theta[t].max() / width * columns))
        r0, r1 = int((h[t].min() - lowest) / cell), int((h[t].max() - lowest) / cell)
        covered = False
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                covered = covered or _is_covered(theta, h, t, first[c % columns, r], links, width)
        keep[t] = not covered
        for c in range(c0, c1 + 1 if keep[t] else c0):
            for r in range(r0, r1 + 1):
                if used == len(links):
                    links = np.concatenate((links, np.empty_like(links)))
                links[used, 0], links[used, 1] = t, first[c % columns, r]
                first[c % columns, r] = used
                used += 1


@njit(cache=True)
def _is_covered(theta: Values, h: Values, t: int, link: int, links: NDArray[np.int64], width: float) -> bool:
    while link >= 0:
        if _overlap(theta, h, t, links[link, 0], width):
            return True
        link = links[link, 1]
    return False


@njit(cache=True)
def _overlap(theta: Values, h: Values, t: int, other: int, width: float) -> bool:
    shift = np.round((theta[t].mean() - theta[other].mean()) / width) * width
    return not (_is_separated(theta, h, t, other, shift) or _is_separated(theta, h, other, t, -shift))


@njit(cache=True)
def _is_separated(theta: Values, h: Values, t: int, other: int, shift: float) -> bool:
    """Whether an edge of t has all of the other triangle on its outer side (touching counts as apart)."""
    for k in range(3):
        x0, y0 = theta[t, k], h[t, k]
        x1, y1 = theta[t, (k + 1) % 3] - x0, h[t, (k + 1) % 3] - y0
        length = np.sqrt(x1 * x1 + y1 * y1)
        apart = True
        for c in range(3):
            x, y = theta[other, c] + shift - x0, h[other, c] - y0
            if x1 * y - y1 * x > 1e-9 * length:
                apart = False
        if apart:
            return True
    return False
