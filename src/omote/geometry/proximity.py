"""Points against a mesh in space: the nearest triangle, the first along a ray, in or out; by brute force."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray

from omote.arrays import Rows, Values

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


def nearest_triangles(corners: Values, points: Values, within: float = np.inf) -> tuple[Values, Rows]:
    """The distance (n,) of points (n, 3) to a mesh with triangles (t, 3, 3), and which of them is nearest (n,).

    corners: (t, 3, 3), metres.

    Points farther away than within metres are at that distance of triangle -1: a short reach looks at few triangles.
    """
    away, nearest, _ = _find_nearest(corners, points, within)
    return away, nearest


def measure_outside(corners: Values, points: Values, within: float) -> tuple[Values, Values]:
    """How far points (n, 3) lie before a patch of a surface, triangles (t, 3, 3) that face outward, (n,) metres, none
    where they are behind it or farther away than within; and the ways back to it, unit vectors (n, 3), or zero.

    corners: (t, 3, 3), metres.

    Near a patch winding numbers are about a half behind it, less by one before it. They are found where the nearest
    triangles leave a doubt (Baerentzen & Aanaes 2005, normals of edges unweighted).
    """
    away, nearest, side = _find_nearest(corners, points, within)
    near = np.flatnonzero((nearest >= 0) & (side > -DOUBT * away) & (away > 0.0))
    out = near[winding_numbers(corners, points[near]) < 0.0]
    far = np.zeros(len(points))
    back = np.zeros((len(points), 3))
    far[out] = away[out]
    met = corners[nearest[out]]
    weights = nearest_weights(met, points[out])
    places = met[:, 0] + weights[:, 1:2] * (met[:, 1] - met[:, 0]) + weights[:, 2:] * (met[:, 2] - met[:, 0])
    back[out] = (places - points[out]) / away[out, None]
    return far, back


@njit(cache=True)
def _find_nearest(corners: Values, points: Values, within: float) -> tuple[Values, Rows, Values]:
    """As `nearest_triangles`; and how far (n,) before the planes of triangles that are as near, in sum."""
    best = np.full(len(points), within)
    at = np.full(len(points), -1, np.int64)
    side = np.zeros(len(points))
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
            b, c = weigh_corners(x, y, z, ux, uy, uz, vx, vy, vz)
            away = _length(x - b * ux - c * vx, y - b * uy - c * vy, z - b * uz - c * vz)
            before = (x * nx + y * ny + z * nz) / size
            if away < best[n] * (1.0 - ALIKE):
                side[n] = before
            elif away <= best[n] * (1.0 + ALIKE):
                side[n] += before
            if away < best[n]:
                best[n] = away
                at[n] = t
    return best, at, side


@njit(cache=True)
def nearest_weights(corners: Values, points: Values) -> Values:
    """The weights (n, 3) of the corners of triangles (n, 3, 3), one for each of points (n, 3), where it is nearest."""
    weights = np.empty((len(points), 3))
    for n in range(len(points)):
        a, u, v = corners[n, 0], corners[n, 1] - corners[n, 0], corners[n, 2] - corners[n, 0]
        off = points[n] - a
        b, c = weigh_corners(off[0], off[1], off[2], u[0], u[1], u[2], v[0], v[1], v[2])
        weights[n, 0], weights[n, 1], weights[n, 2] = 1.0 - b - c, b, c
    return weights


@njit(cache=True, inline="always")
def weigh_corners(
    x: float, y: float, z: float, ux: float, uy: float, uz: float, vx: float, vy: float, vz: float
) -> tuple[float, float]:
    """The weights b, c of the place b u + c v of the triangle of the origin, u (ux, uy, uz) and v (vx, vy, vz) that is
    nearest to (x, y, z) (Ericson 2005, section 5.1.5)."""
    uu, uv, vv = ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz
    area = uu * vv - uv * uv
    along = ux * x + uy * y + uz * z
    across = vx * x + vy * y + vz * z
    if area > 0.0:
        b, c = (vv * along - uv * across) / area, (uu * across - uv * along) / area
        if b >= 0.0 and c >= 0.0 and b + c <= 1.0:
            return b, c
    first = min(max(along / max(uu, 1e-30), 0.0), 1.0)
    second = min(max(across / max(vv, 1e-30), 0.0), 1.0)
    third = (across - along - uv + uu) / max(uu - 2.0 * uv + vv, 1e-30)
    third = min(max(third, 0.0), 1.0)
    # Squared distances, less that of the corner: |p - s e|^2 = |p|^2 - 2 s p.e + s^2 e.e
    to_first = first * (first * uu - 2.0 * along)
    to_second = second * (second * vv - 2.0 * across)
    b, c = 1.0 - third, third
    to_third = b * b * uu + 2.0 * b * c * uv + c * c * vv - 2.0 * (b * along + c * across)
    if to_first <= to_second and to_first <= to_third:
        return first, 0.0
    if to_second <= to_third:
        return 0.0, second
    return b, c


@njit(cache=True)
def _length(x: float, y: float, z: float) -> float:
    return np.sqrt(x * x + y * y + z * z)


@njit(cache=True)
def cast_rays(corners: Values, origins: Values, ways: Values, behind: float) -> tuple[Values, Rows, Values]:
    """Where rays from origins (n, 3) along unit ways (n, 3) first meet triangles (t, 3, 3), from so far behind on.

    corners: (t, 3, 3), metres.

    Moeller and Trumbore (1997): distances (n,), infinity where none is met; triangles (n,), weights (n, 3).
    """
    best = np.full(len(origins), np.inf)
    at = np.zeros(len(origins), np.int64)
    weights = np.zeros((len(origins), 3))
    for t in range(len(corners)):  # numbers, not arrays, which numba takes far longer to compile
        ax, ay, az = corners[t, 0, 0], corners[t, 0, 1], corners[t, 0, 2]
        ux, uy, uz = corners[t, 1, 0] - ax, corners[t, 1, 1] - ay, corners[t, 1, 2] - az
        vx, vy, vz = corners[t, 2, 0] - ax, corners[t, 2, 1] - ay, corners[t, 2, 2] - az
        for n in range(len(origins)):
            wx, wy, wz = ways[n, 0], ways[n, 1], ways[n, 2]
            px, py, pz = wy * vz - wz * vy, wz * vx - wx * vz, wx * vy - wy * vx
            volume = ux * px + uy * py + uz * pz
            if abs(volume) < 1e-18:
                continue
            x, y, z = origins[n, 0] - ax, origins[n, 1] - ay, origins[n, 2] - az
            b = (x * px + y * py + z * pz) / volume
            if b < -SLACK or b > 1.0 + SLACK:
                continue
            qx, qy, qz = y * uz - z * uy, z * ux - x * uz, x * uy - y * ux
            c = (wx * qx + wy * qy + wz * qz) / volume
            far = (vx * qx + vy * qy + vz * qz) / volume
            if c >= -SLACK and b + c <= 1.0 + SLACK and -behind < far < best[n]:
                best[n] = far
                at[n] = t
                weights[n, 0], weights[n, 1], weights[n, 2] = 1.0 - b - c, b, c
    return best, at, weights


@njit(cache=True)
def cast_level_rays(positions: Values, triangles: Corners, origins: Values, ways: Values) -> tuple[Values, Rows]:
    """Where level rays (their ways' y is 0) from origins (n, 3) along unit ways (n, 3) first meet triangles (t, 3) of
    positions (V, 3): distances (n,), infinity where none is met, and which triangle (n,).

    Moeller and Trumbore (1997), of the triangles that reach the ray's height (found by layers of height).
    """
    best = np.full(len(origins), np.inf)
    at = np.zeros(len(origins), np.int64)
    if len(triangles) == 0:
        return best, at
    low, layer, starts, rows = _sort_by_height(positions, triangles)
    for n in range(len(origins)):
        above = (origins[n, 1] - low) / layer
        if not 0.0 <= above <= LAYERS:
            continue
        here = min(int(above), LAYERS - 1)
        for r in range(starts[here], starts[here + 1]):
            t = rows[r]
            i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
            far = _cast_level_ray(positions[i], positions[j], positions[k], origins[n], ways[n])
            if far < best[n]:
                best[n] = far
                at[n] = t
    return best, at


@njit(cache=True)
def _cast_level_ray(one: Values, two: Values, three: Values, origin: Values, way: Values) -> float:
    """How far along a level ray from origin (3,) a triangle of three corners (3,) lies, infinity where it is missed."""
    wx, wz = way[0], way[2]
    x, y, z = origin[0] - one[0], origin[1] - one[1], origin[2] - one[2]
    ux, uy, uz = two[0] - one[0], two[1] - one[1], two[2] - one[2]
    vx, vy, vz = three[0] - one[0], three[1] - one[1], three[2] - one[2]
    aside = z * wx - x * wz  # how far beside the ray the corners lie
    left = aside + ux * wz - uz * wx
    right = aside + vx * wz - vz * wx
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
def _sort_by_height(positions: Values, triangles: Corners) -> tuple[float, float, Rows, Rows]:
    """Sorts triangles into layers of height (y): the lowest height, a layer's height, where each layer begins in the
    rows (LAYERS + 1,), and the rows, a triangle's in each layer that it reaches."""
    # No function of whole arrays: numba takes seconds to compile some, and a show's first face would wait for it.
    reach = np.empty((len(triangles), 2))
    low = np.inf
    high = -np.inf
    for t in range(len(triangles)):
        i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        reach[t, 0] = min(positions[i, 1], positions[j, 1], positions[k, 1])
        reach[t, 1] = max(positions[i, 1], positions[j, 1], positions[k, 1])
        low = min(low, reach[t, 0])
        high = max(high, reach[t, 1])
    layer = max(high - low, 1e-9) / LAYERS
    ends = np.empty((len(triangles), 2), np.int64)
    starts = np.zeros(LAYERS + 1, np.int64)
    for t in range(len(triangles)):
        for end in range(2):
            ends[t, end] = int(min((reach[t, end] - low) / layer, LAYERS - 1))
        for b in range(ends[t, 0], ends[t, 1] + 1):
            starts[b + 1] += 1
    for b in range(LAYERS):
        starts[b + 1] += starts[b]
    free = np.zeros(LAYERS, np.int64)
    rows = np.empty(starts[LAYERS], np.int64)
    for t in range(len(triangles)):
        for b in range(ends[t, 0], ends[t, 1] + 1):
            rows[starts[b] + free[b]] = t
            free[b] += 1
    return low, layer, starts, rows


@njit(cache=True)
def winding_numbers(corners: Values, points: Values) -> Values:
    """How often triangles (t, 3, 3) go around points (n, 3): 1 inside a closed mesh that faces outward, 0 outside it
    (van Oosterom and Strackee 1983); between them where the mesh has holes (Jacobson et al. 2013).

    corners: (t, 3, 3), metres.
    """
    result = np.zeros(len(points))
    for n in range(len(points)):
        total = 0.0
        x = points[n, 0]
        y = points[n, 1]
        z = points[n, 2]
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
