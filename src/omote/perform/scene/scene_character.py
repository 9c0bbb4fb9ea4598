"""A character of a scene: a performer whose light is the scene's."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Protocol

from omote.model.known_names import PLAY_REGIONS, check_play_region
from omote.perform.axis import (
    Axis,
    call_regions,
    called_to_mix,
    goal_of,
    repaced,
    standing_mix,
    weights,
    with_pace,
)
from omote.perform.channels import with_channels
from omote.perform.easing import DEFAULT_EASING
from omote.perform.frame import Frame, Gaze, GazeTarget, Head, Held, MotionSettings, with_fields
from omote.perform.layers.layer_names import check_layer
from omote.perform.layers.layers import hold_by
from omote.perform.mix import Weights
from omote.perform.motion.sight import NOTHING, Sight
from omote.perform.panic import eased, without_channels, without_turn
from omote.perform.performer import Performer
from omote.perform.scene import movement
from omote.perform.scene.clip_goals import call_of_run, goal_of_clip
from omote.perform.scene.goals import (
    LAYER,
    MOTION_LIMITS,
    TURN_LIMITS,
    WITH_FACE,
    Goal,
    check_names,
    expression_of,
    is_setting,
)
from omote.perform.scene.look_goals import goal_of_target, target_of_goal
from omote.perform.scene.memories import CHANNEL_LIMITS, CHANNELS, Turning, turn_at
from omote.perform.scene.movement import Movement, proceed, redirect
from omote.perform.scene.scene_frame import Place
from omote.perform.snapshot import Playable, Snapshot
from omote.perform.springs.cast_springs import SPRING_NAMES
from omote.perform.springs.springs import Travel, amount_of


class CallSceneLight(Protocol):
    """How a scene's light is called."""

    def __call__(self, name: str, *, seconds: float = 1.0, easing: str = DEFAULT_EASING) -> None:
        """Brings a light on air."""


class CheckTarget(Protocol):
    """How a scene rejects what nobody in it can look at."""

    def __call__(self, looker: object, kind: str, name: str) -> None:
        """Raises ValueError where there is nothing of that name."""


