"""The skin's layers: pictures on the head's texture layout that say where lips, brows, pores, fur and all else lie.

Painted by this code from the generic head alone, so that every face can wear them in its own colours and strengths.
The layers lie one below the other in one picture, in the order of LAYERS:
mask = lips (0 outside, 0.5 at their border, 1 at the mouth's line), brows (hair by hair: the thicker the brow a hair
belongs to, the fainter it is), blush, light that is left (1 = untouched): cavities and lash lines;
marks, patches, relief, finish, pelt, level_folds, upright_folds: see marks.py, coat.py, relief.py, finish.py, pelt.py,
folds.py.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tools.baking.heads.basemesh import Floats
from tools.baking.heads.head import Piece
from tools.baking.package import BakeError
from tools.baking.skin.brows import brow_cover
from tools.baking.skin.coat import paint_patches
from tools.baking.skin.finish import paint_finish
from tools.baking.skin.folds import paint_level_folds, paint_upright_folds
from tools.baking.skin.marks import paint_marks
from tools.baking.skin.pelt import paint_pelt
from tools.baking.skin.relief import paint_relief
from tools.baking.skin.texels import Texels, ramp, texels_of

SEED = 1993
# Blush: centre on the generic head (metres; x is mirrored), radius (metres), strength.
BLUSH = (
    ((0.043, -0.030), 0.019, 0.85),  # cheeks
    ((0.000, -0.036), 0.010, 0.55),  # tip of the nose
    ((0.000, -0.098), 0.014, 0.25),  # chin
    ((0.030, 0.004), 0.013, 0.22),  # upper lids
    ((0.082, -0.010), 0.022, 0.45),  # ears
)


def paint_layers(skin: Piece, points: Floats, layout: Floats) -> NDArray[np.uint8]:
    """The layers (SIZE * 8, SIZE, 4) of the generic head: points (n, 3) metres, layout (k, 2).

    skin: its triangles and texture corners.
    """
    texels = texels_of(skin, points, layout)
    return np.concatenate([as_bytes(name, paint(texels)) for name, paint in LAYERS.items()])


def as_bytes(name: str, picture: Floats) -> NDArray[np.uint8]:
    """A picture of numbers from 0 to 1 in steps of 1/255; BakeError where one lies outside.

    name: of the layer, for the message; picture: of any shape.
    """
    low = float(picture.min())
    high = float(picture.max())
    if not (low >= 0.0 and high <= 1.0):
        raise BakeError(f"the layer {name} holds {low} to {high}, expected 0 to 1; mend what paints it.")
    return np.rint(picture * 255.0).astype(np.uint8)


def paint_mask(texels: Texels) -> Floats:
    """The layer `mask` (SIZE, SIZE, 4): lips, brows, blush, light that is left."""
    brows = brow_cover(texels.places, seed=SEED)
    picture = texels.spread(np.stack([_lips(texels), brows, _blush(texels), _light(texels)], axis=1))
    picture[texels.spread(np.ones(len(brows))) == 0.0, 3] = 1.0
    return picture


LAYERS: Mapping[str, Callable[[Texels], Floats]] = {
    "mask": paint_mask,
    "marks": paint_marks,
    "patches": paint_patches,
    "relief": paint_relief,
    "finish": paint_finish,
    "pelt": paint_pelt,
    "level_folds": paint_level_folds,
    "upright_folds": paint_upright_folds,
}
"""The layers in the order in which they lie in the picture, and who paints them."""


def _lips(texels: Texels) -> Floats:
    """The lips, six to seven rings around the mouth's line, four at its corners: 0.5 at their border, 1 at the line."""
    across = np.clip(np.abs(texels.places[:, 0]) / 0.0255, 0.0, 1.0)
    limit = 4.4 + 2.6 * (1.0 - across**3)
    inwards = np.clip(1.0 - texels.lip_rings / limit, 0.0, 1.0)
    lips = 0.5 * ramp(texels.lip_rings, limit + 0.9, limit - 0.7) + 0.5 * inwards**0.7
    return np.where(texels.inner, np.where(texels.lip_rings < texels.lid_rings, 0.75, 0.35), lips)


def _blush(texels: Texels) -> Floats:
    total = np.zeros(len(texels.places))
    for (x, y), radius, strength in BLUSH:
        off = np.hypot(np.abs(texels.places[:, 0]) - x, texels.places[:, 1] - y) / radius
        total += strength * np.exp(-(off**2))
    front = ramp(texels.places[:, 2], 0.0, 0.05)
    return np.clip(total * front, 0.0, 1.0) * ~texels.inner


def _light(texels: Texels) -> Floats:
    """What cavities and lash lines leave of the light."""
    cavity = 0.55 + 0.45 * np.clip(texels.light, 0.0, 1.0) ** 0.8
    lash_line = 1.0 - 0.45 * ramp(texels.lid_rings, 1.8, 0.2)
    return np.clip(np.where(texels.inner, 0.35, cavity * lash_line), 0.0, 1.0)
