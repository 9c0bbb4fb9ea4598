"""Converts a frame of the engine to a state on the wire."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from omote.perform.channels import effective_channels, eye_angles
from omote.perform.easing import DEFAULT_EASING, EASINGS
from omote.perform.frame import CallStatus, Frame
from omote.show.messages import CallState, State

if TYPE_CHECKING:
    from omote.perform.snapshot import Playable


EYE_SECONDS = 0.25
"""Eyes of an expression that changes on air take as long as its skin does on a stage (`source_crossfade.ts`)."""

Angles = tuple[float, float, float, float]


@dataclass(frozen=True)
class EyeOffset:
    """How far the eyes were from where a changed cast has them (radians, as `State.eyes`), at `start`; it eases out."""

    angles: Angles = (0.0, 0.0, 0.0, 0.0)
    start: float = -EYE_SECONDS

    def add_to(self, eyes: Angles, time: float) -> Angles:
        """The angles that show at `time`, seconds of the show."""
        part = (time - self.start) / EYE_SECONDS
        if part >= 1.0:
            return eyes
        rest = 1.0 - EASINGS[DEFAULT_EASING].value(part)
        left_yaw, left_pitch, right_yaw, right_pitch = (
            eye + rest * offset for eye, offset in zip(eyes, self.angles, strict=True)
        )
        return left_yaw, left_pitch, right_yaw, right_pitch


def offset_between(shown: Angles, wanted: Angles, time: float) -> EyeOffset:
    """What keeps the eyes where they show, from `time` (seconds of the show) on."""
    left_yaw, left_pitch, right_yaw, right_pitch = (before - after for before, after in zip(shown, wanted, strict=True))
    return EyeOffset((left_yaw, left_pitch, right_yaw, right_pitch), time)


def state_of(cast: Playable, frame: Frame, *, epoch: int, number: int, revision: int) -> State:
    """The complete state of a frame; `eyes` and `gaze_lids` are what the gaze makes of it."""
    channels = effective_channels(cast.expressions, frame.channels, frame.gaze)
    eyes = eye_angles(cast.expressions, frame.expressions, channels).ravel().tolist()
    return State(
        epoch=epoch,
        number=number,
        time=frame.time,
        revision=revision,
        faces=dict(frame.faces),
        expressions=dict(frame.expressions),
        channels=dict(frame.channels),
        head=(frame.head.yaw, frame.head.pitch, frame.head.roll),
        gaze=(frame.gaze.yaw, frame.gaze.pitch),
        eyes=(eyes[0], eyes[1], eyes[2], eyes[3]),
        lids=gaze_lids(frame.channels, channels),
        face_call=call_state(frame.face_call),
        expression_call=call_state(frame.expression_call),
        face_fader=frame.face_fader,
        expression_fader=frame.expression_fader,
        light=dict(frame.light),
        light_call=call_state(frame.light_call),
        panics=frame.panics,
        home_face=frame.home.face,
        home_seconds=frame.home.seconds,
        home_next=frame.home_next,
    )


def call_state(status: CallStatus | None) -> CallState | None:
    """The call on the wire; None when none runs."""
    if status is None:
        return None
    return CallState(
        target=status.target,
        progress=status.progress,
        remaining=status.remaining,
        by_hand=status.by_hand,
        fader=status.fader,
        pickup=status.pickup,
        start=dict(status.start),
    )


def gaze_lids(channels: Mapping[str, float], effective: Mapping[str, float]) -> dict[str, float]:
    """What the gaze adds to the channels, name by name."""
    added = {name: weight - channels.get(name, 0.0) for name, weight in effective.items()}
    return {name: weight for name, weight in added.items() if weight}


def names_on_air(state: State) -> tuple[frozenset[str], frozenset[str]]:
    """The faces and the expressions (channels are expressions too) that are on air or called."""
    faces = state.faces.keys() | ({state.face_call.target} if state.face_call else set())
    called = {state.expression_call.target} if state.expression_call else set()
    return frozenset(faces), frozenset(state.expressions.keys() | state.channels.keys() | state.lids.keys() | called)
