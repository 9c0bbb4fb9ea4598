"""Paints the lines along which skin can fold: where they run, how deep, and how old a face is that has them.

Two layers, of lines that run level and of those that run upright, since both may cross (between the brows). How deep a
line shows is the stage's (docs/method.md, "Folds"): here each is as deep as it gets.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from tools.baking.heads.basemesh import Floats
from tools.baking.skin.texels import Texels, ramp


class Line(NamedTuple):
    """A line: its points on the generic head (x, y; mm), depth and half width (mm), and its rank: 0 everybody has it, 1
    the old alone, `ANIMALS` nobody but who wears fur. One that crosses the middle is drawn once, any other on both
    sides."""

    points: Sequence[tuple[float, float]]
    depth: float
    half: float
    rank: float


ANIMALS = 1.5
LEVEL: Sequence[Line] = (
    # forehead, from low to high
    Line(((-34, 31), (-20, 35), (-7, 33), (7, 33), (20, 35), (34, 31), (44, 27)), 0.85, 1.5, 0.30),
    Line(((-38, 40), (-22, 44), (-8, 42), (8, 42), (22, 44), (38, 40), (47, 35)), 1.00, 1.6, 0.10),
    Line(((-36, 50), (-20, 53), (0, 51), (20, 53), (36, 50)), 0.90, 1.6, 0.20),
    Line(((-28, 60), (-12, 61), (12, 61), (28, 60)), 0.60, 1.4, 0.55),
    # over the nose, and beside it where it is wrinkled
    Line(((-9, 9), (-4, 7.6), (0, 7.2), (4, 7.6), (9, 9)), 0.80, 1.3, 0.05),
    Line(((-7, 13.5), (0, 12.5), (7, 13.5)), 0.60, 1.1, 0.35),
    Line(((-8, 3.5), (0, 2.4), (8, 3.5)), 0.50, 1.0, 0.45),
    Line(((5, 2), (10, -1), (14, -7)), 0.60, 1.0, 0.12),
    Line(((5, -3), (10, -7), (13, -13)), 0.50, 1.0, 0.25),
    # crow's feet
    Line(((46, 4), (53, 9), (60, 16)), 0.70, 1.1, 0.35),
    Line(((47, 1), (56, 4), (64, 8)), 0.85, 1.1, 0.20),
    Line(((47, -3), (56, -4), (65, -4)), 0.85, 1.1, 0.20),
    Line(((46, -6), (54, -10), (62, -16)), 0.70, 1.1, 0.35),
    Line(((44, -9), (51, -15), (57, -23)), 0.50, 1.0, 0.55),
    # under the eye
    Line(((20, -8), (27, -12.5), (35, -13.5), (43, -10)), 0.60, 1.0, 0.20),
    Line(((19, -12), (25, -17.5), (34, -19.5), (44, -16)), 0.60, 1.3, 0.40),
    Line(((18, -15), (24, -22), (33, -26)), 0.40, 1.2, 0.60),
    # under the lip, and where the chin is pushed up
    Line(((-20, -83), (-9, -86.5), (0, -87), (9, -86.5), (20, -83)), 1.00, 1.9, 0.05),
    Line(((-10, -93), (0, -95), (10, -93)), 0.50, 1.3, 0.30),
    # across a muzzle that is pulled up
    Line(((-14, -6), (0, -4), (14, -6)), 1.20, 1.8, ANIMALS),
    Line(((-15, -14), (0, -12), (15, -14)), 1.20, 1.8, ANIMALS),
    Line(((-15, -22), (0, -20), (15, -22)), 1.00, 1.7, ANIMALS),
)
UPRIGHT: Sequence[Line] = (
    # between the brows
    Line(((8, 9), (6.8, 15), (7.4, 22), (9.5, 29)), 1.40, 2.3, 0.0),
    Line(((1.9, 12), (1.6, 19), (2.4, 25)), 0.60, 1.3, 0.50),
    Line(((14, 20), (14, 26), (16, 32)), 0.70, 1.7, 0.45),
    # from the nose to the corner of the mouth, and on to the chin
    Line(((17, -33), (20, -38), (25, -46), (30, -55), (33, -64)), 1.30, 2.2, 0.10),
    Line(((27, -69), (29.5, -76), (30, -85), (28, -94)), 0.80, 1.6, 0.50),
    Line(((36, -58), (39, -68), (38, -80), (34, -92)), 0.50, 1.6, 0.55),
    Line(((45, -40), (47, -55), (45, -70)), 0.40, 1.7, 0.60),
    # over and under the lips
    Line(((4, -49), (4.6, -57)), 0.30, 0.7, 0.60),
    Line(((8.5, -50), (9, -58)), 0.35, 0.7, 0.60),
    Line(((13, -52), (13.5, -59.5)), 0.35, 0.7, 0.60),
    Line(((17.5, -54), (18, -61.5)), 0.32, 0.7, 0.60),
    Line(((6, -80), (5.6, -86)), 0.30, 0.7, 0.65),
    Line(((12, -79), (12.4, -85)), 0.30, 0.7, 0.65),
    # from the brow and beside a muzzle that is pulled up
    Line(((17, -8), (23, -18), (27, -30)), 1.10, 2.0, ANIMALS),
    Line(((25, -12), (31, -24), (34, -38)), 0.90, 2.0, ANIMALS),
)
MIDDLE = 0.03
"""Metres before the eyes' origin: the axis about which a place's angle counts."""
RADIUS = 115.0
"""Millimetres that a radian around it is worth, as about the middle of a face lies from it."""
FRONT = 0.03
"""Metres: lines lie on what is before this plane."""
REACH = 6.5
"""Half widths around a line in which it is felt."""
STEEPEST = 1.25
"""The slope that a layer's first number says by 0 and by 1; 0.5 is level."""
RANKS = 1.5
"""The rank that a layer's third number says by 1."""
_TURNS = np.pi


