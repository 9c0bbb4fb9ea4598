"""The hair styles of the cast as recipes for the generic head; metres, heights over its eyes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tools.baking.hair.coil import Coil, Tail
from tools.baking.hair.groom import Groom, Strands
from tools.baking.heads.basemesh import Floats

# Hairlines: the angle around the skull, radians, and the height over the eyes where hair begins, metres.
ADULT = (
    (0.0, 0.076),
    (0.35, 0.074),
    (0.6, 0.068),
    (0.76, 0.056),
    (0.9, 0.036),
    (1.02, 0.016),
    (1.12, -0.004),
    (1.24, -0.012),
    (1.34, 0.006),
    (1.6, 0.022),
    (1.9, 0.0),
    (2.2, -0.04),
    (3.2, -0.06),
)
RECEDING = ((0.0, 0.107), (0.35, 0.106), (0.7, 0.096), (0.9, 0.066), (1.04, 0.034), *ADULT[9:])  # nothing beside ears
TIED = (*ADULT[:5], (1.05, 0.022), *ADULT[9:])  # without whiskers
FRINGED = ((0.0, 0.071), (0.35, 0.069), (0.6, 0.064), *ADULT[3:])  # a child's forehead is high
PEAKED = ((0.0, 0.068), (0.14, 0.075), (0.4, 0.086), (0.62, 0.075), *TIED[3:])
# Places on the head, metres.
WHORL = np.array([0.0, 0.125, 0.04])
PART = 0.032  # how far to the character's left hair is parted, metres
KNOT = np.array([0.0, 0.093, -0.03])  # where hair is put up
TAIL = np.array([0.0, 0.062, -0.052])  # where it is bound to one tail
PIGTAILS = (np.array([0.072, 0.034, -0.012]), np.array([-0.072, 0.034, -0.012]))  # and to two


def _azimuth(points: Floats) -> Floats:
    """The angle (n,) around the skull's middle, 0 straight ahead."""
    return np.asarray(np.arctan2(points[:, 0], points[:, 2] - 0.06))


