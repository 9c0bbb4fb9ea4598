"""Rasterises vertex values into a mesh's texture (UV) space."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Values = NDArray[np.float64]

MARGIN = 12
"""Texels painted beyond an island's edge, so that filters find no foreign colour there."""
_TOUCH = 1e-6


def paint(values: NDArray[np.floating], uv: NDArray[np.floating], triangles: NDArray[np.integer], size: int) -> Values:
    """Rasterises values (k,) of vertices at uv (k, 2) into a picture (size, size), linear within triangles (t, 3).

    uv as in glTF: (0, 0) is the upper left corner. Around the islands a margin, beyond it 0.
    """
    picture, known = np.zeros((size, size)), np.zeros((size, size), np.bool_)
    _paint_triangles(np.asarray(values, np.float64), np.asarray(uv, np.float64) * size - 0.5, triangles, picture, known)
    for _ in range(MARGIN):
        picture, known = _grow(picture, known)
    return picture


def _grow(picture: Values, known: NDArray[np.bool_]) -> tuple[Values, NDArray[np.bool_]]:
    """The picture with each texel beside a known one filled by the mean of those."""
    total, count = np.zeros_like(picture), np.zeros(picture.shape)
    for rows, columns in (((1, 0), (0, 0)), ((0, 1), (0, 0)), ((0, 0), (1, 0)), ((0, 0), (0, 1))):
        shift = tuple(slice(first, -last or None) for first, last in (rows, columns))
        back = tuple(slice(last, -first or None) for first, last in (rows, columns))
        total[shift] += np.where(known, picture, 0.0)[back]
        count[shift] += known[back]
    return np.where(known, picture, total / np.maximum(count, 1.0)), known | (count > 0)


@njit(cache=True)
def _paint_triangles(
    values: Values, places: Values, triangles: NDArray[np.integer], picture: Values, known: NDArray[np.bool_]
) -> None:
    size = len(picture)
    for a, b, c in triangles:
        ax, ay = places[a]
        bx, by, cx, cy = places[b, 0] - ax, places[b, 1] - ay, places[c, 0] - ax, places[c, 1] - ay
        area = bx * cy - by * cx
        if area == 0.0:
            continue
        left, right = int(np.ceil(ax + min(0.0, bx, cx))), int(np.floor(ax + max(0.0, bx, cx)))
        top, bottom = int(np.ceil(ay + min(0.0, by, cy))), int(np.floor(ay + max(0.0, by, cy)))
        for y in range(max(0, top), min(size - 1, bottom) + 1):
            for x in range(max(0, left), min(size - 1, right) + 1):
                v, w = ((x - ax) * cy - (y - ay) * cx) / area, (bx * (y - ay) - by * (x - ax)) / area
                if v >= -_TOUCH and w >= -_TOUCH and v + w <= 1.0 + _TOUCH:
                    picture[y, x] = (1.0 - v - w) * values[a] + v * values[b] + w * values[c]
                    known[y, x] = True
