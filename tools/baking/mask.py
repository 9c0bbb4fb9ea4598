"""The region mask: one picture on the head's texture layout that says where lips, brows, blush and shade lie.

Painted by this code from the generic head alone, so that every face can wear it in its own colours:
red = lips, green = brows (hair by hair), blue = blush, alpha = light that is left (255 = untouched): cavities,
lash lines and pores.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, dijkstra

from tools.baking.basemesh import Floats, Ints
from tools.baking.brows import brow_cover
from tools.baking.head import Piece
from tools.baking.layout import islands
from tools.baking.raster import openness, rasterise

SIZE = 1024
PADDING = 8  # pixels that every island is grown by, so that filtering never reads the ground
SEED = 1993
# Blush: centre on the generic head (metres; x is mirrored), radius (metres), strength.
BLUSH = (
    ((0.043, -0.030), 0.019, 0.85),  # cheeks
    ((0.000, -0.036), 0.010, 0.55),  # tip of the nose
    ((0.000, -0.098), 0.014, 0.25),  # chin
    ((0.030, 0.004), 0.013, 0.22),  # upper lids
    ((0.082, -0.010), 0.022, 0.45),  # ears
)


@dataclass(frozen=True)
class Texels:
    """What lies under each pixel of the picture.

    covered: (SIZE, SIZE) bool;  places: (n, 3) metres on the generic head of the covered pixels;
    lip_rings, lid_rings: (n,) edges to the seam of the mouth and of the nearer eye;  light: (n,) 0 to 1;
    inner: (n,) bool, on the islands that lie inside mouth and lids
    """

    covered: NDArray[np.bool_]
    places: Floats
    lip_rings: Floats
    lid_rings: Floats
    light: Floats
    inner: NDArray[np.bool_]


def paint_mask(skin: Piece, points: Floats, layout: Floats) -> NDArray[np.uint8]:
    """The mask (SIZE, SIZE, 4) of the generic head: points (n, 3) metres, layout (k, 2) its texture coordinates."""
    texels = _texels(skin, points, layout)
    picture = np.zeros((SIZE, SIZE, 4))
    picture[texels.covered, 0] = _lips(texels)
    picture[texels.covered, 1] = brow_cover(texels.places, seed=SEED)
    picture[texels.covered, 2] = _blush(texels)
    picture[texels.covered, 3] = _light(texels)
    picture[~texels.covered, 3] = 1.0
    return np.rint(_grown(picture, texels.covered) * 255.0).astype(np.uint8)


def _texels(skin: Piece, points: Floats, layout: Floats) -> Texels:
    corners = np.concatenate([layout * SIZE, np.zeros((len(layout), 1))], axis=1)[skin.uv_corners]
    owner, weights, _ = rasterise(corners, SIZE)
    covered = owner >= 0
    chosen, share = skin.triangles[owner[covered]], weights[covered]

    def at_pixels(values: Floats) -> Floats:
        return np.asarray(np.einsum("ij,ij...->i...", share, values[chosen]))

    light = openness(points, skin.triangles)
    mouth, lids = _rings(skin, points)
    inner = _hidden_islands(skin, light)[skin.uv_corners[owner[covered], 0]]
    return Texels(covered, at_pixels(points), at_pixels(mouth), at_pixels(lids), at_pixels(light), inner)


def _hidden_islands(skin: Piece, light: Floats) -> NDArray[np.bool_]:
    """Whether each texture coordinate (k,) lies on an island that hardly sees light: mouth bag and eye sockets."""
    island = islands(skin.uv_corners, len(skin.uvs))
    seen = np.zeros(len(skin.uvs))
    seen[skin.uv_corners] = light[skin.triangles]
    return (np.bincount(island, weights=seen) / np.bincount(island) < 0.3)[island]


def _rings(skin: Piece, points: Floats) -> tuple[Floats, Floats]:
    """Edges from each vertex (n,) to the seam of the mouth, and to the seam of the nearer eye."""
    seams = [np.unique(seam) for seam in _seams(skin)]
    front = [seam for seam in seams if points[seam, 2].min() > 0.08 and len(seam) > 20]  # mouth and eyes
    mouth = [seam for seam in front if abs(points[seam, 0].mean()) < 0.01]
    eyes = [seam for seam in front if abs(points[seam, 0].mean()) >= 0.01]
    edges = np.concatenate([skin.triangles[:, [0, 1]], skin.triangles[:, [1, 2]], skin.triangles[:, [2, 0]]])
    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(len(points),) * 2).tocsr()

    def edges_to(chosen: list[Ints]) -> Floats:
        start = np.concatenate(chosen) if chosen else np.zeros(0, dtype=np.int32)
        far = np.full(len(points), 99.0)
        return dijkstra(graph, directed=False, unweighted=True, indices=start, min_only=True) if chosen else far

    return edges_to(mouth), edges_to(eyes)


def _seams(skin: Piece) -> list[Ints]:
    """The closed border lines of the largest island, each as vertices."""
    corners, count = skin.uv_corners, len(skin.uvs)
    island = islands(corners, count)
    vertex = np.zeros(count, dtype=np.int32)
    vertex[corners] = skin.triangles
    edges = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    unique, uses = np.unique(edges, axis=0, return_counts=True)
    border = unique[(uses == 1) & (island[unique[:, 0]] == np.bincount(island).argmax())]
    links = coo_array((np.ones(len(border)), (border[:, 0], border[:, 1])), shape=(count, count))
    label = connected_components(links, directed=False)[1]
    return [vertex[label == line] for line in np.unique(label[border[:, 0]])]


def _lips(texels: Texels) -> Floats:
    """The red of the lips: six to seven rings around the mouth's line, four at its corners."""
    across = np.clip(np.abs(texels.places[:, 0]) / 0.0255, 0.0, 1.0)
    limit = 4.4 + 2.6 * (1.0 - across**3)
    lips = _smooth(texels.lip_rings, limit + 0.9, limit - 0.7)
    return np.where(texels.inner, np.where(texels.lip_rings < texels.lid_rings, 0.75, 0.35), lips)


