"""Meshes as pictures inside a figure: an orthographic eye, a few materials, one indexed PNG."""

from __future__ import annotations

import base64
import struct
import zlib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.geometry.mesh import normals
from tools.baking.skin.raster import rasterise
from tools.pictures.method.svg import Box, Figure

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

SMOOTHER = 2
LEVELS = 14
SKIN, INNER, BALL, TEETH, TONGUE, MARK, MEMBRANE, COOL, IRIS = range(9)
_COLOURS = np.array([
    (214, 196, 182), (108, 128, 158), (236, 240, 246), (240, 232, 210), (206, 118, 112), (244, 190, 70), (226, 150, 40),
    (110, 168, 224), (96, 78, 66),
], np.float64)  # fmt: skip
_PAPER = (28, 32, 38)


@dataclass(frozen=True)
class Eye:
    """Looks at a place (3,) from a side: yaw to the head's left and pitch up, degrees; shows `width` metres of it."""

    centre: tuple[float, float, float]
    width: float
    yaw: float = 0.0
    pitch: float = 0.0

    def seen(self, points: NDArray[np.floating], box: Box) -> Values:
        """Points (n, 3) in a box of a figure: x, y and how near they are (n, 3), in the figure's units."""
        left, top, width, height = box
        scale = width / self.width
        turned = (np.asarray(points, np.float64) - self.centre) @ self._axes().T * scale
        x, y = left + width / 2 + turned[:, 0], top + height / 2 - turned[:, 1]
        return np.stack([x, y, turned[:, 2]], axis=1)

    def ahead(self) -> Values:
        """The unit vector (3,) towards the eye."""
        result: Values = self._axes()[2]
        return result

    def _axes(self) -> Values:
        yaw, pitch = np.deg2rad([self.yaw, self.pitch])
        ahead = np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
        right = np.array([np.cos(yaw), 0.0, -np.sin(yaw)])
        return np.stack([right, np.cross(ahead, right), ahead])


@dataclass(frozen=True, eq=False)
class Surface:
    """A mesh and the material of each triangle (t,), or of all; shade (n,) replaces the light, 0 to 1."""

    points: NDArray[np.floating]
    triangles: Indices
    material: NDArray[np.integer] | int = SKIN
    shade: Values | None = None


def picture(
    eye: Eye, box: Box, surfaces: Sequence[Surface], *, edges: bool = True
) -> str:  # fmt: skip
    """What an eye sees in a box of a figure, as an SVG image."""
    seen = [eye.seen(surface.points, box)[surface.triangles] for surface in surfaces]
    lights = [_lit(surface, eye)[surface.triangles] for surface in surfaces]
    materials = [np.broadcast_to(surface.material, len(surface.triangles)) for surface in surfaces]
    return painted(box, np.concatenate(seen), np.concatenate(lights), np.concatenate(materials), edges=edges)


def marked(
    figure: Figure, eye: Eye, box: Box, points: NDArray[np.floating], triangles: Indices,
    colour: str,
) -> None:  # fmt: skip
    """Outlines triangles (t, 3) over a picture, those too that lie behind others; those beyond its box are left out."""
    seen = eye.seen(points, box)[:, :2]
    low = np.array(box[:2])
    high = np.array(box[:2]) + box[2:]
    for corners in seen[triangles]:
        if (corners >= low).all() and (corners <= high).all():
            figure.line(corners, colour, width=1.1, closed=True, fill=colour, fill_opacity=0.35)


def painted(
    box: Box, corners: Values, lights: Values, materials: NDArray[np.integer], *,
    edges: bool = True,
) -> str:  # fmt: skip
    """Triangles (t, 3, 3) with the light at their corners (t, 3), 0 to 1, and their materials (t,), as an SVG image."""
    left, top, width, height = box
    columns = round(width * SMOOTHER)
    rows = round(height * SMOOTHER)
    flat = (corners - [left, top, 0.0]) * [SMOOTHER, SMOOTHER, 1.0]
    near = (flat[:, :, 0].max(axis=1) > 0) & (flat[:, :, 0].min(axis=1) < columns)
    near &= (flat[:, :, 1].max(axis=1) > 0) & (flat[:, :, 1].min(axis=1) < rows)
    owner, weights, _ = rasterise(flat[near], max(columns, rows))
    owner = owner[:rows, :columns]
    weights = weights[:rows, :columns]
    light = (weights * lights[near][owner]).sum(axis=2)
    level = np.clip(np.rint(light * (LEVELS - 1)), 0, LEVELS - 1).astype(np.int64)
    if edges:
        level = np.where(_edge(owner), np.maximum(level - 4, 0), level)
    index = np.where(owner >= 0, 1 + materials[near][owner] * LEVELS + level, 0).astype(np.uint8)
    data = base64.b64encode(_indexed_png(index)).decode("ascii")
    return (
        f'<image x="{left:g}" y="{top:g}" width="{columns / SMOOTHER:g}" height="{rows / SMOOTHER:g}" '
        f'href="data:image/png;base64,{data}"/>'
    )


def _lit(surface: Surface, eye: Eye) -> Values:
    if surface.shade is not None:
        return surface.shade
    lamp = eye.ahead() + np.array([-0.45, 0.55, 0.0])
    slope = normals(np.asarray(surface.points, np.float64), surface.triangles)
    result: Values = 0.25 + 0.75 * np.clip(slope @ (lamp / np.linalg.norm(lamp)), 0.0, 1.0)
    return result


def _edge(owner: NDArray[np.int32]) -> NDArray[np.bool_]:
    found = np.zeros(owner.shape, np.bool_)
    found[:, :-1] |= owner[:, :-1] != owner[:, 1:]
    found[:-1] |= owner[:-1] != owner[1:]
    return found


def _indexed_png(index: NDArray[np.uint8]) -> bytes:
    """A PNG of palette entries (rows, columns): 0 the panel, then LEVELS shades of each material."""
    shades = np.linspace(0.22, 1.0, LEVELS)[:, None]
    palette = np.concatenate([[_PAPER], *(shades * colour for colour in _COLOURS)]).round().astype(np.uint8)
    rows, columns = index.shape
    lines = np.concatenate([np.zeros((rows, 1), np.uint8), index], axis=1)
    head = struct.pack(">IIBBBBB", columns, rows, 8, 3, 0, 0, 0)
    parts = (
        (b"IHDR", head),
        (b"PLTE", palette.tobytes()),
        (b"IDAT", zlib.compress(lines.tobytes(), 9)),
        (b"IEND", b""),
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in parts
    )
