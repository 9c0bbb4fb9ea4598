"""The skin of a face as photographs show it, for a look on a page: a colour for each vertex of a finer mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]

FINER = 2
"""Times that each edge is halved: vertices of the face are further apart than what one knows a person by."""


@dataclass(frozen=True, eq=False)
class ColouredSkin:
    """positions (n, 3) float32 metres; triangles (t, 3) uint32; colours (n, 3) uint8 sRGB."""

    positions: NDArray[np.float32]
    triangles: NDArray[np.uint32]
    colours: NDArray[np.uint8]


def colour_skin(
    positions: NDArray[np.floating], uv: NDArray[np.floating], triangles: NDArray[np.integer],
    painted: NDArray[np.uint8], /,
) -> ColouredSkin:  # fmt: skip
    """A finer mesh of positions (k, 3), triangles (t, 3) and texture coordinates (k, 2) from the upper left corner,
    with the colours of a texture (s, s, 3)."""
    corners = np.concatenate([positions, uv], axis=1).astype(np.float64)
    for _ in range(FINER):
        corners, triangles = halve_edges(corners, triangles)
    colours = texels_at(corners[:, 3:], painted)
    return ColouredSkin(corners[:, :3].astype(np.float32), triangles.astype(np.uint32), colours)


def texels_at(uv: NDArray[np.floating], texture: NDArray[np.uint8], /) -> NDArray[np.uint8]:
    """The texels of a texture (s, s, ...) in which texture coordinates (n, 2) lie."""
    side = len(texture)
    columns, rows = np.clip((uv * side).astype(np.int64), 0, side - 1).T
    found: NDArray[np.uint8] = texture[rows, columns]
    return found


def halve_edges(corners: Values, triangles: NDArray[np.integer], /) -> tuple[Values, NDArray[np.integer]]:
    """Each triangle (t, 3) as four: vertices (n, c) with those in the middles of the edges after them."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    once, which = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = (len(corners) + which.reshape(-1, 3)).T
    a, b, c = triangles.T
    four = np.concatenate([np.stack(each, axis=1) for each in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return np.concatenate([corners, corners[once].mean(axis=1)]), four
