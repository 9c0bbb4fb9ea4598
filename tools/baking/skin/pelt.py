"""Paints the two coats that fur comes in, each as a pale and a dark pattern: a hound's and a tabby cat's."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import cloud_noise, strand_noise, value_noise
from tools.baking.skin.texels import Texels, blob, ramp

SEED = 4409
Line = Sequence[tuple[float, float]]

# Lines of a tabby on the front of the generic head: |x| and height, metres. Half of the M over the eyes, the two lines
# that leave the eye's outer corner, the one that runs down from the inner one.
M_OF_THE_FOREHEAD: Line = ((0.0, 0.030), (0.006, 0.040), (0.0125, 0.061), (0.020, 0.043), (0.029, 0.027))
LINES_OF_THE_CHEEK: Sequence[Line] = (
    ((0.047, -0.001), (0.056, -0.008), (0.066, -0.013), (0.074, -0.014)),
    ((0.044, -0.019), (0.054, -0.029), (0.064, -0.034)),
    ((0.042, -0.037), (0.052, -0.048), (0.058, -0.052)),
)
_BROW_HAIRS = (0.0016, 0.0052, 0.0)  # metres: how far and whereto a hair over the left eye lies
LINE_OF_TEARS: Line = ((0.0185, -0.005), (0.0155, -0.013), (0.0165, -0.022))
# Whiskers, from the pad out over the cheek, and the roots on the pad: |x| and height, metres.
WHISKERS: Sequence[Line] = (
    ((0.014, -0.0475), (0.030, -0.038), (0.046, -0.030), (0.060, -0.026)),
    ((0.016, -0.0505), (0.032, -0.044), (0.048, -0.040), (0.063, -0.039)),
    ((0.017, -0.0535), (0.033, -0.051), (0.048, -0.051), (0.062, -0.053)),
    ((0.016, -0.0565), (0.030, -0.058), (0.044, -0.062), (0.056, -0.067)),
)
PADS = np.array([(x, y) for y in (-0.0490, -0.0530, -0.0570) for x in (0.010, 0.0145, 0.019, 0.0235)])
DOT = 0.0007  # metres, the radius of a whisker's root


def paint_pelt(texels: Texels) -> Floats:
    """The layer `pelt` (SIZE, SIZE, 4): a hound's pale and dark fur, a tabby's pale and dark fur."""
    layers = np.stack(
        [hound_pale(texels), hound_dark(texels), tabby_pale(texels), tabby_dark(texels)],
        axis=1,
    )
    layers[texels.inner] = 0.0
    return texels.spread(layers)


def hound_pale(texels: Texels) -> Floats:
    """A hound's pale fur (n,), 0 to 1: muzzle, chin and throat, a blaze up to the crown, soft spots over the eyes."""
    places = texels.places
    muzzle = blob(places, (0.010, -0.062, 0.150), (0.028, 0.030, 0.045))
    throat = blob(places, (0.0, -0.118, 0.10), (0.035, 0.03, 0.06))
    blaze = blob(places, (0.0, 0.022, 0.15), (0.0075, 0.058, 0.07))
    torn = _torn(places)
    spots = 0.5 * _in_hairs(blob(places, (0.0225, 0.0262, 0.138), (0.0095, 0.0050, 0.04)), places)
    return np.asarray(np.maximum(ramp(np.maximum.reduce([muzzle, throat, blaze]) + torn, 0.3, 0.5), spots))


def hound_dark(texels: Texels) -> Floats:
    """A hound's dark fur (n,), 0 to 1: the ears, a shade over crown and nape, the roots of the whiskers."""
    places = texels.places
    saddle = 0.8 * ramp(places[:, 2] + 0.06 * _torn(places), 0.055, 0.02)
    return np.asarray(np.maximum.reduce([0.9 * _ears(places), saddle, 0.7 * _whisker_roots(places)]))


def tabby_pale(texels: Texels) -> Floats:
    """A tabby's pale fur (n,), 0 to 1: whisker pads, chin and throat, rings around the eyes, inner ears, whiskers."""
    places = texels.places
    pads = blob(places, (0.012, -0.056, 0.152), (0.019, 0.015, 0.04))
    chin = blob(places, (0.0, -0.092, 0.14), (0.024, 0.026, 0.05))
    throat = 0.8 * blob(places, (0.0, -0.13, 0.09), (0.03, 0.03, 0.06))
    ring = 0.75 * ramp(texels.lid_rings, 8.0, 3.5) * ramp(places[:, 2], 0.10, 0.12)
    ear = 0.85 * _ears(places) * ramp(_facing_out(texels), 0.1, 0.5)
    soft = ramp(np.maximum.reduce([pads, chin, throat]) + _torn(places), 0.25, 0.55)
    whiskers = 0.9 * _strokes(places, WHISKERS, 0.0006, taper=True)
    brow = 0.68 * _in_hairs(blob(places, (0.0235, 0.0195, 0.138), (0.0105, 0.0095, 0.04)), places)
    return np.asarray(np.maximum.reduce([soft, ring, ear, whiskers, brow]))


