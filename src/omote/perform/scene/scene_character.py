"""A character of a scene: a performer whose light is the scene's."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from omote.perform.easing import DEFAULT_EASING
from omote.perform.frame import GazeTarget, MotionSettings
from omote.perform.motion.sight import NOTHING, Sight
from omote.perform.performer import Performer
from omote.perform.snapshot import Playable, Snapshot


class CallSceneLight(Protocol):
    """How a scene's light is called."""

    def __call__(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air."""


class CheckTarget(Protocol):
    """How a scene rejects what nobody in it can look at."""

    def __call__(self, looker: object, kind: str, name: str) -> None:
        """Raises ValueError where there is nothing of that name."""


class SceneCharacter(Performer):
    """A performer in a scene. sight: what its eyes look at, which the scene finds before each step of time."""

    _call_light: CallSceneLight
    _check_target: CheckTarget
    sight: Sight = NOTHING

    @classmethod
    def of(
        cls, cast: Playable, snapshot: Snapshot, call_light: CallSceneLight, check_target: CheckTarget
    ) -> SceneCharacter:
        """The character of a snapshot; call_light, check_target: of its scene. cast: what it plays."""
        character = cls(cast)
        character._call_light = call_light
        character._check_target = check_target
        character._go_on(snapshot)
        return character

    @classmethod
    def new(
        cls, cast: Playable, face: str, time: float, call_light: CallSceneLight, check_target: CheckTarget
    ) -> SceneCharacter:
        """A character that wears `face`, its home face too, at the time of its scene.

        cast: what it plays; call_light, check_target: of its scene.
        """
        performer = Performer(cast)
        performer.call_face(face, seconds=0.0)
        performer.set_home(face)
        return cls.of(cast, replace(performer.snapshot(), time=time), call_light, check_target)

    def call_light(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air: that of the whole scene.

        name: of the light; seconds: 0 to 3600, 0 cuts; easing: the curve of the way.
        """
        self._call_light(name, seconds=seconds, easing=easing)

    def look_at(
        self,
        kind: str,
        name: str = "",
        *,
        yaw: float = 0.0,
        pitch: float = 0.0,
        x: float = 0.0,
        y: float = 0.0,
        z: float = 2.0,
    ) -> None:
        """Chooses whom or what the eyes look at, of all that there is in the scene.

        kind: nothing, a direction, a point, a gaze point, a character or a stage; name: of it; yaw, pitch: radians; x,
        y, z: metres.
        """
        self._check_target(self, kind, name)
        super().look_at(kind, name, yaw=yaw, pitch=pitch, x=x, y=y, z=z)

    @property
    def motion(self) -> MotionSettings:
        """What is set of its automatic motion."""
        return MotionSettings() if self._now.motion is None else self._now.motion.settings

    @property
    def turned(self) -> float:
        """Radians by which the head has gone with the gaze."""
        return 0.0 if self._now.motion is None else self._now.motion.head.second.yaw

    def _find_sight(self, target: GazeTarget) -> Sight:
        return NOTHING if target.kind == "ahead" else self.sight

    def note_played(self) -> None:
        """Notes that an operator did something for the whole scene: the next panic is a first one again."""
        self._play()
