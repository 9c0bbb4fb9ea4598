"""The guided minute: what a performer is asked to do, and what that is in units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from omote.inputs.camera.landmark_map import UNITS

NEUTRAL = "neutral"
GUIDED: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "shut": {"eyeBlink": 1.0},
        "wide": {"eyeWide": 1.0, "browInnerUp": 0.15},
        "smile": {"mouthSmile": 0.9, "cheekSquint": 0.3, "eyeSquint": 0.1},
        "pucker": {"mouthPucker": 0.95},
        "aa": {"jawOpen": 0.7, "mouthLowerDown": 0.15},
        "ee": {"mouthStretch": 0.5, "mouthSmile": 0.4, "mouthLowerDown": 0.3, "jawOpen": 0.12},
        "oo": {"mouthFunnel": 0.6, "mouthPucker": 0.5, "jawOpen": 0.25},
        "browsUp": {"browInnerUp": 0.9, "browOuterUp": 0.9},
        "browsDown": {"browDown": 0.9},
        "puff": {"cheekPuff": 0.9, "mouthPress": 0.1},
    }
)
"""Weights that a face wears at each step, about; of pairs both sides."""
LOOKS: Mapping[str, tuple[float, float]] = MappingProxyType(
    {name: (math.radians(yaw), math.radians(pitch)) for name, yaw, pitch in (
        ("left", 25.0, 0.0), ("right", -25.0, 0.0), ("up", 0.0, 15.0), ("down", 0.0, -15.0)
    )}
)  # fmt: skip
"""Yaw and pitch of the eyes at each step for the gaze, about, radians."""
STEPS = (NEUTRAL, *(name for name in GUIDED if name != "puff"), *LOOKS, "puff")
"""All steps in the order in which they are asked for."""


def guided_weights(step: str) -> NDArray[np.float64]:
    """The weights of UNITS at a step."""
    weights = np.zeros(len(UNITS))
    for group, weight in GUIDED[step].items():
        for name in (group, f"{group}Left", f"{group}Right"):
            if name in UNITS:
                weights[UNITS.index(name)] = weight
    return weights
