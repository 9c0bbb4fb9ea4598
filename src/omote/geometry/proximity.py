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
# A ray that passes a triangle by more than this, metres, does not meet it.
ASIDE = 1e-6
# Triangles as near as the nearest one, but for this share of the distance: its neighbours at an edge or a corner.
ALIKE = 1e-7
# What is behind the planes of the nearest triangles by less than this share of its distance may be before the surface.
DOUBT = 0.1
# Triangles are sorted into so many layers of height.
LAYERS = 64


def nearest_triangles(corners: Values, points: Values, within: float = np.inf) -> tuple[Values, Indices]:
    """The distance (n,) of points (n, 3) to a mesh with triangles (t, 3, 3), and which of them is nearest (n,).

    Points farther away than within metres are at that distance of triangle -1: a short reach looks at few triangles.
    """
    away, nearest, _ = _find_nearest(corners, points, within)
    return away, nearest


def measure_outside(corners: Values, points: Values, within: float) -> tuple[Values, Values]:
    """How far points (n, 3) lie before a patch of a surface, triangles (t, 3, 3) that face outward, (n,) metres, none
    where they are behind it or farther away than within; and the ways back to it, unit vectors (n, 3), or zero.

    Near a patch winding numbers are about a half behind it, less by one before it. They are found where the nearest
    triangles leave a doubt (Baerentzen & Aanaes 2005, normals of edges unweighted).
    """
    away, nearest, side = _find_nearest(corners, points, within)
    near = np.flatnonzero((nearest >= 0) & (side > -DOUBT * away) & (away > 0.0))
    out = near[winding_numbers(corners, points[near]) < 0.0]
    far, back = np.zeros(len(points)), np.zeros((len(points), 3))
    far[out] = away[out]
    back[out] = (_nearest_places(corners[nearest[out]], points[out]) - points[out]) / away[out, None]
    return far, back


@njit(cache=True)
def _find_nearest(corners: Values, points: Values, within: float) -> tuple[Values, Indices, Values]:
    """As `nearest_triangles`; and how far (n,) before the planes of triangles that are as near, in sum."""
    best, at, side = np.full(len(points), within), np.full(len(points), -1, np.int64), np.zeros(len(points))
    for t in range(len(corners)):
        ax, ay, az = corners[t, 0, 0], corners[t, 0, 1], corners[t, 0, 2]
        ux, uy, uz = corners[t, 1, 0] - ax, corners[t, 1, 1] - ay, corners[t, 1, 2] - az
        vx, vy, vz = corners[t, 2, 0] - ax, corners[t, 2, 1] - ay, corners[t, 2, 2] - az
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        size = max(_length(nx, ny, nz), 1e-30)
        reach = np.sqrt(max(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz))
        for n in range(len(points)):
            x, y, z = points[n, 0] - ax, points[n, 1] - ay, points[n, 2] - az
            if x * x + y * y + z * z > (best[n] * (1.0 + ALIKE) + reach) ** 2:
                continue
            b, c = _nearest_weights(x, y, z, ux, uy, uz, vx, vy, vz)
            away = _length(x - b * ux - c * vx, y - b * uy - c * vy, z - b * uz - c * vz)
            before = (x * nx + y * ny + z * nz) / size
            if away < best[n] * (1.0 - ALIKE):
                side[n] = before
            elif away <= best[n] * (1.0 + ALIKE):
                side[n] += before
            if away < best[n]:
                best[n], at[n] = away, t
    return best, at, side


@njit(cache=True)
def _nearest_places(corners: Values, points: Values) -> Values:
    """Where a triangle each, (n, 3, 3), is nearest to points (n, 3)."""
    places = np.empty(points.shape)
    for n in range(len(points)):
        a, u, v = corners[n, 0], corners[n, 1] - corners[n, 0], corners[n, 2] - corners[n, 0]
        off = points[n] - a
        b, c = _nearest_weights(off[0], off[1], off[2], u[0], u[1], u[2], v[0], v[1], v[2])
        places[n] = a + b * u + c * v
    return places


