"""Even samples of scans: by area where there are triangles, as they are where there are none."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.geometry import mesh
from omote.model.fitting.scan import Scan

Values = NDArray[np.float64]

SAMPLES = 45_000
# How many of them say how far neighbours are apart.
_ASKED = 1500


def sample_surface(scan: Scan, /, *, chosen: NDArray[np.bool_] | None = None, count: int = SAMPLES) -> Values:
    """At most so many points (n, 3) of a scan's surface, or of what its chosen points (m,) span; the same each time."""
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
    result: Values = a + np.where(over, 1.0 - u, u) * (b - a) + np.where(over, 1.0 - v, v) * (c - a)
    return result


def thin_out(points: Values, cell: float, /) -> Values:
    """The mean of the points (n, 3) in each cube of a lattice: as dense everywhere, noise averaged."""
    at = np.floor((points - points.min(axis=0)) / cell).astype(np.int64)
    sizes = at.max(axis=0) + 1
    key = (at[:, 0] * sizes[1] + at[:, 1]) * sizes[2] + at[:, 2]
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    result: Values = np.add.reduceat(points[order], starts) / np.diff(np.append(starts, len(order)))[:, None]
    return result


def measure_spacing(points: Values, tree: cKDTree, /) -> float:
    """How far from a place on the surface the nearest of its samples (n, 3) usually is."""
    some = points[:: max(len(points) // _ASKED, 1)]
    # The second nearest: where all points come twice the nearest is the point itself again.
    away, _ = tree.query(some, k=4, workers=1)
    return float(np.median(away[:, 3])) / 2.0
