"""Channels: ARKit blendshape weights (or any expression's) driven continuously beside the mix; and eyes and lids that
follow the gaze."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.known_names import NEUTRAL
from omote.model.space.expression import Expression
from omote.perform.frame import Gaze
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, check_known, check_within

LEFT, RIGHT = 0, 1
YAW, PITCH = 0, 1
GAZE_UNITS: Mapping[str, tuple[int, int]] = {
    "eyeLookOutLeft": (LEFT, YAW),
    "eyeLookInLeft": (LEFT, YAW),
    "eyeLookUpLeft": (LEFT, PITCH),
    "eyeLookDownLeft": (LEFT, PITCH),
    "eyeLookOutRight": (RIGHT, YAW),
    "eyeLookInRight": (RIGHT, YAW),
    "eyeLookUpRight": (RIGHT, PITCH),
    "eyeLookDownRight": (RIGHT, PITCH),
}
"""The units that turn an eyeball, and which angle of which eye each one turns; its sign is the unit's own."""


def with_channel(
    channels: Mapping[str, float], expressions: Mapping[str, Expression], name: str, value: float
) -> dict[str, float]:
    """Sets one channel (a blendshape weight); 0 removes it. Rejects unknown names, `neutral` and values out of
    range."""
    check_known(name, (unit for unit in expressions if unit != NEUTRAL), "channel")
    value = check_within(value, CHANNEL_LOWEST, CHANNEL_HIGHEST, f"the channel {name}")
    kept = {**channels, name: value}
    return {unit: kept[unit] for unit in sorted(kept) if kept[unit]}


def gaze_channels(expressions: Mapping[str, Expression], gaze: Gaze) -> dict[str, float]:
    """The `eyeLook*` weights that turn both eyeballs by the gaze: its angle over the unit's own."""
    angles = {YAW: gaze.yaw, PITCH: gaze.pitch}
    turned: dict[str, float] = {}
    for name, (eye, direction) in GAZE_UNITS.items():
        own = float(expressions[name].eyes[eye, direction]) if name in expressions else 0.0
        if own * angles[direction] > 0.0:
            turned[name] = angles[direction] / own
    return turned


def effective_channels(
    expressions: Mapping[str, Expression], channels: Mapping[str, float], gaze: Gaze
) -> dict[str, float]:
    """The blendshape weights added to the mix: channels and gaze; where both drive a unit the larger one, not the
    sum."""
    merged = dict(channels)
    for name, weight in gaze_channels(expressions, gaze).items():
        if abs(weight) > abs(merged.get(name, 0.0)):
            merged[name] = weight
    return merged


def eye_angles(
    expressions: Mapping[str, Expression], mix: Mapping[str, float], channels: Mapping[str, float]
) -> NDArray[np.float64]:
    """Yaw and pitch (radians) of the left and the right eyeball, (2, 2): those of the mix and of the channels added."""
    total = np.zeros((2, 2))
    for weights in (mix, channels):
        for name, weight in weights.items():
            total += weight * expressions[name].eyes
    return total
