"""Paints large marks of the skin: what fur leaves bare, its dark rims, make-up, and the paint of a mask."""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import strand_noise
from tools.baking.skin.texels import Texels, blob, ramp

SEED = 4409


def paint_patches(texels: Texels) -> Floats:
    """The layer `patches` (SIZE, SIZE, 4): leather, dark rims, make-up, a mask's paint."""
    layers = np.stack([leather(texels), dark_rims(texels), make_up(texels), mask_paint(texels)], axis=1)
    layers[texels.inner] = 0.0
    return texels.spread(layers)


def leather(texels: Texels) -> Floats:
    """Where a muzzle is bare (n,), 0 to 1: tip and wings of the nose, and the line from it down to the lip."""
    places = texels.places
    tip = blob(places, (0.0, -0.037, 0.165), (0.0135, 0.0105, 0.02))
    wings = 0.75 * blob(places, (0.0095, -0.040, 0.158), (0.0085, 0.0085, 0.016))
    groove = 0.9 * blob(places, (0.0, -0.054, 0.16), (0.0014, 0.010, 0.02))
    return np.asarray(ramp(np.maximum.reduce([tip, wings, groove]), 0.3, 0.5))


def dark_rims(texels: Texels) -> Floats:
    """The dark skin along the openings of a face with fur (n,), 0 to 1: lids, the eyes' inner corners, lips."""
    places = texels.places
    lids = ramp(texels.lid_rings, 5.2, 2.8)
    corner = blob(places, (0.018, -0.006, 0.138), (0.004, 0.006, 0.02))
    lips = ramp(texels.lip_rings, 3.2, 1.6)
    return np.asarray(np.maximum.reduce([lids, 0.8 * corner, lips]))


def make_up(texels: Texels) -> Floats:
    """Make-up of the eyes (n,), 0 to 1: a line along the lids, a shadow over the upper one."""
    places = texels.places
    rings = texels.lid_rings
    upper = ramp(places[:, 1], -0.001, 0.002)
    wing = ramp(np.abs(places[:, 0]), 0.02, 0.042)
    line = ramp(rings, 2.3 + 1.2 * wing * upper, 0.6) * (0.4 + 0.6 * upper)
    shadow = 0.42 * ramp(rings, 11.0, 3.0) * upper * (0.45 + 0.55 * wing) * ramp(places[:, 1], 0.017, 0.009)
    return np.asarray(np.maximum(line, shadow) * ramp(places[:, 2], 0.1, 0.12))


_DOWN = np.array([0.0, -0.010, -0.003])  # metres: as long as the strands of a nape are seen
# The outline of an ear from the side, an ellipse on the generic head: its middle's height and depth, half its length
# and width (metres), and how far its upper end lies behind its lower one (radians).
_EAR_MIDDLE = (-0.0240, 0.0495)
_EAR_HALVES = (0.0250, 0.0190)
_EAR_LEAN = 0.2


def _off_the_ear(places: Floats) -> Floats:
    """How far each place lies from the middle of an ear as seen from the side (n,), 1 on its outline."""
    up = places[:, 1] - _EAR_MIDDLE[0]
    ahead = places[:, 2] - _EAR_MIDDLE[1]
    along = np.cos(_EAR_LEAN) * up - np.sin(_EAR_LEAN) * ahead
    across = np.sin(_EAR_LEAN) * up + np.cos(_EAR_LEAN) * ahead
    return np.asarray(np.hypot(along / _EAR_HALVES[0], across / _EAR_HALVES[1]))


def mask_paint(texels: Texels) -> Floats:
    """What is painted on a Noh mask in ink (n,), 0 to 1: high brows, parted hair, three loose strands."""
    places = texels.places
    x, y, z = np.abs(places[:, 0]), places[:, 1], places[:, 2]
    brush = strand_noise(places, np.broadcast_to([0.006, 0.002, 0.0], places.shape), 0.0008, seed=SEED + 9)
    brow = ramp(blob(places, (0.029, 0.051, 0.14), (0.0165, 0.0095, 0.06)), 0.2, 0.7) * (0.85 + 0.2 * brush)
    edge = 0.081 - 18.0 * np.clip(x - 0.01, 0.0, 1.0) ** 2 + 0.004 * ramp(x, 0.006, 0.0)
    parting = ramp(x, 0.0004, 0.0014)
    hair = ramp(y, edge - 0.0007, edge + 0.0007) * parting
    strokes = strand_noise(places, np.broadcast_to(_DOWN, places.shape), 0.0012, seed=SEED + 11) - 0.5
    nape = -0.062 + 9.0 * x**2 + 0.010 * strokes
    behind = ramp(z, 0.066, 0.062) * ramp(y, nape - 0.005, nape + 0.012)  # a brush that runs dry
    strands = sum(
        ramp(np.abs(y - (edge - down) + 0.25 * down), 0.0011, 0.0005) * ramp(x, 0.012 + 3 * down, 0.02 + 3 * down)
        for down in (0.0035, 0.007, 0.0105)
    )
    skull = 0.0725 + 0.005 * ramp(z, 0.048, 0.03)  # behind the ears it is as wide as they are before
    skull = skull + 0.0022 * ramp(y, -0.006, 0.0)  # above the ear's root it bulges
    ears = np.maximum(ramp(x, skull + 0.001, skull - 0.001), ramp(_off_the_ear(places), 1.0, 1.06))
    return np.asarray(
        np.clip(np.maximum(np.maximum(0.9 * brow, hair), np.maximum(behind, 0.9 * strands)) * ears, 0.0, 1.0)
    )
