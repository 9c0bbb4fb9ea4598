"""Fine relief of the skin as slopes: pores, the net of the skin, the furrows of the lips, and the lines of age.

A slope is the rise per way along the picture's columns and along its rows, on the surface of the generic head, so a
shader can tilt any face's normal by it, and slopes of several layers add up.
"""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import cell_noise, cloud_noise, strand_noise, value_noise
from tools.baking.skin.texels import SIZE, Texels, blob, ramp
from tools.baking.skin.wrinkles import fine_net, lines_of_age

STEEPEST = 0.8  # the slope that a picture's 0 and 1 stand for; 0.5 is level
SEED = 2719


def paint_relief(texels: Texels) -> Floats:
    """The layer `relief` (SIZE, SIZE, 4): slopes of the skin at rest, slopes of the lines of age."""
    deep, _ = lines_of_age(texels)
    outer = ~texels.inner
    young = slopes(texels, skin_height(texels) * outer)
    old = slopes(texels, (fine_net(texels) - deep) * outer)
    return np.asarray(np.clip(0.5 + 0.5 * np.concatenate([young, old], axis=2) / STEEPEST, 0.0, 1.0))


def skin_height(texels: Texels) -> Floats:
    """The height (n,) in metres that pores, the skin's net and the lips' furrows add to the generic head."""
    places = texels.places
    coarse = coarseness(places)
    first, _, own = cell_noise(places, 0.00155, seed=SEED)
    pores = -ramp(first, 0.42, 0.12) * (0.4 + 0.6 * own) * 0.00016 * coarse
    near, next_near, _ = cell_noise(places, 0.0019, seed=SEED + 4)
    net = ramp(next_near - near, 0.0, 0.3) * 0.00005 * (0.5 + 0.5 * coarse)
    swell = (cloud_noise(places, 0.006, seed=SEED + 8) - 0.5) * 0.00026
    lips = ramp(texels.lip_rings, 7.5, 5.5)
    return np.asarray((pores + net + swell) * (1.0 - lips) + lip_furrows(texels) * lips)


def coarseness(places: Floats) -> Floats:
    """How coarse the pores are (n,), 0 to 1: nose, inner cheeks, chin and forehead more than lids and neck."""
    nose = blob(places, (0.008, -0.03, 0.155), (0.018, 0.022, 0.03))
    cheeks = blob(places, (0.028, -0.032, 0.135), (0.022, 0.022, 0.03))
    forehead = blob(places, (0.0, 0.045, 0.14), (0.045, 0.03, 0.03))
    chin = blob(places, (0.0, -0.095, 0.14), (0.025, 0.016, 0.03))
    return np.asarray(np.clip(0.3 + 0.7 * nose + 0.6 * cheeks + 0.4 * forehead + 0.4 * chin, 0.0, 1.0))


def lip_furrows(texels: Texels) -> Floats:
    """The height (n,) in metres of the lips: furrows that run from the mouth's line outwards."""
    places = texels.places
    fan = np.stack([places[:, 0] * 3.0, np.sign(places[:, 1] + 0.0675) * 1.2, np.zeros(len(places))], axis=1)
    flow = fan / np.linalg.norm(fan + 1e-9, axis=1, keepdims=True) * 0.005
    flow[:, 0] *= 4.0 * np.abs(places[:, 0]) / 0.025
    broad = strand_noise(places, flow, 0.0011, seed=SEED + 12)
    patch = 0.5 + 0.5 * value_noise(places, 0.005, seed=SEED + 13)
    return np.asarray((broad - 0.5) * 0.0003 * patch)


def slopes(texels: Texels, height: Floats) -> Floats:
    """The slopes (SIZE, SIZE, 2) of a height (n,) in metres, along columns and rows.

    texels: of the skin, n of them.
    """
    picture = texels.spread(height)
    places = texels.spread(texels.places)
    rises = [_central(picture, axis) for axis in (1, 0)]
    ways = [_central(places, axis) for axis in (1, 0)]
    first, mixed, second = (np.einsum("ijk,ijk->ij", a, b) for a, b in ((ways[0],) * 2, ways, (ways[1],) * 2))
    area = np.maximum(first * second - mixed**2, 1e-18)
    found = np.stack([rises[0] * np.sqrt(second / area), rises[1] * np.sqrt(first / area)], axis=2)
    found[~texels.covered] = 0.0
    return texels.spread(found[texels.covered])


def _central(values: Floats, axis: int) -> Floats:
    """Central differences per pixel; values (SIZE, SIZE, ...)."""
    assert len(values) == SIZE
    return np.asarray((np.roll(values, -1, axis) - np.roll(values, 1, axis)) / 2.0)
