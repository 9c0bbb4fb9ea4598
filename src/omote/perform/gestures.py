"""The gestures of a character that run, and what they add to a frame."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from types import MappingProxyType
from typing import Literal, get_args

from omote.model.space.expression import Expression
from omote.perform.channels import channels_of
from omote.perform.easing import EASINGS
from omote.perform.frame import Frame, Head, Held, with_fields
from omote.perform.limits import FOREVER, HEAD_LIMITS, check_known, check_within

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
    return check_known(name, GESTURES, "gesture")


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


AMPLITUDE_LIMIT = 2.0
SHORTEST_GESTURE = 0.2
LONGEST_GESTURE = 10.0
RELEASE_SECONDS = 0.25
"""In which a gesture goes that another interrupts."""
MOST_GESTURES = 32
"""That run at once: all but the last are on their way out."""
_RELEASE = EASINGS["smooth"]


@dataclass(frozen=True)
class Gesture:
    """One that runs. amplitude: 1 as it is, below 0 to the other side; elapsed: seconds; released: for how long it has
    been on its way out, None while it is not."""

    name: GestureName
    amplitude: float
    seconds: float
    elapsed: float = 0.0
    released: float | None = None

    @property
    def ended(self) -> bool:
        """Whether it adds nothing any more."""
        return self.elapsed >= self.seconds or (self.released is not None and self.released >= RELEASE_SECONDS)

    @property
    def strength(self) -> float:
        """How much of it is on air."""
        if self.released is None:
            return self.amplitude
        return self.amplitude * (1.0 - _RELEASE.value(min(self.released / RELEASE_SECONDS, 1.0)))


def begin_gesture(
    running: tuple[Gesture, ...], name: object, amplitude: object, seconds: object
) -> tuple[Gesture, ...]:
    """The gestures with another one, which the others make way for.

    Parameters
    ----------
    running : tuple of Gesture
        Those on air.
    name : str
        One of `GESTURES`.
    amplitude : float
        -2 to 2: 1 as it is, below 0 to the other side (a nod: up).
    seconds : float or None
        How long it takes, 0.2 to 10; None: as it takes by itself.

    Returns
    -------
    tuple of Gesture
        The newest last.

    Raises
    ------
    ValueError
        On a name that there is not, on numbers out of range.
    TypeError
        On what is no number.
    """
    gesture = check_gesture(name)
    strength = check_within(amplitude, -AMPLITUDE_LIMIT, AMPLITUDE_LIMIT, "the amplitude of a gesture")
    what = "the time of a gesture (seconds)"
    takes = (
        CURVES[gesture].seconds if seconds is None else check_within(seconds, SHORTEST_GESTURE, LONGEST_GESTURE, what)
    )
    return (*release_gestures(running), Gesture(gesture, strength, takes))[-MOST_GESTURES:]


def release_gestures(running: tuple[Gesture, ...]) -> tuple[Gesture, ...]:
    """The gestures on their way out."""
    return tuple(replace(gesture, released=0.0) if gesture.released is None else gesture for gesture in running)


def advance_gestures(running: tuple[Gesture, ...], dt: float) -> tuple[Gesture, ...]:
    """The gestures `dt` seconds later, without those that are over. running: those under way."""
    later = [
        replace(
            gesture, elapsed=gesture.elapsed + dt, released=None if gesture.released is None else gesture.released + dt
        )
        for gesture in running
    ]
    return tuple(gesture for gesture in later if not gesture.ended)


def with_gestures(
    frame: Frame, running: tuple[Gesture, ...], expressions: Mapping[str, Expression], held: Held
) -> Frame:  # fmt: skip
    """A frame with what gestures add: angles to the head, and to channels what is still open.

    running: those under way.

    expressions: those of the cast, by name, which are the channels too. held: what hands hold, which is no longer what
    is on air.
    """
    if not running:
        return frame
    angles = {"yaw": frame.head.yaw, "pitch": frame.head.pitch, "roll": frame.head.roll}
    channels = channels_of(expressions, frame)
    for gesture in running:
        curves = CURVES[gesture.name]
        share = gesture.elapsed / gesture.seconds
        strength = gesture.strength
        for angle, curve in (("yaw", curves.yaw), ("pitch", curves.pitch), ("roll", curves.roll)):
            angles[angle] += strength * value_at(curve, share)
        for name, curve in curves.channels.items():
            where = name if gesture.amplitude >= 0.0 else mirror_channel(name)
            added = min(abs(strength) * value_at(curve, share), 1.0)
            before = channels.get(where, 0.0)
            if where in expressions and added:
                channels[where] = before + added * max(1.0 - before, 0.0)
    head = Head(**{angle: min(max(turn, -HEAD_LIMITS[angle]), HEAD_LIMITS[angle]) for angle, turn in angles.items()})
    return with_fields(frame, head=head, channels=channels, held=held if frame.held is None else frame.held)


def check_gestures(running: tuple[Gesture, ...]) -> tuple[Gesture, ...]:
    """Returns gestures that were read; ValueError for those that none has made."""
    if len(running) > MOST_GESTURES:
        raise ValueError(f"{len(running)} gestures run in the snapshot; at most {MOST_GESTURES} do")
    for gesture in running:
        check_gesture(gesture.name)
        check_within(gesture.amplitude, -AMPLITUDE_LIMIT, AMPLITUDE_LIMIT, "the amplitude of a gesture")
        check_within(gesture.seconds, SHORTEST_GESTURE, LONGEST_GESTURE, "the time of a gesture (seconds)")
        check_within(gesture.elapsed, 0.0, FOREVER, "the elapsed time of a gesture (seconds)")
        if gesture.released is not None:
            check_within(gesture.released, 0.0, FOREVER, "the time since a gesture was interrupted (seconds)")
    return running
