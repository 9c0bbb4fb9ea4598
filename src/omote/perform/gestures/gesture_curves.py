"""The gestures that there are: what each does to the head and to the channels, over its time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from types import MappingProxyType
from typing import Literal, get_args

from omote.perform.easing import EASINGS
from omote.perform.limits import check_known

GestureName = Literal["nod", "shake", "tilt", "bow", "shrug", "brows", "wink"]
GESTURES: tuple[GestureName, ...] = get_args(GestureName)
_EASE = EASINGS["smooth"]
Curve = tuple[tuple[float, float], ...]
"""Shares of the time with values; smooth between them, 0 at both ends."""


@dataclass(frozen=True)
class GestureCurves:
    """A gesture. seconds: how long it takes by itself; yaw, pitch, roll: radians; channels: weights."""

    seconds: float
    yaw: Curve = ()
    pitch: Curve = ()
    roll: Curve = ()
    channels: Mapping[str, Curve] = field(default_factory=dict)


def _held(value: float, rise: float = 0.3, fall: float = 0.6) -> Curve:
    """Up to a value, there for a while, and back."""
    return ((0.0, 0.0), (rise, value), (fall, value), (1.0, 0.0))


_CURVES: dict[GestureName, GestureCurves] = {
    "nod": GestureCurves(0.9, pitch=((0.0, 0.0), (0.28, -0.22), (0.52, 0.02), (0.74, -0.11), (1.0, 0.0))),
    "shake": GestureCurves(
        1.2, yaw=((0.0, 0.0), (0.18, 0.22), (0.4, -0.22), (0.6, 0.16), (0.8, -0.1), (1.0, 0.0))
    ),
    "tilt": GestureCurves(1.6, roll=_held(0.2), pitch=_held(0.03)),
    "bow": GestureCurves(2.0, pitch=_held(-0.55, 0.35, 0.55), channels={"eyeBlinkLeft": _held(0.5, 0.35, 0.55),
                         "eyeBlinkRight": _held(0.5, 0.35, 0.55)}),
    "shrug": GestureCurves(1.2, roll=_held(0.08), channels={"browInnerUp": _held(0.7), "browOuterUpLeft": _held(0.6),
                           "browOuterUpRight": _held(0.6), "mouthShrugLower": _held(0.4),
                           "mouthFrownLeft": _held(0.25), "mouthFrownRight": _held(0.25)}),
    "brows": GestureCurves(0.7, channels={"browInnerUp": _held(0.8), "browOuterUpLeft": _held(0.7),
                           "browOuterUpRight": _held(0.7), "eyeWideLeft": _held(0.25), "eyeWideRight": _held(0.25)}),
    "wink": GestureCurves(0.5, roll=_held(0.04), channels={"eyeBlinkLeft": _held(1.0), "cheekSquintLeft": _held(0.5),
                          "browDownLeft": _held(0.3), "mouthSmileLeft": _held(0.25)}),
}  # fmt: skip
CURVES: Mapping[GestureName, GestureCurves] = MappingProxyType(_CURVES)


def check_gesture(name: object) -> GestureName:
    """The gesture of this name; ValueError with those that there are where there is none."""
    found = check_known(name, GESTURES, "gesture")
    return next(gesture for gesture in GESTURES if gesture == found)


def value_at(curve: Curve, share: float) -> float:
    """The value of a curve at a share of its time; nothing before and after it."""
    if not 0.0 < share < 1.0:
        return 0.0
    for (start, low), (end, high) in pairwise(curve):
        if share <= end:
            return low + (high - low) * _EASE.value((share - start) / (end - start))
    return 0.0


def mirror_channel(channel: str) -> str:
    """The channel of the other side of the face."""
    if channel.endswith("Left"):
        return channel.removesuffix("Left") + "Right"
    return channel.removesuffix("Right") + "Left" if channel.endswith("Right") else channel
