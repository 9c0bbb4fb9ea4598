"""Paints large marks of the skin: the patches of a coat, its dark marks, make-up, and the paint of a mask."""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import cloud_noise, strand_noise, value_noise
from tools.baking.skin.texels import Texels, blob, ramp

SEED = 4409
ALWAYS = 0.5  # stripes end here; above it lie the marks that every coat has
PATCH = 0.7  # a coat's patch ends here; above it begins the leather of the nose, which always lies inside one


def paint_patches(texels: Texels) -> Floats:
    """The layer `patches` (SIZE, SIZE, 4): patch and leather, dark marks, make-up, a mask's paint."""
    layers = np.stack([patches(texels), dark_marks(texels), make_up(texels), mask_paint(texels)], axis=1)
    layers[texels.inner] = 0.0
    return texels.spread(layers)


def patches(texels: Texels) -> Floats:
    """The second colour of a coat (n,), up to 0.7: muzzle, chin, throat, a blaze; the nose's leather reaches 1."""
    places = texels.places
    torn = (cloud_noise(places, 0.008, seed=SEED) - 0.5) * 0.5
    muzzle = blob(places, (0.012, -0.055, 0.145), (0.027, 0.027, 0.045))
    throat = blob(places, (0.0, -0.115, 0.11), (0.035, 0.03, 0.05))
    blaze = blob(places, (0.0, 0.01, 0.15), (0.0085, 0.055, 0.05))
    brows = 0.55 * blob(places, (0.028, 0.024, 0.14), (0.007, 0.004, 0.03))
    patch = ramp(np.maximum(np.maximum(muzzle, throat), np.maximum(blaze, brows)) + torn * 0.5, 0.3, 0.55)
    bare = _leather(places)
    patch = np.maximum(patch, ramp(bare, 0.04, 0.2))
    leather = ramp(bare, 0.35, 0.5)
    return np.asarray(np.maximum(PATCH * patch, leather))


def _leather(places: Floats) -> Floats:
    """Where a nose is bare (n,): tip and wings."""
    tip = blob(places, (0.0, -0.037, 0.165), (0.0135, 0.0105, 0.02))
    wings = 0.75 * blob(places, (0.0095, -0.040, 0.158), (0.0085, 0.0085, 0.016))
    return np.asarray(np.maximum(tip, wings))


def dark_marks(texels: Texels) -> Floats:
    """Dark marks of a coat (n,): stripes up to 0.5, above it ears and rims of the eyes."""
    places = texels.places
    x, y, z = np.abs(places[:, 0]), places[:, 1], places[:, 2]
    wave = (cloud_noise(places, 0.018, seed=SEED + 5) - 0.5) * 0.9
    crown = ramp(y, 0.02, 0.035) * ramp(x, 0.07, 0.045)
    forehead = np.sin((x / 0.0085 + wave) * np.pi) * crown
    cheek = np.sin(((y - 0.35 * x) / 0.0095 + wave) * np.pi) * ramp(x, 0.036, 0.05) * ramp(y, 0.012, 0.0)
    rough = (value_noise(places, 0.003, seed=SEED + 6) - 0.5) * 0.6
    stripes = ALWAYS * ramp(np.maximum(forehead, cheek) + rough, 0.25, 0.75)
    ears = 0.9 * ramp(x, 0.071, 0.078) * ramp(z, 0.1, 0.08)
    rims = ramp(texels.lid_rings, 3.2, 1.2)
    corner = blob(places, (0.018, -0.006, 0.138), (0.005, 0.009, 0.02))
    return np.asarray(np.maximum(np.maximum(stripes, ears), np.maximum(rims, 0.8 * corner)))


def make_up(texels: Texels) -> Floats:
    """Make-up of the eyes (n,), 0 to 1: a line along the lids, a shadow over the upper one."""
    places, rings = texels.places, texels.lid_rings
    upper = ramp(places[:, 1], -0.001, 0.002)
    wing = ramp(np.abs(places[:, 0]), 0.02, 0.042)
    line = ramp(rings, 2.3 + 1.2 * wing * upper, 0.6) * (0.4 + 0.6 * upper)
    shadow = 0.42 * ramp(rings, 11.0, 3.0) * upper * (0.45 + 0.55 * wing) * ramp(places[:, 1], 0.017, 0.009)
    return np.asarray(np.maximum(line, shadow) * ramp(places[:, 2], 0.1, 0.12))


def mask_paint(texels: Texels) -> Floats:
    """What is painted on a Noh mask in ink (n,), 0 to 1: high brows, parted hair, three loose strands."""
    places = texels.places
    x, y, z = np.abs(places[:, 0]), places[:, 1], places[:, 2]
    brush = strand_noise(places, np.broadcast_to([0.006, 0.002, 0.0], places.shape), 0.0008, seed=SEED + 9)
    brow = ramp(blob(places, (0.029, 0.051, 0.14), (0.0165, 0.0095, 0.06)), 0.2, 0.7) * (0.85 + 0.2 * brush)
    edge = 0.081 - 18.0 * np.clip(x - 0.01, 0.0, 1.0) ** 2 + 0.004 * ramp(x, 0.006, 0.0)
    parting = ramp(x, 0.0004, 0.0014)
    hair = ramp(y, edge - 0.0007, edge + 0.0007) * parting
    behind = ramp(z, 0.066, 0.062) * ramp(y, -0.05, -0.045)
    strands = sum(
        ramp(np.abs(y - (edge - down) + 0.25 * down), 0.0011, 0.0005) * ramp(x, 0.012 + 3 * down, 0.02 + 3 * down)
        for down in (0.0035, 0.007, 0.0105)
    )
    ears = np.maximum(ramp(x, 0.0735, 0.0715), ramp(y, 0.024, 0.03))
    return np.asarray(
        np.clip(np.maximum(np.maximum(0.9 * brow, hair), np.maximum(behind, 0.9 * strands)) * ears, 0.0, 1.0)
    )
