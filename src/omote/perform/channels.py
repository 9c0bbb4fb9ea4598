"""Channels: ARKit blendshape weights (or any expression's) driven continuously beside the mix; and eyes and lids that
follow the gaze."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.model.known_names import NEUTRAL
from omote.model.space.expression import STILL_EYES, Expression
from omote.perform.frame import Frame, Gaze
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, check_known, check_within

LEFT = 0
RIGHT = 1
YAW = 0
PITCH = 1
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


SIGNED_LOWEST = -1.0
"""The smallest weight of a signed channel: no spring goes further (`springs.spring.RANGES`)."""


def highest_weight(expressions: Mapping[str, Expression], name: str) -> float:
    """The largest weight that a channel has on air: of a unit that turns an eye, what the widest gaze makes of it.

    expressions: those of the cast, by name; name: of the channel.
    """
    if name not in GAZE_UNITS or name not in expressions:
        return CHANNEL_HIGHEST
    eye, direction = GAZE_UNITS[name]
    own = abs(float(expressions[name].eyes[eye, direction]))
    widest = tuple(GAZE_LIMITS.values())[direction]
    return max(CHANNEL_HIGHEST, widest / own) if own else CHANNEL_HIGHEST


def lowest_weight(expressions: Mapping[str, Expression], name: str) -> float:
    """The smallest weight that a channel has on air: of a signed one, which springs play, as far as the largest of a
    spring.

    expressions: those of the cast, by name; name: of the channel.
    """
    return SIGNED_LOWEST if name in expressions and expressions[name].signed else CHANNEL_LOWEST


def with_channel(
    channels: Mapping[str, float], expressions: Mapping[str, Expression], name: str, value: float
) -> dict[str, float]:
    """Sets one channel (a blendshape weight); 0 removes it. Rejects unknown names, `neutral` and values out of
    range.

    channels: weights by name; expressions: those of the cast, by name; name: of the channel; value: -0.5 to 1.5.
    """
    return with_channels(channels, expressions, {name: value})


def with_channels(
    channels: Mapping[str, float], expressions: Mapping[str, Expression], values: Mapping[str, float]
) -> dict[str, float]:
    """Sets some channels, as `with_channel` one after the other, or none where one is rejected.

    expressions: those of the cast, by name; values: weights by name, -0.5 to 1.5.
    """
    kept = dict(channels)
    in_order = True
    for name, value in values.items():
        if name == NEUTRAL or name not in expressions:
            check_known(name, (unit for unit in expressions if unit != NEUTRAL), "channel")
        if not (type(value) is float and CHANNEL_LOWEST <= value <= CHANNEL_HIGHEST):
            value = check_within(value, CHANNEL_LOWEST, CHANNEL_HIGHEST, f"the channel {name}")
        in_order = in_order and value != 0.0 and name in channels
        kept[name] = value
    if in_order:
        return kept
    return {unit: kept[unit] for unit in sorted(kept) if kept[unit]}


def gaze_channels(expressions: Mapping[str, Expression], gaze: Gaze, vergence: float = 0.0) -> dict[str, float]:
    """The `eyeLook*` weights that turn both eyeballs by the gaze: its angle over the unit's own. vergence: radians by
    which each eye turns in, as far as an eye can.

    expressions: those of the cast, by name.
    """
    turned: dict[str, float] = {}
    if not (gaze.yaw or gaze.pitch or vergence):
        return turned
    widest = GAZE_LIMITS["yaw"]
    yaws = (gaze.yaw - vergence, gaze.yaw + vergence) if vergence else (gaze.yaw, gaze.yaw)
    for name, (eye, direction) in GAZE_UNITS.items():
        angle = min(max(yaws[eye], -widest), widest) if direction == YAW else gaze.pitch
        own = expressions[name].eye_turns[2 * eye + direction] if name in expressions else 0.0
        if own * angle > 0.0:
            turned[name] = angle / own
    return turned


def effective_channels(
    expressions: Mapping[str, Expression], channels: Mapping[str, float], gaze: Gaze
) -> dict[str, float]:
    """The blendshape weights added to the mix: channels and gaze; where both drive a unit the larger one, not the
    sum.

    expressions: those of the cast, by name.
    """
    merged = dict(channels)
    for name, weight in gaze_channels(expressions, gaze).items():
        if abs(weight) > abs(merged.get(name, 0.0)):
            merged[name] = weight
    return merged


def channels_of(expressions: Mapping[str, Expression], frame: Frame) -> dict[str, float]:
    """The blendshape weights that a frame adds to the mix, its gaze among them.

    expressions: those of the cast, by name.
    """
    if frame.held is not None:  # layers have mixed each one's gaze with its channels
        return dict(frame.channels)
    return effective_channels(expressions, frame.channels, frame.gaze)


def eye_angles(
    expressions: Mapping[str, Expression], mix: Mapping[str, float], channels: Mapping[str, float]
) -> NDArray[np.float64]:
    """Yaw and pitch (radians) of the left and the right eyeball, (2, 2): those of the mix and of the channels added.

    expressions: those of the cast, by name.
    """
    return np.array(eye_turns(expressions, mix, channels)).reshape(2, 2)


def eye_turns(
    expressions: Mapping[str, Expression], mix: Mapping[str, float], channels: Mapping[str, float]
) -> tuple[float, float, float, float]:
    """Yaw and pitch of the left eyeball, then of the right one, as `eye_angles`: plain numbers, for each state.

    expressions: those of the cast, by name; mix: weights of expressions; channels: weights that are added.
    """
    left_yaw = left_pitch = right_yaw = right_pitch = 0.0
    for weights in (mix, channels):
        for name, weight in weights.items():
            turns = expressions[name].eye_turns
            if turns is STILL_EYES:
                continue  # nearly all
            left_yaw += weight * turns[0]
            left_pitch += weight * turns[1]
            right_yaw += weight * turns[2]
            right_pitch += weight * turns[3]
    return left_yaw, left_pitch, right_yaw, right_pitch
