"""Rasterises vertex values into a mesh's texture (UV) space."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from omote.arrays import Mask, Values

MARGIN = 12
"""Texels painted beyond an island's edge, so that filters find no foreign colour there."""
# So much outside a triangle, as a barycentric weight, a texel still belongs to it.
_TOUCH = 1e-6


def paint(values: NDArray[np.floating], uv: NDArray[np.floating], triangles: NDArray[np.integer], size: int) -> Values:
    """Rasterises values (k,) of vertices at uv (k, 2) into a picture (size, size), linear within triangles (t, 3).

    uv as in glTF: (0, 0) is the upper left corner. Around the islands a margin, beyond it 0.
    """
    picture = np.zeros((size, size))
    known = np.zeros((size, size), np.bool_)
    _paint_triangles(np.asarray(values, np.float64), np.asarray(uv, np.float64) * size - 0.5, triangles, picture, known)
    for _ in range(MARGIN):
        picture, known = _grow(picture, known)
    return picture


@njit(cache=True)
def _grow(picture: Values, known: Mask) -> tuple[Values, Mask]:
    """The picture with each texel beside a known one filled by the mean of those."""
    grown = picture.copy()
    reached = known.copy()
    rows, columns = picture.shape
    for y in range(rows):
        for x in range(columns):
            if known[y, x]:
                continue
            total = 0.0
            count = 0
            for down, right in ((-1, 0), (1, 0), (0, -1), (0, 1)):
                row = y + down
                column = x + right
                if 0 <= row < rows and 0 <= column < columns and known[row, column]:
                    total += picture[row, column]
                    count += 1
            if count:
                grown[y, x] = total / count
                reached[y, x] = True
    return grown, reached


@njit(cache=True)
def _paint_triangles(
    values: Values, places: Values, triangles: NDArray[np.integer], picture: Values, known: Mask
) -> None:
    size = len(picture)
    for a, b, c in triangles:
        ax, ay = places[a]
        bx, by, cx, cy = places[b, 0] - ax, places[b, 1] - ay, places[c, 0] - ax, places[c, 1] - ay
        area = bx * cy - by * cx
        if area == 0.0:
            continue
        left = int(np.ceil(ax + min(0.0, bx, cx)))
        right = int(np.floor(ax + max(0.0, bx, cx)))
        top = int(np.ceil(ay + min(0.0, by, cy)))
        bottom = int(np.floor(ay + max(0.0, by, cy)))
        for y in range(max(0, top), min(size - 1, bottom) + 1):
            for x in range(max(0, left), min(size - 1, right) + 1):
                v, w = ((x - ax) * cy - (y - ay) * cx) / area, (bx * (y - ay) - by * (x - ax)) / area
                if v >= -_TOUCH and w >= -_TOUCH and v + w <= 1.0 + _TOUCH:
                    picture[y, x] = (1.0 - v - w) * values[a] + v * values[b] + w * values[c]
                    known[y, x] = True
