"""Paints small marks of the skin: creases and spots of age, freckles, stubble, and the strands of fur."""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import cell_noise, cloud_noise, strand_noise
from tools.baking.skin.texels import Texels, blob, ramp
from tools.baking.skin.wrinkles import lines_of_age, spots_of_age

SEED = 3137
MUZZLE = (0.0, -0.045, 0.10)  # metres: fur flows away from here


def paint_marks(texels: Texels) -> Floats:
    """The layer `marks` (SIZE, SIZE, 4): marks of age, freckles, stubble, strands of fur (0.5 is the fur's mean)."""
    layers = np.stack([age_marks(texels), freckles(texels), stubble(texels), fur_strands(texels)], axis=1)
    layers[texels.inner] = [0.0, 0.0, 0.0, 0.5]
    return texels.spread(layers)


def age_marks(texels: Texels) -> Floats:
    """How much darker and redder age makes each place (n,), 0 to 1."""
    _, crease = lines_of_age(texels)
    return np.asarray(np.clip(0.55 * crease + 0.6 * spots_of_age(texels), 0.0, 1.0))


def freckles(texels: Texels) -> Floats:
    """Freckles (n,), 0 to 1, over nose and cheeks."""
    places = texels.places
    where = blob(places, (0.028, -0.022, 0.135), (0.026, 0.017, 0.05))
    where += blob(places, (0.0, -0.016, 0.15), (0.016, 0.016, 0.04))
    where += 0.3 * blob(places, (0.0, 0.045, 0.14), (0.045, 0.025, 0.05))
    where = np.clip(where, 0.0, 1.0) * ramp(places[:, 2], 0.06, 0.1)
    total = np.zeros(len(places))
    for size, share, seed in ((0.0026, 0.8, 0), (0.0042, 0.6, 10)):
        first, _, own = cell_noise(places, size, seed=SEED + seed)
        radius = 0.2 + 0.22 * (own * 13.0 % 1.0)
        total = np.maximum(total, ramp(first, radius, radius * 0.4) * (own < share * where))
    return np.asarray(total * (0.5 + 0.5 * where))


def beard(texels: Texels) -> Floats:
    """Where a beard grows (n,), 0 to 1: upper lip, chin, jaw, and up before the ears."""
    places = texels.places
    jaw = ramp(places[:, 1], -0.045, -0.075) * ramp(places[:, 2], 0.035, 0.065)
    lip = blob(places, (0.012, -0.052, 0.148), (0.017, 0.008, 0.03))
    side = blob(places, (0.063, -0.045, 0.085), (0.012, 0.03, 0.018))
    grown = np.clip(np.maximum(np.maximum(jaw, 1.15 * lip), 0.9 * side), 0.0, 1.0)
    philtrum = 1.0 - 0.5 * blob(places, (0.0, -0.052, 0.155), (0.003, 0.006, 0.03))
    soul = 1.0 - 0.6 * blob(places, (0.014, -0.083, 0.14), (0.006, 0.004, 0.03))
    neck = ramp(places[:, 1], -0.135, -0.115)
    return np.asarray(grown * philtrum * soul * neck * ramp(texels.lip_rings, 6.2, 8.0))


def stubble(texels: Texels) -> Floats:
    """Stubble (n,), 0 to 1: a shadow under the skin and short hairs over it."""
    places = texels.places
    normals = texels.normals
    flow = _along_skin(np.array([[0.0, -1.0, -0.2]]), normals) * 0.0016
    hairs = ramp(strand_noise(places, flow, 0.00055, seed=SEED + 20), 0.5, 0.8)
    thin = 0.55 + 0.45 * cloud_noise(places, 0.01, seed=SEED + 22)
    return np.asarray(beard(texels) * thin * (0.45 + 0.55 * hairs))


def fur_strands(texels: Texels) -> Floats:
    """The strands of fur (n,), around 0.5: hairs in tufts that flow back from the muzzle."""
    places = texels.places
    away = places - np.array(MUZZLE)
    way = _along_skin(away / np.linalg.norm(away, axis=1, keepdims=True) + [0.0, -0.25, -0.1], texels.normals)
    sway = cloud_noise(places, 0.02, seed=SEED + 30)[:, None] - 0.5
    way = way + 0.9 * sway * np.cross(texels.normals, way)
    long = 0.004 + 0.006 * ramp(np.linalg.norm(away, axis=1), 0.05, 0.11)
    hairs = strand_noise(places, way * long[:, None], 0.0007, seed=SEED + 31)
    tufts = strand_noise(places, way * 1.6 * long[:, None], 0.0024, seed=SEED + 32)
    return np.asarray(np.clip(0.5 + 0.62 * (hairs - 0.5) + 0.5 * (tufts - 0.5), 0.0, 1.0))


def _along_skin(ways: Floats, normals: Floats) -> Floats:
    """Directions (n, 3) laid into the surface, of unit length."""
    flat = ways - normals * np.einsum("ij,ij->i", np.broadcast_to(ways, normals.shape), normals)[:, None]
    return np.asarray(flat / np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-9))
