"""What each command of a console does to the scene and its characters."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import msgspec
import numpy as np

from omote.perform.limits import check_known
from omote.perform.performer import Performer
from omote.perform.scene.character_names import ALL
from omote.perform.scene.scene import Scene
from omote.show import messages as wire
from omote.show.validation import Refusal


def _call_face(performer: Performer, call: wire.CallFace) -> None:
    performer.call_face(call.name, seconds=_seconds(call.seconds), easing=call.easing)


def _call_expression(performer: Performer, call: wire.CallExpression) -> None:
    if call.region is not None and call.seconds is None:
        raise Refusal("a region of a face has no T-bar: give the seconds of the call, or call the whole face.")
    performer.call_expression(
        call.name,
        seconds=_seconds(call.seconds),
        easing=call.easing,
        region=call.region,
        strength=call.strength,
    )


def _say(performer: Performer, asked: wire.Say) -> None:
    if len(asked.times) % 4:
        raise Refusal(f"the times have {len(asked.times)} bytes; send float32 numbers of 4 bytes each.")
    performer.say(
        asked.text,
        timing=asked.timing,
        marks=asked.marks,
        times=np.frombuffer(asked.times, "<f4").astype(np.float64).tolist(),
        language=asked.language,
        seconds=asked.seconds,
        sound=asked.sound,
        delay=asked.delay,
        offset=asked.offset,
        queue=asked.queue,
        key=asked.key,
    )


def _seconds(seconds: float | None) -> float:
    if seconds is None:
        return math.inf  # by hand: the performer's own word for a call that waits for its T-bar
    if seconds == math.inf:
        raise Refusal("the time of a call (seconds) is inf; give a number of seconds, or nil for a call by hand.")
    return seconds


ACTIONS: dict[type[wire.Message], Callable[[Performer, Any], None]] = {
    wire.CallFace: _call_face,
    wire.CallExpression: _call_expression,
    wire.FadeFace: lambda performer, bar: performer.fade_face(bar.value),
    wire.ReleaseFace: lambda performer, _: performer.release_face(),
    wire.FadeExpression: lambda performer, bar: performer.fade_expression(bar.value),
    wire.ReleaseExpression: lambda performer, _: performer.release_expression(),
    wire.SetChannel: lambda performer, fader: performer.set_channel(fader.name, fader.value),
    wire.SetHead: lambda performer, head: performer.set_head(head.yaw, head.pitch, head.roll),
    wire.SetGaze: lambda performer, gaze: performer.set_gaze(gaze.yaw, gaze.pitch),
    wire.SetLayer: lambda performer, asked: performer.set_layer(
        asked.layer, region=asked.region, influence=asked.influence, on=asked.on
    ),
    wire.SetMotion: lambda performer, asked: performer.set_motion(
        asked.liveliness, blinks=asked.blinks, gaze=asked.gaze, breath=asked.breath, seed=asked.seed, idle=asked.idle
    ),
    wire.Say: _say,
    wire.StopSpeaking: lambda performer, _: performer.stop_speaking(),
    wire.MakeGesture: lambda performer, asked: performer.gesture(
        asked.name, amplitude=asked.amplitude, seconds=asked.seconds
    ),
    wire.Panic: lambda performer, _: performer.panic(),
    wire.SetHome: lambda performer, home: performer.set_home(home.face, seconds=home.seconds),
}
"""The action of each command on a performer, which alone validates names and numbers (`perform/limits.py`)."""


def _add(scene: Scene, asked: wire.AddCharacter) -> None:
    """One of the same name that is still on its way out stays, with the label and the face that are asked for."""
    found = scene.snapshot().characters.get(asked.character)
    if found is None or not found.standing.leaves:
        scene.add(asked.character, face=asked.face, label=asked.label)
        return
    scene[asked.character].call_face(asked.face)
    scene.rename(asked.character, asked.label)
    scene.enter(asked.character)


def _remove(scene: Scene, asked: wire.RemoveCharacter) -> None:
    standing = {name: each.standing for name, each in scene.snapshot().characters.items()}
    check_known(asked.character, standing, "character")
    if all(each.leaves for name, each in standing.items() if name != asked.character):
        raise Refusal(f"{standing[asked.character].label} is the last character: add another one first.")
    scene.remove(asked.character, seconds=asked.seconds, key=asked.key)


def _place(scene: Scene, asked: wire.PlaceCharacter) -> None:
    x, depth, size, turn = asked.x, asked.depth, asked.size, asked.turn
    for name in characters_of(scene, asked.character):
        scene.place(name, x=x, depth=depth, size=size, turn=turn, seconds=asked.seconds)


def _enter(scene: Scene, asked: wire.EnterCharacter) -> None:
    for name in characters_of(scene, asked.character):
        scene.enter(name, seconds=asked.seconds)


def _leave(scene: Scene, asked: wire.LeaveCharacter) -> None:
    for name in characters_of(scene, asked.character):
        scene.leave(name, seconds=asked.seconds)


def _look_at(scene: Scene, asked: wire.LookAt) -> None:
    """Of all, the one that is looked at is left out."""
    for name in characters_of(scene, asked.character):
        if (asked.character, asked.kind, asked.name) != (ALL, "character", name):
            at = {"yaw": asked.yaw, "pitch": asked.pitch, "x": asked.x, "y": asked.y, "z": asked.z}
            scene[name].look_at(asked.kind, asked.name, **at)


SCENE_ACTIONS: dict[type[wire.Message], Callable[[Scene, Any], Any]] = {
    wire.CallLight: lambda scene, call: scene.call_light(call.name, seconds=_seconds(call.seconds), easing=call.easing),
    wire.CallFraming: lambda scene, call: scene.call_framing(call.characters, seconds=call.seconds, easing=call.easing),
    wire.AddCharacter: _add,
    wire.RemoveCharacter: _remove,
    wire.RestoreCharacter: lambda scene, asked: scene.restore(asked.key, seconds=asked.seconds),
    wire.RenameCharacter: lambda scene, asked: scene.rename(asked.character, asked.label),
    wire.PlaceCharacter: _place,
    wire.EnterCharacter: _enter,
    wire.LeaveCharacter: _leave,
    wire.LookAt: _look_at,
    wire.SetGazePoint: lambda scene, asked: scene.set_gaze_point(asked.name, x=asked.x, y=asked.y, z=asked.z),
    wire.DeleteGazePoint: lambda scene, asked: scene.delete_gaze_point(asked.name),
}
"""The action of each command on the scene."""


def carry_out(scene: Scene, message: wire.FromClient) -> None:
    """Does what a command asks for, of all characters that it is for; ValueError and TypeError where it cannot be.

    All characters have one cast and the same ranges: what one rejects the first rejects, and nothing has changed.
    """
    if type(message) in SCENE_ACTIONS:
        SCENE_ACTIONS[type(message)](scene, message)
        return
    for name in characters_of(scene, message.character):  # type: ignore[union-attr]
        ACTIONS[type(message)](scene[name], message)


def characters_of(scene: Scene, character: str) -> tuple[str, ...]:
    """The characters that a message is for; ValueError where there is none of that name."""
    if character in scene:
        return (character,)
    names = tuple(scene)
    return names if character == ALL else (check_known(character, names, "character"),)


def find_addressed(scene: Scene, message: wire.FromClient) -> tuple[str, ...]:
    """The characters that a message is for; none for one of the whole scene, or that names nobody there is."""
    character = getattr(message, "character", "")
    if character in scene:
        return (character,)
    return characters_of(scene, character) if character == ALL else ()


def refuse_unknown(scene: Scene, character: str) -> None:
    """Refusal where a message is not for one character of the scene."""
    try:
        check_known(character, scene, "character")
    except ValueError as error:
        raise Refusal(f"{error}.") from error


@contextmanager
def refuse_errors(message: wire.FromClient) -> Iterator[None]:
    """What cannot be done of a message is a Refusal that says why."""
    try:
        yield
    except Refusal:
        raise
    except (ValueError, TypeError) as error:
        raise Refusal(f"{error}. Nothing has changed.{reload_hint(message)}") from error


def reload_hint(message: wire.FromClient) -> str:
    """What to do about a number that no hand can have set: the page that sent it has gone wrong."""
    values = msgspec.structs.astuple(message)
    wrong = any(isinstance(value, float) and not math.isfinite(value) for value in values)
    return " Send a finite number; a page that sends another is to be reloaded." if wrong else ""
