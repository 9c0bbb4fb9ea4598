"""The signed distance field (SDF) of the generic head on a grid, with its gradient, on which hair grows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from omote.geometry.mesh import normals
from tools.baking.heads.basemesh import Floats, Ints

STEP = 0.003  # metres between grid points
MARGIN = 0.05  # metres of air around the head
SAMPLES = 5  # points along a triangle's edge that stand for its surface


@dataclass(frozen=True, eq=False)
class Field:
    """Signed distances in metres (outside is positive) at grid points `origin + STEP * index`, and their gradients."""

    origin: Floats
    values: Floats
    slopes: tuple[Floats, Floats, Floats]

    def height(self, points: Floats) -> Floats:
        """Metres above the surface, (...,); negative inside."""
        return self._at(self.values, points)

    def outward(self, points: Floats) -> Floats:
        """Unit vectors (..., 3) away from the surface."""
        slope = np.stack([self._at(one, points) for one in self.slopes], axis=-1)
        return np.asarray(slope / np.maximum(np.linalg.norm(slope, axis=-1, keepdims=True), 1e-9))

    def _at(self, values: Floats, points: Floats) -> Floats:
        places = np.moveaxis((points - self.origin) / STEP, -1, 0)
        return np.asarray(ndimage.map_coordinates(values, places, order=1, mode="nearest"))


def field_of(points: Floats, triangles: Ints, *, closing: float, blur: float) -> Field:
    """The field around a skin with points (n, 3).

    closing: gaps up to twice this many metres (behind ears, under the jaw) count as filled; blur: metres over which the
    surface is smoothed, so that hair does not follow every bump.

    triangles (t, 3): of the skin.
    """
    origin = points.min(axis=0) - MARGIN
    shape = tuple(np.ceil((np.ptp(points, axis=0) + 2 * MARGIN) / STEP).astype(int))
    grid = np.stack(np.meshgrid(*(np.arange(n) for n in shape), indexing="ij"), axis=-1) * STEP + origin
    inside = _inside(points, triangles, grid)
    reach = round(closing / STEP)
    if reach > 0:
        filled = _distance(inside) < closing
        inside = _distance(~filled) >= closing
    signed = _distance(inside) - _distance(~inside)
    values = ndimage.gaussian_filter(signed, blur / STEP)
    slopes = np.gradient(values)
    return Field(origin, values, (slopes[0], slopes[1], slopes[2]))


def _distance(inside: NDArray[np.bool_]) -> Floats:
    """Metres from every grid point to the nearest one that is inside."""
    return np.asarray(ndimage.distance_transform_edt(~inside) * STEP)


def _inside(points: Floats, triangles: Ints, grid: Floats) -> NDArray[np.bool_]:
    """Which grid points (..., 3) lie behind the skin: near it by the nearest sample's normal, elsewhere as the nearest
    of those does."""
    spots, facing = surface_samples(points, triangles)
    wall = np.zeros(grid.shape[:-1], bool)
    wall[tuple(np.round((spots - grid[0, 0, 0]) / STEP).astype(int).T)] = True
    near = _distance(wall) <= 2 * STEP
    _, nearest = cKDTree(spots).query(grid[near])
    inside = np.zeros(wall.shape, bool)
    inside[near] = ((grid[near] - spots[nearest]) * facing[nearest]).sum(axis=1) < 0.0
    links = ndimage.distance_transform_edt(~near, return_distances=False, return_indices=True)
    return np.asarray(inside[tuple(links)])


def surface_samples(points: Floats, triangles: Ints) -> tuple[Floats, Floats]:
    """Points spread evenly over every triangle and the smooth normals there, (s, 3) each.

    points (V, 3), triangles (t, 3): of the skin, metres.
    """
    first, second = np.meshgrid(np.arange(SAMPLES), np.arange(SAMPLES), indexing="ij")
    kept = first + second < SAMPLES
    weights = np.stack([first[kept], second[kept], SAMPLES - 1 - first[kept] - second[kept]], axis=1) / (SAMPLES - 1)
    smooth = normals(points, triangles)
    spots = np.einsum("sc,tcd->tsd", weights, points[triangles]).reshape(-1, 3)
    facing = np.einsum("sc,tcd->tsd", weights, smooth[triangles]).reshape(-1, 3)
    return spots, facing