def _blush(texels: Texels) -> Floats:
    total = np.zeros(len(texels.places))
    for (x, y), radius, strength in BLUSH:
        off = np.hypot(np.abs(texels.places[:, 0]) - x, texels.places[:, 1] - y) / radius
        total += strength * np.exp(-(off**2))
    front = _smooth(texels.places[:, 2], 0.0, 0.05)
    return np.clip(total * front, 0.0, 1.0) * ~texels.inner


def _light(texels: Texels) -> Floats:
    """What cavities, lash lines and pores leave of the light."""
    cavity = 0.55 + 0.45 * np.clip(texels.light, 0.0, 1.0) ** 0.8
    lash_line = 1.0 - 0.45 * _smooth(texels.lid_rings, 1.8, 0.2)
    rng = np.random.default_rng(SEED)
    grain = rng.standard_normal((SIZE, SIZE))
    pores = (grain + np.roll(grain, 1, 0) + np.roll(grain, 1, 1))[texels.covered] / 3.0
    outer = cavity * lash_line * (1.0 + 0.018 * pores)
    return np.clip(np.where(texels.inner, 0.35, outer), 0.0, 1.0)


def _grown(picture: Floats, covered: NDArray[np.bool_]) -> Floats:
    """The picture with each island's border carried outwards by PADDING pixels."""
    picture, covered = picture.copy(), covered.copy()
    for _ in range(PADDING):
        for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
            source = np.roll(covered, step, axis)
            fresh = source & ~covered
            picture[fresh] = np.roll(picture, step, axis)[fresh]
            covered |= fresh
    return picture


def _smooth(values: Floats, low: Floats | float, high: Floats | float) -> Floats:
    """0 at `low`, 1 at `high`, with a soft step between; the two may stand in either order."""
    share = np.clip((values - low) / (np.asarray(high) - low), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))
