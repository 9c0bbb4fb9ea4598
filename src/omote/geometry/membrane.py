"""Closes a hole with triangles between its own vertices, by ear clipping in the plane."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Indices, Values

Plane = NDArray[np.float64]


def close_loop(polygon: Plane, /) -> Indices:
    """Triangles that fill a polygon, as indices into it; shortest diagonals first, so lids and lips get ladders.

    polygon (n, 2), counter-clockwise. Returns (m, 3) with m <= n - 2, all counter-clockwise: what is left when no ear
    remains (a polygon that crosses itself) stays open.
    """
    left = list(range(len(polygon)))
    result: list[tuple[int, int, int]] = []
    while len(left) > 2:
        ear = _shortest_ear(polygon, left)
        if ear is None:
            break
        before = left[ear - 1]
        tip = left[ear]
        after = left[(ear + 1) % len(left)]
        result.append((before, tip, after))
        del left[ear]
    return np.array(result, dtype=np.int32).reshape(-1, 3)


def _shortest_ear(polygon: Plane, left: list[int]) -> int | None:
    points = polygon[left]
    before = np.roll(points, 1, axis=0)
    after = np.roll(points, -1, axis=0)
    convex = _cross(points - before, after - points) > 0
    lengths = np.linalg.norm(after - before, axis=1)
    for ear in np.argsort(lengths, kind="stable"):
        if convex[ear] and not _any_inside(points, int(ear)):
            return int(ear)
    return None


def _any_inside(points: Plane, ear: int) -> bool:
    count = len(points)
    corners = [(ear - 1) % count, ear, (ear + 1) % count]
    rest = np.delete(points, corners, axis=0)
    a, b, c = points[corners]
    inside = (_cross(b - a, rest - a) >= 0) & (_cross(c - b, rest - b) >= 0) & (_cross(a - c, rest - c) >= 0)
    return bool(inside.any())


def _cross(a: Plane, b: Plane) -> Values:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
