"""A character of a scene: a performer whose light is the scene's."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Protocol

from omote.model.known_names import PLAY_REGIONS
from omote.perform.axis import weights
from omote.perform.easing import DEFAULT_EASING
from omote.perform.frame import Frame, Gaze, GazeTarget, Head, Held, MotionSettings, with_fields
from omote.perform.limits import check_known
from omote.perform.motion.sight import NOTHING, Sight
from omote.perform.panic import eased
from omote.perform.performer import Performer
from omote.perform.scene.memories import TURN_LIMITS, CharacterMemory, Turning, called_mix, standing_mix, turn_at
from omote.perform.scene.movement import Movement, proceed, redirect
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
    """A performer in a scene. sight: what its eyes look at, which the scene finds before each step of time; turning:
    head and gaze on their way to a memory."""

    _call_light: CallSceneLight
    _check_target: CheckTarget
    sight: Sight = NOTHING
    turning: Turning | None = None

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

    def remember(self) -> CharacterMemory:
        """What a memory keeps of it: what shows of faces and expressions, and where hands hold head and gaze."""
        now = self._now
        regions = {region: standing_mix(weights(on)) for region, on in now.regions.items()}
        held = self._turned_by_hands()
        faces = standing_mix(weights(now.face))
        return CharacterMemory(faces, standing_mix(weights(now.expression)), regions, held.head, held.gaze)

    def check_memory(self, memory: CharacterMemory) -> None:
        """Raises ValueError where the cast has lost what a memory has of it."""
        for name in memory.faces:
            check_known(name, self._cast.faces, "face")
        for mix in (memory.expressions, *memory.regions.values()):
            for name in mix:
                check_known(name, self._cast.expressions, "expression")

    def call_memory(self, memory: CharacterMemory, seconds: float, easing: str) -> None:
        """Brings what a memory has of it on air, all in the same time. memory: checked; seconds: 0 cuts; easing: the
        curve of the way."""
        now = self._now
        own = {
            region: called_mix(
                now.regions.get(region, now.expression),
                memory.regions.get(region, memory.expressions),
                seconds,
                easing,
            )
            for region in PLAY_REGIONS
            if region in memory.regions or region in now.regions
        }
        self._play(
            face=called_mix(now.face, memory.faces, seconds, easing),
            expression=called_mix(now.expression, memory.expressions, seconds, easing),
            regions=own,
        )
        self._turn_to({"head": memory.head, "gaze": memory.gaze}, seconds, easing)

    def advance(self, dt: float) -> Frame:
        """What is on air some time later, with head and gaze further on their way to a memory. dt: seconds."""
        turning = self.turning
        if turning is not None:
            self._set_turns({part: proceed(way, dt) for part, way in self._ways(turning).items()}, turning.panics)
        return super().advance(dt)

    def _turned_by_hands(self) -> Held:
        """Where hands hold head and gaze, or what a panic has left of it."""
        now = self._now
        return eased(Held({}, now.head, now.gaze), now.easing_to_rest)

    def _ways(self, turning: Turning) -> dict[str, Movement]:
        """The ways that no hand and no panic has ended since."""
        if turning.panics != self._now.panics:
            return {}
        return {part: way for part, way in turning.ways.items() if getattr(self._now, part) == turn_at(part, way)}

    def _turn_to(self, goals: Mapping[str, Head | Gaze], seconds: float, easing: str) -> None:
        held = self._turned_by_hands()
        under_way = {} if self.turning is None else self._ways(self.turning)
        ways = {}
        for part, goal in goals.items():
            way = under_way.get(part, Movement(vars(getattr(held, part))))
            ways[part] = redirect(way, vars(goal), seconds, TURN_LIMITS[part], easing)
        left = self._now.easing_to_rest
        rest = None if left is None else replace(left, head=Head(), gaze=Gaze())
        self._now = with_fields(self._now, easing_to_rest=rest)
        self._set_turns(ways, self._now.panics)

    def _set_turns(self, ways: Mapping[str, Movement], panics: int) -> None:
        self._now = with_fields(self._now, **{part: turn_at(part, way) for part, way in ways.items()})
        on = {part: way for part, way in ways.items() if way.way is not None}
        self.turning = Turning(on, panics) if on else None

    def note_played(self) -> None:
        """Notes that an operator did something for the whole scene: the next panic is a first one again."""
        self._play()
