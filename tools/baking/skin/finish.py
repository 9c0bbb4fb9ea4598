"""Paints the skin's response to light: oiliness (specular), translucency, and fine hollows (cavity)."""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import cloud_noise
from tools.baking.skin.relief import skin_height
from tools.baking.skin.texels import Texels, blob, ramp

SEED = 5501


def paint_finish(texels: Texels) -> Floats:
    """The layer `finish` (SIZE, SIZE, 4): oil, thinness, fine hollows (1 is level), and the mottling of the blood."""
    layers = np.stack([oil(texels), thinness(texels), hollows(texels), mottling(texels)], axis=1)
    layers[texels.inner] = [0.6, 0.3, 1.0, 0.5]
    return texels.spread(layers)


def oil(texels: Texels) -> Floats:
    """How oily the skin is (n,), 0 to 1: most on the nose, least at the sides and on the neck."""
    places = texels.places
    shine = 0.30 + 0.55 * blob(places, (0.0, -0.02, 0.16), (0.013, 0.032, 0.03))
    shine += 0.35 * blob(places, (0.0, 0.045, 0.14), (0.036, 0.026, 0.03))
    shine += 0.3 * blob(places, (0.043, -0.014, 0.125), (0.016, 0.012, 0.03))
    shine += 0.25 * blob(places, (0.0, -0.095, 0.14), (0.014, 0.01, 0.03))
    shine += 0.25 * blob(places, (0.032, 0.008, 0.14), (0.014, 0.006, 0.03))
    shine -= 0.25 * blob(places, (0.01, -0.054, 0.15), (0.022, 0.011, 0.04))
    patchy = 0.75 + 0.5 * cloud_noise(places, 0.009, seed=SEED)
    return np.asarray(np.clip(shine * patchy, 0.0, 1.0))


def thinness(texels: Texels) -> Floats:
    """How much light goes through (n,), 0 to 1: ears, wings and tip of the nose, lids and lips."""
    places = texels.places
    ears = ramp(np.abs(places[:, 0]), 0.072, 0.078)
    wings = blob(places, (0.015, -0.04, 0.15), (0.008, 0.008, 0.016))
    tip = 0.6 * blob(places, (0.0, -0.037, 0.166), (0.009, 0.009, 0.012))
    lids = 0.5 * ramp(texels.lid_rings, 9.0, 2.0)
    lips = 0.5 * ramp(texels.lip_rings, 7.0, 4.0)
    return np.asarray(np.clip(np.maximum.reduce([ears, wings, tip, lids, lips, np.full(len(ears), 0.12)]), 0.0, 1.0))


def hollows(texels: Texels) -> Floats:
    """What pores and furrows leave of the light (n,), 1 where the skin is level."""
    return np.asarray(np.clip(1.0 + skin_height(texels) / 0.00022, 0.35, 1.0))


def mottling(texels: Texels) -> Floats:
    """Where the blood shows (n,), around 0.5: the colour of living skin is never even."""
    places = texels.places
    patches = cloud_noise(places, 0.014, seed=SEED + 3, octaves=4)
    return np.asarray(np.clip(0.5 + 1.5 * (patches - 0.5), 0.0, 1.0))
