"""What years draw into a face: its lines one by one, and the fine net between them."""

from __future__ import annotations

import numpy as np

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.noise import cell_noise, cloud_noise, strand_noise, value_noise
from tools.baking.skin.texels import Texels, blob, ramp

SEED = 1905
# A line: its points on the generic head (x, y; mm, mirrored), its depth and half its width (mm).
Line = tuple[tuple[tuple[float, float], ...], float, float]
LINES: tuple[Line, ...] = (
    # forehead, from low to high
    (((-34, 31), (-20, 35), (-7, 33), (7, 33), (20, 35), (34, 31), (44, 27)), 0.38, 1.1),
    (((-38, 40), (-22, 44), (-8, 42), (8, 42), (22, 44), (38, 40), (47, 35)), 0.45, 1.2),
    (((-36, 50), (-20, 53), (0, 51), (20, 53), (36, 50)), 0.40, 1.2),
    (((-28, 60), (-12, 61), (12, 61), (28, 60)), 0.26, 1.1),
    # between the brows
    (((7.5, 13), (7, 20), (8.5, 28), (10, 33)), 0.45, 1.0),
    (((3.0, 15), (2.6, 22), (3.4, 27)), 0.20, 0.8),
    (((-8, 8), (0, 7), (8, 8)), 0.28, 0.9),
    # crow's feet
    (((47, 3), (53, 8), (59, 15)), 0.32, 0.8),
    (((48, 0), (56, 3), (63, 7)), 0.40, 0.8),
    (((48, -3), (56, -4), (64, -4)), 0.40, 0.8),
    (((47, -6), (54, -10), (61, -15)), 0.32, 0.8),
    (((45, -9), (51, -15), (56, -22)), 0.24, 0.8),
    # under the eye
    (((21, -6), (27, -11), (35, -12.5), (42, -9)), 0.30, 0.8),
    (((19, -9), (25, -16), (34, -18.5), (43, -15)), 0.36, 1.1),
    (((18, -12), (24, -21), (32, -25)), 0.22, 1.0),
    # from the nose to the corner of the mouth, and on to the chin
    (((19, -37), (24, -44), (29, -53), (32, -62), (33, -70)), 0.85, 1.7),
    (((27, -69), (29.5, -76), (30, -85), (28, -94)), 0.55, 1.3),
    (((36, -58), (39, -68), (38, -80), (34, -92)), 0.25, 1.2),
    (((45, -40), (47, -55), (45, -70)), 0.18, 1.3),
    # over and under the lips
    (((4, -49), (4.6, -57)), 0.20, 0.6),
    (((8.5, -50), (9, -58)), 0.24, 0.6),
    (((13, -52), (13.5, -59.5)), 0.24, 0.6),
    (((17.5, -54), (18, -61.5)), 0.22, 0.6),
    (((6, -80), (5.6, -86)), 0.18, 0.6),
    (((12, -79), (12.4, -85)), 0.18, 0.6),
    (((-18, -84), (-8, -87), (8, -87), (18, -84)), 0.45, 1.5),
)
REACH = 9.0  # mm around a line in which it is felt
FRONT = 0.045  # metres: lines are drawn on what lies before this plane
SPOT = 0.009  # metres between places where a spot may be


def lines_of_age(texels: Texels) -> tuple[Floats, Floats]:
    """How deep each place (n,) lies in the lines of age (metres), and how much it is a crease, 0 to 1."""
    places = texels.places
    warp = np.stack([value_noise(places, 0.007, seed=SEED + axis) - 0.5 for axis in range(2)], axis=1)
    flat = (places[:, :2] + warp * 0.0022) * 1000.0
    broken = 0.45 + 0.55 * ramp(cloud_noise(places, 0.012, seed=SEED + 2), 0.25, 0.6)
    depth = np.zeros(len(places))
    crease = np.zeros(len(places))
    ahead = ramp(places[:, 2], FRONT, FRONT + 0.02)
    for points, deep, half in LINES:
        for line in _both_sides(np.array(points, dtype=np.float64)):
            near = np.flatnonzero(((flat > line.min(axis=0) - REACH) & (flat < line.max(axis=0) + REACH)).all(axis=1))
            off, fade = _beside(flat[near], line)
            fade *= (broken * ahead)[near]
            groove = np.exp(-((off / half) ** 2)) - 0.35 * np.exp(-(((off - 2.2 * half) / (1.2 * half)) ** 2))
            depth[near] += deep * 1e-3 * groove * fade
            crease[near] = np.maximum(crease[near], np.exp(-((off / (0.75 * half)) ** 2)) * fade * deep / 0.5)
    return depth, np.clip(crease, 0.0, 1.0)


def fine_net(texels: Texels) -> Floats:
    """The height (n,) in metres of thin dry skin: small folds across the pull of the muscles."""
    places = texels.places
    across = np.array([1.0, 0.25, 0.0]) * 0.006  # folds lie level
    down = np.array([0.2, 1.0, 0.0]) * 0.006
    level = strand_noise(places, np.broadcast_to(across, places.shape), 0.0011, seed=SEED + 5)
    upright = strand_noise(places, np.broadcast_to(down, places.shape), 0.0012, seed=SEED + 6)
    cheeks = blob(places, (0.045, -0.045, 0.11), (0.03, 0.035, 0.06))
    lids = blob(places, (0.034, -0.008, 0.135), (0.022, 0.018, 0.05))
    first, second, _ = cell_noise(places, 0.0032, seed=SEED + 7)
    net = ramp(second - first, 0.0, 0.35)
    return np.asarray(
        0.00022 * (level - 0.5) * (0.5 + lids) + 0.00026 * (upright - 0.5) * cheeks + 0.00012 * net * (0.3 + cheeks)
    )


def spots_of_age(texels: Texels) -> Floats:
    """Brown spots (n,), 0 to 1: few, large, at temples, forehead and cheeks."""
    places = texels.places
    rough = (cloud_noise(places, 0.0035, seed=SEED + 8) - 0.5) * 0.5
    first, _, label = cell_noise(places, SPOT, seed=SEED + 9)
    size = 0.12 + 0.3 * (label * 7.0 % 1.0)
    spot = ramp(first + rough * 0.7, size, size * 0.3) * (label < 0.3) * (0.4 + 2.0 * label)
    side = ramp(np.abs(places[:, 0]), 0.02, 0.05) + ramp(places[:, 1], 0.035, 0.06)
    return np.asarray(np.clip(spot * np.clip(side, 0.0, 1.0), 0.0, 1.0))


def _both_sides(line: Floats) -> list[Floats]:
    """A line that crosses the middle is drawn once, any other on both sides."""
    return [line] if line[:, 0].min() < 0 else [line, line * [-1.0, 1.0]]


def _beside(flat: Floats, line: Floats) -> tuple[Floats, Floats]:
    """Distance (n,) of places (n, 2) to a line of points, and how far from its ends they lie, 0 to 1."""
    off = np.full(len(flat), np.inf)
    along = np.zeros(len(flat))
    lengths = np.linalg.norm(np.diff(line, axis=0), axis=1)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    for start, end, length, before in zip(line[:-1], line[1:], lengths, starts[:-1], strict=True):
        share = np.clip((flat - start) @ (end - start) / length**2, 0.0, 1.0)
        far = np.linalg.norm(flat - start - share[:, None] * (end - start), axis=1)
        nearer = far < off
        off[nearer] = far[nearer]
        along[nearer] = (before + share * length)[nearer]
    share = along / starts[-1]
    return off, ramp(share, 0.0, 0.25) * ramp(share, 1.0, 0.75)
