"""Takes photographs of heads of any mesh on the CPU: known shape, known camera, known colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.photographs.photograph import PhotographCamera
from tools.tracking import rasterizer
from tools.tracking.picture import Setting, _stretch

Floats = NDArray[np.float32]
Values = NDArray[np.float64]
FINE = 2
"""Pixels are drawn so many times as fine, along each axis."""


@dataclass(frozen=True, eq=False)
class Model:
    """What is drawn: points (n, 3) metres, normals (n, 3), triangles (t, 3), material (t,), as `rasterizer` names them.

    uv (n, 2) of the mask, openness (n,), local (n, 3) places on eyeballs; mask (h, w, 4); colours, traits: as
    `rasterizer.shade_pixels`; lashes: how many; strands: places (k, s, 3) and light (k, s) of hair, and its colour.
    """

    points: Values
    normals: Floats
    triangles: NDArray[np.int32]
    material: NDArray[np.int32]
    uv: Floats
    openness: Floats
    local: Floats
    mask: NDArray[np.uint8]
    colours: Floats
    traits: Floats
    lashes: float = 0.0
    strands: tuple[Floats, Floats, Floats] | None = None
    clothes: float = 0.15


@dataclass(frozen=True, eq=False)
class Hits:
    """What each pixel shows: triangle (h, w), -1 nothing, -2 hair; shares (h, w, 2) of its second and third corner;
    depth (h, w) metres."""

    triangle: NDArray[np.int32]
    shares: Floats
    depth: Floats


def look_through(camera: PhotographCamera, model: Model, fine: int, lashes: float = 0.0) -> Hits:
    """What each pixel of a picture `fine` times as large shows of the model, without its hair."""
    size = (camera.height * fine, camera.width * fine)
    depth = np.full(size, rasterizer.FAR, np.float32)
    hit = np.full(size, -1, np.int32)
    shares = np.zeros((*size, 2), np.float32)
    seen = camera.view(model.points)
    screen = np.concatenate([camera.project(seen) * fine, -seen[:, 2:]], axis=1).astype(np.float32)
    rasterizer.draw_triangles(screen, model.triangles, model.material, lashes, depth, hit, shares)
    return Hits(hit, shares, depth)


def photograph(
    camera: PhotographCamera, model: Model, setting: Setting, draw: np.random.Generator
) -> tuple[NDArray[np.uint8], Hits]:
    """A photograph (height, width, 3) of sRGB, and what its fine pixels show."""
    hits = look_through(camera, model, FINE, model.lashes)
    height, width = hits.triangle.shape
    picture = _behind(camera, model, setting, max(height, width))[:height, :width]
    picture = np.ascontiguousarray(picture)
    seen = camera.view(model.points)
    _draw_hair(camera, model, setting, hits, picture)
    facing = model.normals @ camera.rotation.T
    rasterizer.shade_pixels(
        hits.triangle, hits.shares, model.triangles, model.material, facing.astype(np.float32),
        seen.astype(np.float32), model.uv, model.openness, model.local, model.mask, model.colours, model.traits,
        setting.lamps.astype(np.float32), picture,
    )  # fmt: skip
    return develop(picture, setting, draw), hits


def develop(picture: Floats, setting: Setting, draw: np.random.Generator) -> NDArray[np.uint8]:
    """The picture (h, w, 3) of sRGB that a camera makes of linear colours (2h, 2w, 3)."""
    small = 0.25 * (picture[::2, ::2] + picture[1::2, ::2] + picture[::2, 1::2] + picture[1::2, 1::2])
    coded = np.clip(small * setting.exposure, 0, None)
    values = 255 * np.clip(coded / (1.0 + 0.25 * coded), 0, 1) ** np.float32(0.4545)
    values += setting.noise * draw.standard_normal(values.shape, np.float32)
    result: NDArray[np.uint8] = np.clip(np.rint(values), 0, 255).astype(np.uint8)
    return result


def _draw_hair(camera: PhotographCamera, model: Model, setting: Setting, hits: Hits, picture: Floats) -> None:
    if model.strands is None:
        return
    places, light, colour = model.strands
    seen = camera.view(places.reshape(-1, 3))
    screen = np.concatenate([camera.project(seen) * FINE, -seen[:, 2:]], axis=1).astype(np.float32)
    shade = (light * float(setting.lamps[0, 3:].mean() * 0.7 + setting.lamps[2, 3:].mean())).astype(np.float32)
    thick = max(1.5, 0.0028 * camera.focal * FINE / float(-camera.shift[2]))
    rasterizer.draw_strands(
        screen.reshape(*places.shape), shade, colour.astype(np.float32), thick, hits.depth, hits.triangle, picture
    )


def _behind(camera: PhotographCamera, model: Model, setting: Setting, side: int) -> Floats:
    """The room, with shoulders and a neck."""
    picture = _stretch(setting.room, side)
    chest = camera.project(camera.view(np.array([[0.0, -0.15, 0.0]])))[0] * FINE
    wide = 0.2 * camera.focal * FINE / float(-camera.shift[2])
    rows = np.arange(side, dtype=np.float32)[:, None]
    columns = np.arange(side, dtype=np.float32)
    across = ((columns - chest[0]) / wide) ** 2
    body = across + (np.minimum(rows - chest[1] - 0.5 * wide, 0) / (0.5 * wide)) ** 2 < 1
    picture[body] = setting.clothes
    low, high, left, right = (
        int(np.clip(edge, 0, side))
        for edge in (chest[1] - 0.35 * wide, chest[1] + 0.2 * wide, chest[0] - 0.29 * wide, chest[0] + 0.29 * wide)
    )
    picture[low:high, left:right] = 0.4 * model.colours[0]
    return picture
