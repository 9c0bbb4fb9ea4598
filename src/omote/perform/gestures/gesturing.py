"""The gestures of a character that run, and what they add to a frame."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass, replace

from omote.perform.easing import EASINGS
from omote.perform.frame import Frame, Head, Held, with_fields
from omote.perform.gestures.gesture_curves import CURVES, GestureName, check_gesture, mirror_channel, value_at
from omote.perform.limits import FOREVER, HEAD_LIMITS, check_within

AMPLITUDE_LIMIT = 2.0
SHORTEST_GESTURE, LONGEST_GESTURE = 0.2, 10.0
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
    known = check_gesture(name)
    strength = check_within(amplitude, -AMPLITUDE_LIMIT, AMPLITUDE_LIMIT, "the amplitude of a gesture")
    what = "the time of a gesture (seconds)"
    takes = CURVES[known].seconds if seconds is None else check_within(seconds, SHORTEST_GESTURE, LONGEST_GESTURE, what)
    return (*release_gestures(running), Gesture(known, strength, takes))[-MOST_GESTURES:]


def release_gestures(running: tuple[Gesture, ...]) -> tuple[Gesture, ...]:
    """The gestures on their way out."""
    return tuple(replace(each, released=0.0) if each.released is None else each for each in running)


def advance_gestures(running: tuple[Gesture, ...], dt: float) -> tuple[Gesture, ...]:
    """The gestures `dt` seconds later, without those that are over."""
    later = [
        replace(each, elapsed=each.elapsed + dt, released=None if each.released is None else each.released + dt)
        for each in running
    ]
    return tuple(each for each in later if not each.ended)


def with_gestures(frame: Frame, running: tuple[Gesture, ...], names: Container[str], held: Held) -> Frame:
    """A frame with what gestures add: angles to the head, and to channels what is still open.

    names: of the channels that there are. held: what hands hold, which is no longer what is on air.
    """
    if not running:
        return frame
    angles = {"yaw": frame.head.yaw, "pitch": frame.head.pitch, "roll": frame.head.roll}
    channels = dict(frame.channels)
    for each in running:
        curves, share, strength = CURVES[each.name], each.elapsed / each.seconds, each.strength
        for angle, curve in (("yaw", curves.yaw), ("pitch", curves.pitch), ("roll", curves.roll)):
            angles[angle] += strength * value_at(curve, share)
        for name, curve in curves.channels.items():
            where = name if each.amplitude >= 0.0 else mirror_channel(name)
            added = min(abs(strength) * value_at(curve, share), 1.0)
            before = channels.get(where, 0.0)
            if where in names and added:
                channels[where] = before + added * max(1.0 - before, 0.0)
    head = Head(**{angle: min(max(turn, -HEAD_LIMITS[angle]), HEAD_LIMITS[angle]) for angle, turn in angles.items()})
    return with_fields(frame, head=head, channels=channels, held=held if frame.held is None else frame.held)


def check_gestures(running: tuple[Gesture, ...]) -> tuple[Gesture, ...]:
    """Returns gestures that were read; ValueError for those that none has made."""
    if len(running) > MOST_GESTURES:
        raise ValueError(f"{len(running)} gestures run in the snapshot; at most {MOST_GESTURES} do")
    for each in running:
        check_gesture(each.name)
        check_within(each.amplitude, -AMPLITUDE_LIMIT, AMPLITUDE_LIMIT, "the amplitude of a gesture")
        check_within(each.seconds, SHORTEST_GESTURE, LONGEST_GESTURE, "the time of a gesture (seconds)")
        check_within(each.elapsed, 0.0, FOREVER, "the elapsed time of a gesture (seconds)")
        if each.released is not None:
            check_within(each.released, 0.0, FOREVER, "the time since a gesture was interrupted (seconds)")
    return running
