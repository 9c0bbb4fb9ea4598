"""Clamping and smoothstep, as in GLSL."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Values = NDArray[Any]


def clamp_unit(values: Values, /) -> Values:
    """Clamps values to [0, 1]."""
    return np.clip(values, 0.0, 1.0)


def smooth_ramp(low: float, high: float, values: Values, /) -> Values:
    """0 up to low, 1 from high on, level at both ends (GLSL's smoothstep). values: any shape."""
    share = clamp_unit((values - low) / (high - low))
    return share * share * (3.0 - 2.0 * share)
