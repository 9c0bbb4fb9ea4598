"""Samples of the surface of a scan: even ones to find a head by, and points with normals to fit one to."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from omote.arrays import Indices, Mask, Rows, Values
from omote.geometry import mesh
from omote.model.fitting.scan import Scan

SEARCH_SAMPLES = 45_000
# How many of them say how far neighbours are apart.
_ASKED = 1500
FIT_SAMPLES = 200_000
# A normal that is the other way round is as far as so many metres.
TURN = 0.006
# A surface of one side only is inside out where it faces so much against a head, in the mean of cosines.
INSIDE_OUT = 0.5
NOTHING = "the scan has no surface where the head is; expected triangles with an area there"
# A local plane of a cloud goes through so many points.
PLANE = 16


def sample_surface(scan: Scan, /, *, chosen: Mask | None = None, count: int = SEARCH_SAMPLES) -> Values:
    """At most so many points (n, 3) of a scan's surface, or of what its chosen points (m,) span; the same each time.

    scan: in its own unit; chosen (m,): None for all; count: how many points at most.
    """
    kept = np.ones(len(scan.positions), np.bool_) if chosen is None else chosen
    if scan.triangles is not None and len(scan.triangles):
        corners = scan.positions[scan.triangles[kept[scan.triangles].any(axis=1)]]
        area = mesh.areas(corners.reshape(-1, 3), np.arange(corners.size // 3, dtype=np.int32).reshape(-1, 3))
        if area.sum() > 0.0:
            return _sample_triangles(corners, area, count)
    points = scan.positions[kept]
    return points if len(points) <= count else points[np.random.default_rng(0).choice(len(points), count, False)]


def _sample_triangles(corners: Values, area: Values, count: int) -> Values:
    """One point in each of so many equal shares of the area."""
    draw = np.random.default_rng(0)
    ends = np.cumsum(area)
    rows = np.searchsorted(ends, (np.arange(count) + draw.uniform(size=count)) / count * ends[-1])
    a, b, c = corners[np.minimum(rows, len(corners) - 1)].transpose(1, 0, 2)
    u, v = draw.uniform(size=(2, count, 1))
    over = u + v > 1.0
    return a + np.where(over, 1.0 - u, u) * (b - a) + np.where(over, 1.0 - v, v) * (c - a)


def thin_out(points: Values, cell: float, /) -> Values:
    """The mean of the points (n, 3) in each cube of a lattice: as dense everywhere, noise averaged.

    points (n, 3), cell: the lattice's edge, in the same unit.
    """
    at = np.floor((points - points.min(axis=0)) / cell).astype(np.int64)
    sizes = at.max(axis=0) + 1
    key = (at[:, 0] * sizes[1] + at[:, 1]) * sizes[2] + at[:, 2]
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    return np.add.reduceat(points[order], starts) / np.diff(np.append(starts, len(order)))[:, None]


def measure_spacing(points: Values, tree: cKDTree, /) -> float:
    """How far from a place on the surface the nearest of its samples (n, 3) usually is.

    points (n, 3): samples; tree: of them.
    """
    some = points[:: max(len(points) // _ASKED, 1)]
    # The second nearest: where all points come twice the nearest is the point itself again.
    away, _ = tree.query(some, k=4, workers=1)
    return float(np.median(away[:, 3])) / 2.0


@dataclass(frozen=True, eq=False)
class ScanSurface:
    """Points on a surface, (n, 3) metres, their unit normals outward, whether they lie at an open border, the sheet
    that each belongs to, and the triangle of the scan that it lies in, -1 for a cloud's."""

    points: Values
    normals: Values
    border: Mask
    component: Indices
    triangle: Indices

    # Trees are made when they are first asked for; halves of unequal size are as fast to ask and sooner made.
    @cached_property
    def tree(self) -> cKDTree:
        """The points, by place."""
        return cKDTree(self.points, balanced_tree=False)

    @cached_property
    def turned(self) -> cKDTree:
        """The points, by place and way."""
        return cKDTree(np.hstack([self.points, TURN * self.normals]), balanced_tree=False)

    def keep(self, chosen: Mask, /) -> ScanSurface:
        """This surface without the points that are not chosen (n,)."""
        return ScanSurface(
            self.points[chosen], self.normals[chosen], self.border[chosen], self.component[chosen],
            self.triangle[chosen],
        )  # fmt: skip

    def find_nearest(self, points: Values, normals: Values, /) -> Rows:
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
        return np.hypot(height, np.maximum(along - spacing, 0.0))

    @property
    def spacing(self) -> float:
        """The usual distance between neighbouring rows, metres."""
        some = self.points[:: max(len(self.points) // 2000, 1)]
        return float(2.0 * np.median(self.tree.query(some, k=2, workers=1)[0][:, 1]))


def sample_mesh(points: Values, triangles: NDArray[np.integer], near: Values, reach: float, /) -> ScanSurface:
    """Samples of a mesh (n, 3), (t, 3), denser than its triangles, of what lies within reach of a box (2, 3).

    points (n, 3), triangles (t, 3): the mesh, metres; near (2, 3): the box's least and greatest corner; reach: metres.
    """
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
    owner = draw.choice(len(corners), FIT_SAMPLES, p=area / area.sum())
    u, v = draw.uniform(size=(2, FIT_SAMPLES, 1))
    over = (u + v) > 1.0
    u, v = np.where(over, 1.0 - u, u), np.where(over, 1.0 - v, v)
    places = (1.0 - u - v) * a[owner] + u * b[owner] + v * c[owner]
    normals = across[owner] / np.maximum(area[owner], 1e-30)[:, None]
    return ScanSurface(places, normals, edge[corners].any(axis=1)[owner], labels[owner], rows[owner].astype(np.int32))


def _label_sheets(corners: NDArray[np.integer]) -> Indices:
    """Which sheet each triangle (t, 3) belongs to: triangles hang together across edges that just two of them share, so
    what was put onto the lids for tears or lashes is a sheet of its own."""
    ends = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2), axis=1).astype(np.int64)
    keys = ends[:, 0] * (int(corners.max()) + 1) + ends[:, 1]
    owner = np.repeat(np.arange(len(corners)), 3)
    order = np.argsort(keys, kind="stable")
    keys = keys[order]
    owner = owner[order]
    first = np.flatnonzero(keys[1:] == keys[:-1])
    alone = np.ones(len(first), np.bool_)
    alone[1:] &= first[1:] != first[:-1] + 1
    alone[:-1] &= first[1:] != first[:-1] + 1
    one = owner[first[alone]]
    other = owner[first[alone] + 1]
    graph = sparse.coo_array((np.ones(len(one)), (one, other)), shape=(len(corners), len(corners)))
    return connected_components(graph, directed=False)[1]


