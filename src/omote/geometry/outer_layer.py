"""Finds the outer layer of a periodic strip: the triangles that are visible from outside along the radius."""

from __future__ import annotations

import numpy as np
from numba import njit

from omote.arrays import Mask, Rows, Values


def keep_outer_layer(theta: Values, h: Values, radius: Values, width: float, cell: float, keep: Mask) -> None:
    """Clears keep where a triangle of a periodic strip is covered by one of larger radius.

    theta, h (F, 3) unwrapped corners scaled to metres, period width; radius (F,) of each triangle; cell: the size of a
    cell of the grid in which neighbours are looked up; keep (F,).
    """
    columns = max(1, int(width / cell))
    spans = np.stack(
        [
            np.floor(theta.min(axis=1) / width * columns),
            np.floor(theta.max(axis=1) / width * columns),
            (h.min(axis=1) - h.min()) / cell,
            (h.max(axis=1) - h.min()) / cell,
        ],
        axis=1,
    ).astype(np.int64)
    first = np.full((columns, int(spans[:, 3].max()) + 1), -1, np.int64)
    links = np.empty((int(((spans[:, 1] - spans[:, 0] + 1) * (spans[:, 3] - spans[:, 2] + 1)).sum()), 2), np.int64)
    order = np.argsort(-radius, kind="stable")
    _keep_from_outside(theta, h, order, spans, width, theta.mean(axis=1), first, links, keep)


@njit(cache=True)
def _keep_from_outside(
    theta: Values, h: Values, order: Rows, spans: Rows, width: float, middles: Values, first: Rows, links: Rows,
    keep: Mask,
) -> None:  # fmt: skip
    """spans (F, 4): first and last column and row of a triangle's cells; middles (F,) of its theta; first: the newest
    link of each cell; links: a triangle and the link before. Sorting and means of whole arrays are NumPy's: numba takes
    longer to compile them than all else here."""
    columns = len(first)
    used = 0
    for t in order:
        c0, c1, r0, r1 = spans[t, 0], spans[t, 1], spans[t, 2], spans[t, 3]
        covered = False
        for c in range(c0, c1 + 1):
            for r in range(r0, r1 + 1):
                covered = covered or _is_covered(theta, h, middles, t, first[c % columns, r], links, width)
        keep[t] = not covered
        for c in range(c0, c1 + 1 if keep[t] else c0):
            for r in range(r0, r1 + 1):
                links[used, 0] = t
                links[used, 1] = first[c % columns, r]
                first[c % columns, r] = used
                used += 1


@njit(cache=True)
def _is_covered(theta: Values, h: Values, middles: Values, t: int, link: int, links: Rows, width: float) -> bool:
    while link >= 0:
        if _overlap(theta, h, middles, t, links[link, 0], width):
            return True
        link = links[link, 1]
    return False


@njit(cache=True)
def _overlap(theta: Values, h: Values, middles: Values, t: int, other: int, width: float) -> bool:
    shift = np.round((middles[t] - middles[other]) / width) * width
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