def paint_level_folds(texels: Texels) -> Floats:
    """The layer `level_folds` (SIZE, SIZE, 4): of lines that run level, the slope across, the groove, the rank and how
    far the line's normal is turned from upright (0.5: not at all; 0 and 1 half a turn apart)."""
    return _paint(texels, LEVEL, np.array([0.0, 1.0]))


def paint_upright_folds(texels: Texels) -> Floats:
    """The layer `upright_folds`: the same of lines that run upright; the normal is turned from level."""
    return _paint(texels, UPRIGHT, np.array([1.0, 0.0]))


def _paint(texels: Texels, lines: Sequence[Line], main: Floats) -> Floats:
    flat = _unrolled(texels.places)
    seen = np.flatnonzero((texels.places[:, 2] > FRONT) & ~texels.inner)
    at = cKDTree(texels.places[seen, :2] * 1000.0)
    found = np.zeros((len(flat), 2))  # slope, groove
    drawn = np.zeros((len(flat), 3))  # rank and turn, weighed by nearness, and that
    drawn[:, 0] = 1e-6 * RANKS
    drawn[:, 2] = 1e-6
    for line in lines:
        for points in _both_sides(np.array(line.points, dtype=np.float64)):
            _draw(flat, seen, flat[seen][at.query(_divided(points))[1]], line, main, found, drawn)
    slope = np.clip(0.5 + 0.5 * found[:, 0] / STEEPEST, 0.0, 1.0)
    rank = np.clip(drawn[:, 0] / drawn[:, 2] / RANKS, 0.0, 1.0)
    turn = np.clip(0.5 + drawn[:, 1] / drawn[:, 2] / _TURNS, 0.0, 1.0)
    picture = texels.spread(np.stack([slope, np.clip(found[:, 1], 0.0, 1.0), rank, turn], axis=1))
    picture[texels.spread(np.ones(len(flat))) == 0.0] = [0.5, 0.0, 1.0, 0.5]
    return picture


