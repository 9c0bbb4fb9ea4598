"""The hair styles of the cast as recipes for the generic head; lengths in metres, heights over its eyes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tools.baking.basemesh import Floats
from tools.baking.hair_groom import Groom, Strands

ADULT = (
    (0.0, 0.076),
    (0.35, 0.074),
    (0.62, 0.063),
    (0.85, 0.046),
    (1.05, 0.03),
    (1.3, 0.004),
    (1.55, 0.022),
    (1.9, 0.0),
    (2.2, -0.04),
    (3.2, -0.06),
)
WHORL = np.array([0.0, 0.125, 0.04])


def azimuth(points: Floats) -> Floats:
    """The angle (n,) around the skull's middle, 0 straight ahead."""
    return np.asarray(np.arctan2(points[:, 0], points[:, 2] - 0.06))


def _bob_comb(strands: Strands) -> Floats:
    """Away from the whorl, down over the sides; the tips turn inwards below the jaw's corner."""
    away = (strands.points - WHORL) * [1.0, 0.4, 1.0] * 14.0
    away[:, 1] -= 0.55
    below = np.clip((-0.035 - strands.points[:, 1]) / 0.03, 0.0, 1.0)[:, None]
    inward = (np.array([0.0, 0.0, 0.045]) - strands.points) * [1.0, 0.0, 1.0] * 11.0
    side = np.clip(-strands.points[:, 1:2] / 0.02 + 2.0, 0.0, 1.0)
    fall = np.array([0.0, -1.0, 0.0])
    return np.asarray(away * (1.0 - 0.9 * side) + side * fall + below * inward)


def _bob_cut(strands: Strands) -> NDArray[np.bool_]:
    """A straight fringe above the brows, the rest as long as the chin."""
    angle = np.abs(azimuth(strands.points))
    fringe = (angle < 0.58) & (strands.points[:, 2] > 0.1)
    jitter = strands.chance[:, 2]
    brow = 0.029 - 3.5 * strands.points[:, 0] ** 2 - 0.006 * jitter
    chin = -0.082 + 0.012 * np.clip((angle - 1.2) / 1.5, 0.0, 1.0) - 0.006 * jitter
    return np.asarray(strands.points[:, 1] < np.where(fringe, brow, chin))


GROOMS: Mapping[str, Groom] = {
    "bob": Groom(ADULT, _bob_comb, _bob_cut, layers=(0.003, 0.013), blur=0.007, count=1000),
}
