"""Builds the hair mesh for export: each strand of a style is a ribbon that faces outwards and follows its anchor."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.glb_writer import Material, Shape, Target
from omote.interchange.formats.png import png_bytes
from omote.interchange.part_textures import paint_strands
from omote.interchange.skin_texture import decode_srgb
from omote.model.cast import Look
from omote.model.hair import HairStyle, place_strands

Points = NDArray[np.float64]

HAIR = "hair"
STRANDS = 7
"""Hairs on a ribbon."""


def hair_shape(
    style: HairStyle, generic: Points, positions: NDArray[np.floating], targets: Mapping[str, Target], look: Look
) -> Shape:
    """Builds the hair of a face with positions (V, 3): two vertices for each strand point; targets: the skin's."""
    strands = place_strands(style, generic, positions.astype(np.float64))
    count, places = strands.shape[:2]
    along = np.gradient(strands, axis=1)
    facing = style.facing.astype(np.float64)
    side = _unit(np.cross(along, facing)) * (0.5 * style.width)
    points = np.stack([strands - side, strands + side], axis=2).reshape(-1, 3)
    normals = np.repeat(_unit(np.cross(side, along)).reshape(-1, 3), 2, axis=0)
    shape = (count, places, 2)
    across = np.broadcast_to([0.0, 1.0], shape)
    down = np.broadcast_to(np.linspace(0.0, 1.0, places)[None, :, None], shape)
    rows = np.repeat(style.anchors, 2 * places)
    still = np.zeros((len(rows), 3), np.float32)
    picture = paint_strands(decode_srgb(look.hair), STRANDS, columns=128, rows=256)
    return Shape(
        name=HAIR,
        points=points.astype(np.float32),
        normals=normals.astype(np.float32),
        uv=np.stack([across, down], axis=-1).reshape(-1, 2).astype(np.float32),
        triangles=_ribbon_triangles(count, places),
        material=Material(HAIR, png_bytes(picture), roughness=0.55, cut=0.4, both=True),
        targets={name: Target(target.moves[rows], still) for name, target in targets.items()},
        shade=np.repeat(0.25 + 0.75 * style.light.reshape(-1), 2).astype(np.float32),
    )


def _ribbon_triangles(count: int, places: int) -> NDArray[np.int32]:
    """The triangles of ribbons, two vertices a place, seen from where they face."""
    first = (np.arange(count)[:, None] * places + np.arange(places - 1)).ravel() * 2
    left, right, down, far = first, first + 1, first + 2, first + 3
    return np.concatenate([np.stack([left, right, far], axis=1), np.stack([left, far, down], axis=1)]).astype(np.int32)


def _unit(vectors: Points) -> Points:
    size = np.linalg.norm(vectors, axis=-1, keepdims=True)
    result: Points = np.where(size > 1e-12, vectors / np.maximum(size, 1e-12), [0.0, 0.0, 1.0])
    return result
