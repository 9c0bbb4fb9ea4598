"""Where lips, brows and cheeks are painted on the built-in head: python -m tools.photographs.look_up_layers.

Writes `builtin/photographs/skin_layers.npz`, which is committed.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from omote.builtin import load_cast, load_mask
from omote.builtin.own_skin import SKIN_LAYERS
from omote.interchange.formats.png import read_png
from omote.model.fitting.head_zones import head_zones

Values = NDArray[np.float64]

STRONG = (1.6, 2.0, 1.0)
"""Lips and brows are painted so many times as strongly as the mask says, at most wholly."""
SMEAR = 2.0
SIDE = 1024
LINED = 0.9
"""Skin that less light reaches is the lining of an opening."""


def look_up_layers() -> tuple[NDArray[np.intp], Values]:
    """Triangles (s,) of the face's skin, as rows of the space's, and how far the middle of each lies on lips, brows and
    cheeks (s, 3)."""
    cast = load_cast()
    assert cast.atlas is not None
    space = cast.space
    atlas = cast.atlas
    first = np.zeros(space.vertex_count, np.intp)
    first[atlas.source] = np.arange(len(atlas.source))
    rows = np.flatnonzero(head_zones(space).face[space.triangles].all(axis=1))
    uv = np.asarray(atlas.uv, np.float64)[first[space.triangles[rows]]].mean(axis=1)
    column, row = np.clip((uv * SIDE).astype(np.intp), 0, SIDE - 1).T
    mask = read_png(load_mask())[:SIDE] / 255.0
    shown = np.stack([gaussian_filter(mask[..., c], SMEAR)[row, column] for c in range(4)], axis=1)
    used = shown[:, 3] > LINED
    return rows[used], np.minimum(shown[used, :3] * STRONG, 1.0)


def main() -> None:
    """Writes them beside the landmark table."""
    rows, layers = look_up_layers()
    with SKIN_LAYERS.open("wb") as stream:
        np.savez_compressed(
            stream, allow_pickle=False, rows=rows.astype(np.uint16), layers=np.rint(255 * layers).astype(np.uint8)
        )


if __name__ == "__main__":
    main()
