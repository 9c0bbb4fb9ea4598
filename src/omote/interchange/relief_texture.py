"""Paints what the skin's relief does to light as normal textures: pores, lines of age, and the folds of expressions.

As the stage's shaders have it (skin_shaders.ts: `fine`; fold_shaders.ts), in the tangent space of glTF and USD: x along
the columns of the texture, y up along its rows.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

from omote.arrays import Picture, Points
from omote.geometry.ramp import smooth_ramp
from omote.geometry.texture import MARGIN
from omote.interchange.skin_texture import Canvas, grown_of, lips_of, paint_skin
from omote.model.albedo import decode_light, encode_light
from omote.model.cast import Look

Values = NDArray[Any]

STEEPEST = 0.8
"""The slope that 0 and 1 of the layer `relief` stand for (tools/baking/skin/relief.py)."""
STEEPEST_FOLD = 1.25
RANKS = 1.5
"""The slope that 0 and 1 of a layer of folds stand for, and the rank that 1 does (tools/baking/skin/folds.py)."""
DEEPEST = 1.2
"""How deep a fold is where its place is pressed the most, before age."""
GROOVE = np.array([0.60, 0.47, 0.42], np.float32)
GROOVE_OF_FUR = np.array([0.5, 0.5, 0.5], np.float32)
"""What is left of the light in a groove of bare skin, and under fur."""
COVERED = 0.22
"""The slope from which on a picture of folds covers the skin wholly."""
_LAYERS = ("level_folds", "upright_folds")


class Folds(NamedTuple):
    """The folds of a look as deep as they get. picture (k, k, 4): the skin with their grooves, sRGB, and how much it
    covers; depth (2, k, k): how deep lines that run level and upright are;
    turn (2, k, k, 2): the way across them, level and upright parts."""

    picture: Picture
    depth: Values
    turn: Values


def paint_relief(canvas: Canvas, look: Look, /) -> Picture:
    """Paints the normals (k, k, 3) of a look's pores and lines of age.

    canvas: of the cast; look: whose skin.
    """
    return encode_normals(_fine_slopes(canvas, look))


def paint_folds(canvas: Canvas, look: Look, /) -> Folds:
    """Paints the folds of a look as deep as expressions press them at most.

    canvas: of the cast; look: whose skin.
    """
    lips, _ = lips_of(canvas, look)
    fur = look.fur * (1.0 - lips)
    bare = (1.0 - grown_of(canvas) * look.scalp) * (1.0 - look.lacquer) * (1.0 - 0.6 * lips)
    steep = np.zeros((*canvas.hair.shape, 2), np.float32)
    groove = np.zeros_like(canvas.hair)
    depths = list[Values]()
    ways = list[Values]()
    for name in _LAYERS:
        layer = canvas.layers[name]
        rank = layer[..., 2] * RANKS
        aged = (0.42 + 0.73 * np.sqrt(look.age)) * smooth_ramp(-0.35, 0.12, look.age - rank)
        depth = DEEPEST * (aged + (1.3 - aged) * fur) * bare
        turn = (layer[..., 3] - 0.5) * np.pi
        way = np.stack(
            [np.cos(turn), np.sin(turn)] if name == "upright_folds" else [-np.sin(turn), np.cos(turn)], axis=-1
        )
        slope = (layer[..., 0] - 0.5) * 2.0 * STEEPEST_FOLD * depth
        steep += way * slope[..., None]
        groove = np.maximum(groove, layer[..., 1] * depth)
        depths.append(layer[..., 1] * depth)
        ways.append(way)
    steep /= np.sqrt(1.0 + (steep**2).sum(axis=-1, keepdims=True))  # softly below 1
    groove = np.clip(groove, 0.0, 1.0)[..., None]
    left = 1.0 + (GROOVE + (GROOVE_OF_FUR - GROOVE) * fur[..., None] - 1.0) * groove
    skin = encode_light(decode_light(_at_size(paint_skin(canvas, look), len(canvas.hair))) * left)
    cover = np.clip(np.maximum(groove, np.linalg.norm(steep, axis=-1, keepdims=True) / COVERED), 0.0, 1.0)
    alpha = np.rint(255.0 * cover).astype(np.uint8)
    far = ~binary_dilation(alpha[..., 0] > 0, iterations=MARGIN)
    skin[far] = skin[~far].mean(axis=0) if not far.all() else 0  # what nobody sees takes no bytes
    return Folds(np.concatenate([skin, alpha], axis=2), np.stack(depths), np.stack(ways))


def encode_normals(slopes: Values, /) -> Picture:
    """The normals (k, k, 3), 255 for 1, of a surface that rises by slopes (k, k, 2) along columns and down rows."""
    x, y = -slopes[..., 0], slopes[..., 1]
    normals = np.stack([x, y, np.ones_like(x)], axis=-1) / np.sqrt(1.0 + x * x + y * y)[..., None]
    encoded: Picture = np.rint(127.5 + 127.5 * normals).astype(np.uint8)
    return encoded


def _fine_slopes(canvas: Canvas, look: Look) -> Values:
    lips, _ = lips_of(canvas, look)
    slopes = (canvas.layers["relief"] - np.float32(0.5)) * np.float32(2.0 * STEEPEST)
    young = slopes[..., :2] * np.maximum(look.pores, 0.8 * lips)[..., None]
    old = slopes[..., 2:] * (look.age * (1.0 - 0.6 * lips))[..., None]
    bare = (1.0 - grown_of(canvas) * look.scalp) * (1.0 - look.fur * (1.0 - lips)) * (1.0 - look.lacquer)
    fine: Values = (2.0 * young + old) * bare[..., None]
    return fine


def tangents_of(points: Points, normals: Points, uv: Values, triangles: NDArray[np.integer], /) -> Values:
    """The tangents (n, 4) of a mesh as glTF has them: along the columns of its texture, and 1 where the cross product
    of normal and tangent goes up its rows, else -1.

    points, normals (n, 3), uv (n, 2), triangles (t, 3): of the mesh.
    """
    columns, rows = _texture_ways(points, uv, triangles)
    along = _unit(columns - normals * (normals * columns).sum(axis=1, keepdims=True))
    up = -(np.cross(normals, along) * rows).sum(axis=1, keepdims=True)
    return np.concatenate([along, np.where(up < 0.0, -1.0, 1.0)], axis=1)


def _texture_ways(points: Points, uv: Values, triangles: NDArray[np.integer]) -> tuple[Values, Values]:
    """Which way the columns and the rows of a texture go on at each vertex, unit vectors (n, 3) each."""
    first, second = (points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
    a, b = (uv[triangles[:, k]] - uv[triangles[:, 0]] for k in (1, 2))
    turn = np.sign(a[:, :1] * b[:, 1:] - a[:, 1:] * b[:, :1])
    ways = [(first * b[:, 1:] - second * a[:, 1:]) * turn, (second * a[:, :1] - first * b[:, :1]) * turn]
    totals = [np.zeros(points.shape), np.zeros(points.shape)]
    for total, way in zip(totals, ways, strict=True):
        for corner in range(3):
            np.add.at(total, triangles[:, corner], way)
    return _unit(totals[0]), _unit(totals[1])


def _unit(vectors: Points) -> Points:
    unit: Points = vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
    return unit


def _at_size(picture: Picture, side: int) -> Picture:
    """A picture as the mean of the texels that each texel of a smaller one covers."""
    times = len(picture) // side
    if times <= 1:
        return picture
    mean = picture.reshape(side, times, side, times, 3).mean(axis=(1, 3))
    smaller: Picture = np.rint(mean).astype(np.uint8)
    return smaller