def _ease(values: Floats, low: float, high: float) -> Floats:
    share = np.clip((values - low) / (high - low), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def _bob_comb(strands: Strands) -> Floats:
    """Away from the whorl, down over the sides; the tips turn inwards below the jaw's corner."""
    away = (strands.points - WHORL) * [1.0, 0.4, 1.0] * 14.0
    away[:, 1] -= 0.55
    below = np.clip((-0.035 - strands.points[:, 1]) / 0.03, 0.0, 1.0)[:, None]
    inward = (np.array([0.0, 0.0, 0.045]) - strands.points) * [1.0, 0.0, 1.0] * 11.0
    side = np.clip(-strands.points[:, 1:2] / 0.02 + 3.0, 0.0, 1.0)
    back = -0.75 * _ease(strands.points[:, 2], 0.055, 0.095)  # off the cheeks
    fall = np.stack([0.0 * back, -1.0 + 0.0 * back, back], axis=1)
    return np.asarray(away * (1.0 - 0.9 * side) + side * fall + below * inward)


def _bob_cut(strands: Strands) -> NDArray[np.bool_]:
    """A straight fringe above the brows, the rest as long as the chin."""
    angle = np.abs(_azimuth(strands.points))
    fringe = (angle < 0.58) & (strands.points[:, 2] > 0.1)
    jitter = strands.chance[:, 2]
    brow = 0.035 - 3.5 * strands.points[:, 0] ** 2 - 0.005 * jitter
    chin = -0.080 + 0.012 * _ease(angle, 1.2, 2.7) - 0.005 * jitter
    return np.asarray(strands.points[:, 1] < np.where(fringe, brow, chin))


def _short_comb(strands: Strands) -> Floats:
    """From the parting over to either side, on top a little forwards and up, at the sides down and back."""
    x, y, z = strands.points.T
    top = _ease(strands.roots[:, 1], 0.055, 0.09)
    across = np.where(strands.roots[:, 0] > PART, 1.0, -1.0)
    over = np.stack([1.2 * across, np.full_like(x, -0.1), np.where(z > 0.07, 0.35, -0.5)], axis=1)
    back = -0.45 * _ease(strands.roots[:, 1], 0.0, 0.04)  # not over the ears
    down = np.stack([0.0 * x, np.full_like(y, -1.0), np.where(z < 0.04, -0.45, back)], axis=1)
    lean = (strands.chance[:, 1:2] - 0.5) * [0.5, 0.0, 0.7]
    return np.asarray(top[:, None] * over + (1.0 - top[:, None]) * down + lean)


def _short_cut(strands: Strands) -> NDArray[np.bool_]:
    """Long on top, shorn towards the ears and the nape."""
    length = np.interp(strands.roots[:, 1], [-0.06, 0.02, 0.06, 0.09], [0.008, 0.016, 0.032, 0.068])
    return np.asarray(strands.grown > length * (0.75 + 0.5 * strands.chance[:, 2]))


def _back_comb(strands: Strands) -> Floats:
    """Straight back over the skull and down to the nape."""
    x, y, z = strands.points.T
    behind = _ease(-z, -0.05, 0.03)
    return np.stack([3.0 * x, -0.15 - 1.6 * behind, -1.0 + 0.9 * behind + 0.0 * y], axis=1)


def _back_cut(strands: Strands) -> NDArray[np.bool_]:
    """As long as it takes to the nape."""
    jitter = strands.chance[:, 2]
    return np.asarray((strands.points[:, 1] < -0.058 - 0.01 * jitter) | (strands.grown > 0.13 + 0.06 * jitter))


def _thin_comb(strands: Strands) -> Floats:
    """Back and down, every wisp its own way."""
    lean = (strands.chance[:, 1:] - 0.5) * [1.5, 0.9, 1.2]
    return np.asarray(_back_comb(strands) + lean + np.array([0.0, -0.45, 0.0]))


def _thin_cut(strands: Strands) -> NDArray[np.bool_]:
    length = np.interp(strands.roots[:, 1], [-0.05, 0.05, 0.1], [0.018, 0.034, 0.05])
    return np.asarray(strands.grown > length * (0.6 + 0.7 * strands.chance[:, 2]))


def _mop_comb(strands: Strands) -> Floats:
    """Away from a whorl beside the middle, every lock its own way."""
    away = (strands.points - WHORL - [0.012, 0.0, -0.02]) * [1.0, 0.3, 1.0] * 14.0
    away[:, 1] -= 0.5
    x, y, z = strands.roots.T
    lock = np.sin(95.0 * x + 60.0 * y + 1.0) * np.cos(90.0 * z - 50.0 * y)
    turn = 0.5 * lock + (strands.chance[:, 1] - 0.5) * 0.45
    aside = np.stack([away[:, 2], 0.0 * turn, -away[:, 0]], axis=1)
    side = _ease(-strands.points[:, 1:2], -0.045, 0.0)  # beside the ears it falls
    combed = np.cos(turn)[:, None] * away + np.sin(turn)[:, None] * aside
    return np.asarray(combed * (1.0 - 0.9 * side) + side * np.array([0.0, -1.0, -0.15]))


def _mop_cut(strands: Strands) -> NDArray[np.bool_]:
    """Off the eyes, over the ears' tops."""
    front = np.abs(_azimuth(strands.points)) < 0.9
    low = np.where(front, 0.036, -0.012) - 0.016 * strands.chance[:, 2]
    nape = strands.roots[:, 1] < 0.0
    length = np.where(nape, 0.022, 0.105) * (0.6 + 0.4 * strands.chance[:, 3])
    return np.asarray((strands.points[:, 1] < np.where(nape, -1.0, low)) | (strands.grown > length))


def _up_comb(strands: Strands) -> Floats:
    """To the knot, from all sides."""
    return np.asarray((KNOT - strands.points) * 20.0)


def _up_cut(strands: Strands) -> NDArray[np.bool_]:
    return np.asarray(np.linalg.norm(strands.points - KNOT, axis=1) < 0.021)


def _crop_comb(strands: Strands) -> Floats:
    """Straight out, a little any way."""
    away = strands.points - [0.0, 0.03, 0.055]
    return np.asarray(away / 0.08 + (strands.chance[:, 1:] - 0.5) * 2.4)


def _crop_cut(strands: Strands) -> NDArray[np.bool_]:
    length = np.interp(strands.roots[:, 1], [-0.05, 0.03, 0.08], [0.005, 0.008, 0.014])
    return np.asarray(strands.grown > length * (0.8 + 0.4 * strands.chance[:, 2]))


def _long_comb(strands: Strands) -> Floats:
    """From a parting in the middle over to either side and back off the forehead, then straight down."""
    side = np.where(strands.roots[:, 0] + 0.004 * np.sin(170.0 * strands.roots[:, 2]) > 0.0, 1.0, -1.0)
    top = _ease(strands.points[:, 1], 0.035, 0.085)[:, None]
    flat = np.zeros_like(side)
    over = np.stack([1.5 * side, flat - 0.25, flat - 0.75], axis=1)
    back = -0.8 * _ease(strands.points[:, 2], 0.045, 0.085)  # off the cheeks
    fall = np.stack([flat, flat - 1.0, back], axis=1)
    return np.asarray(top * over + (1.0 - top) * fall)


def _long_cut(strands: Strands) -> NDArray[np.bool_]:
    """As long as to the collar."""
    return np.asarray(strands.points[:, 1] < -0.118 - 0.02 * strands.chance[:, 2])


def _pixie_comb(strands: Strands) -> Floats:
    """Forwards from the whorl with a sweep to one side, close to the head behind."""
    x, y, z = strands.points.T
    away = (strands.points - WHORL) * [1.0, 0.35, 1.0] * 14.0
    away[:, 1] -= 0.6
    sweep = np.stack([np.full_like(x, -0.9), 0.0 * y, 0.0 * z], axis=1)
    front = _ease(z, 0.06, 0.12)[:, None]
    lean = (strands.chance[:, 1:2] - 0.5) * [0.4, 0.0, 0.4]
    return np.asarray(away + front * sweep + lean)


def _pixie_cut(strands: Strands) -> NDArray[np.bool_]:
    """A fringe to the brows, tapered to ears and nape."""
    length = np.interp(strands.roots[:, 1], [-0.06, 0.0, 0.05, 0.09], [0.012, 0.024, 0.046, 0.072])
    low = np.where(strands.points[:, 2] > 0.1, 0.034 + 0.14 * strands.points[:, 0], -0.2)
    return np.asarray((strands.grown > length * (0.75 + 0.5 * strands.chance[:, 2])) | (strands.points[:, 1] < low))


def _quiff_comb(strands: Strands) -> Floats:
    """Up and back on top, straight down and back at the sides."""
    x, y, z = strands.points.T
    top = _ease(strands.roots[:, 1], 0.058, 0.08)[:, None]
    up = 1.1 * _ease(strands.roots[:, 2], 0.05, 0.12) * (1.0 - _ease(strands.grown, 0.012, 0.04))
    over = np.stack([1.5 * x, up - 0.1, np.full_like(z, -1.0)], axis=1)
    down = np.stack([0.0 * x, np.full_like(y, -1.0), np.full_like(z, -0.4)], axis=1)
    lean = (strands.chance[:, 1:2] - 0.5) * [0.4, 0.0, 0.4]
    return np.asarray(top * over + (1.0 - top) * down + lean)


def _quiff_cut(strands: Strands) -> NDArray[np.bool_]:
    """Shorn at the sides, long on top."""
    length = np.interp(strands.roots[:, 1], [-0.06, 0.045, 0.07, 0.09], [0.006, 0.011, 0.045, 0.07])
    return np.asarray(strands.grown > length * (0.8 + 0.4 * strands.chance[:, 2]))


def _tail_comb(strands: Strands) -> Floats:
    """To the tail, from all sides."""
    return np.asarray((TAIL - strands.points) * 20.0)


def _tail_cut(strands: Strands) -> NDArray[np.bool_]:
    return np.asarray(np.linalg.norm(strands.points - TAIL, axis=1) < 0.014)


def _pigtail_of(points: Floats) -> Floats:
    """Where the hair at points (n, 3) is bound, (n, 3)."""
    return np.where(points[:, :1] > 0.0, PIGTAILS[0], PIGTAILS[1])


def _pigtail_comb(strands: Strands) -> Floats:
    """From the parting to the tail of its side."""
    return np.asarray((_pigtail_of(strands.roots) - strands.points) * 20.0)


def _pigtail_cut(strands: Strands) -> NDArray[np.bool_]:
    return np.asarray(np.linalg.norm(strands.points - _pigtail_of(strands.roots), axis=1) < 0.014)


def _bowl_cut(strands: Strands) -> NDArray[np.bool_]:
    """All round at the height of the brows, a little lower behind."""
    angle = np.abs(_azimuth(strands.points))
    line = 0.032 - 0.03 * _ease(angle, 0.9, 2.6)
    return np.asarray(strands.points[:, 1] < line - 0.005 * strands.chance[:, 2])


def _waves_comb(strands: Strands) -> Floats:
    """Off the forehead and out on all sides, as it is set in rollers."""
    away = (strands.points - WHORL - [0.0, 0.0, 0.02]) * [1.0, 0.35, 1.0] * 12.0
    away[:, 1] -= 0.25
    front = _ease(strands.roots[:, 2], 0.08, 0.13)[:, None]
    return np.asarray((1.0 - front) * away + front * np.array([0.5, 0.5, -0.9]) * np.sign(strands.roots[:, :1] + 1e-9))


def _waves_cut(strands: Strands) -> NDArray[np.bool_]:
    length = np.interp(strands.roots[:, 1], [-0.06, 0.02, 0.09], [0.024, 0.045, 0.06])
    return np.asarray(strands.grown > length * (0.75 + 0.5 * strands.chance[:, 2]))


def _wreath_cut(strands: Strands) -> NDArray[np.bool_]:
    return np.asarray(strands.grown > 0.028 * (0.6 + 0.8 * strands.chance[:, 2]))


GROOMS: Mapping[str, Groom] = {
    "bob": Groom(ADULT, _bob_comb, _bob_cut, layers=(0.003, 0.013), blur=0.007, count=1000, locks=0.2, sparse=0.004),
    "short": Groom(
        ADULT, _short_comb, _short_cut, layers=(0.002, 0.012), rise=0.025, hold=0.9, closing=0.0, count=1300,
        width=0.0052,
    ),
    "swept": Groom(PEAKED, _back_comb, _back_cut, layers=(0.002, 0.007), hold=1.0, free=-0.2, closing=0.004),
    "thin": Groom(
        RECEDING, _thin_comb, _thin_cut, layers=(0.001, 0.008), closing=0.0, width=0.003, wave=(0.0015, 0.03),
        locks=0.25, count=600, scalp=0.4, sparse=0.02,
    ),
    "mop": Groom(
        FRINGED, _mop_comb, _mop_cut, layers=(0.003, 0.018), hold=0.8, closing=0.006, wave=(0.0018, 0.045),
        width=0.0045, count=1400, locks=0.45,
    ),
    "bun": Groom(
        TIED, _up_comb, _up_cut, layers=(0.002, 0.006), hold=1.0, free=-0.2, bound=(Coil(KNOT, radius=0.027),),
        count=850,
    ),
    "crop": Groom(
        ADULT, _crop_comb, _crop_cut, layers=(0.02, 0.02), rise=0.001, closing=0.0, hold=0.0, stiffness=0.3,
        width=0.0055, wave=(0.0012, 0.009), count=1600,
    ),
    "long": Groom(
        TIED, _long_comb, _long_cut, layers=(0.003, 0.012), blur=0.007, count=1100, locks=0.3, length=0.3,
        wave=(0.0012, 0.07),
    ),
    "pixie": Groom(
        ADULT, _pixie_comb, _pixie_cut, layers=(0.002, 0.013), rise=0.025, hold=0.9, count=1200, width=0.005,
        locks=0.45,
    ),
    "quiff": Groom(
        ADULT, _quiff_comb, _quiff_cut, layers=(0.002, 0.02), rise=0.02, hold=0.8, closing=0.0, count=1300, width=0.005,
    ),
    "ponytail": Groom(
        TIED, _tail_comb, _tail_cut, layers=(0.002, 0.006), hold=1.0, free=-0.2, count=850,
        bound=(Tail(TAIL, radius=0.018, length=0.17),),
    ),
    "pigtails": Groom(
        TIED, _pigtail_comb, _pigtail_cut, layers=(0.002, 0.007), hold=1.0, free=-0.2, count=900,
        bound=tuple(Tail(foot, radius=0.021, length=0.13, count=200, arc=0.036) for foot in PIGTAILS),
    ),
    "bowl": Groom(
        FRINGED, _bob_comb, _bowl_cut, layers=(0.003, 0.012), blur=0.007, count=1100, locks=0.25, sparse=0.004,
    ),
    "waves": Groom(
        TIED, _waves_comb, _waves_cut, layers=(0.006, 0.024), hold=0.75, closing=0.006, count=1200, width=0.0045,
        wave=(0.004, 0.03), locks=0.7,
    ),
    "wreath": Groom(
        ADULT, _thin_comb, _wreath_cut, layers=(0.001, 0.007), closing=0.0, width=0.003, count=1000, locks=0.3,
        bald=0.064, sparse=0.008,
        wave=(0.0012, 0.02), scalp=0.1,
    ),
}  # fmt: skip