@njit(cache=True, inline="always")
def _nearest_weights(
    x: float, y: float, z: float, ux: float, uy: float, uz: float, vx: float, vy: float, vz: float
) -> tuple[float, float]:  # fmt: skip
    """The weights b, c of the place b u + c v of the triangle of the origin, u and v that is nearest to (x, y, z)
    (Ericson 2005, section 5.1.5)."""
    uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
    area = uu * vv - uv * uv
    along, across = ux * x + uy * y + uz * z, vx * x + vy * y + vz * z
    if area > 0.0:
        b, c = (vv * along - uv * across) / area, (uu * across - uv * along) / area
        if b >= 0.0 and c >= 0.0 and b + c <= 1.0:
            return b, c
    first = min(max(along / max(uu, 1e-30), 0.0), 1.0)
    second = min(max(across / max(vv, 1e-30), 0.0), 1.0)
    third = (across - along - uv + uu) / max(uu - 2.0 * uv + vv, 1e-30)
    third = min(max(third, 0.0), 1.0)
    # Squared distances, less that of the corner: |p - s e|^2 = |p|^2 - 2 s p.e + s^2 e.e
    to_first, to_second = first * (first * uu - 2.0 * along), second * (second * vv - 2.0 * across)
    b, c = 1.0 - third, third
    to_third = b * b * uu + 2.0 * b * c * uv + c * c * vv - 2.0 * (b * along + c * across)
    if to_first <= to_second and to_first <= to_third:
        return first, 0.0
    if to_second <= to_third:
        return 0.0, second
    return b, c


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

    Moeller and Trumbore (1997), of the triangles that reach the ray's height (found by layers of height).
    """
    best, at = np.full(len(origins), np.inf), np.zeros(len(origins), np.int64)
    if len(triangles) == 0:
        return best, at
    low, layer, starts, rows = _sort_by_height(positions, triangles)
    for n in range(len(origins)):
        above = (origins[n, 1] - low) / layer
        if not 0.0 <= above <= LAYERS:
            continue
        here = min(int(above), LAYERS - 1)
        for r in range(starts[here], starts[here + 1]):
            i, j, k = triangles[rows[r]]
            far = _cast_level_ray(positions[i], positions[j], positions[k], origins[n], ways[n])
            if far < best[n]:
                best[n], at[n] = far, rows[r]
    return best, at


@njit(cache=True)
def _cast_level_ray(one: Values, two: Values, three: Values, origin: Values, way: Values) -> float:
    """How far along a level ray from origin (3,) a triangle of three corners (3,) lies, infinity where it is missed."""
    wx, wz = way[0], way[2]
    x, y, z = origin[0] - one[0], origin[1] - one[1], origin[2] - one[2]
    ux, uy, uz = two[0] - one[0], two[1] - one[1], two[2] - one[2]
    vx, vy, vz = three[0] - one[0], three[1] - one[1], three[2] - one[2]
    aside = z * wx - x * wz  # how far beside the ray the corners lie
    left, right = aside + ux * wz - uz * wx, aside + vx * wz - vz * wx
    if min(aside, left, right) > ASIDE or max(aside, left, right) < -ASIDE:
        return np.inf
    cx, cy, cz = -wz * vy, wz * vx - wx * vz, wx * vy
    volume = ux * cx + uy * cy + uz * cz
    if abs(volume) < 1e-18:
        return np.inf
    ox, oy, oz = y * uz - z * uy, z * ux - x * uz, x * uy - y * ux
    b, c = (x * cx + y * cy + z * cz) / volume, (wx * ox + wz * oz) / volume
    far = (vx * ox + vy * oy + vz * oz) / volume
    met = b >= -SLACK and c >= -SLACK and b + c <= 1.0 + SLACK and far > 0.0
    return far if met else np.inf


@njit(cache=True)
def _sort_by_height(positions: Values, triangles: Corners) -> tuple[float, float, Indices, Indices]:
    """Sorts triangles into layers of height (y): the lowest height, a layer's height, where each layer begins in the
    rows (LAYERS + 1,), and the rows, a triangle's in each layer that it reaches."""
    reach = np.empty((len(triangles), 2))
    for t in range(len(triangles)):
        i, j, k = triangles[t]
        reach[t, 0] = min(positions[i, 1], positions[j, 1], positions[k, 1])
        reach[t, 1] = max(positions[i, 1], positions[j, 1], positions[k, 1])
    low = reach[:, 0].min()
    layer = max(reach[:, 1].max() - low, 1e-9) / LAYERS
    ends = np.minimum((reach - low) / layer, LAYERS - 1).astype(np.int64)
    starts = np.zeros(LAYERS + 1, np.int64)
    for t in range(len(triangles)):
        starts[ends[t, 0] + 1 : ends[t, 1] + 2] += 1
    starts = np.cumsum(starts)
    free, rows = starts[:-1].copy(), np.empty(starts[-1], np.int64)
    for t in range(len(triangles)):
        for b in range(ends[t, 0], ends[t, 1] + 1):
            rows[free[b]] = t
            free[b] += 1
    return low, layer, starts, rows


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
