"""Thins a scan for a look on a page: fewer triangles of the same surface, in the frame of the fitted face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity

Values = NDArray[np.float64]

MOST_TRIANGLES = 60_000
MOST_POINTS = 60_000
# A cell of the grid grows by so much until few enough are left.
_COARSER = 1.15
# About so many triangles cross a cell of the grid.
_TRIANGLES_A_CELL = 2.0


@dataclass(frozen=True, eq=False)
class ThinScan:
    """positions (n, 3) float32; triangles (t, 3) uint32, none of a cloud; colours (n, 3) uint8 sRGB, or None."""

    positions: NDArray[np.float32]
    triangles: NDArray[np.uint32]
    colours: NDArray[np.uint8] | None


def thin_scan(scan: Scan, placement: Similarity, around: Values | None = None, /) -> ThinScan:
    """The scan where it was placed, its points merged by the cells of a grid (Rossignac and Borrel 1993) until at most
    MOST_TRIANGLES triangles and MOST_POINTS points are left.

    around: the least and the greatest corner (2, 3), metres, of what is kept of it; None keeps all.
    """
    points, colours = placement(scan.positions), _colours_of_points(scan)
    triangles = np.zeros((0, 3), np.int32) if scan.triangles is None else scan.triangles
    if around is not None:
        points, triangles, colours = _cut(points, triangles, colours, around)
    if not _is_thin(points, triangles):
        cell = _first_cell(points, triangles)
        while not _is_thin(*(thinned := _merge(points, triangles, colours, cell))[:2]):
            cell *= _COARSER
        points, triangles, colours = thinned
    shades = None if colours is None else np.rint(colours).astype(np.uint8)
    return ThinScan(points.astype(np.float32), triangles.astype(np.uint32), shades)


def _is_thin(points: Values, triangles: NDArray[np.integer]) -> bool:
    return len(triangles) <= MOST_TRIANGLES and (len(triangles) > 0 or len(points) <= MOST_POINTS)


def _colours_of_points(scan: Scan) -> Values | None:
    """The colour (n, 3) of each point: its own, else its texture's at one of its corners."""
    if scan.texture is None or scan.texcoords is None or scan.triangles is None:
        return None if scan.colours is None else scan.colours.astype(np.float64)
    height, width = scan.texture.shape[:2]
    places = scan.texcoords.reshape(-1, 2) * [width, height]
    columns = np.clip(places[:, 0].astype(np.int64), 0, width - 1)
    rows = np.clip(places[:, 1].astype(np.int64), 0, height - 1)
    colours = np.full((len(scan.positions), 3), 128.0)
    colours[scan.triangles.reshape(-1)] = scan.texture[rows, columns]
    return colours


def _cut(
    points: Values, triangles: NDArray[np.integer], colours: Values | None, around: Values
) -> tuple[Values, NDArray[np.integer], Values | None]:
    inside = ((points >= around[0]) & (points <= around[1])).all(axis=1)
    if not inside.any():
        return points, triangles, colours
    place = np.cumsum(inside) - 1
    kept = triangles[inside[triangles].all(axis=1)] if len(triangles) else triangles
    return points[inside], place[kept], None if colours is None else colours[inside]


def _first_cell(points: Values, triangles: NDArray[np.integer]) -> float:
    """The edge of a grid's cells that leaves about as many as are wanted."""
    if len(triangles):
        a, b, c = points[triangles].transpose(1, 0, 2)
        area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2
        cell = float(np.sqrt(_TRIANGLES_A_CELL * area / MOST_TRIANGLES))
    else:
        cell = float(np.sqrt((np.ptp(points, axis=0) ** 2).sum() / MOST_POINTS)) / 2
    return max(cell, 1e-9 * float(np.abs(points).max(initial=1.0)))


def _merge(
    points: Values, triangles: NDArray[np.integer], colours: Values | None, cell: float
) -> tuple[Values, NDArray[np.integer], Values | None]:
    """Each cell's points as one, in their middle, in their mean colour; triangles that lie in fewer cells than three,
    or where another lies, go."""
    low = points.min(axis=0)
    keys = np.minimum((points - low) / cell, 2**20 - 1).astype(np.int64) @ np.array([1 << 40, 1 << 20, 1])
    _, place, counts = np.unique(keys, return_inverse=True, return_counts=True)
    middles = np.stack([np.bincount(place, axis) for axis in points.T], axis=1) / counts[:, None]
    shades = colours
    if colours is not None:
        shades = np.stack([np.bincount(place, each) for each in colours.T], axis=1) / counts[:, None]
    merged = place[triangles].reshape(-1, 3)
    merged = merged[(merged != np.roll(merged, 1, axis=1)).all(axis=1)]
    _, first = np.unique(np.sort(merged, axis=1), axis=0, return_index=True)
    return middles, merged[np.sort(first)], shades
