"""Depth maps: how far the nearest surface is in each pixel of a picture (a z-buffer, Catmull 1974)."""

from __future__ import annotations

import numpy as np
from numba import njit

from omote.arrays import Floats, Indices, Mask, Values


@njit(cache=True)
def draw_depth(screen: Values, triangles: Indices, width: int, height: int) -> Floats:
    """The depth (height, width) of the nearest of triangles (t, 3) over points (n, 3): pixels right, pixels down, depth
    (positive); infinity where there is none. Pixels are sampled in their middles.

    screen: (n, 3): pixels right and down, depth.
    """
    depth = np.full((height, width), np.inf, np.float32)
    for t in range(len(triangles)):
        a, b, c = screen[triangles[t, 0]], screen[triangles[t, 1]], screen[triangles[t, 2]]
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        if area == 0.0 or min(a[2], b[2], c[2]) <= 0.0:
            continue
        left = max(int(min(a[0], b[0], c[0])), 0)
        right = min(int(max(a[0], b[0], c[0])), width - 1)
        top = max(int(min(a[1], b[1], c[1])), 0)
        low = min(int(max(a[1], b[1], c[1])), height - 1)
        for y in range(top, low + 1):
            for x in range(left, right + 1):
                px, py = x + 0.5 - a[0], y + 0.5 - a[1]
                second = (px * (c[1] - a[1]) - (c[0] - a[0]) * py) / area
                third = ((b[0] - a[0]) * py - px * (b[1] - a[1])) / area
                if second < 0.0 or third < 0.0 or second + third > 1.0:
                    continue
                # The inverse of depth is linear in the picture.
                away = 1.0 / ((1.0 - second - third) / a[2] + second / b[2] + third / c[2])
                if away < depth[y, x]:
                    depth[y, x] = away
    return depth


def visible(depth: Floats, screen: Values, slack: float, /) -> Mask:
    """Whether points (n, 3), as `draw_depth` takes them, lie in the picture and no surface is nearer by more than
    slack.

    depth: of `draw_depth`; screen: the points (n, 3).
    """
    height, width = depth.shape
    column = np.floor(screen[:, 0]).astype(np.int64)
    row = np.floor(screen[:, 1]).astype(np.int64)
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height) & (screen[:, 2] > 0.0)
    nearest = depth[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)]
    return inside & (screen[:, 2] <= nearest + slack)
