"""A small rasteriser, for texels and for ambient occlusion."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from tools.baking.heads.basemesh import Floats, Ints


@njit(cache=True)
def _fill(corners: Floats, owner: Ints, weights: Floats, depth: Floats) -> None:
    """Writes, at each pixel's centre, the triangle with the largest depth, its weights and that depth."""
    rows, columns = owner.shape
    for triangle in range(len(corners)):
        a, b, c = corners[triangle]
        area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        if area == 0.0:
            continue
        left = min(a[0], b[0], c[0])
        right = max(a[0], b[0], c[0])
        top = min(a[1], b[1], c[1])
        bottom = max(a[1], b[1], c[1])
        for row in range(max(0, int(top)), min(rows, int(bottom) + 1)):
            for column in range(max(0, int(left)), min(columns, int(right) + 1)):
                x, y = column + 0.5, row + 0.5
                u = ((b[0] - x) * (c[1] - y) - (c[0] - x) * (b[1] - y)) / area
                v = ((c[0] - x) * (a[1] - y) - (a[0] - x) * (c[1] - y)) / area
                w = 1.0 - u - v
                z = u * a[2] + v * b[2] + w * c[2]
                if u >= 0.0 and v >= 0.0 and w >= 0.0 and z > depth[row, column]:
                    owner[row, column] = triangle
                    weights[row, column, 0], weights[row, column, 1], weights[row, column, 2] = u, v, w
                    depth[row, column] = z


def rasterise(corners: Floats, size: int) -> tuple[Ints, Floats, Floats]:
    """What each pixel of a square picture shows.

    corners: (m, 3, 3) triangles: column, row (pixels), depth (larger is nearer);
    gives the triangle of each pixel (size, size), -1 where there is none, its barycentric weights (size, size, 3)
    and its depth (size, size)
    """
    owner = np.full((size, size), -1, dtype=np.int32)
    weights = np.zeros((size, size, 3))
    depth = np.full((size, size), -np.inf)
    _fill(np.ascontiguousarray(corners, dtype=np.float64), owner, weights, depth)
    return owner, weights, depth


def openness(points: Floats, triangles: Ints, *, directions: int = 96, size: int = 256) -> Floats:
    """How much of the sky each vertex (n,) sees over its own horizon, 0 to 1; the rest is ambient occlusion.

    points (n, 3): metres; triangles (t, 3); directions: how many are looked along; size: pixels of a picture from
    each.
    """
    normals = vertex_normals(points, triangles)
    start = points + normals * 0.0008
    centre = points.mean(axis=0)
    radius = np.ptp(points, axis=0).max()
    seen = np.zeros(len(points))
    possible = np.full(len(points), 1e-9)
    for direction in sphere(directions):
        turn = _facing(direction)
        scale = size / (2.0 * radius)
        flat = (points - centre) @ turn.T * scale + [size / 2, size / 2, 0.0]
        depth = rasterise(flat[triangles], size)[2]
        eye = (start - centre) @ turn.T * scale + [size / 2, size / 2, 0.0]
        front = depth[eye[:, 1].astype(int), eye[:, 0].astype(int)]
        weight = np.maximum(normals @ direction, 0.0)
        seen += weight * (eye[:, 2] + 1.5 > front)
        possible += weight
    return np.asarray(seen / possible)


def vertex_normals(points: Floats, triangles: Ints) -> Floats:
    """Unit normals (n, 3) of the vertices, weighted by the area of the triangles around.

    points (n, 3), triangles (t, 3).
    """
    corners = points[triangles]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], facing)
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12))


def sphere(count: int) -> NDArray[np.float64]:
    """Unit vectors (count, 3) spread evenly over the sphere along a golden spiral."""
    rank = np.arange(count) + 0.5
    height = 1.0 - 2.0 * rank / count
    angle = np.pi * (1.0 + 5.0**0.5) * rank
    ring = np.sqrt(1.0 - height**2)
    return np.stack([ring * np.cos(angle), height, ring * np.sin(angle)], axis=1)


def _facing(direction: Floats) -> Floats:
    """A rotation (3, 3) that turns `direction` onto +z."""
    helper = np.array([1.0, 0.0, 0.0]) if abs(direction[0]) < 0.9 else np.array([0.0, 1.0, 0.0])
    across = np.cross(helper, direction)
    across /= np.linalg.norm(across)
    return np.stack([across, np.cross(direction, across), direction])
