"""What of a mouth can be seen, and what should not be: teeth through skin and through the mouth bag, gums that end in
the air, holes, slits between closed lips; seen by a depth buffer from turned heads, and measured in space."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.geometry import mesh
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_bag import find_mouth_bag

Values = NDArray[np.float64]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

TEETH = ("teeth_upper", "teeth_lower")
PARTS = (*TEETH, "tongue")
PIXEL = 0.0005
"""Metres."""
TURNS = tuple((yaw, pitch) for pitch in (-30, 0, 30) for yaw in (-60, -30, 0, 30, 60))
"""Yaw and pitch of the head, degrees."""
BEHIND = 0.004
"""What is seen so far behind the lips' own surface is the inside of the mouth, metres."""
GROUPS = 128
AT_ONCE = 16
"""Points whose winding numbers are found in one call."""
# Places of a triangle at which it is tested.
PLACES = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [3, 3, 0], [0, 3, 3], [3, 0, 3], [2, 2, 2]]) / [
    [1],
    [1],
    [1],
    [6],
    [6],
    [6],
    [6],
]


@dataclass(frozen=True)
class Seen:
    """Of one compound: how deep teeth lie outside of the skin, and crowns in the mouth's walls, millimetres; how far a
    gum's edge that is seen is from the mouth's lining; how much of the open mouth shows the outer skin from behind or
    nothing at all, square millimetres; how far one can look through between the lips, millimetres."""

    pierced: float
    buried: float
    bare: float
    hole: float
    slit: float


