"""A character of a scene: a performer whose light is the scene's."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from omote.perform.easing import DEFAULT_EASING
from omote.perform.performer import Performer
from omote.perform.snapshot import Playable, Snapshot


class CallLight(Protocol):
    """How a scene's light is called."""

    def __call__(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air."""


class SceneCharacter(Performer):
    """A performer in a scene."""

    _call_light: CallLight

    @classmethod
    def of(cls, cast: Playable, snapshot: Snapshot, call_light: CallLight) -> SceneCharacter:
        """The character of a snapshot; call_light: of its scene."""
        character = cls(cast)
        character._call_light = call_light
        character._go_on(snapshot)
        return character

    @classmethod
    def new(cls, cast: Playable, face: str, time: float, call_light: CallLight) -> SceneCharacter:
        """A character that wears `face`, its home face too, at the time of its scene."""
        performer = Performer(cast)
        performer.call_face(face, seconds=0.0)
        performer.set_home(face)
        return cls.of(cast, replace(performer.snapshot(), time=time), call_light)

    def call_light(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air: that of the whole scene."""
        self._call_light(name, seconds=seconds, easing=easing)

    def note_played(self) -> None:
        """An operator did something for the whole scene: the next panic is a first one again."""
        self._play()
