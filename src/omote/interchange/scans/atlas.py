"""Joins the textures of several materials into one picture, one below the other, with texture coordinates in it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture, Values
from omote.interchange.scans.picture_reader import MOST_PIXELS
from omote.model.albedo import encode_light

PATCH = 4
"""Pixels, height and width of the picture of a plain colour."""


def plain_picture(colour: Sequence[float], /) -> Picture:
    """A small picture of one colour: linear, 0 to 1, as glTF and OBJ materials have it; alpha is passed over."""
    linear = np.clip(np.nan_to_num(np.asarray(colour[:3], np.float64)), 0.0, 1.0)
    return np.broadcast_to(encode_light(linear), (PATCH, PATCH, 3)).copy()


def join_textures(
    pictures: Sequence[Picture | None], texcoords: Values, of: NDArray[np.int64], /
) -> tuple[Picture | None, Values | None]:  # fmt: skip
    """One picture of all, and the texture coordinates (t, 3, 2) in it, v down from its top.

    pictures: of each material, None for one without; of (t,): the material of each triangle. None for both where no
    material has a picture of its own, or all together have too many pixels.

    texcoords (t, 3, 2): in the materials' own pictures.
    """
    used = [at for at in np.unique(of).tolist() if 0 <= at < len(pictures)]
    shown = {at: picture for at in used if (picture := pictures[at]) is not None}
    if all(picture.shape[0] <= PATCH for picture in shown.values()):
        return None, None
    if len(shown) == 1 and len(used) == 1:
        return next(iter(shown.values())), texcoords
    grey = plain_picture((0.2, 0.2, 0.2))
    tiles = {at: shown.get(at, grey) for at in used}
    width = max(tile.shape[1] for tile in tiles.values())
    height = sum(tile.shape[0] for tile in tiles.values())
    if width * height > MOST_PIXELS:
        return None, None
    whole = np.zeros((height, width, 3), np.uint8)
    moved = texcoords.copy()
    top = 0
    for at, tile in tiles.items():
        rows, columns = tile.shape[:2]
        whole[top : top + rows, :columns] = tile
        inside = np.clip(_repeat(texcoords[of == at]) * [columns, rows], 0.5, [columns - 0.5, rows - 0.5])
        moved[of == at] = (inside + np.array([0.0, top])) / [width, height]
        top += rows
    return whole, moved


def _repeat(texcoords: Values) -> Values:
    """Coordinates moved by whole repetitions of the picture, each triangle as one, so that it lies in the picture."""
    middle = texcoords.mean(axis=1, keepdims=True)
    return texcoords - np.where((middle < 0.0) | (middle > 1.0), np.floor(middle), 0.0)
