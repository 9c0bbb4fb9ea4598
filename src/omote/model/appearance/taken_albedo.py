"""Takes the colours of a scan over to a face fitted to it, and carries them on where the scan saw nothing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_closing, binary_opening, distance_transform_edt

from omote.arrays import Floats, Mask, Values
from omote.geometry import mesh
from omote.geometry.ramp import smooth_ramp
from omote.model.albedo import Albedo, Light, SkinAtlas, decode_light, encode_light
from omote.model.appearance.scan_colours import TURN, ScanColours, choose_nearest, nearest_faces, place_colours
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity

NEAR = 0.003
"""Metres from the fitted face within which a scan's surface is that skin."""
LEVEL = 0.5
"""Cosine between the normals of both beyond which it is (60 degrees)."""
FEATHER = 10 / 1024
"""Of a side, the width of the border in which what was seen passes over into what is filled."""
SLOW = 3
"""Times that the ratio is halved before it is carried on: what is finer than 8 texels stays where it was seen."""
_DARKEST = np.float32(0.004)  # linear light below which a ratio says nothing
_MOST = np.float32(3.0)  # of the logarithm of a ratio: 20 times as bright or as dark, pale skin over dark


def pull_push(values: Floats, weights: Floats, /) -> Floats:
    """Fills a square picture (k, k, c), k a power of two, where its weights (k, k), 0 to 1, are not 1.

    What is known stays; the farther away it is, the larger the neighbourhood whose mean is filled in (S. Gortler et
    al., "The Lumigraph", 1996). A picture of which nothing is known becomes 0.

    values (k, k, c), weights (k, k): the picture, and where it is known.
    """
    if len(values) == 1:
        return np.where(weights[..., None] > 0.0, values, np.float32(0.0))
    summed = halve(weights[..., None])
    means = halve(values * weights[..., None]) / np.maximum(summed, np.float32(1e-9))
    below = pull_push(means.astype(np.float32), np.minimum(4.0 * summed[..., 0], 1.0).astype(np.float32))
    return weights[..., None] * values + (1.0 - weights[..., None]) * double(below)


def double(values: Floats, /) -> Floats:
    """A picture (k, k, c) at twice the size, linear between the middles of its texels."""
    rows = _double_rows(values)
    return np.ascontiguousarray(_double_rows(rows.swapaxes(0, 1)).swapaxes(0, 1))


def _double_rows(values: Floats) -> Floats:
    above = np.concatenate([values[:1], values[:-1]])
    below = np.concatenate([values[1:], values[-1:]])
    pairs = np.stack([0.25 * above + 0.75 * values, 0.75 * values + 0.25 * below], axis=1)
    return pairs.reshape(2 * len(values), *values.shape[1:]).astype(np.float32)


def halve(values: Floats, /) -> Floats:
    """A picture (k, k, c) at half the size: means of two by two texels."""
    return 0.25 * (values[::2, ::2] + values[1::2, ::2] + values[::2, 1::2] + values[1::2, 1::2])


@dataclass(frozen=True, eq=False)
class TakenAlbedo:
    """A picture of a person's skin, and how far each texel was seen, (k, k) uint8: 255 on the scan, 0 filled in."""

    albedo: Albedo
    seen: NDArray[np.uint8]


def take_albedo(
    space: ParameterSpace, atlas: SkinAtlas, face: Face, scan: Scan, placement: Similarity, painted: NDArray[np.uint8]
) -> TakenAlbedo:
    """Takes the colours of a scan over to the skin of a face that was fitted to it.

    Parameters
    ----------
    space : ParameterSpace
        Of the face; its inner skin (sockets of the eyes, lining of the mouth) stays uncovered.
    atlas : SkinAtlas
        How the skin lies on its texture.
    face : Face
        Fitted to the scan.
    scan : Scan
        With a texture, or a colour for each point; light that fell on it stays in the picture.
    placement : Similarity
        From the scan to the face.
    painted : array of uint8, (k, k, 3)
        The face's painted skin in sRGB, without brows, freckles and the like: what is filled where nothing was seen,
        in the scan's hue and light. k is 1024 or 2048.

    Returns
    -------
    TakenAlbedo
        The picture, and what of it was seen.

    Raises
    ------
    ValueError
        Where the scan has no colours, or none of it lies on the face.
    """
    side = len(painted)
    texels = place_texels(space, atlas, face, side)
    colours = place_colours(scan, placement, face.positions.astype(np.float64))
    light, seen = _look_up(colours, texels)
    if not seen.any():
        raise ValueError("no skin of the face lies on the scan; expected the placement that the face was fitted by")
    return complete_albedo(texels, light, seen, painted)


