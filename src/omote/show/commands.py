"""What each command of a console does to the performer."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import msgspec

from omote.perform.performer import Performer
from omote.show import messages as wire
from omote.show.validation import Refusal


def _call_face(performer: Performer, call: wire.CallFace) -> None:
    performer.call_face(call.name, seconds=_seconds(call.seconds), easing=call.easing)


def _call_expression(performer: Performer, call: wire.CallExpression) -> None:
    performer.call_expression(call.name, seconds=_seconds(call.seconds), easing=call.easing)


def _call_light(performer: Performer, call: wire.CallLight) -> None:
    performer.call_light(call.name, seconds=_seconds(call.seconds), easing=call.easing)


def _seconds(seconds: float | None) -> float:
    if seconds is None:
        return math.inf  # by hand: the performer's own word for a call that waits for its T-bar
    if seconds == math.inf:
        raise Refusal("the time of a call (seconds) is inf; give a number of seconds, or nil for a call by hand.")
    return seconds


ACTIONS: dict[type[wire.Message], Callable[[Performer, Any], None]] = {
    wire.CallFace: _call_face,
    wire.CallExpression: _call_expression,
    wire.CallLight: _call_light,
    wire.FadeFace: lambda performer, bar: performer.fade_face(bar.value),
    wire.ReleaseFace: lambda performer, _: performer.release_face(),
    wire.FadeExpression: lambda performer, bar: performer.fade_expression(bar.value),
    wire.ReleaseExpression: lambda performer, _: performer.release_expression(),
    wire.SetChannel: lambda performer, fader: performer.set_channel(fader.name, fader.value),
    wire.SetHead: lambda performer, head: performer.set_head(head.yaw, head.pitch, head.roll),
    wire.SetGaze: lambda performer, gaze: performer.set_gaze(gaze.yaw, gaze.pitch),
    wire.Panic: lambda performer, _: performer.panic(),
    wire.SetHome: lambda performer, home: performer.set_home(home.face, seconds=home.seconds),
}
"""The action of each command on the performer, which alone validates names and numbers (`perform/limits.py`)."""


def reload_hint(message: wire.FromClient) -> str:
    """What to do about a number that no hand can have set: the page that sent it has gone wrong."""
    values = msgspec.structs.astuple(message)
    wrong = any(isinstance(value, float) and not math.isfinite(value) for value in values)
    return " Reload the page that sent it." if wrong else ""