def tabby_dark(texels: Texels) -> Floats:
    """A tabby's dark fur (n,), 0 to 1: the M of the forehead, stripes of crown and neck, lines of eyes and cheeks."""
    places = texels.places
    x, y, z = np.abs(places[:, 0]), places[:, 1], places[:, 2]
    wave = (cloud_noise(places, 0.018, seed=SEED + 5) - 0.5) * 0.9
    crown = np.sin((x / 0.0095 + wave) * np.pi) * ramp(y, 0.055, 0.066) * ramp(x, 0.07, 0.045)
    side = np.sin(((y - 0.35 * x) / 0.0125 + wave) * np.pi) * ramp(x, 0.060, 0.068) * ramp(z, 0.085, 0.06)
    rough = (value_noise(places, 0.003, seed=SEED + 6) - 0.5) * 0.6
    stripes = ramp(np.maximum(crown, side) + rough, 0.3, 0.8) * ramp(y, -0.135, -0.12) * (1.0 - _ears(places))
    lines = (
        _strokes(places, (M_OF_THE_FOREHEAD, *LINES_OF_THE_CHEEK), 0.0029)
        * ramp(rough, -0.4, 0.0)
        * (1.0 - _ears(places))
    )
    tears = 0.8 * _strokes(places, (LINE_OF_TEARS,), 0.0014)
    rim = 0.7 * _ears(places) * ramp(_facing_out(texels), 0.0, -0.4)
    return np.asarray(np.maximum.reduce([stripes, lines, tears, rim, 0.8 * _whisker_roots(places)]))


def _ears(places: Floats) -> Floats:
    """How much of an ear each place is (n,), 0 to 1."""
    x, y, z = np.abs(places[:, 0]), places[:, 1], places[:, 2]
    return np.asarray(ramp(x, 0.0695, 0.0725) * ramp(z, 0.085, 0.075) * ramp(y, 0.034, 0.026) * ramp(y, -0.052, -0.046))


def _facing_out(texels: Texels) -> Floats:
    """How far each place looks away from the midline (n,), -1 to 1: an ear's inner side does, its back does not."""
    return np.asarray(texels.normals[:, 0] * np.sign(texels.places[:, 0]))


def _torn(places: Floats) -> Floats:
    """What makes the border of a patch ragged (n,), around 0."""
    return np.asarray((cloud_noise(places, 0.008, seed=SEED) - 0.5) * 0.25)


def _in_hairs(cover: Floats, places: Floats) -> Floats:
    """A soft spot over an eye (n,), 0 to 1, that ends hair by hair as the fur around it lies."""
    left = np.stack([np.abs(places[:, 0]), places[:, 1], places[:, 2]], axis=1)
    near = np.flatnonzero(cover > 0.02)
    found = np.zeros(len(places))
    hairs = strand_noise(left[near], np.broadcast_to(_BROW_HAIRS, (len(near), 3)), 0.0008, seed=SEED + 7) - 0.5
    found[near] = ramp(cover[near] + 0.7 * hairs * (1.0 - cover[near]), 0.2, 0.9)
    return found


def _whisker_roots(places: Floats) -> Floats:
    """The dots on the whisker pads (n,), 0 to 1."""
    flat = np.stack([np.abs(places[:, 0]), places[:, 1]], axis=1)
    near = np.flatnonzero((flat[:, 0] < 0.03) & (np.abs(flat[:, 1] + 0.053) < 0.01) & (places[:, 2] > 0.1))
    found = np.zeros(len(places))
    away = np.linalg.norm(flat[near, None] - PADS, axis=2).min(axis=1)
    found[near] = ramp(away, 1.5 * DOT, 0.5 * DOT)
    return found


def _strokes(places: Floats, lines: Sequence[Line], width: float, *, taper: bool = False) -> Floats:
    """How much strokes along lines cover each place of the front (n,), 0 to 1; width: half, metres, less at the ends
    of a line, with `taper` at its last end alone."""
    flat = np.stack([np.abs(places[:, 0]), places[:, 1]], axis=1)
    cover = np.zeros(len(places))
    for line in lines:
        points = np.array(line)
        pieces = np.linalg.norm(np.diff(points, axis=0), axis=1)
        before = np.concatenate([[0.0], np.cumsum(pieces)]) / pieces.sum()
        for start, end, first, last in zip(points[:-1], points[1:], before[:-1], before[1:], strict=True):
            share = np.clip((flat - start) @ (end - start) / ((end - start) @ (end - start)), 0.0, 1.0)
            off = np.linalg.norm(flat - start - share[:, None] * (end - start), axis=1)
            along = first + share * (last - first)
            thick = width * (1.0 - 0.8 * along if taper else 1.1 - 0.8 * np.abs(2.0 * along - 1.0) ** 2)
            cover = np.maximum(cover, ramp(off / thick, 1.4, 0.6))
    return np.asarray(cover * ramp(places[:, 2], 0.055, 0.075))
