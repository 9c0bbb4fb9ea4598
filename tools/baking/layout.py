"""A texture layout for the head alone: the published islands repacked, the front of the face enlarged.

The package's layout spends a few percent of the picture on the face, because it holds a whole body. Here the skin's
largest island fills the picture, magnified towards the tip of the nose; the others lie in a row below it.
Texture coordinates as in glTF: (0, 0) is the upper left corner of the picture.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from tools.baking.heads.basemesh import Floats, Ints
from tools.baking.heads.head import Piece

MARGIN = 0.008  # of the texture's side, around islands
ROW_TOP = 0.80  # the small islands lie below this line
MAGNIFY_ACROSS = 5.0  # argument of asinh at the far edge: 5 enlarges the centre 2.2 times
MAGNIFY_ALONG = 3.0


def unwrap(skin: Piece, points: Floats) -> Floats:
    """The skin's texture coordinates (k, 2) in the head's own layout; points: (n, 3) of the skin's vertices."""
    across, along = _upright(skin, points)
    island = islands(skin.uv_corners, len(skin.uvs))
    main = np.bincount(island).argmax()
    nose = skin.uv_corners[skin.triangles == points[:, 2].argmax()][0]
    layout = np.empty_like(skin.uvs)
    inside = island == main
    layout[inside, 0] = _magnify(across[inside], across[nose], MAGNIFY_ACROSS, MARGIN, 1.0 - MARGIN)
    layout[inside, 1] = _magnify(along[inside], along[nose], MAGNIFY_ALONG, MARGIN, ROW_TOP - MARGIN)
    others = [island == other for other in range(island.max() + 1) if other != main]
    _pack_row(layout, skin.uvs, others)
    return layout


def _upright(skin: Piece, points: Floats) -> tuple[Floats, Floats]:
    """The published coordinates turned so that the first grows with x and the second falls with y."""
    corners = points[skin.triangles.ravel()]
    uvs = skin.uvs[skin.uv_corners.ravel()]
    front = corners[:, 2] > np.median(corners[:, 2])
    tie = np.corrcoef(np.concatenate([uvs[front], corners[front, :2]], axis=1).T)[:2, 2:]
    columns = (0, 1) if abs(tie[0, 0]) > abs(tie[1, 0]) else (1, 0)
    across = skin.uvs[:, columns[0]]
    along = skin.uvs[:, columns[1]]
    return across * np.sign(tie[columns[0], 0]), -along * np.sign(tie[columns[1], 1])


def islands(corners: Ints, count: int) -> Ints:
    """The island (connected piece of the layout) of each texture coordinate, (k,).

    corners (t, 3): rows of texture coordinates; count: how many there are.
    """
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]]])
    links = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(count, count))
    return np.asarray(connected_components(links, directed=False)[1].astype(np.int32))


def _magnify(values: Floats, centre: float, strength: float, low: float, high: float) -> Floats:
    """Values spread over [low, high], enlarged around `centre` by a rising function, so that nothing folds."""
    reach = max(values.max() - centre, centre - values.min())
    spread = np.arcsinh(strength * (values - centre) / reach)
    return np.asarray(low + (high - low) * (spread - spread.min()) / (spread.max() - spread.min()))


def _pack_row(layout: Floats, uvs: Floats, others: list[np.ndarray]) -> None:
    sizes = [np.ptp(uvs[other], axis=0) for other in others]
    widths = np.array([size[0] / size[1] for size in sizes])
    free = 1.0 - MARGIN * (len(others) + 1)
    height = min(free / widths.sum(), 1.0 - ROW_TOP - MARGIN) if others else 0.0
    left = MARGIN
    for other, size, width in zip(others, sizes, widths, strict=True):
        layout[other] = (uvs[other] - uvs[other].min(axis=0)) * height / size[1] + [left, ROW_TOP]
        left += width * height + MARGIN