def complete_albedo(texels: Texels, light: Light, seen: Mask, painted: NDArray[np.uint8], /) -> TakenAlbedo:
    """The picture of linear light (k, k, 3) where skin was seen (k, k), carried on by the painted skin (k, k, 3)
    elsewhere.

    texels: where each lies; light (k, k, 3): linear; seen (k, k): where; painted (k, k, 3): sRGB.
    """
    share = _feathered(seen, FEATHER * len(painted))
    filled = _carried_on(light, share, decode_light(painted))
    whole = share[..., None] * light + (1.0 - share[..., None]) * filled
    cover = np.rint(255.0 * texels.outer)
    pixels = np.concatenate([encode_light(whole), cover[..., None].astype(np.uint8)], axis=2)
    return TakenAlbedo(Albedo(pixels), np.rint(255.0 * share * texels.outer).astype(np.uint8))


@dataclass(frozen=True, eq=False)
class Texels:
    """Where each texel lies on the face: places, normals (k, k, 3); used (k, k); outer, 0 on inner skin, 1 outside."""

    places: Values
    normals: Values
    used: Mask
    outer: Values


def place_texels(space: ParameterSpace, atlas: SkinAtlas, face: Face, side: int, /) -> Texels:
    """Where the texels of a face's skin lie on it.

    space, atlas: the skin and its texture; face: whose; side: texels along the texture.
    """
    positions = face.positions.astype(np.float64)
    normals = mesh.normals(positions.astype(np.float64), space.triangles)
    places, turns = (
        np.stack([atlas.spread(values[:, axis], side) for axis in range(3)], axis=2) for values in (positions, normals)
    )
    turns /= np.maximum(np.linalg.norm(turns, axis=2, keepdims=True), 1e-9)
    used = atlas.spread(np.ones(len(positions)), side) > 0.0
    outside = np.zeros(len(positions))
    outside[np.unique(space.skin_triangles)] = 1.0
    outer = smooth_ramp(0.5, 1.0, atlas.spread(outside, side))
    return Texels(places, turns, used, np.where(used, outer, 1.0))


def _look_up(colours: ScanColours, texels: Texels) -> tuple[Light, Mask]:
    """Linear light of every texel (k, k, 3), and where it is that skin's own."""
    side = len(texels.used)
    around = np.array([0, 1])
    coarse = texels.used[::2, ::2]
    nearest = np.full(coarse.shape, -1)
    places = texels.places[::2, ::2][coarse]
    normals = texels.normals[::2, ::2][coarse]
    nearest[coarse] = nearest_faces(colours, places, normals, within=float(np.hypot(2.0 * NEAR, TURN)))
    rows, columns = np.nonzero(texels.used & (texels.outer > 0.0))
    most = side // 2 - 1
    down, right = (np.minimum(index[:, None] // 2 + around, most) for index in (rows, columns))
    candidates = np.stack([nearest[down[:, i], right[:, j]] for i in around for j in around], axis=1)
    places = texels.places[rows, columns]
    normals = texels.normals[rows, columns]
    faces, shares, away = choose_nearest(colours, places, normals, candidates)
    turned = (colours.normals[faces] * normals).sum(axis=1)
    good = (away < NEAR) & ((turned > LEVEL) | (not colours.normals.any()))
    light = np.zeros((side, side, 3), np.float32)
    seen = np.zeros((side, side), np.bool_)
    light[rows, columns] = colours.light(faces, shares)
    seen[rows, columns] = good
    return light, seen


def _feathered(seen: Mask, width: float) -> Light:
    """How far each texel is what was seen, (k, k): specks and pinholes apart, rising over a border of its own."""
    whole = binary_opening(binary_closing(seen, iterations=2), iterations=3) & seen
    return smooth_ramp(0.0, 1.0, distance_transform_edt(whole) / width).astype(np.float32)


def _carried_on(light: Light, share: Light, painted: Light) -> Light:
    """The painted skin in the hue and light of what was seen nearest."""
    ratio = np.log(np.maximum(light, _DARKEST)) - np.log(np.maximum(painted, _DARKEST))
    slow = ratio * share[..., None]
    weights = share[..., None]
    for _ in range(SLOW):
        slow = halve(slow)
        weights = halve(weights)
    means = slow / np.maximum(weights, np.float32(1e-9))
    even = pull_push(np.minimum(np.maximum(means, -_MOST), _MOST), np.minimum(4.0 * weights[..., 0], 1.0))
    for _ in range(SLOW):
        even = double(even)
    return painted * np.exp(even)
