"""The surface of a scan as points with normals that can be asked for the nearest, and how far it is from any point."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from omote.geometry import mesh

Values = NDArray[np.float64]
Indices = NDArray[np.intp]

SAMPLES = 200_000
# A normal that is the other way round is as far as so many metres.
TURN = 0.006
# A surface of one side only is inside out where it faces so much against a head, in the mean of cosines.
INSIDE_OUT = 0.5
NOTHING = "the scan has no surface where the head is; expected triangles with an area there"
# A local plane of a cloud goes through so many points.
PLANE = 16


@dataclass(frozen=True, eq=False)
class ScanSurface:
    """Points on a surface, (n, 3) metres, their unit normals outward, whether they lie at an open border, the sheet
    that each belongs to, and the triangle of the scan that it lies in, -1 for a cloud's."""

    points: Values
    normals: Values
    border: NDArray[np.bool_]
    component: NDArray[np.int32]
    triangle: NDArray[np.int32]

    # Trees are made when they are first asked for; halves of unequal size are as fast to ask and sooner made.
    @cached_property
    def tree(self) -> cKDTree:
        """The points, by place."""
        return cKDTree(self.points, balanced_tree=False)

    @cached_property
    def turned(self) -> cKDTree:
        """The points, by place and way."""
        return cKDTree(np.hstack([self.points, TURN * self.normals]), balanced_tree=False)

    def keep(self, chosen: NDArray[np.bool_], /) -> ScanSurface:
        """This surface without the points that are not chosen (n,)."""
        return ScanSurface(
            self.points[chosen], self.normals[chosen], self.border[chosen], self.component[chosen],
            self.triangle[chosen],
        )  # fmt: skip

    def find_nearest(self, points: Values, normals: Values, /) -> Indices:
        """The rows (m,) nearest to points (m, 3) that look along normals (m, 3): place and way together."""
        _, rows = self.turned.query(np.hstack([points, TURN * normals]), workers=1)
        return np.asarray(rows)

    def measure_distance(self, points: Values, /) -> Values:
        """How far points (m, 3) are from the planes of the nearest rows, (m,) metres; far from all, from the rows."""
        away, rows = self.tree.query(points, workers=1)
        off = points - self.points[rows]
        height = np.abs((off * self.normals[rows]).sum(axis=1))
        along = np.sqrt(np.maximum(away**2 - height**2, 0.0))
        spacing = self.spacing
        result: Values = np.hypot(height, np.maximum(along - spacing, 0.0))
        return result

    @property
    def spacing(self) -> float:
        """The usual distance between neighbouring rows, metres."""
        some = self.points[:: max(len(self.points) // 2000, 1)]
        return float(2.0 * np.median(self.tree.query(some, k=2, workers=1)[0][:, 1]))


def sample_mesh(points: Values, triangles: NDArray[np.integer], near: Values, reach: float, /) -> ScanSurface:
    """Samples of a mesh (n, 3), (t, 3), denser than its triangles, of what lies within reach of a box (2, 3)."""
    joined = mesh.weld(points)
    corners = joined[triangles]
    rows = np.flatnonzero((corners != np.roll(corners, 1, axis=1)).all(axis=1))
    inside = ((points > near[0] - reach) & (points < near[1] + reach)).all(axis=1)
    edge = np.zeros(len(points), np.bool_)
    edge[mesh.boundary_edges(corners[rows].astype(np.int32)).ravel()] = True
    rows = rows[inside[corners[rows]].any(axis=1)]
    corners = corners[rows]
    if not len(corners):
        raise ValueError(NOTHING)
    labels = _label_sheets(corners)
    a, b, c = (points[corners[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    area = np.linalg.norm(across, axis=1)
    if not area.sum() > 0.0:
        raise ValueError(NOTHING)
    draw = np.random.default_rng(0)
    owner = draw.choice(len(corners), SAMPLES, p=area / area.sum())
    u, v = draw.uniform(size=(2, SAMPLES, 1))
    over = (u + v) > 1.0
    u, v = np.where(over, 1.0 - u, u), np.where(over, 1.0 - v, v)
    found = (1.0 - u - v) * a[owner] + u * b[owner] + v * c[owner]
    normals = across[owner] / np.maximum(area[owner], 1e-30)[:, None]
    return ScanSurface(found, normals, edge[corners].any(axis=1)[owner], labels[owner], rows[owner].astype(np.int32))


def _label_sheets(corners: NDArray[np.integer]) -> NDArray[np.int32]:
    """Which sheet each triangle (t, 3) belongs to: triangles hang together across edges that just two of them share, so
    what was put onto the lids for tears or lashes is a sheet of its own."""
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2), axis=1).astype(np.int64)
    keys, owner = ends[:, 0] * (int(corners.max()) + 1) + ends[:, 1], np.repeat(np.arange(len(corners)), 3)
    order = np.argsort(keys, kind="stable")
    keys, owner = keys[order], owner[order]
    first = np.flatnonzero(keys[1:] == keys[:-1])
    alone = np.ones(len(first), np.bool_)
    alone[1:] &= first[1:] != first[:-1] + 1
    alone[:-1] &= first[1:] != first[:-1] + 1
    one, other = owner[first[alone]], owner[first[alone] + 1]
    graph = sparse.coo_array((np.ones(len(one)), (one, other)), shape=(len(corners), len(corners)))
    result: NDArray[np.int32] = connected_components(graph, directed=False)[1]
    return result


def sample_cloud(points: Values, outside: tuple[Values, Values], near: Values, reach: float, /) -> ScanSurface:
    """A cloud of points (n, 3) near a box (2, 3) with the normals of local planes, that look as those of a head
    (k, 3), (k, 3) beside them."""
    inside = ((points > near[0] - reach) & (points < near[1] + reach)).all(axis=1)
    kept = points[inside]
    if len(kept) < PLANE:
        raise ValueError(f"the scan has {len(kept)} points where the head is; expected at least {PLANE}")
    if len(kept) > SAMPLES:
        kept = kept[np.random.default_rng(0).choice(len(kept), SAMPLES, replace=False)]
    _, rows = cKDTree(kept).query(kept, k=PLANE, workers=1)
    off = kept[rows] - kept[rows].mean(axis=1, keepdims=True)
    _, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", off, off))
    normals = axes[:, :, 0]
    normals = normals * np.where(_facing(kept, normals, outside) < 0.0, -1.0, 1.0)[:, None]
    none = np.zeros(len(kept))
    return ScanSurface(kept, normals, none.astype(np.bool_), none.astype(np.int32), np.full(len(kept), -1, np.int32))


def face_outward(surface: ScanSurface, outside: tuple[Values, Values], /) -> ScanSurface:
    """The surface with its normals as those of a head (k, 3), (k, 3) near it; some programs wind triangles the other
    way."""
    some = slice(None, None, 16)
    if _facing(surface.points[some], surface.normals[some], outside).mean() >= 0.0:
        return surface
    return ScanSurface(surface.points, -surface.normals, surface.border, surface.component, surface.triangle)


def is_inside_out(surface: ScanSurface, outside: tuple[Values, Values], /) -> bool:
    """Whether nearly all of a surface faces the other way than a head (k, 3), (k, 3) near it: its triangles are wound
    the other way, or its points were mirrored since they were wound."""
    some = slice(None, None, 16)
    return bool(_facing(surface.points[some], surface.normals[some], outside).mean() < -INSIDE_OUT)


def _facing(points: Values, normals: Values, outside: tuple[Values, Values]) -> Values:
    """The cosines (n,) between normals and those of the nearest points of a head."""
    _, beside = cKDTree(outside[0]).query(points, workers=1)
    result: Values = (normals * outside[1][beside]).sum(axis=1)
    return result