class MouthViews:
    """Everything of a space that measures need of its topology."""

    def __init__(self, space: ParameterSpace) -> None:
        bag = find_mouth_bag(space)
        if bag is None:
            raise ValueError("the space has no mouth bag; expected the built-in cast's")
        self._lips = space.welded[next(line.loop for line in space.lines if line.kind == "lips")]
        self._bag = bag.triangles.astype(np.int64)
        self._rim = _loop(bag.triangles)
        corners = space.welded[space.triangles]
        middle = space.points[corners].mean(axis=1)
        lips = space.points[self._lips].mean(axis=0)
        other = ~np.isin(corners, bag.vertices).any(axis=1) & (np.linalg.norm(middle - lips, axis=1) < 0.13)
        skin = [corners[other], bag.triangles]
        starts = np.cumsum([space.vertex_count, *(len(space.parts[name].points) for name in PARTS)])
        parts = [space.parts[name].triangles + start for name, start in zip(PARTS, starts, strict=False)]
        self._triangles = np.concatenate([*skin, *parts]).astype(np.int64)
        self._kind = np.repeat(np.arange(5), [len(list_) for list_ in (*skin, *parts)])
        touching = space.on_sheet[bag.triangles].any(axis=1)  # the lips' own edges
        self._of_lips = np.zeros(len(self._kind), np.bool_)
        self._of_lips[: len(skin[0]) + len(skin[1])] = np.concatenate([np.ones(len(skin[0]), np.bool_), touching])
        closed = space.location_triangles
        self._closed = closed.astype(np.int64)
        near = np.linalg.norm(space.points[closed].mean(axis=1) - lips, axis=1)
        sheet = np.arange(len(closed)) < len(space.sheet_triangles)
        self._sheet = closed[sheet & (near < 0.09)].astype(np.int64)
        self._membrane = closed[~sheet & np.isin(closed, [*self._lips, *self._rim]).all(axis=1) & (near < 0.03)]
        self._gums, self._crowns = zip(
            *(_gum_edges(space, name, start) for name, start in zip(TEETH, starts, strict=False)), strict=True
        )

    def look(
        self, skin: Values, parts: Mapping[str, NDArray[np.floating]], turns: Sequence[tuple[int, int]] = TURNS
    ) -> Seen:
        """What is seen of a face with skin (V, 3) and parts (n, 3)."""
        points = np.concatenate([skin, *(parts[name] for name in PARTS)]).astype(np.float64)
        gums, bare = self._air(points)
        views = [self._view(points @ _turn(*turn).T, gums @ _turn(*turn).T, bare) for turn in turns]
        hole, seen = (max(view[part] for view in views) for part in range(2))
        return Seen(
            1e3 * self._pierced(points), 1e3 * self._buried(points), 1e3 * seen, 1e6 * hole, 1e3 * self._slit(points)
        )  # fmt: skip

    def _corners(self, points: Values, triangles: Indices) -> Values:
        return np.ascontiguousarray(points[triangles])

    def _pierced(self, points: Values) -> float:
        """The greatest distance to the skin of teeth that lie outside of it, other than through the open lips."""
        teeth = self._triangles[(self._kind == 2) | (self._kind == 3)]
        return self.measure_pierced(points, points[teeth])

    def measure_pierced(self, skin: Values, triangles: Values) -> float:
        """The greatest distance to the skin (V, 3) of triangles (t, 3, 3) of teeth outside of it, other than through
        the open lips, metres."""
        tested = np.unique(np.einsum("sk,tkc->tsc", PLACES, triangles).reshape(-1, 3).round(9), axis=0)
        corners = self._corners(skin, self._sheet)
        away, at = _find_nearest(corners, tested)
        normal = np.cross(corners[at, 1] - corners[at, 0], corners[at, 2] - corners[at, 0])
        out = np.flatnonzero((((tested - corners[at, 0]) * normal).sum(axis=1) > 0) & (away > 1e-4))
        through, _ = nearest_triangles(self._corners(skin, self._membrane), tested[out])
        out = out[away[out] < through]
        out = out[np.argsort(-away[out])]
        closed = self._corners(skin, self._closed)
        for start in range(0, len(out), AT_ONCE):  # winding numbers are dear: the first that lies outside is the answer
            some = out[start : start + AT_ONCE]
            outside = winding_numbers(closed, tested[some]) < 0.5
            if outside.any():
                return float(away[some][outside].max())
        return 0.0

    def _buried(self, points: Values) -> float:
        """How deep crowns lie behind the walls of the mouth bag, other than out of the open lips."""
        rim = points[self._rim]
        lid = np.stack([np.roll(rim, -1, axis=0), rim, np.broadcast_to(rim.mean(axis=0), rim.shape)], axis=1)
        walls = self._corners(points, self._bag)
        crowns = points[np.concatenate(self._crowns)]
        inside = winding_numbers(np.concatenate([walls, lid]), crowns) < -0.5
        away, through, open_ = (
            nearest_triangles(np.ascontiguousarray(part), crowns[~inside])[0]
            for part in (walls, lid, points[self._membrane])
        )
        return float(away[(away < through) & (away < open_)].max(initial=0.0))

    def _air(self, points: Values) -> tuple[Values, Values]:
        """Places of the gums' edges (n, 3), and their distance to lining and tongue (n,)."""
        edges = np.concatenate(self._gums)
        places = np.concatenate(
            [points[edges[:, 0]] * (1 - share) + points[edges[:, 1]] * share for share in (0.0, 0.25, 0.5, 0.75)]
        )
        around = self._triangles[(self._kind == 1) | (self._kind == 4)]
        return places, nearest_triangles(self._corners(points, around), places)[0]

    def _view(self, points: Values, gums: Values, bare: Values) -> tuple[float, float]:
        """Area of holes, square metres, and the greatest distance of a gum's edge that is seen to what is around it."""
        low, size = _frame(np.concatenate([points[self._lips], gums]))
        depth, first, front = draw(points, self._triangles, low, size)
        wrong = (~front & (self._kind[first] == 0)) | (first < 0)  # the stage draws the lining from both sides
        hole = (wrong & _inside(points[self._lips], low, size)).sum() * PIXEL**2
        column, row = ((gums[:, :2] - low) / PIXEL).astype(np.int64).T
        seen = gums[:, 2] >= depth[row, column] - 3e-4
        return float(hole), float(bare[seen].max(initial=0.0))

    def _slit(self, points: Values) -> float:
        """How many pixels over each other show what lies BEHIND the lips, in metres; straight, from above and below."""
        longest = 0
        for pitch in (-20, 0, 20):
            turned = points @ _turn(0, pitch).T
            low, size = _frame(turned[self._lips])
            depth, first, front = draw(turned, self._triangles, low, size)
            lips = front & (first >= 0) & self._of_lips[first]  # on a muzzle they go far back
            order = np.argsort(turned[self._lips, 0])
            columns = low[0] + (np.arange(size[1]) + 0.5) * PIXEL
            surface = np.interp(columns, turned[self._lips, 0][order], turned[self._lips, 2][order])
            within = _inside(turned[self._lips], low, size)
            within = within | np.roll(within, 2, axis=0) | np.roll(within, -2, axis=0)
            run = np.zeros(size[1], np.int64)
            for through in within & ~lips & (depth < surface - BEHIND):
                run = np.where(through, run + 1, 0)
                longest = max(longest, int(run.max()))
        return longest * PIXEL


def _find_nearest(corners: Values, points: Values) -> tuple[Values, Indices]:
    """As `nearest_triangles`, for many points that lie together: each group of them looks at the triangles near it."""
    tree = cKDTree(corners[:, 0])
    middles = corners.mean(axis=1)
    reach = np.linalg.norm(corners - middles[:, None], axis=2).max(axis=1)
    away = np.empty(len(points))
    at = np.empty(len(points), np.int64)
    for group in _groups(points):
        middle = points[group].mean(axis=0)
        radius = np.linalg.norm(points[group] - middle, axis=1).max()
        farthest = 2.0 * radius + tree.query(middle)[0]  # no triangle that is nearest to a point lies farther away
        near = np.flatnonzero(np.linalg.norm(middles - middle, axis=1) <= farthest + reach)
        away[group], found = nearest_triangles(corners[near], points[group])
        at[group] = near[found]
    return away, at


