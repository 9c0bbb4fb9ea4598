"""Depth maps: what a surface looks like from before a point that juts out, rings by turns; and how alike two are.

The axis goes from the middle of the surface around the point to the point, so no normals are needed (compare spin
images, Johnson and Hebert 1999); a map may be turned about it, and leans of the axis are taken out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import njit

from omote.arrays import Mask, Rows, Values

RINGS = 8
TURNS = 24
REACH = 0.062
"""Metres from the axis to a map's rim."""
CELL = 0.0045
"""Metres: maps are made of points about so far apart."""
NOTHING = -1.0
"""The depth of what shows nothing."""
# Radii about a point, metres, in which the middle of the surface is taken.
_WIDE = 0.05
_NEAR = 0.02
# Depths behind and before the point that belong to its map, metres.
_BEHIND = -0.055
_BEFORE = 0.03
# A surface juts out where the middle of what is near lies so far behind, metres: noses' are 6 and 14 mm and more.
_LEAST_NEAR = 0.0045
_LEAST_WIDE = 0.011
# The slopes between the turns of a quarter.
_SLOPES = tuple(np.tan(2.0 * np.pi / TURNS * np.arange(1, TURNS // 4)).tolist())
# Sums may be taken in any order, not a number is not to be left out.
_FAST = {"reassoc", "contract", "arcp", "nsz"}
# Farther than this from each other, metres, depths are simply different.
_DIFFERENT = 0.02
# What a map that shows nothing where it should adds, for all of it, metres.
_MISSING = 0.006
# The square of the most that an axis may lean.
_LEAN = 0.35


@dataclass(frozen=True, eq=False)
class DepthMaps:
    """Maps (n, RINGS * TURNS) of points (n, 3), metres, and their frames (n, 3, 3): two rows across, the axis last."""

    points: Values
    depths: Values
    frames: Values


@dataclass(frozen=True, eq=False)
class Likeness:
    """How far each map is from the wanted one, (n,) metres; by how many TURNS it is turned, (n,); its lean (n, 2)."""

    distance: Values
    turn: Rows
    lean: Values


def make_maps(points: Values, places: Values, /) -> DepthMaps:
    """The maps of those places (k, 3) on a surface with points (n, 3) that jut out, metres."""
    near = places[_middles(points, places, _NEAR)[1] > _LEAST_NEAR]
    middles, away = _middles(points, near, _WIDE)
    juts = away > _LEAST_WIDE
    near = near[juts]
    axes = -middles[juts] / away[juts, None]
    frames = _frames(axes)
    depths = np.full((len(near), RINGS * TURNS), NOTHING)
    if len(near):
        _draw_maps(*_lattice(points, REACH), near, frames, depths)
    shown = (depths[:, TURNS:] > NOTHING).mean(axis=1) > 0.5
    return DepthMaps(near[shown], depths[shown], frames[shown])


def compare_maps(depths: Values, wanted: Values, /, *, barred: Rows | None = None) -> Likeness:
    """How alike maps (n, RINGS * TURNS) are to a wanted one (RINGS * TURNS,), turned as they fit best.

    barred (n,): turns that are not asked, with those less than a quarter from them.

    depths, wanted: metres.
    """
    likeness = Likeness(np.full(len(depths), np.inf), np.zeros(len(depths), np.int64), np.zeros((len(depths), 2)))
    ring, turn = np.divmod(np.arange(RINGS * TURNS), TURNS)
    radius = (ring + 0.5) * REACH / RINGS
    angle = (turn + 0.5) * 2.0 * np.pi / TURNS - np.pi
    across = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    every = np.stack([np.roll(wanted.reshape(RINGS, TURNS), step, axis=1).ravel() for step in range(TURNS)])
    allowed = np.ones((len(depths), TURNS), np.bool_)
    if barred is not None:
        away = (np.arange(TURNS) - barred[:, None]) % TURNS
        allowed = np.minimum(away, TURNS - away) >= TURNS // 4
    _match(depths, every, across, np.sqrt(ring + 0.5), allowed, likeness.distance, likeness.turn, likeness.lean)
    return likeness


def _frames(axes: Values) -> Values:
    rows = np.arange(len(axes))
    least = np.zeros_like(axes)
    least[rows, np.abs(axes).argmin(axis=1)] = 1.0
    first = np.cross(least, axes)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    return np.stack([first, np.cross(axes, first), axes], axis=1)


def _middles(points: Values, places: Values, reach: float) -> tuple[Values, Values]:
    """From each place (k, 3) to the middle of the points within reach, (k, 3), and how far that is (k,)."""
    middles = np.zeros((len(places), 3))
    if len(places):
        _add_middles(*_lattice(points, reach), places, middles)
    return middles, np.maximum(np.linalg.norm(middles, axis=1), 1e-12)


def _lattice(points: Values, cell: float) -> tuple[Values, Rows, Rows, Values, float]:
    """The points by cubes of a lattice, where each cube's begin, how many cubes there are, its low corner."""
    low = points.min(axis=0) - 1e-9
    at = ((points - low) / cell).astype(np.int64)
    sizes = at.max(axis=0) + 1
    key = (at[:, 0] * sizes[1] + at[:, 1]) * sizes[2] + at[:, 2]
    starts = np.zeros(int(np.prod(sizes)) + 1, np.int64)
    np.cumsum(np.bincount(key, minlength=len(starts) - 1), out=starts[1:])
    return points[np.argsort(key, kind="stable")], starts, sizes, low, cell


@njit(cache=True)
def _cubes(place: Values, sizes: Rows, low: Values, cell: float) -> Rows:
    """The cubes around a place that there are."""
    cubes = np.empty(27, np.int64)
    count = 0
    at = ((place - low) / cell).astype(np.int64)
    for step in range(27):
        x, y, z = at[0] + step // 9 - 1, at[1] + step // 3 % 3 - 1, at[2] + step % 3 - 1
        if 0 <= x < sizes[0] and 0 <= y < sizes[1] and 0 <= z < sizes[2]:
            cubes[count] = (x * sizes[1] + y) * sizes[2] + z
            count += 1
    return cubes[:count]


@njit(cache=True, fastmath=_FAST)
def _add_middles(
    points: Values, starts: Rows, sizes: Rows, low: Values, cell: float, places: Values, middles: Values
) -> None:
    for k in range(len(places)):
        sx = 0.0
        sy = 0.0
        sz = 0.0
        count = 0
        for cube in _cubes(places[k], sizes, low, cell):
            for row in range(starts[cube], starts[cube + 1]):
                x, y, z = points[row, 0] - places[k, 0], points[row, 1] - places[k, 1], points[row, 2] - places[k, 2]
                if x * x + y * y + z * z < cell * cell:
                    sx = sx + x
                    sy = sy + y
                    sz = sz + z
                    count = count + 1
        # Fewer than eight points are no surface.
        if count >= 8:
            middles[k, 0], middles[k, 1], middles[k, 2] = sx / count, sy / count, sz / count


@njit(cache=True, fastmath=_FAST)
def _draw_maps(
    points: Values, starts: Rows, sizes: Rows, low: Values, cell: float, places: Values, frames: Values, depths: Values
) -> None:
    for k in range(len(places)):
        p, f = places[k], frames[k]
        for cube in _cubes(p, sizes, low, cell):
            for row in range(starts[cube], starts[cube + 1]):
                x, y, z = points[row, 0] - p[0], points[row, 1] - p[1], points[row, 2] - p[2]
                depth = x * f[2, 0] + y * f[2, 1] + z * f[2, 2]
                if depth < _BEHIND or depth > _BEFORE:
                    continue
                u = x * f[0, 0] + y * f[0, 1] + z * f[0, 2]
                v = x * f[1, 0] + y * f[1, 1] + z * f[1, 2]
                square = u * u + v * v
                if square < REACH * REACH:
                    at = int(np.sqrt(square) * (RINGS / REACH)) * TURNS + find_turn(u, v)
                    # The outermost counts: linings and eyeballs lie behind.
                    depths[k, at] = max(depths[k, at], depth)


@njit(cache=True)
def find_turn(u: float, v: float) -> int:
    """In which of the TURNS from -pi on a direction lies; slopes tell it in a fraction of an arc tangent's time.

    u, v: to the right and up, in any unit.
    """
    if v < 0.0:
        quarter, along, up = (0, -u, -v) if u < 0.0 else (1, -v, u)
    else:
        quarter, along, up = (2, u, v) if u > 0.0 else (3, v, -u)
    turn = quarter * (TURNS // 4)
    for slope in _SLOPES:
        if up < slope * along:
            break
        turn += 1
    return turn


@njit(cache=True)
def _match(
    depths: Values, every: Values, across: Values, weights: Values, allowed: Mask,
    distance: Values, turns: Rows, leans: Values,
) -> None:  # fmt: skip
    for k in range(len(depths)):
        for turn in np.flatnonzero(allowed[k]):
            away, a, b = _compare(depths[k], every[turn], across, weights)
            if away < distance[k]:
                distance[k], turns[k], leans[k, 0], leans[k, 1] = away, turn, a, b


@njit(cache=True, fastmath=_FAST)
def _compare(depths: Values, wanted: Values, across: Values, weights: Values) -> tuple[float, float, float]:
    """The weighted distance of two maps after the lean (a, b) between them is taken out."""
    s = 0.0
    total = 0.0
    xx = 0.0
    xy = 0.0
    yy = 0.0
    ex = 0.0
    ey = 0.0
    ee = 0.0
    for i in range(len(depths)):
        goal = wanted[i]
        if goal <= NOTHING:
            continue
        w, x, y = weights[i], across[i, 0], across[i, 1]
        total += w
        if depths[i] <= NOTHING:
            continue
        e = max(min(depths[i] - goal, _DIFFERENT), -_DIFFERENT)
        s, xx, xy, yy = s + w, xx + w * x * x, xy + w * x * y, yy + w * y * y
        ex, ey, ee = ex + w * e * x, ey + w * e * y, ee + w * e * e
    turned = xx * yy - xy * xy
    if turned <= 1e-20 or s <= 0.0:
        return np.inf, 0.0, 0.0
    a, b = (ex * yy - ey * xy) / turned, (ey * xx - ex * xy) / turned
    if a * a + b * b > _LEAN:
        return np.inf, 0.0, 0.0
    return np.sqrt(max((ee - a * ex - b * ey) / s, 0.0)) + _MISSING * (1.0 - s / total), a, b
