"""Outlines: where a head ends in a photograph, sought as an edge of brightness near where a fitted head ends.

Says what landmarks do not: how far cheeks, brow and nose stand out where a head is turned (after Bas, Smith, Bolkart
and Wuhrer 2016, "Fitting a 3D morphable model to edges").
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

from omote.arrays import Floats, Mask, Rows, Values
from omote.geometry import mesh
from omote.geometry.depth_map import visible
from omote.model.fitting.photographs.photograph import PhotographCamera
from omote.model.space.parameter_space import ParameterSpace

REACH = 0.007
"""Metres to both sides of a fitted outline within which an edge is sought."""
STEPS = 29
BLUR = 0.0012
"""Metres: finer brightness is no edge."""
SLACK = 0.002
CLEAR = 3.0
"""An edge stands out so many times over the median of what lies across it."""
BESIDE = 3.0
GAP = 0.02
"""An outline has nothing within so many metres behind it, so many pixels of the depth map beside it."""


@dataclass(frozen=True, eq=False)
class Outline:
    """Edges found: rows (k,) of the skin where it ends, ways (k, 2) across its outline (right, up), how far along them
    the edge lies (k,), metres, and how clear it is (k,), 0 to 1."""

    rows: Rows
    ways: Values
    away: Values
    clear: Values


def find_outline(
    space: ParameterSpace, camera: PhotographCamera, skin: Values, luma: Values, counted: Mask, /
) -> Outline:
    """The edges near the outline of a skin (V, 3) in a photograph's brightness (h, w); counted (V,): where to look.

    space, skin (V, 3): the head, metres; camera: of the photograph; luma (h, w): 0 to 255; counted (V,): where to look.
    """
    seen = camera.view(skin)
    normals = mesh.normals(skin, space.triangles) @ camera.rotation.T
    rows = _rims(space, skin, normals, camera, counted)
    ways = normals[rows, :2] / np.maximum(np.linalg.norm(normals[rows, :2], axis=1, keepdims=True), 1e-9)
    pixel = -seen[rows, 2] / camera.focal
    offsets = np.linspace(-REACH, REACH, STEPS)
    middle = camera.project(seen[rows])
    along = middle[:, None] + (offsets[None, :, None] / pixel[:, None, None]) * (ways * [1.0, -1.0])[:, None]
    smooth = gaussian_filter(luma, max(BLUR / float(np.median(pixel)), 0.7)) if len(rows) else luma
    profile = map_coordinates(smooth, [along[..., 1] - 0.5, along[..., 0] - 0.5], order=1, mode="nearest")
    slope = np.abs(np.gradient(profile, axis=1))
    score = slope * np.exp(-0.5 * (offsets / (0.6 * REACH)) ** 2)
    best = score[:, 2:-2].argmax(axis=1) + 2
    peak = slope[np.arange(len(rows)), best]
    clear = np.clip((peak / (np.median(slope, axis=1) + 0.3) - 1.0) / CLEAR, 0.0, 1.0)
    return Outline(rows, ways, offsets[best], clear)


def _rims(space: ParameterSpace, skin: Values, normals: Values, camera: PhotographCamera, counted: Mask) -> Rows:
    """The counted rows of the skin where it turns away from the camera and nothing is before it."""
    seen = camera.view(skin)
    facing = (normals * -seen).sum(axis=1) / np.linalg.norm(seen, axis=1)
    corners = space.triangles
    turned = facing[corners]
    crossing = (turned.max(axis=1) > 0.0) & (turned.min(axis=1) <= 0.0)
    rows = corners[crossing][np.abs(turned[crossing]).argmin(axis=1)[:, None] == np.arange(3)]
    rows = np.unique(rows)
    rows = rows[counted[rows]]
    screen = camera.screen(skin, camera.coarse)
    depth = camera.draw(skin, corners, camera.coarse)
    beside = screen[rows] + BESIDE * normals[rows] * [1.0, -1.0, 0.0]
    gap = _depth_at(depth, beside) - screen[rows, 2]
    return np.asarray(rows[visible(depth, screen[rows], SLACK) & (gap > GAP)])


def _depth_at(depth: Floats, screen: Values) -> Values:
    row = np.clip(screen[:, 1].astype(int), 0, depth.shape[0] - 1)
    column = np.clip(screen[:, 0].astype(int), 0, depth.shape[1] - 1)
    return depth[row, column].astype(np.float64)