def _groups(points: Values) -> list[Indices]:
    """Points (n, 3) in groups that lie together: halves along the longer side, over and over."""
    groups = [np.arange(len(points))]
    while len(groups) < GROUPS:
        ordered = [group[np.argsort(points[group][:, np.ptp(points[group], axis=0).argmax()])] for group in groups]
        groups = [half for group in ordered for half in np.array_split(group, 2)]
    return [group for group in groups if len(group)]


def _loop(triangles: NDArray[np.int32]) -> Indices:
    """The vertices of a mesh's border, in order around it."""
    after = {int(one): int(other) for one, other in mesh.boundary_edges(triangles)}
    here = next(iter(after))
    found = [here]
    while (here := after[here]) != found[0]:
        found.append(here)
    return np.array(found)


def _gum_edges(space: ParameterSpace, name: str, start: int) -> tuple[Indices, Indices]:
    """The edges (e, 2) in which the gum of a row of teeth ends, its two last teeth's open backs left out; and its
    crowns' vertices."""
    part = space.parts[name]
    edges = np.unique(np.sort(mesh.boundary_edges(part.triangles), axis=1), axis=0)
    crowns = np.setdiff1d(np.arange(len(part.points)), edges)
    back = part.points[edges][..., 2].max(axis=1) < part.points[:, 2].min() + 0.006
    return edges[~back] + start, crowns + start


def _turn(yaw: float, pitch: float) -> Values:
    """The rotation (3, 3) of a head, degrees: yaw to its left, pitch down."""
    (cy, sy), (cp, sp) = ((np.cos(angle), np.sin(angle)) for angle in np.radians([yaw, pitch]))
    pitched = np.array([[1, 0, 0], [0, cp, sp], [0, -sp, cp]])
    return np.asarray(np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]]) @ pitched)


def _frame(points: Values) -> tuple[Values, tuple[int, int]]:
    """The lower left corner (2,) of a picture around points, and its height and width in pixels."""
    low = points[:, :2].min(axis=0) - 0.01
    high = points[:, :2].max(axis=0) + 0.01
    width, height = np.ceil((high - low) / PIXEL).astype(int)
    return low, (int(height), int(width))


def _inside(loop: Values, low: Values, size: tuple[int, int]) -> Mask:
    """Which pixels (height, width) lie inside a closed line (n, 3): even-odd rule."""
    x = low[0] + (np.arange(size[1]) + 0.5) * PIXEL
    y = low[1] + (np.arange(size[0])[:, None] + 0.5) * PIXEL
    result = np.zeros(size, np.bool_)
    for one, other in zip(loop, np.roll(loop, -1, axis=0), strict=True):
        rise = other[1] - one[1]
        if rise:
            result ^= ((one[1] > y) != (other[1] > y)) & (x < one[0] + (other[0] - one[0]) * (y - one[1]) / rise)
    return result


@njit(cache=True)
def draw(points: Values, triangles: Indices, low: Values, size: tuple[int, int]) -> tuple[Values, Indices, Mask]:
    """A depth buffer of triangles (t, 3), seen along z: the nearest z, triangle (-1: none), and whether its front."""
    depth = np.full(size, -np.inf)
    first = np.full(size, -1)
    front = np.zeros(size, np.bool_)
    for t in range(len(triangles)):
        a, b, c = points[triangles[t, 0]], points[triangles[t, 1]], points[triangles[t, 2]]
        ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]
        area = ux * vy - uy * vx
        if abs(area) < 1e-14:
            continue
        left = min(a[0], b[0], c[0])
        right = max(a[0], b[0], c[0])
        under = min(a[1], b[1], c[1])
        over = max(a[1], b[1], c[1])
        for row in range(max(0, int((under - low[1]) / PIXEL) - 1), min(size[0], int((over - low[1]) / PIXEL) + 2)):
            y = low[1] + (row + 0.5) * PIXEL - a[1]
            for column in range(
                max(0, int((left - low[0]) / PIXEL) - 1), min(size[1], int((right - low[0]) / PIXEL) + 2)
            ):
                x = low[0] + (column + 0.5) * PIXEL - a[0]
                u, v = (x * vy - y * vx) / area, (ux * y - uy * x) / area
                if u >= -1e-9 and v >= -1e-9 and u + v <= 1.0 + 1e-9:
                    z = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])
                    if z > depth[row, column]:
                        depth[row, column] = z
                        first[row, column] = t
                        front[row, column] = area > 0
    return depth, first, front
