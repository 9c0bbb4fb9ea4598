"""A character of a scene: a performer whose light is the scene's."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Protocol

from omote.model.known_names import PLAY_REGIONS, check_play_region
from omote.perform.axis import (
    Axis,
    call_part,
    called_to_mix,
    goal_of,
    plays_same_pad,
    repaced,
    standing_mix,
    weights,
    with_pace,
)
from omote.perform.channels import with_channels
from omote.perform.complexion import SKIN_FADERS, fader_at
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.figure_axes import FACES_OWN, on_all
from omote.perform.frame import Frame, Gaze, GazeTarget, Head, Held, MotionSettings, with_fields
from omote.perform.layers.layer_names import check_layer
from omote.perform.layers.layers import hold_by
from omote.perform.limits import check_known
from omote.perform.mappings.macro_vectors import move_macro
from omote.perform.mappings.mapping import MACRO_LIMITS
from omote.perform.motion.sight import NOTHING, Sight
from omote.perform.pad_playing import axes_of_pads
from omote.perform.pads.blend_space import AXES, PLACE_RANGE, Pad, PadPlace
from omote.perform.pads.pad_point import TAKE_UP_SECONDS, PadPoint
from omote.perform.panic import eased, without_channels, without_turn
from omote.perform.performer import Performer
from omote.perform.scene import movement
from omote.perform.scene.clip_goals import call_of_run, goal_of_clip
from omote.perform.scene.figure_goals import called_figure, figure_goal
from omote.perform.scene.goals import (
    BODY,
    LAYER,
    MACROS,
    MOTION_LIMITS,
    POSE,
    POSE_PARTS,
    TURN_LIMITS,
    WITH_FACE,
    Goal,
    check_names,
    is_of_macros,
    is_setting,
    whole_of,
)
from omote.perform.scene.look_goals import goal_of_target, target_of_goal
from omote.perform.scene.memories import CHANNEL_LIMITS, CHANNELS, MACRO_WAY, PAD_WAY, VALUE, Turning, turn_at
from omote.perform.scene.movement import Movement, proceed, redirect
from omote.perform.scene.pad_goals import check_point_fits, goal_of_point, is_pad_goal, point_of_goal
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
        """Where a part goes, or stands: a mix, the point of a pad, or numbers; nothing for a region that goes with the
        whole face.

        name: of a part that is the character's own, without place and presence.
        """

        def going(on: Axis) -> Goal:
            return goal_of(on) if on.point is None else goal_of_point(on.point.pad, self._place_of(on.point))

        return self._goal_of(name, going, self._way_of)

    def shown_goal(self, name: str, *, points: bool = True) -> Goal:
        """What a part shows now, as a goal that brings it back. name: as of `goal_of`; points: where a pad plays it,
        its point; else the mix that it shows."""

        def showing(on: Axis) -> Goal:
            if points and on.point is not None:
                return goal_of_point(on.point.pad, on.point.place)
            return standing_mix(weights(on))

        return self._goal_of(name, showing, self._shown_of)

    def _shown_of(self, part: str) -> Mapping[str, float]:
        """Where head, gaze or macros are now."""
        return self._macros_at() if part == MACROS else vars(getattr(self._turned_by_hands(), part))

    def check_call(self, part: str, goal: Goal) -> None:
        """Raises ValueError for a name of a goal that the cast has not. part: with the character's name."""
        of = part.rpartition("/")[2]
        if is_pad_goal(part, goal):
            pad, place = point_of_goal(goal)
            check_known(pad, self._pads, "pad")
            check_point_fits(self._pads[pad], of, place)
        elif of == "face":
            check_names(goal, self._cast.faces, "face")
        elif of in (POSE, *POSE_PARTS):
            check_names(goal, self._cast.poses, "pose")
        elif of == BODY:
            check_names(goal, {FACES_OWN, *self._cast.bodies}, "body")
        elif of == "expression" or whole_of(part):
            check_names(goal, self._cast.expressions, "expression")
        elif is_of_macros(part):
            check_names(goal, self.mappings, "macro")
        elif of == "look":
            target = target_of_goal(dict(goal))
            self._check_target(self, target.kind, target.name)

    def call_goal(self, name: str, goal: Goal, seconds: float, easing: str, pace: float | None = None) -> None:
        """Brings a part to a goal from whatever shows. name: as of `goal_of`; goal: checked; seconds: 0 cuts; easing:
        the curve of the way; pace: as of `Scene.call_goal`. A clip is stopped: the scene knows which it can play."""
        if name == "clip":
            self.stop_clip(seconds=seconds)
        elif is_pad_goal(name, goal):
            self._call_point(*point_of_goal(goal), seconds, easing, pace)
        elif name in TURN_LIMITS:
            self._turn_to(name, goal, seconds, easing, pace)
        elif is_setting(name):
            self._set(name, goal)
        elif name == MACROS:
            self._call_macros(goal, seconds, easing, pace)
        elif name in (POSE, *POSE_PARTS, BODY):
            self._play(figure=called_figure(self._now.figure, name, goal, seconds, easing, pace))
        else:
            self._call_mix(name, goal, seconds, easing, pace)

    def _call_mix(self, name: str, goal: Goal, seconds: float, easing: str, pace: float | None) -> None:
        """Brings the faces, the expression or a region of it to a mix. name: which; all else as of `call_goal`."""
        now = self._now

        def call(on: Axis) -> Axis:
            return with_pace(called_to_mix(on, goal or goal_of(now.expression), seconds, easing), pace)

        if name == "face":
            self._play(face=call(now.face))
            return
        region = None if name == "expression" else check_play_region(name)
        if region is None or goal or region in now.regions:  # else it goes with the face already
            expression, regions = call_part(now.expression, now.regions, region, call)
            self._play(expression=expression, regions=regions)

    def _goal_of(self, name: str, mix: Callable[[Axis], Goal], turned: Callable[[str], Mapping[str, float]]) -> Goal:
        now = self._now
        if name in TURN_LIMITS:
            return dict(turned(name))
        if is_setting(name):
            return self._setting_of(name)
        if name == "clip":
            return self._clip_goal()
        if name == MACROS:
            return dict(turned(name))
        if name in (POSE, *POSE_PARTS, BODY):
            return figure_goal(now.figure, name, mix)
        if name in PLAY_REGIONS:
            own = now.regions.get(check_play_region(name))
            return WITH_FACE if own is None or plays_same_pad(own, now.expression) else dict(mix(own))
        return dict(mix(now.face if name == "face" else now.expression))

    def _call_point(self, name: str, place: PadPlace, seconds: float, easing: str, pace: float | None) -> None:
        """Moves the point of a pad (by its name) to a place of it, as a cue does: on its way there where the pad plays
        already, else what shows makes way for it in that time."""
        pad = self._pads[name]
        under_way = {} if self.turning is None else self._ways(self.turning)
        key = f"{PAD_WAY}{name}"
        ways = {part: way for part, way in under_way.items() if part != key}
        if seconds and self._plays(name):
            before = under_way.get(key, Movement(_numbers(self._now.pads[name])))
            way = redirect(before, _numbers(place), seconds, dict.fromkeys(_numbers(place), PLACE_RANGE), easing)
            here = self._now.pads[name]
            self._play(**self._moved(pad, here, seconds, easing, pace, along=True))
            self._set_turns({**ways, key: movement.with_pace(way, pace)}, self._now.panics)
            return
        self._play(**self._moved(pad, place, seconds, easing, pace, along=True))

    def _macros_at(self) -> dict[str, float]:
        """Where the macros are that hands or cues have moved."""
        return {} if self._macros is None else self._macros.moved_to

    def _put_macro(self, name: str, value: float) -> None:
        """Moves a macro on its way."""
        self._macros = move_macro(self._macros, self.mappings, name, value, self._reading)

    def _call_macros(self, goal: Goal, seconds: float, easing: str, pace: float | None) -> None:
        """Brings some macros to where a goal has them, each from where it is, as a cue does."""
        self._play()
        ways = {} if self.turning is None else self._ways(self.turning)
        at = self._macros_at()
        for name, value in goal.items():
            before = ways.get(f"{MACRO_WAY}{name}", Movement({VALUE: at.get(name, 0.0)}))
            way = redirect(before, {VALUE: value}, seconds, {VALUE: MACRO_LIMITS}, easing)
            ways[f"{MACRO_WAY}{name}"] = movement.with_pace(way, pace)
        self._set_turns(ways, self._now.panics)

    def _plays(self, pad: str) -> bool:
        """Whether a pad plays anything of the character."""
        return any(on.point is not None and on.point.pad == pad for on in axes_of_pads(self._now))

    def _place_of(self, point: PadPoint) -> PadPlace:
        """Where the point of a pad goes, or is."""
        way = None if self.turning is None else self._ways(self.turning).get(f"{PAD_WAY}{point.pad}")
        return point.place if way is None else tuple(way.goal.values())

    def wear_pads(self, pads: Mapping[str, Pad], renamed: Mapping[str, str] | None = None) -> None:
        """Goes on with other pads, as of `Performer.wear_pads`; a point on its way goes on under its pad's new name.

        pads: all that there are, by name; renamed: what pads were called before, with what they are called now.
        """
        under_way = {} if self.turning is None else self._ways(self.turning)
        super().wear_pads(pads, renamed)
        if self.turning is not None:
            names = {f"{PAD_WAY}{before}": f"{PAD_WAY}{name}" for before, name in (renamed or {}).items()}
            ways = {names.get(part, part): way for part, way in under_way.items()}
            self.turning = replace(self.turning, ways=ways) if ways else None

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
        elif name == "skin":
            for fader, amount in goal.items():
                self.set_skin(fader, amount)
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
        if name == "skin":
            return {fader: fader_at(self._now.skin, fader) for fader in SKIN_FADERS}
        if name == "look":
            return goal_of_target(self.motion.target)
        influence = self._begun_layers().settings[check_layer(name.removeprefix(LAYER))].influence
        return {str(region): value for region, value in influence.items()}

    def _way_of(self, part: str) -> Mapping[str, float]:
        """Where head, gaze or macros go."""
        ways = {} if self.turning is None else self._ways(self.turning)
        if part == MACROS:
            at = self._macros_at()
            return {name: ways[way].goal[VALUE] if (way := f"{MACRO_WAY}{name}") in ways else at[name] for name in at}
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
        return {part: way for part, way in turning.ways.items() if self._stands_at(part) == turn_at(part, way)}

    def _stands_at(self, part: str) -> object:
        """Where something is that may be on a way; None for a pad that plays nothing and a macro that is not moved."""
        if part.startswith(MACRO_WAY):
            return self._macros_at().get(part.removeprefix(MACRO_WAY))
        if not part.startswith(PAD_WAY):
            return getattr(self._now, part)
        name = part.removeprefix(PAD_WAY)
        return self._now.pads.get(name) if self._plays(name) else None

    def set_pace(self, pace: float) -> None:
        """Lets the time of all that was called with a pace go at another, 0 to 1 of the show's."""
        now = self._now
        regions = {region: repaced(on, pace) for region, on in now.regions.items()}
        face = repaced(now.face, pace)
        clips = tuple(run if run.pace is None else replace(run, pace=pace) for run in now.clips)
        figure = on_all(now.figure, lambda on: repaced(on, pace))
        self._now = with_fields(
            now, face=face, expression=repaced(now.expression, pace), regions=regions, clips=clips, figure=figure
        )
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
        at = {part: turn_at(part, way) for part, way in ways.items()}
        self._now = with_fields(
            self._now, **{part: turn for part, turn in at.items() if not isinstance(turn, tuple | float)}
        )
        for part, place in at.items():
            if isinstance(place, float):
                self._put_macro(part.removeprefix(MACRO_WAY), place)
            elif isinstance(place, tuple):
                pad = self._pads[part.removeprefix(PAD_WAY)]
                self._now = with_fields(self._now, **self._moved(pad, place, TAKE_UP_SECONDS))
        on = {part: way for part, way in ways.items() if way.way is not None}
        self.turning = Turning(on, panics) if on else None

    def note_played(self) -> None:
        """Notes that an operator did something for the whole scene: the next panic is a first one again."""
        self._play()


def _numbers(place: PadPlace) -> dict[str, float]:
    return dict(zip(AXES, place, strict=False))


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