def _draw(
    flat: Floats, seen: NDArray[np.int64], way: Floats, line: Line, main: Floats, found: Floats, drawn: Floats
) -> None:
    """Adds a line to what is found and drawn. flat (n, 2): places unrolled, mm; seen: those that may have lines; way
    (k, 2): the line, unrolled; main: the way across of its family."""
    reach = REACH * line.half
    near = seen[((flat[seen] > way.min(axis=0) - reach) & (flat[seen] < way.max(axis=0) + reach)).all(axis=1)]
    side, across, fade = _beside(flat[near], way, main)
    off = np.abs(side) / line.half
    groove = np.exp(-(off**2))
    swell = np.exp(-(((off - 2.1) / 1.25) ** 2))
    slope = line.depth / line.half * (2.0 * off * groove - 0.5 * 2.0 * (off - 2.1) / 1.25**2 * swell) * np.sign(side)
    found[near, 0] += slope * fade
    found[near, 1] = np.maximum(found[near, 1], np.exp(-((off / 0.8) ** 2)) * fade * min(1.0, line.depth))
    weight = np.exp(-((off / 2.0) ** 2)) + 1e-5 / (0.1 + off)
    turn = np.arctan2(main[0] * across[:, 1] - main[1] * across[:, 0], across @ main)
    drawn[near] += weight[:, None] * np.stack([np.full(len(near), line.rank), turn, np.ones(len(near))], axis=1)


def _beside(flat: Floats, way: Floats, main: Floats) -> tuple[Floats, Floats, Floats]:
    """Of places (n, 2): how far they lie beside a way (k, 2), signed, the way across there (n, 2), and how far from its
    ends they lie, 0 to 1."""
    off = np.full(len(flat), np.inf)
    side = np.zeros(len(flat))
    across = np.zeros((len(flat), 2))
    along = np.zeros(len(flat))
    lengths = np.linalg.norm(np.diff(way, axis=0), axis=1)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    normals = _turned_to(main, way)
    for start, end, length, before, (first, last) in zip(way[:-1], way[1:], lengths, starts[:-1], normals, strict=True):
        if length == 0.0:
            continue
        share = np.clip((flat - start) @ (end - start) / length**2, 0.0, 1.0)
        apart = flat - start - share[:, None] * (end - start)
        far = np.linalg.norm(apart, axis=1)
        nearer = far < off
        normal = first + share[:, None] * (last - first)
        off[nearer] = far[nearer]
        side[nearer] = (np.sign((apart * normal).sum(axis=1)) * far)[nearer]
        across[nearer] = normal[nearer]
        along[nearer] = (before + share * length)[nearer]
    share = along / starts[-1]
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    return side, across, ramp(share, 0.0, 0.25) * ramp(share, 1.0, 0.75)


def _turned_to(main: Floats, way: Floats) -> list[tuple[Floats, Floats]]:
    """For each piece of a way its normals at both ends, which change along it without a kink, on the side of `main`."""
    pieces = np.diff(way, axis=0)
    normals = np.stack([-pieces[:, 1], pieces[:, 0]], axis=1)
    normals *= np.where(normals @ main < 0.0, -1.0, 1.0)[:, None]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    ends = np.concatenate([normals[:1], 0.5 * (normals[:-1] + normals[1:]), normals[-1:]])
    return [*pairwise(ends)]


def _unrolled(places: Floats) -> Floats:
    """Places (n, 3), metres, around the head and up, (n, 2) mm."""
    return np.stack([RADIUS * np.arctan2(places[:, 0], places[:, 2] - MIDDLE), 1000.0 * places[:, 1]], axis=1)


def _divided(points: Floats) -> Floats:
    """A way (k, 2) with three places more between two of its own, as a cubic through them, so that it has no kinks."""
    before = np.concatenate([2.0 * points[:1] - points[1:2], points, 2.0 * points[-1:] - points[-2:-1]])
    ways = []
    for a, b, c, d in zip(before[:-3], before[1:-2], before[2:-1], before[3:], strict=True):
        for t in (0.0, 0.25, 0.5, 0.75):
            bends = (2 * a - 5 * b + 4 * c - d) * t**2 + (3 * b - a - 3 * c + d) * t**3
            ways.append(b + 0.5 * ((c - a) * t + bends))
    return np.stack([*ways, points[-1]])


def _both_sides(line: Floats) -> list[Floats]:
    return [line] if line[:, 0].min() < 0 else [line, line * [-1.0, 1.0]]
