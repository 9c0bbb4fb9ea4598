"""Paints textures of eyeballs, teeth, tongue, lashes and hair for programs that lack our shaders.

Each comes with the texture coordinates that it is painted for, from the generic face alone. Colours and measures are
those of web/src/face (eye_shaders, mouth_shaders, lashes), without their light.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture
from omote.geometry.ramp import clamp_unit, smooth_ramp
from omote.interchange.skin_texture import decode_srgb
from omote.interchange.tooth_profiles import TEETH
from omote.model.albedo import encode_light
from omote.model.cast import Look

Values = NDArray[Any]

SEED = 1993
LIMBUS = 0.42
"""Radius of a person's iris, in the ball's."""
PUPIL = 0.32
ARCH = 0.034
"""From the front teeth back to the middle of the dental arch, metres."""
_LOWER = 1.7
TOOTH_REACH = 0.16
_WIDEST = 1.7
"""Radians along the arch: of one tooth's height, and that a texture spans."""
ARCH_DEPTH = 0.05
"""Metres behind the front teeth that a texture spans."""


def eye_uv(points: Values) -> NDArray[np.float32]:
    """Places (k, 2) of an eyeball's points (k, 3), from its centre: equal areas around the line of sight (Lambert)."""
    x, y, z = (points / np.linalg.norm(points, axis=1, keepdims=True)).T
    reach = np.sqrt(np.maximum((1.0 - z) / 2.0, 0.0)) / np.maximum(np.hypot(x, y), 1e-9) * 0.5
    return np.stack([0.5 + reach * x, 0.5 - reach * y], axis=1).astype(np.float32)


def paint_eye(look: Look, size: int = 512) -> Picture:
    """An eyeball (size, size, 3) on `eye_uv`: iris, pupil, white with its vessels.

    look: for its iris; size: pixels.
    """
    x, y, radius = _disc(size)
    off = radius * np.sqrt(np.maximum(1.0 - radius**2, 0.0)) * 2.0  # of the unit ball, seen from ahead
    angle = np.arctan2(y, x)
    front = radius < np.sqrt(0.5)
    edge = LIMBUS * look.iris_size
    out = off / edge
    place = np.stack([np.cos(angle), np.sin(angle)]) * out
    iris = _iris(look, size, out, _pupil(place, look.slit))
    white = np.broadcast_to(np.array([0.80, 0.745, 0.69]), (*off.shape, 3))
    white = white * (1.0 + look.age * (np.array([0.94, 0.86, 0.72]) - 1.0))
    white = white * (1.0 + look.fur * (np.array([0.62, 0.50, 0.38]) * 0.65 - 1.0))
    white = white * (1.0 - np.array([0.02, 0.10, 0.11]) * smooth_ramp(0.45, 0.95, np.where(front, off, 1.0))[..., None])
    disc = np.where(front, 1.0 - smooth_ramp(0.91, 1.07, out), 0.0)[..., None]
    return encode_light(white + (iris - white) * disc)


def _disc(size: int) -> tuple[Values, Values, Values]:
    axis = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    x, y = np.meshgrid(axis, -axis)
    return x, y, np.minimum(np.hypot(x, y), 1.0)


def _pupil(place: Values, slit: float) -> Values:
    """1 at the pupil's edge, less inside: a circle, an upright lens, or what lies between."""
    across = PUPIL + (0.07 + 0.22 * PUPIL - PUPIL) * slit
    along = PUPIL + (0.86 - PUPIL) * slit
    x, y = np.abs(place[0] / across), place[1] / along
    circle = np.hypot(x, y)
    result: Values = circle + (x + y**2 - circle) * slit
    return result


def _iris(look: Look, size: int, out: Values, hole: Values) -> Values:
    rim = out / np.maximum(hole, 0.05)
    share = clamp_unit((out - rim) / np.maximum(1.0 - rim, 0.05))
    fine = _fibres(size, 90)
    coarse = _fibres(size, 22)
    ridge = 0.30 + 0.05 * coarse
    inner = 1.0 - smooth_ramp(-0.05, 0.06, share - ridge)
    tone = decode_srgb(look.iris) * (1.25 - 0.45 * smooth_ramp(0.2, 0.95, share))[..., None] + np.array(
        [0.012, 0.009, 0.006]
    )
    warm = tone * np.array([1.30, 1.02, 0.66]) + np.array([0.02, 0.010, 0.0])
    tone = tone + (warm - tone) * (0.7 * inner)[..., None]
    tone = tone * np.maximum(1.0 + 0.35 * fine + 0.25 * coarse, 0.2)[..., None]
    dark = (1.0 - 0.45 * smooth_ramp(0.90, 1.0, 1.0 - share)) * (1.0 - 0.86 * smooth_ramp(0.66, 1.0, out) ** 2)
    result: Values = np.maximum(tone, 0.0) * (dark * smooth_ramp(0.94, 1.06, hole))[..., None]
    return result


