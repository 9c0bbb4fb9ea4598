"""How different colours look: CIE delta E of the year 2000 (Sharma, Wu and Dalal 2005)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.albedo import decode_light
from omote.model.appearance.lab import to_lab

Values = NDArray[np.float64]


def delta_e(picture: NDArray[np.uint8], truth: NDArray[np.uint8], seen: NDArray[np.bool_], /) -> float:
    """The mean distance of the seen colours (k, k, 3) from true ones, after both are as bright: nobody knows the light.

    Pictures are sRGB of uint8.
    """
    ours = decode_light(picture[seen]).astype(np.float64)
    theirs = decode_light(truth[seen]).astype(np.float64)
    ours *= np.median(theirs[:, 1]) / max(float(np.median(ours[:, 1])), 1e-6)
    return float(colour_distance(to_lab(ours), to_lab(theirs)).mean())


def colour_distance(one: Values, other: Values, /) -> Values:
    """Delta E 2000 of colours (n, 3) in L*a*b*: (n,)."""
    chroma = (np.hypot(one[:, 1], one[:, 2]) + np.hypot(other[:, 1], other[:, 2])) / 2
    grey = 1.5 - 0.5 * np.sqrt(chroma**7 / (chroma**7 + 25.0**7))
    a, b = one[:, 1] * grey, other[:, 1] * grey
    c1, c2 = np.hypot(a, one[:, 2]), np.hypot(b, other[:, 2])
    h1, h2 = np.arctan2(one[:, 2], a) % (2 * np.pi), np.arctan2(other[:, 2], b) % (2 * np.pi)
    turn = (h2 - h1 + np.pi) % (2 * np.pi) - np.pi
    turn = np.where(c1 * c2 == 0.0, 0.0, turn)
    hue = 2.0 * np.sqrt(c1 * c2) * np.sin(turn / 2)
    light = (one[:, 0] + other[:, 0]) / 2
    mean = (c1 + c2) / 2
    middle = np.degrees(np.where(c1 * c2 == 0.0, h1 + h2, h1 + turn / 2)) % 360.0
    t = 1 - 0.17 * np.cos(np.radians(middle - 30)) + 0.24 * np.cos(np.radians(2 * middle))
    t += 0.32 * np.cos(np.radians(3 * middle + 6)) - 0.20 * np.cos(np.radians(4 * middle - 63))
    by_light = 1 + 0.015 * (light - 50) ** 2 / np.sqrt(20 + (light - 50) ** 2)
    by_chroma = 1 + 0.045 * mean
    by_hue = 1 + 0.015 * mean * t
    bend = -2 * np.sqrt(mean**7 / (mean**7 + 25.0**7)) * np.sin(np.radians(60 * np.exp(-(((middle - 275) / 25) ** 2))))
    dl, dc, dh = (other[:, 0] - one[:, 0]) / by_light, (c2 - c1) / by_chroma, hue / by_hue
    result: Values = np.sqrt(np.maximum(dl**2 + dc**2 + dh**2 + bend * dc * dh, 0.0))
    return result
