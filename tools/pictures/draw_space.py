"""Draws the parameter space S of the built-in head and, where ../shared/data is, of heads that nobody here made.

Usage: python -m tools.pictures.draw_space. Writes docs/pictures/space-*.png: the sheet shaded as its normals lie,
membranes in amber, edges dark; theta from -180 to 180 degrees to the right, h upward.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import omote
from omote.geometry.mesh import normals
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.skin_sheet import unwrap_corners
from tests.model import heads
from tools.baking.skin.raster import rasterise
from tools.baking.write import png_bytes

ROOT = Path(__file__).resolve().parents[2]
SIZE = 1100
SMOOTHER = 2
BACKGROUND = np.array([18.0, 18.0, 22.0])
MEMBRANE = np.array([226.0, 150.0, 40.0])


def picture(space: ParameterSpace) -> NDArray[np.uint8]:
    """S as a picture (rows, columns, 4), one metre of h as long as one metre along the mean circle."""
    corners = space.location_triangles
    size = SIZE * SMOOTHER
    x, y = unwrap_corners(space.theta, corners), space.h[corners]
    metric = float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())
    scale = size / (2 * np.pi * metric)
    rows = int(np.ptp(y) * scale) + 1
    twice = [_place(x + shift, y, metric, scale) for shift in (-2 * np.pi, 0.0, 2 * np.pi)]
    owner, weights, _ = rasterise(np.concatenate(twice), size)
    owner = owner[:rows]
    weights = weights[:rows]
    shown = owner >= 0
    triangle = owner[shown] % len(corners)
    slope = normals(space.points, space.triangles)[corners[triangle]]
    toward = (weights[shown][..., None] * slope).sum(axis=1)
    outward = np.stack([np.sin(space.theta), np.zeros(len(space.theta)), np.cos(space.theta)], axis=1)[
        corners[triangle, 0]
    ]
    light = np.clip((toward * (outward * 0.8 + [0.0, 0.45, 0.0])).sum(axis=1), 0.0, 1.0)
    colour = np.array([206.0, 190.0, 178.0]) * (0.25 + 0.75 * light[:, None])
    colour = np.where((triangle >= len(space.skin_triangles))[:, None], MEMBRANE, colour)
    colour *= np.where(weights[shown].min(axis=1) < 0.06, 0.62, 1.0)[:, None]
    full = np.tile(BACKGROUND, (rows, size, 1))
    full[shown] = colour
    return _smaller(full)


def _place(x: NDArray[np.float64], y: NDArray[np.float64], metric: float, scale: float) -> NDArray[np.float64]:
    column = (x + np.pi) * metric * scale
    row = (y.max() - y) * scale
    return np.stack([column, row, np.zeros_like(row)], axis=-1)


def _smaller(full: NDArray[np.float64]) -> NDArray[np.uint8]:
    rows = full.shape[0] // SMOOTHER
    columns = full.shape[1] // SMOOTHER
    blocks = (
        full[: rows * SMOOTHER, : columns * SMOOTHER].reshape(rows, SMOOTHER, columns, SMOOTHER, 3).mean(axis=(1, 3))
    )
    opaque = np.full((rows, columns, 1), 255.0)
    return np.concatenate([blocks, opaque], axis=2).round().astype(np.uint8)


def main() -> int:
    """Draws every head that is here and says which."""
    spaces = {"generic": omote.load_cast().space}
    if heads.DATA.is_dir():
        spaces["ict-facekit"] = ParameterSpace.build(*heads.ict_facekit())
        spaces["perry-smith"] = ParameterSpace.build(*heads.perry_smith())
    folder = ROOT / "docs" / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    for name, space in spaces.items():
        (folder / f"space-{name}.png").write_bytes(png_bytes(picture(space)))
        sheet = f"{len(space.skin_triangles)} triangles, {space.on_sheet.sum()} vertices"
        print(f"docs/pictures/space-{name}.png: {sheet}, {len(space.membranes)} membrane triangles")
    return 0


if __name__ == "__main__":
    sys.exit(main())
