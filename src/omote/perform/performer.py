"""The performer: it takes commands at any moment and says at any later time what is on air. It owns no clock."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from omote.model.cast import GENERIC, NEUTRAL
from omote.perform import axis
from omote.perform.axis import Axis
from omote.perform.channels import with_channel
from omote.perform.easing import DEFAULT_EASING, find_easing
from omote.perform.frame import Frame, Gaze, Head
from omote.perform.lights import check_light
from omote.perform.limits import FOREVER, LONGEST_CALL, SHORTEST_CALL, check_known, check_within
from omote.perform.snapshot import Playable, Snapshot, check_snapshot


class Performer:
    """Plays a cast: calls, T-bars, channels, head, gaze and light in; a frame for each step of time out."""

    def __init__(self, cast: Playable) -> None:
        check_known(GENERIC, cast.faces, "face")
        self._cast = cast
        self._now = Snapshot(Axis(GENERIC), Axis(NEUTRAL))

    @classmethod
    def restored(cls, cast: Playable, snapshot: Snapshot) -> Performer:
        """The performer that continues from a snapshot, frame by frame the same. Refuses what this cast cannot play."""
        performer = cls(cast)
        performer._now = check_snapshot(snapshot, cast)
        return performer

    def snapshot(self) -> Snapshot:
        """Everything needed to continue later, or elsewhere."""
        return self._now

    def recast(self, cast: Playable) -> None:
        """Plays another cast from now on; what is on air stays. Refuses (ValueError) one without what is on air."""
        self._now = check_snapshot(self._now, cast)
        self._cast = cast

    def call_face(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a face on air from whatever is showing; 0 seconds cut, `math.inf` waits for `fade_face`."""
        self._now = replace(
            self._now, face=_start_call(self._now.face, self._cast.faces, name, "face", seconds, easing)
        )

    def call_expression(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings an expression on air from whatever shows; 0 seconds cut, `math.inf` waits for `fade_expression`."""
        called = _start_call(self._now.expression, self._cast.expressions, name, "expression", seconds, easing)
        self._now = replace(self._now, expression=called)

    def call_light(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air from whatever light shows; 0 seconds cut."""
        check_light(name)
        find_easing(easing)
        self._now = replace(self._now, light=axis.called(self._now.light, name, _length(seconds), easing))

    def fade_face(self, x: float) -> None:
        """Moves the T-bar of the faces to `x`, 0..1; it takes over the call once it has passed its progress."""
        self._now = replace(self._now, face=axis.faded(self._now.face, check_within(x, 0.0, 1.0, "the face T-bar")))

    def fade_expression(self, x: float) -> None:
        """Moves the T-bar of the expressions to `x`, 0..1; it takes over the call once it has passed its progress."""
        hand = check_within(x, 0.0, 1.0, "the expression T-bar")
        self._now = replace(self._now, expression=axis.faded(self._now.expression, hand))

    def release_face(self) -> None:
        """Lets go of the T-bar of the faces: a timed call goes on from where it is, a call by hand stays."""
        self._now = replace(self._now, face=axis.released(self._now.face))

    def release_expression(self) -> None:
        """Lets go of the T-bar of the expressions: a timed call goes on from where it is, a call by hand stays."""
        self._now = replace(self._now, expression=axis.released(self._now.expression))

    def set_channel(self, name: str, value: float) -> None:
        """Adds an expression to the mix at once, at a weight from -0.5 to 1.5; 0 takes it out."""
        self._now = replace(self._now, channels=with_channel(self._now.channels, self._cast.expressions, name, value))

    def set_head(self, yaw: float, pitch: float, roll: float) -> None:
        """Turns the head, in radians: + is the character's left, up, tilt to its left."""
        self._now = replace(self._now, head=Head(yaw, pitch, roll))

    def set_gaze(self, yaw: float, pitch: float) -> None:
        """Turns the eyes relative to the head, in radians: + is the character's left, up."""
        self._now = replace(self._now, gaze=Gaze(yaw, pitch))

    def panic(self) -> None:
        """Neutral, now: no expression, channel, head turn, gaze or T-bar is left; face and light stay."""
        expression = Axis(NEUTRAL, hand=self._now.expression.hand)
        now = self._now
        self._now = Snapshot(axis.released(now.face), expression, time=now.time, light=now.light)

    def advance(self, dt: float) -> Frame:
        """What is on air `dt` seconds later (0 or more); one long step lands where many short ones do."""
        dt = check_within(dt, 0.0, FOREVER, "the time step (seconds)")
        now = self._now
        self._now = replace(
            now,
            face=axis.advanced(now.face, dt),
            expression=axis.advanced(now.expression, dt),
            light=axis.advanced(now.light, dt),
            time=now.time + dt,
        )
        return _frame(self._now)


def _start_call(on: Axis, names: Mapping[str, object], name: str, what: str, seconds: float, easing: str) -> Axis:
    check_known(name, names, what)
    find_easing(easing)
    if isinstance(seconds, float) and seconds == math.inf:
        return axis.called(on, name, None, easing)
    return axis.called(on, name, _length(seconds), easing)


def _length(seconds: float) -> float:
    seconds = check_within(seconds, 0.0, LONGEST_CALL, "the time of a call (seconds)")
    return seconds if seconds >= SHORTEST_CALL else 0.0


def _frame(now: Snapshot) -> Frame:
    return Frame(
        faces=axis.weights(now.face),
        expressions=axis.weights(now.expression),
        channels=now.channels,
        head=now.head,
        gaze=now.gaze,
        time=now.time,
        face_call=axis.status(now.face),
        expression_call=axis.status(now.expression),
        face_fader=now.face.hand,
        expression_fader=now.expression.hand,
        light=axis.weights(now.light),
        light_call=axis.status(now.light),
    )