class SceneCharacter(Performer):
    """A performer in a scene. sight, stands: what its eyes look at and where it is, which the scene finds before each
    step of time; turning: head, gaze and channels on their way to where they were called."""

    _call_light: CallSceneLight
    _check_target: CheckTarget
    sight: Sight = NOTHING
    stands: Place = Place()
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

    def _find_travel(self) -> Travel:
        return Travel(self.stands.x, self.stands.turn)

    def goal_of(self, name: str) -> Goal:
        """Where a part goes, or stands: a mix, or numbers; nothing for a region that goes with the whole face.

        name: of a part that is the character's own, without place and presence.
        """
        return self._goal_of(name, goal_of, self._way_of)

    def shown_goal(self, name: str) -> Goal:
        """What a part shows now, as a goal that brings it back. name: as of `goal_of`."""
        return self._goal_of(
            name, lambda on: standing_mix(weights(on)), lambda part: vars(getattr(self._turned_by_hands(), part))
        )

    def check_call(self, part: str, goal: Goal) -> None:
        """Raises ValueError for a name of a goal that the cast has not. part: with the character's name."""
        if part.endswith("/face"):
            check_names(goal, self._cast.faces, "face")
        elif part.endswith("/expression") or expression_of(part):
            check_names(goal, self._cast.expressions, "expression")
        elif part.endswith("/look"):
            target = target_of_goal(dict(goal))
            self._check_target(self, target.kind, target.name)

    def call_goal(self, name: str, goal: Goal, seconds: float, easing: str, pace: float | None = None) -> None:
        """Brings a part to a goal from whatever shows. name: as of `goal_of`; goal: checked; seconds: 0 cuts; easing:
        the curve of the way; pace: as of `Scene.call_goal`. A clip is stopped: the scene knows which it can play."""
        now = self._now
        if name == "clip":
            self.stop_clip(seconds=seconds)
            return

        def call(on: Axis) -> Axis:
            return with_pace(called_to_mix(on, goal or goal_of(now.expression), seconds, easing), pace)

        if name in TURN_LIMITS:
            self._turn_to(name, goal, seconds, easing, pace)
        elif is_setting(name):
            self._set(name, goal)
        elif name == "face":
            self._play(face=call(now.face))
        elif name == "expression":
            self._play(expression=call(now.expression), regions=call_regions(now.regions, now.expression, call))
        else:
            region = check_play_region(name)
            if goal or region in now.regions:  # else it goes with the face already
                self._play(regions={**now.regions, region: call(now.regions.get(region, now.expression))})

    def _goal_of(self, name: str, mix: Callable[[Axis], Weights], turned: Callable[[str], Mapping[str, float]]) -> Goal:
        now = self._now
        if name in TURN_LIMITS:
            return dict(turned(name))
        if is_setting(name):
            return self._setting_of(name)
        if name == "clip":
            return self._clip_goal()
        if name in PLAY_REGIONS:
            own = now.regions.get(check_play_region(name))
            return WITH_FACE if own is None else dict(mix(own))
        return dict(mix(now.face if name == "face" else now.expression))

    def _clip_goal(self) -> Goal:
        """What plays the newest clip again as it was called; nothing where none plays, or it is stopped already."""
        run = self._now.clips[-1] if self._now.clips else None
        return (
            WITH_FACE
            if run is None or run.gone is not None
            else goal_of_clip(call_of_run(run, self._clips.get(run.number)))
        )

    def _set(self, name: str, goal: Goal) -> None:
        """Sets what is taken at once, and followed by filters of its own."""
        if name == "motion":
            self.set_motion(goal["liveliness"], blinks=goal["blinks"], gaze=goal["gaze"], breath=goal["breath"])
        elif name == "springs":
            for spring, amount in goal.items():
                self.set_spring(spring, amount)
        elif name == "look":
            at = target_of_goal(dict(goal))
            self.look_at(at.kind, at.name, yaw=at.yaw, pitch=at.pitch, x=at.x, y=at.y, z=at.z)
        else:
            for region, influence in goal.items():
                self.set_layer(name.removeprefix(LAYER), region=region, influence=influence)

    def _setting_of(self, name: str) -> Goal:
        if name == "motion":
            return {each: getattr(self.motion, each) for each in MOTION_LIMITS}
        if name == "springs":
            return {spring: amount_of(self._now.springs, spring) for spring in SPRING_NAMES}
        if name == "look":
            return goal_of_target(self.motion.target)
        influence = self._begun_layers().settings[check_layer(name.removeprefix(LAYER))].influence
        return {str(region): value for region, value in influence.items()}

    def _way_of(self, part: str) -> Mapping[str, float]:
        """Where head or gaze go."""
        ways = {} if self.turning is None else self._ways(self.turning)
        return ways[part].goal if part in ways else vars(getattr(self._now, part))

    def advance(self, dt: float) -> Frame:
        """What is on air some time later, with head and gaze further on their way to a memory. dt: seconds."""
        turning = self.turning
        if turning is not None:
            self._set_turns({part: proceed(way, dt) for part, way in self._ways(turning).items()}, turning.panics)
            if self._layers is not None:
                self._layers = hold_by(self._cast, self._layers, self._held(), on_way=True)
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

    def set_pace(self, pace: float) -> None:
        """Lets the time of all that was called with a pace go at another, 0 to 1 of the show's."""
        now = self._now
        regions = {region: repaced(on, pace) for region, on in now.regions.items()}
        face = repaced(now.face, pace)
        clips = tuple(run if run.pace is None else replace(run, pace=pace) for run in now.clips)
        self._now = with_fields(now, face=face, expression=repaced(now.expression, pace), regions=regions, clips=clips)
        if self.turning is not None:
            ways = {part: movement.repaced(way, pace) for part, way in self.turning.ways.items()}
            self.turning = replace(self.turning, ways=ways)

    def check_channels(self, weights: Mapping[str, float]) -> Mapping[str, float]:
        """Returns weights that channels can have; ValueError, TypeError for others."""
        return with_channels({}, self._cast.expressions, weights)

    @property
    def channels_goal(self) -> Mapping[str, float]:
        """Where the weights of the channels go, or stand: those that are not 0."""
        ways = {} if self.turning is None else self._ways(self.turning)
        goal = ways[CHANNELS].goal if CHANNELS in ways else self._now.channels
        return {name: goal[name] for name in sorted(goal) if goal[name]}

    def call_channels(self, weights: Mapping[str, float], seconds: float, easing: str) -> None:
        """Brings all channels to these weights, others to 0, as hands would in time. seconds: 0 cuts; easing: the curve
        of the way."""
        under_way = {} if self.turning is None else self._ways(self.turning)
        shown = eased(Held(self._now.channels, Head(), Gaze()), self._now.easing_to_rest).channels
        names = {**under_way[CHANNELS].goal, **shown} if CHANNELS in under_way else shown
        goal = {name: weights.get(name, 0.0) for name in sorted({*names, *weights})}
        before = _widened(under_way.get(CHANNELS), shown, goal)
        way = redirect(before, goal, seconds, dict.fromkeys(goal, CHANNEL_LIMITS), easing)
        self._play(easing_to_rest=without_channels(self._now.easing_to_rest, goal))
        self._set_turns({**under_way, CHANNELS: way}, self._now.panics)

    def _turn_to(self, part: str, goal: Goal, seconds: float, easing: str, pace: float | None) -> None:
        under_way = {} if self.turning is None else self._ways(self.turning)
        way = under_way.get(part, Movement(vars(getattr(self._turned_by_hands(), part))))
        self._play(easing_to_rest=without_turn(self._now.easing_to_rest, "head" if part == "head" else "gaze"))
        ways = {**under_way, part: movement.with_pace(redirect(way, goal, seconds, TURN_LIMITS[part], easing), pace)}
        self._set_turns(ways, self._now.panics)

    def _set_turns(self, ways: Mapping[str, Movement], panics: int) -> None:
        self._now = with_fields(self._now, **{part: turn_at(part, way) for part, way in ways.items()})
        on = {part: way for part, way in ways.items() if way.way is not None}
        self.turning = Turning(on, panics) if on else None

    def note_played(self) -> None:
        """Notes that an operator did something for the whole scene: the next panic is a first one again."""
        self._play()


def _widened(way: Movement | None, shown: Mapping[str, float], names: Iterable[str]) -> Movement:
    """A way of channels with all of some names: those that it has not stand where they show."""
    if way is None:
        return Movement({name: shown.get(name, 0.0) for name in names})
    goal = {name: way.goal.get(name, 0.0) for name in names}
    if way.way is None:
        return Movement(goal)
    start = {name: way.way.start.get(name, 0.0) for name in names}
    velocity = {name: way.way.velocity.get(name, 0.0) for name in names}
    return Movement(goal, replace(way.way, start=start, velocity=velocity))