def whole_sheets(points: Values, triangles: NDArray[np.integer], surface: ScanSurface, /) -> Rows:
    """The triangles of a mesh in the sheets that a surface shows, those among them that are too small for a sample.

    points (n, 3), triangles (t, 3): the mesh, metres; surface: samples of it.
    """
    corners = mesh.weld(points)[triangles]
    labels = np.full(len(triangles), -1)
    rows = np.flatnonzero((corners != np.roll(corners, 1, axis=1)).all(axis=1))
    labels[rows] = _label_sheets(corners[rows])
    return np.flatnonzero(np.isin(labels, np.unique(labels[surface.triangle])))


def sample_cloud(points: Values, outside: tuple[Values, Values], near: Values, reach: float, /) -> ScanSurface:
    """A cloud of points (n, 3) near a box (2, 3) with the normals of local planes, that look as those of a head
    (k, 3), (k, 3) beside them.

    points (n, 3): metres; outside: points and normals of the head; near (2, 3): the box's corners; reach: metres.
    """
    inside = ((points > near[0] - reach) & (points < near[1] + reach)).all(axis=1)
    kept = points[inside]
    if len(kept) < PLANE:
        raise ValueError(f"the scan has {len(kept)} points where the head is; expected at least {PLANE}")
    if len(kept) > FIT_SAMPLES:
        kept = kept[np.random.default_rng(0).choice(len(kept), FIT_SAMPLES, replace=False)]
    _, rows = cKDTree(kept).query(kept, k=PLANE, workers=1)
    off = kept[rows] - kept[rows].mean(axis=1, keepdims=True)
    _, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", off, off))
    normals = axes[:, :, 0]
    normals = normals * np.where(_facing(kept, normals, outside) < 0.0, -1.0, 1.0)[:, None]
    none = np.zeros(len(kept))
    return ScanSurface(kept, normals, none.astype(np.bool_), none.astype(np.int32), np.full(len(kept), -1, np.int32))


def face_outward(surface: ScanSurface, outside: tuple[Values, Values], /) -> ScanSurface:
    """The surface with its normals as those of a head (k, 3), (k, 3) near it; some programs wind triangles the other
    way.

    surface: the scan's; outside: points and normals of the head.
    """
    some = slice(None, None, 16)
    if _facing(surface.points[some], surface.normals[some], outside).mean() >= 0.0:
        return surface
    return ScanSurface(surface.points, -surface.normals, surface.border, surface.component, surface.triangle)


def is_inside_out(surface: ScanSurface, outside: tuple[Values, Values], /) -> bool:
    """Whether nearly all of a surface faces the other way than a head (k, 3), (k, 3) near it: its triangles are wound
    the other way, or its points were mirrored since they were wound.

    surface: the scan's; outside: points and normals of the head.
    """
    some = slice(None, None, 16)
    return bool(_facing(surface.points[some], surface.normals[some], outside).mean() < -INSIDE_OUT)


def _facing(points: Values, normals: Values, outside: tuple[Values, Values]) -> Values:
    """The cosines (n,) between normals and those of the nearest points of a head."""
    _, beside = cKDTree(outside[0]).query(points, workers=1)
    return (normals * outside[1][beside]).sum(axis=1)