@lru_cache(maxsize=4)
def _fibres(size: int, most: int) -> Values:
    """Noise around the iris (size, size), about -1..1, without a seam: waves of whole numbers up to `most`.

    It is the same for all eyes, and takes most of the time of one: it is kept.
    """
    x, y, _ = _disc(size)
    angle = np.arctan2(y, x)
    chance = np.random.default_rng(SEED + most)
    waves = np.arange(most // 3, most)
    total = np.zeros(angle.shape)
    for wave, phase in zip(waves, chance.uniform(0.0, 2.0 * np.pi, len(waves)), strict=True):
        total += np.cos(wave * angle + phase)
    result: Values = total / np.sqrt(len(waves))
    result.flags.writeable = False
    return result


def arch_uv(points: Values, *, upper: bool) -> NDArray[np.float32]:
    """Places (k, 2) of teeth at points (k, 3): the angle on the arch, and how far from the gum to the edge.

    points (k, 3): metres; upper: whether they are the upper ones.
    """
    angle = np.arctan2(points[:, 0], points[:, 2] - points[:, 2].max() + ARCH)
    beside = np.abs(angle[:, None] - angle[None]) < TOOTH_REACH
    low = np.where(beside, points[None, :, 1], np.inf).min(axis=1)
    high = np.where(beside, points[None, :, 1], -np.inf).max(axis=1)
    level = (points[:, 1] - low) / np.maximum(high - low, 1e-9)
    return np.stack([0.5 + angle / (2.0 * _WIDEST), 1.0 - level if upper else level], axis=1).astype(np.float32)


def paint_teeth(look: Look, *, upper: bool, size: int = 512) -> Picture:
    """A row of teeth (size / 2, size, 4) on `arch_uv`, gums above; clear beyond the teeth's edges.

    look: for its age; upper: whether they are the upper ones; size: pixels.
    """
    angle = ((np.arange(size) + 0.5) / size * 2.0 - 1.0) * _WIDEST
    height = ((np.arange(size // 2) + 0.5) / (size // 2))[:, None]
    across, number = _teeth_at(angle, upper=upper)
    sides = across**2
    end = 1.0 - 0.075 * sides**3 - np.where(number == 2, 0.07 * np.abs(across), 0.0) - (number == 1) * 0.05 * upper
    line = 0.36 + 0.13 * sides**2 - np.where(number == 1, 0.0, 0.03)
    gum = (1.0 - smooth_ramp(-0.03, 0.03, height - line))[..., None]
    groove = (smooth_ramp(0.80, 1.0, np.abs(across)) * np.ones_like(height))[..., None] * (1.0 - gum)
    enamel = _interpolate((0.80, 0.68, 0.50), (0.86, 0.79, 0.68), smooth_ramp(0.0, 0.45, height - line))
    clear = 0.55 * smooth_ramp(0.84, 1.02, height + 0.05 * sides)[..., None]
    enamel = enamel + (0.60 - enamel) * clear
    enamel = enamel * (1.0 + look.age * (np.array([0.93, 0.84, 0.66]) - 1.0)) * (1.0 - 0.62 * groove)
    pink = _interpolate((0.50, 0.17, 0.16), (0.60, 0.27, 0.25), smooth_ramp(-0.16, 0.0, height - line))
    there = np.where(height > end + 0.02, 0, 255).astype(np.uint8)[..., None]
    return np.concatenate([encode_light(enamel + (pink - enamel) * gum), there], axis=2)


def paint_jaw(look: Look, size: int = 1024) -> Picture:
    """A jaw (size / 4, size, 3) as stages draw it: teeth across from the right end, from their edges on top to the gum
    line in the middle, and gums from there to palate or floor.

    look: for its age; size: pixels.
    """
    number = np.clip(((np.arange(size) + 0.5) / size) * 2 * TEETH, 0.0, 2 * TEETH - 1e-9)
    height = 1.0 - 2.0 * ((np.arange(size // 4) + 0.5) / (size // 4))[:, None]
    tooth = np.floor(number)
    across = np.abs(2.0 * (number - tooth) - 1.0)
    from_middle = np.abs(tooth - (TEETH - 0.5)) - 0.5
    shade = 1.0 + 0.06 * (_chance(tooth) - 0.5)
    enamel = _interpolate((0.84, 0.73, 0.56), (0.93, 0.88, 0.79), smooth_ramp(0.0, 0.55, height) + 0.0 * number)
    enamel = enamel + (0.76 - enamel) * (0.4 * smooth_ramp(0.86, 1.0, height))[..., None]
    enamel = enamel * (1.0 + look.age * (np.array([0.93, 0.84, 0.66]) - 1.0)) * shade[:, None]
    between = smooth_ramp(0.72, 1.0, across) * smooth_ramp(0.0, 0.15, height)
    enamel = enamel * (1.0 + between[..., None] * (np.array([0.62, 0.50, 0.43]) - 1.0))
    enamel = enamel * (1.0 - 0.28 * smooth_ramp(1.5, 5.5, from_middle))[:, None]
    pink = _interpolate((0.62, 0.28, 0.26), (0.50, 0.15, 0.14), smooth_ramp(0.1, 0.7, -height) + 0.0 * number)
    gum = 1.0 - smooth_ramp(-0.02, 0.02, height)[..., None]
    line = 0.74 + 0.26 * smooth_ramp(0.0, 0.07, np.abs(height))[..., None]
    return encode_light((enamel + (pink - enamel) * gum) * line)


def _chance(number: Values) -> Values:
    """Noise of whole numbers, 0 to 1, as shaders have it."""
    wave = np.sin(number * 12.9) * 43.7
    result: Values = wave - np.floor(wave)
    return result


def _teeth_at(angle: Values, *, upper: bool) -> tuple[Values, Values]:
    """Place across its tooth, -1..1, and the tooth's number from the middle, for each angle on the arch."""
    widths = np.array([0.268 if upper else 0.180, 0.212 if upper else 0.195, 0.235, 0.235, 0.235, 0.330, 0.330])
    starts = np.concatenate([[0.0], np.cumsum(widths)[:-1]])
    number = np.searchsorted(starts, np.abs(angle), side="right") - 1
    return (2.0 * (np.abs(angle) - starts[number]) / widths[number] - 1.0) * np.sign(angle), number


def tongue_uv(points: Values) -> NDArray[np.float32]:
    """Places (k, 2) of a tongue's points (k, 3): across, and how far back."""
    x, z = points[:, 0], points[:, 2]
    reach = max(float(np.abs(x).max()), 1e-9)
    return np.stack([0.5 + 0.5 * x / reach, clamp_unit((z.max() - z) / ARCH_DEPTH)], axis=1).astype(np.float32)


def paint_tongue(size: int = 128) -> Picture:
    """A tongue (size, size, 3) on `tongue_uv`: a furrow along the middle, darker at the root."""
    across, back = np.meshgrid((np.arange(size) + 0.5) / size * 2.0 - 1.0, (np.arange(size) + 0.5) / size)
    bumps = 0.12 * np.random.default_rng(SEED).standard_normal((size, size))
    flesh = _interpolate((0.42, 0.115, 0.105), (0.50, 0.21, 0.19), clamp_unit(0.35 + bumps))
    furrow = np.exp(-((across / 0.12) ** 2))
    return encode_light(flesh * ((1.0 - 0.38 * furrow) * (1.0 - 0.35 * back))[..., None])


def lash_uv(points: Values, centre: Values) -> NDArray[np.float32]:
    """Places (k, 2) of one eye's lashes, points (k, 3): the angle around the eyeball, and how far off it.

    points (k, 3): metres; centre (3,): the eyeball's.
    """
    away = points - centre
    reach = np.linalg.norm(away, axis=1)
    angle = np.arctan2(away[:, 0], away[:, 2])
    along = (reach - reach.min()) / max(float(np.ptp(reach)), 1e-9)
    along = np.where(away[:, 1] < 0.0, _LOWER * along, along)  # the lower lid's end sooner
    return np.stack([0.5 + angle / np.pi, along], axis=1).astype(np.float32)


def paint_strands(
    colour: NDArray[np.floating], strands: int, *, columns: int, rows: int, cover: float = 0.84
) -> Picture:
    """Hairs (rows, columns, 4) from their roots in the first row to their tips in the last, clear between them.

    cover: how much of the width they hide at their roots.

    colour (3,): linear light; strands: how many; columns, rows: pixels.
    """
    chance = np.random.default_rng(SEED)
    root = (np.arange(strands) + 0.5 + chance.uniform(-0.3, 0.3, strands)) / strands
    bend = chance.normal(0, 0.4, strands)
    length = chance.uniform(0.6, 1.0, strands)
    x, y = np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    hidden = np.zeros((rows, columns))
    tone = np.ones((rows, columns))
    widest = 0.5 * cover / strands
    for start, lean, end in zip(root, bend, length, strict=True):
        ends = np.array([min(0.0, lean / strands) - widest, max(0.0, lean / strands) + widest])
        first, last = np.clip(np.array([-2, 2]) + np.rint((start + ends) * columns), 0, columns).astype(int)
        at = np.s_[:, first:last]  # a strand covers a few columns of all
        wide = widest * np.maximum(1.0 - y[at] / end, 0.0) ** 0.5
        here = clamp_unit((wide - np.abs(x[at] - start - lean * y[at] ** 2 / strands)) * columns + 0.5) * (wide > 0.0)
        tone[at] = np.where(here > hidden[at], 0.75 + 0.5 * end * end, tone[at])
        hidden[at] = np.maximum(hidden[at], here)
    drawn = encode_light(colour * tone[..., None])
    return np.concatenate([drawn, np.rint(255.0 * hidden).astype(np.uint8)[..., None]], axis=2)


def _interpolate(one: tuple[float, float, float], other: tuple[float, float, float], share: Values) -> Values:
    result: Values = np.array(one) + (np.array(other) - np.array(one)) * share[..., None]
    return result
