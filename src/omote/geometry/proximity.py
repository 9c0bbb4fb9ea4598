"""Points against a mesh in space: the nearest triangle, the first along a ray, in or out; by brute force."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

Values = NDArray[np.float64]
Indices = NDArray[np.int64]
Corners = NDArray[np.int32]

# Barycentric slack of a ray that passes an edge: it belongs to both triangles.
SLACK = 1e-6


@njit(cache=True)
def nearest_triangles(corners: Values, points: Values, within: float = np.inf) -> tuple[Values, Indices]:
    """The distance (n,) of points (n, 3) to a mesh with triangles (t, 3, 3), and which of them is nearest (n,).

    Points farther away than within metres are at that distance of triangle -1: a short reach looks at few triangles.
    """
    best, at = np.full(len(points), within), np.full(len(points), -1, np.int64)
    u, v = np.empty(3), np.empty(3)
    for t in range(len(corners)):
        for c in range(3):
            u[c], v[c] = corners[t, 1, c] - corners[t, 0, c], corners[t, 2, c] - corners[t, 0, c]
        reach = np.sqrt(max(u[0] * u[0] + u[1] * u[1] + u[2] * u[2], v[0] * v[0] + v[1] * v[1] + v[2] * v[2]))
        for n in range(len(points)):
            x, y, z = points[n, 0] - corners[t, 0, 0], points[n, 1] - corners[t, 0, 1], points[n, 2] - corners[t, 0, 2]
            if x * x + y * y + z * z > (best[n] + reach) ** 2:
                continue
            away = _distance(x, y, z, u, v)
            if away < best[n]:
                best[n], at[n] = away, t
    return best, at


@njit(cache=True)
def _distance(x: float, y: float, z: float, u: Values, v: Values) -> float:
    """How far (x, y, z) is from the triangle of the origin, u and v (Ericson 2005, section 5.1.5)."""
    uu, uv, vv = (u * u).sum(), (u * v).sum(), (v * v).sum()
    area = uu * vv - uv * uv
    along, across = u[0] * x + u[1] * y + u[2] * z, v[0] * x + v[1] * y + v[2] * z
    if area > 0.0:
        b, c = (vv * along - uv * across) / area, (uu * across - uv * along) / area
        if b >= 0.0 and c >= 0.0 and b + c <= 1.0:
            return _length(x - b * u[0] - c * v[0], y - b * u[1] - c * v[1], z - b * u[2] - c * v[2])
    result = min(_to_edge(x, y, z, u), _to_edge(x, y, z, v))
    return min(result, _to_edge(x - u[0], y - u[1], z - u[2], v - u))


@njit(cache=True)
def _to_edge(x: float, y: float, z: float, edge: Values) -> float:
    share = (edge[0] * x + edge[1] * y + edge[2] * z) / max((edge * edge).sum(), 1e-30)
    share = min(max(share, 0.0), 1.0)
    return _length(x - share * edge[0], y - share * edge[1], z - share * edge[2])


@njit(cache=True)
def _length(x: float, y: float, z: float) -> float:
    return np.sqrt(x * x + y * y + z * z)  # type: ignore[no-any-return]


@njit(cache=True)
def cast_rays(corners: Values, origins: Values, ways: Values, behind: float) -> tuple[Values, Indices, Values]:
    """Where rays from origins (n, 3) along unit ways (n, 3) first meet triangles (t, 3, 3), from so far behind on.

    Moeller and Trumbore (1997): distances (n,), infinity where none is met; triangles (n,), weights (n, 3).
    """
    best, at, weights = np.full(len(origins), np.inf), np.zeros(len(origins), np.int64), np.zeros((len(origins), 3))
    for t in range(len(corners)):
        a, u, v = corners[t, 0], corners[t, 1] - corners[t, 0], corners[t, 2] - corners[t, 0]
        for n in range(len(origins)):
            across = np.cross(ways[n], v)
            volume = (u * across).sum()
            if abs(volume) < 1e-18:
                continue
            off = origins[n] - a
            b = (off * across).sum() / volume
            if b < -SLACK or b > 1.0 + SLACK:
                continue
            over = np.cross(off, u)
            c = (ways[n] * over).sum() / volume
            far = (v * over).sum() / volume
            if c >= -SLACK and b + c <= 1.0 + SLACK and -behind < far < best[n]:
                best[n], at[n] = far, t
                weights[n, 0], weights[n, 1], weights[n, 2] = 1.0 - b - c, b, c
    return best, at, weights


@njit(cache=True)
def cast_level_rays(positions: Values, triangles: Corners, origins: Values, ways: Values) -> tuple[Values, Indices]:
    """Where level rays (their ways' y is 0) from origins (n, 3) along unit ways (n, 3) first meet triangles (t, 3) of
    positions (V, 3): distances (n,), infinity where none is met, and which triangle (n,).

    Moeller and Trumbore (1997), of the triangles that reach the ray's height.
    """
    best, at = np.full(len(origins), np.inf), np.zeros(len(origins), np.int64)
    for n in range(len(origins)):
        (wx, _, wz), height = ways[n], origins[n, 1]
        for t in range(len(triangles)):
            i, j, k = triangles[t]
            low, high = min(positions[i, 1], positions[j, 1]), max(positions[i, 1], positions[j, 1])
            if min(low, positions[k, 1]) > height or max(high, positions[k, 1]) < height:
                continue
            ax, ay, az = positions[i]
            ux, uy, uz = positions[j, 0] - ax, positions[j, 1] - ay, positions[j, 2] - az
            vx, vy, vz = positions[k, 0] - ax, positions[k, 1] - ay, positions[k, 2] - az
            cx, cy, cz = -wz * vy, wz * vx - wx * vz, wx * vy
            volume = ux * cx + uy * cy + uz * cz
            x, y, z = origins[n, 0] - ax, height - ay, origins[n, 2] - az
            ox, oy, oz = y * uz - z * uy, z * ux - x * uz, x * uy - y * ux
            if abs(volume) < 1e-18:
                continue
            b, c = (x * cx + y * cy + z * cz) / volume, (wx * ox + wz * oz) / volume
            far = (vx * ox + vy * oy + vz * oz) / volume
            if b >= -SLACK and c >= -SLACK and b + c <= 1.0 + SLACK and 0.0 < far < best[n]:
                best[n], at[n] = far, t
    return best, at


@njit(cache=True)
def winding_numbers(corners: Values, points: Values) -> Values:
    """How often triangles (t, 3, 3) go around points (n, 3): 1 inside a closed mesh that faces outward, 0 outside it
    (van Oosterom and Strackee 1983); between them where the mesh has holes (Jacobson et al. 2013)."""
    result = np.zeros(len(points))
    for n in range(len(points)):
        total, x, y, z = 0.0, points[n, 0], points[n, 1], points[n, 2]
        for t in range(len(corners)):
            ax, ay, az = corners[t, 0, 0] - x, corners[t, 0, 1] - y, corners[t, 0, 2] - z
            bx, by, bz = corners[t, 1, 0] - x, corners[t, 1, 1] - y, corners[t, 1, 2] - z
            cx, cy, cz = corners[t, 2, 0] - x, corners[t, 2, 1] - y, corners[t, 2, 2] - z
            a, b, c = _length(ax, ay, az), _length(bx, by, bz), _length(cx, cy, cz)
            volume = ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)
            ab, bc, ca = ax * bx + ay * by + az * bz, bx * cx + by * cy + bz * cz, cx * ax + cy * ay + cz * az
            total += np.arctan2(volume, a * b * c + ab * c + bc * a + ca * b)
        result[n] = total / (2.0 * np.pi)
    return result
