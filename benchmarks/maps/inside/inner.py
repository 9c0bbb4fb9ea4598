"""How far the mouth bag, and the lining of the eye sockets, come out through the skin, on any face."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from omote.geometry.cylinder import Cylinder
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import find_behind, find_mouth_bag, measure_distance

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

# What is farther in front of the skin than this, metres, lies in front of another part of it (a fold, the nape).
BEYOND = 0.01
# Skin that the line of sight meets at less than this cosine says nothing of what lies behind it.
GRAZED = 0.2
# Nearer to the lips along the mesh, metres, it is their inner edge, which they may roll out.
EDGE = 0.001


class Mouth:
    """The bag of a space, and the sheet and membranes around it: what is seen through the open mouth is not out."""

    def __init__(self, space: ParameterSpace) -> None:
        bag = find_mouth_bag(space)
        if bag is None:
            raise ValueError("the space has no mouth bag; expected lips and parts bound to the jaw")
        self._cylinder = space.cylinder
        self._vertices = bag.vertices[bag.distance > EDGE]
        middle = space.points[space.location_triangles].mean(axis=1)
        low = space.points[bag.vertices, 1].min() - 0.02
        high = space.points[bag.vertices, 1].max() + 0.02
        near = (middle[:, 1] > low) & (middle[:, 1] < high) & (middle[:, 2] > space.cylinder.z)
        self._sheet = space.location_triangles[near]

    def out(self, positions: Values) -> Values:
        """How far each bag vertex has come out in front of the skin, (m,) metres along the skin's normal, seen from the
        cylinder's axis; positions (V, 3)."""
        return _in_front(*_lines(self._cylinder, positions, self._vertices, self._sheet))


class Sockets:
    """The lining of a space's eye sockets, and the sheet around it: only skin that is there can be pierced."""

    def __init__(self, space: ParameterSpace) -> None:
        lids = [space.welded[line.loop] for line in space.lines if line.kind == "lids"]
        corners = space.welded[space.triangles]
        vertices = np.unique(np.concatenate([find_behind(corners, ~space.on_sheet, loop) for loop in lids]))
        near = corners[np.isin(corners, vertices).any(axis=1)].astype(np.int32)
        self._cylinder = space.cylinder
        self._vertices = vertices[measure_distance(space, near, vertices) > EDGE].astype(np.int32)
        middle = space.points[space.sheet_triangles].mean(axis=1)
        low = space.points[vertices, 1].min() - 0.02
        high = space.points[vertices, 1].max() + 0.02
        self._sheet = space.sheet_triangles[(middle[:, 1] > low) & (middle[:, 1] < high) & (middle[:, 2] > 0.06)]

    def out(self, positions: Values) -> Values:
        """How far each vertex of the lining has come out in front of the skin, (m,) metres along its normal, seen from
        the cylinder's axis; positions (V, 3)."""
        return _in_front(*_lines(self._cylinder, positions, self._vertices, self._sheet))


def more(here: Values, there: Values) -> float:
    """How much more than on the source, metres: the worst of the vertices."""
    return float(np.maximum(here - there, 0.0).max(initial=0.0))


def _lines(cylinder: Cylinder, positions: Values, vertices: Indices, sheet: Indices) -> tuple[Values, Values]:
    """Bag (m, 3) and sheet (T, 3, 3) unrolled: metres around the axis at the bag's own mean radius, up, and out."""
    theta, h, radius = cylinder.unroll(positions)
    plane = np.stack([theta * radius[vertices].mean(), h, radius], axis=1)
    return plane[vertices], np.ascontiguousarray(plane[sheet])


def _in_front(points: Values, corners: Values) -> Values:
    surface, cosine = foremost(corners, points)
    ahead = points[:, 2] - surface
    out = (ahead > 0) & (ahead < BEYOND) & (cosine > GRAZED)
    result: Values = np.where(out, np.where(out, ahead, 0.0) * cosine, 0.0)
    return result


@njit(cache=True)
def foremost(corners: Values, points: Values) -> tuple[Values, Values]:
    """The largest z of the triangles (t, 3, 3) before or behind each point (n, 3), minus infinity where none is, and
    how squarely that one is met, as a cosine."""
    highest = np.full(len(points), -np.inf)
    cosine = np.zeros(len(points))
    for t in range(len(corners)):
        a, b, c = corners[t, 0], corners[t, 1], corners[t, 2]
        ux, uy, uz, vx, vy, vz = b[0] - a[0], b[1] - a[1], b[2] - a[2], c[0] - a[0], c[1] - a[1], c[2] - a[2]
        area = ux * vy - uy * vx
        if abs(area) < 1e-12:
            continue
        left = min(a[0], b[0], c[0])
        right = max(a[0], b[0], c[0])
        low = min(a[1], b[1], c[1])
        up = max(a[1], b[1], c[1])
        for n in range(len(points)):
            x, y = points[n, 0], points[n, 1]
            if x < left or x > right or y < low or y > up:
                continue
            u, v = ((x - a[0]) * vy - (y - a[1]) * vx) / area, (ux * (y - a[1]) - uy * (x - a[0])) / area
            height = a[2] + u * uz + v * vz
            if u >= 0 and v >= 0 and u + v <= 1 and height > highest[n]:
                highest[n] = height
                cosine[n] = abs(area) / np.sqrt((uy * vz - uz * vy) ** 2 + (uz * vx - ux * vz) ** 2 + area**2)
    return highest, cosine
