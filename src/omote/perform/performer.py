"""The performer: takes commands at any moment and returns frames at any later time. It owns no clock."""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from dataclasses import replace

from omote.model.body.pose import Pose
from omote.model.known_names import GENERIC, NEUTRAL, PLAY_REGIONS
from omote.perform import axis
from omote.perform.axis import Axis, advance_regions, call_regions
from omote.perform.body_playing import BodyPlaying
from omote.perform.clips.played_body import left_body
from omote.perform.complexion import calm_skin
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.figure_axes import AT_REST, advance_figure, figure_frame, halt_figure
from omote.perform.figures.packed_pose import pose_numbers
from omote.perform.frame import NO_IDLE, NO_TARGET, Frame, Gaze, GazeTarget, Head, Held, check_target_kind, with_fields
from omote.perform.gestures import advance_gestures, begin_gesture, release_gestures, with_gestures
from omote.perform.layers.layer_mix import influences, kept_of_mix, with_layers
from omote.perform.layers.layer_names import RULES, LayerName, check_driven, check_layer, check_part
from omote.perform.layers.layer_vectors import Layers
from omote.perform.layers.layers import (
    advance,
    begin,
    drive,
    drive_direct,
    is_at_rest,
    leave,
    recalibrate,
    set_layer,
    switch_off,
)
from omote.perform.layers.layers_snapshot import restored, snapshot_of
from omote.perform.layers.source_frame import (
    AUTOMATIC,
    SPEECH,
    BodyFrame,
    SourceFrame,
    check_frame,
    source_frame,
    with_gaze_of_units,
)
from omote.perform.limits import FOREVER, check_call_seconds, check_known, check_within
from omote.perform.mappings.macro_vectors import MacroVectors, macro_statuses, states_of, vectors_of
from omote.perform.mappings.macros import NO_MACROS
from omote.perform.mix import combine, mix_in
from omote.perform.motion.automatic_motion import (
    MOTION_LAYERS,
    AutomaticMotion,
    advance_motion,
    figure_idle,
    is_free,
    is_moving,
    is_speaking,
    is_tracker_lost,
    motion_frames,
    set_motion,
)
from omote.perform.motion.sight import Sight, sight_alone
from omote.perform.panic import PANIC_EASING, PANIC_SECONDS, EasingToRest, at_speed, ease_later, eased
from omote.perform.snapshot import Playable, Snapshot, check_snapshot, is_home_next, refuse_no_cast
from omote.perform.speech.speaking import (
    advance_speaking,
    find_spoken,
    mouth_of_speaking,
    share_of_lips,
    speech_status,
)
from omote.perform.speech.visemes import speech_frame
from omote.perform.springs.springs import release_springs

MOMENT = 1e-4
"""Seconds in which the speed of what shows is measured: no step of a show, and long beside rounding."""


class Performer(BodyPlaying):
    """Plays a cast: calls, T-bars, channels, head, gaze and light in; a frame for each step of time out.

    It owns no clock and no thread; the same commands and steps give the same frames.

    Parameters
    ----------
    cast : Cast
        The faces and expressions that can be called; a face "generic" is among them.

    Raises
    ------
    ValueError
        Where the cast has no face "generic".

    Examples
    --------
    >>> performer = omote.Performer(cast)
    >>> performer.call_expression("smile", seconds=0.5)
    >>> frame = performer.advance(0.25)
    >>> round(frame.expressions["smile"], 3), frame.expression_call.remaining
    (0.5, 0.25)

    References
    ----------
    docs/method.md, "The mix"; inertialised calls after D. Bollo (2018).
    """

    def __init__(self, cast: Playable) -> None:
        refuse_no_cast(cast)
        check_known(GENERIC, cast.faces, "face")
        self._cast = cast
        self._now = Snapshot(Axis(GENERIC), Axis(NEUTRAL))
        self._layers: Layers | None = None
        self._worn = {}

    @classmethod
    def restored(cls, cast: Playable, snapshot: Snapshot) -> Performer:
        """The performer that continues from a snapshot, frame by frame the same.

        Parameters
        ----------
        cast : Cast
            What it plays.
        snapshot : Snapshot
            What another one's `snapshot` gave.

        Returns
        -------
        Performer
            Independent of the first.

        Raises
        ------
        ValueError
            Where this cast cannot play the snapshot, or no performer can have written it.

        Examples
        --------
        >>> first = omote.Performer(cast)
        >>> first.call_face("dog", seconds=2)
        >>> second = omote.Performer.restored(cast, first.snapshot())
        >>> first.advance(0.7) == second.advance(0.7)
        True
        """
        performer = cls(cast)
        performer._go_on(check_snapshot(snapshot, cast))
        return performer

    def _go_on(self, snapshot: Snapshot) -> None:
        self._now = replace(snapshot, layers=None, macros=NO_MACROS)
        self._macros = vectors_of(snapshot.macros, snapshot.mappings.kept)
        self._last_sources = ()
        self._layers = restored(self._cast, snapshot.layers)

    def snapshot(self) -> Snapshot:
        """Everything needed to continue later, or elsewhere.

        Returns
        -------
        Snapshot
            Plain values, frozen.

        Examples
        --------
        >>> omote.Performer(cast).snapshot().face.on_air
        'generic'
        """
        return replace(self._now, layers=snapshot_of(self._layers), macros=states_of(self._macros))

    def recast(self, cast: Playable) -> None:
        """Plays another cast from now on; what is on air stays.

        Parameters
        ----------
        cast : Cast
            One that has everything that is on air.

        Raises
        ------
        ValueError
            Where it has not.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.recast(cast.with_expressions(beam=cast.expressions["joy"]))
        >>> performer.call_expression("beam")
        """
        now = check_snapshot(self.snapshot(), cast)
        self._cast = cast
        self._worn = {}
        self._go_on(now)

    def drive(
        self,
        channels: Mapping[str, float],
        *,
        layer: str = "playback",
        head: tuple[float, float, float] | None = None,
        gaze: tuple[float, float] | None = None,
        found: bool = True,
        smoothing: float = 0.0,
        body: Pose | None = None,
    ) -> None:
        """Takes one frame of a source: the newest wins, and the layer follows it without a jump.

        Where a layer replaces, the parts of the face in which these channels act show the source instead of what lies
        below. A source that is silent, or not found, for half a second fades out, and in again when it is back.

        Parameters
        ----------
        channels : mapping of float
            Weights by expression, -0.5 to 1.5 (breath -0.05 to 0.05, blink 0 to 1); the same names in each frame.
        layer : {"breath", "gaze", "blink", "tracker", "lips", "playback"}
            The layer that it drives.
        head : tuple of float, optional
            Yaw, pitch and roll as of `set_head`; without it the head is left to other layers.
        gaze : tuple of float, optional
            Yaw and pitch as of `set_gaze`; without it the eyes are left to the channels.
        found : bool
            False while the source does not see its performer.
        smoothing : float
            Seconds, to 2, in which the layer goes nine tenths of a step; without it 0.1, of the mouth 0.06, on the
            layer lips 0.04, and less where it moves fast.
        body : Pose, optional
            What the performer's body does, beside where the head looks; the figure does that instead of its poses, and
            these again when the source is lost.

        Raises
        ------
        ValueError
            On a name or a layer that there is not, and on numbers out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.drive({"jawOpen": 0.4})
        >>> for _ in range(120):
        ...     performer.drive({"jawOpen": 0.4})
        ...     frame = performer.advance(1 / 60)
        >>> round(frame.channels["jawOpen"], 2)
        0.4

        References
        ----------
        docs/method.md, "Layers".
        """
        which = check_driven(layer)
        expressions = self._cast.expressions
        frame = source_frame(expressions, channels, head, gaze, found=found, smoothing=smoothing)
        if body is not None:
            frame = with_fields(frame, body=BodyFrame(pose_numbers(body)))
        self.drive_layer(which, check_frame(frame, which))

    def set_layer(
        self, layer: str, *, region: str | None = None, influence: float | None = None, on: bool | None = None
    ) -> None:
        """Sets how much of a layer shows, or switches it: what is on air follows within half a second.

        Parameters
        ----------
        layer : {"breath", "gaze", "emotion", "blink", "tracker", "lips", "playback", "hands"}
            The layer.
        region : {"brows", "eyes", "mouth", "rest", "head", "gaze"}, optional
            Where the influence is meant; everywhere where it is left out.
        influence : float, optional
            0 (nothing of it) to 1.
        on : bool, optional
            Whether it plays at all.

        Raises
        ------
        ValueError
            On a layer or a region that there is not, and on an influence out of range.
        TypeError
            On an influence that is no number, and on a switch that is neither True nor False.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_layer("emotion", region="mouth", influence=0.5)
        >>> performer.advance(0.0).layers["emotion"].influence
        (1.0, 1.0, 0.5, 1.0, 1.0, 1.0)
        """
        part = None if region is None else check_part(region)
        self._layers = set_layer(self._begun_layers(), check_layer(layer), part, influence, on)
        self._play()

    def set_motion(
        self,
        liveliness: float | None = None,
        *,
        blinks: float | None = None,
        gaze: float | None = None,
        breath: float | None = None,
        seed: int | None = None,
        idle: bool | None = None,
    ) -> None:
        """Sets how much the character moves by itself: lids, eyes, the head that follows them, breath and small noise.

        It plays the layers *blink*, *gaze* and *breath* where no source drives them, below a tracker: where that is
        lost, it is what shows. What is not given stays.

        Parameters
        ----------
        liveliness : float, optional
            0 nothing; 0.5 as people move; 1 lively.
        blinks, gaze, breath : float, optional
            Each beside the others, 0 to 2; 1 at first.
        seed : int, optional
            Which of all ways to move, 0 to 2147483647: the same seed and steps give the same bits.
        idle : bool, optional
            Whether it moves as people do while its tracker is lost, where the liveliness is 0 too.

        Raises
        ------
        ValueError
            On numbers out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.set_motion(0.5)
        >>> sorted(performer.advance(1 / 60).layers)
        ['blink', 'breath', 'gaze']

        References
        ----------
        docs/method.md, "Automatic motion".
        """
        motion = AutomaticMotion() if self._now.motion is None else self._now.motion
        settings = {"liveliness": liveliness, "blinks": blinks, "gaze": gaze, "breath": breath, "seed": seed}
        self._play(motion=set_motion(motion, motion.settings.change(**settings, idle=idle)))

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
        """Chooses whom or what the eyes look at, beyond 17 degrees the head too; they look away between, as people do.

        It plays the layer *gaze*, as all that the character does by itself; without liveliness the look is steady. Two
        who look at one another meet each other's eyes in spells of 1 to 5 s.

        Parameters
        ----------
        kind : {"ahead", "direction", "point", "gaze_point", "character", "stage"}
            Nothing; a direction of the house; a point of the scene; a named one; another character; a stage's camera.
            The last three are known in a scene alone.
        name : str
            Of the gaze point, the character or the stage; "" for any stage.
        yaw, pitch : float
            The direction, radians: + is to the picture's right, up.
        x, y, z : float
            The point, metres: to the picture's right, above the eyes, before the front line.

        Raises
        ------
        ValueError
            On a kind or a name that there is not, and on numbers out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.look_at("direction", yaw=0.2)
        >>> for _ in range(240):
        ...     frame = performer.advance(1 / 60)
        >>> round(frame.gaze.yaw, 2)
        0.2

        References
        ----------
        docs/method.md, "Automatic motion".
        """
        motion = AutomaticMotion() if self._now.motion is None else self._now.motion
        target = GazeTarget(check_target_kind(kind), name, yaw, pitch, x, y, z)
        self._play(motion=set_motion(motion, motion.settings.change(target=target)))

    def gesture(self, name: str, *, amplitude: float = 1.0, seconds: float | None = None) -> None:
        """Makes a short motion of head or brows, on top of all that plays; one that runs makes way for it.

        Parameters
        ----------
        name : {"nod", "shake", "tilt", "bow", "shrug", "brows", "wink"}
            Which.
        amplitude : float
            -2 to 2: 1 as it is, below 0 to the other side (a nod: up).
        seconds : float, optional
            How long it takes, 0.2 to 10; as it takes by itself without it.

        Raises
        ------
        ValueError
            On a name that there is not, on numbers out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.gesture("nod")
        >>> performer.advance(0.25).head.pitch < -0.1
        True
        """
        self._play(gestures=begin_gesture(self._now.gestures, name, amplitude, seconds))

    def panic(self) -> None:
        """Brings the face on air to neutral and to a stand: after a quarter of a second nothing moves or goes on.

        Expression, channels, head and gaze ease to rest, a call of a face stops where it is, both T-bars stand at 0;
        the light is left alone. Panic again brings the home face (`set_home`), where nothing has been played in
        between; within 0.7 s it is the same press.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.call_face("dog", seconds=0)
        >>> performer.set_channel("jawOpen", 1.0)
        >>> performer.panic()
        >>> frame = performer.advance(1.0)
        >>> dict(frame.faces), dict(frame.channels)
        ({'dog': 1.0}, {})
        >>> performer.panic()
        >>> dict(performer.advance(2.0).faces)
        {'generic': 1.0}
        """
        now = self._now
        if now.panicked is None:
            soon = self._show_soon()
            now = self._without_layers(_at_rest(self._with_played_mixes(now, soon[0]), self._held()))
            if now.easing_to_rest is not None:
                now = replace(now, easing_to_rest=at_speed(now.easing_to_rest, *soon, MOMENT))
            self._macros = None
        elif is_home_next(now):
            now = replace(
                now, face=axis.called(now.face, now.home.face, check_call_seconds(now.home.seconds), DEFAULT_EASING)
            )
        self._now = replace(now, panicked=now.time, panics=now.panics + 1)

    @property
    def panics(self) -> int:
        """How often panic has been pressed."""
        return self._now.panics

    def advance(self, dt: float) -> Frame:
        """What is on air some time later; one long step lands where many short ones do.

        Parameters
        ----------
        dt : float
            Seconds since the last step, 0 or more.

        Returns
        -------
        Frame
            The mixes of faces, expressions and lights (each sums to one), channels, head and gaze.

        Raises
        ------
        ValueError
            On a step that is negative or endless.
        TypeError
            On what is no number.

        Examples
        --------
        >>> omote.Performer(cast).advance(1 / 60).expressions
        {'neutral': 1.0}
        """
        dt = check_within(dt, 0.0, FOREVER, "the time step (seconds)")
        now = self._now
        expression = axis.advanced(now.expression, dt)
        self._now = with_fields(
            now,
            face=axis.advanced(now.face, dt),
            expression=expression,
            regions=advance_regions(now.regions, expression, dt) if now.regions else now.regions,
            light=axis.advanced(now.light, dt),
            figure=advance_figure(now.figure, dt, self._is_layer_on),
            easing_to_rest=ease_later(now.easing_to_rest, dt),
            time=now.time + dt,
        )
        self._advance_macros(dt)
        self._move(dt)
        self._speak(dt)
        self._advance_clips(dt)
        self._layers = self._advance_layers(self._layers, dt)
        return self._with_chest(self._with_skin(self._with_springs(self._frame(), dt, self._held()), dt), dt)

    def drive_layer(self, layer: LayerName, frame: SourceFrame) -> None:
        """Takes one frame of a source that is checked already, as `drive`.

        Parameters
        ----------
        layer : str
            The layer.
        frame : SourceFrame
            What `source_frame` and `check_frame` gave.

        Examples
        --------
        >>> from omote.perform.layers.source_frame import source_frame
        >>> performer = omote.Performer(cast)
        >>> performer.drive_layer("lips", source_frame(cast.expressions, {"jawOpen": 0.4}, None, None))
        >>> list(performer.advance(0.0).layers)
        ['lips']
        """
        if frame.body is not None:
            self._drive_body(layer, frame, frame.body)
        if not frame.parts:
            return
        turns = RULES[layer] != "fill"  # what fills closes what is open, and turns nothing
        played = with_gaze_of_units(frame) if turns else frame
        self._layers = drive(self._cast, self._begun_layers(), layer, played)

    def leave_layer(self, layer: LayerName, source: str) -> None:
        """Fades out the layer of a source that has gone.

        Parameters
        ----------
        layer : str
            The layer that it drives.
        source : str
            Its name; another's layer stays.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.drive({"jawOpen": 0.4})
        >>> performer.leave_layer("playback", "")
        >>> performer.advance(8.0).layers
        {}
        """
        self._layers = None if self._layers is None else leave(self._layers, layer, source)
        self._leave_body(layer, source)

    def recalibrate_layer(self, layer: LayerName, source: str) -> None:
        """Fades out the layer of a source that sends by another measure from now on, before it follows again.

        Parameters
        ----------
        layer : str
            The layer that it drives.
        source : str
            Its name; another's layer stays.

        Examples
        --------
        >>> performer = omote.Performer(cast)
        >>> performer.drive({"jawOpen": 0.4})
        >>> performer.recalibrate_layer("playback", "")
        """
        self._layers = None if self._layers is None else recalibrate(self._layers, layer, source)

    def _is_layer_on(self, layer: LayerName) -> bool:
        return self._layers is None or self._layers.settings[layer].on

    def _move(self, dt: float) -> None:
        """What the character does by itself plays the layers that no source drives."""
        motion = self._now.motion
        if motion is None:
            return
        if (lost := is_tracker_lost(self._layers, motion.lost)) != motion.lost:
            motion = with_fields(motion, lost=lost)
        if is_moving(motion):
            speaking = self._layers is not None and is_speaking(self._layers)
            motion = advance_motion(motion, dt, sight=self._find_sight(motion.settings.target), speaking=speaking)
        self._now = with_fields(self._now, motion=motion)
        frames = motion_frames(motion, self._cast.expressions)
        for layer in MOTION_LAYERS:
            if layer not in frames:
                self.leave_layer(layer, AUTOMATIC)
        before = self._layers
        free = {layer: frame for layer, frame in frames.items() if before is None or is_free(before, layer)}
        if free:
            self._layers = drive_direct(self._cast, self._begun_layers(), free)

    def _find_sight(self, target: GazeTarget) -> Sight:
        """What the eyes look at; others are nowhere for a performer that is in no scene."""
        return sight_alone(target)

    def _speak(self, dt: float) -> None:
        """What is said plays the layer of the lips, and gestures go on."""
        if self._now.gestures:
            self._now = with_fields(self._now, gestures=advance_gestures(self._now.gestures, dt))
        if self._now.speaking is None:
            return
        before = self._now.speaking
        share = share_of_lips(before)  # none at first, so that its layer is trusted at once
        speaking = advance_speaking(before, dt)
        spoken = find_spoken(before, speaking)
        self._now = with_fields(self._now, speaking=speaking, spoken=self._now.spoken if spoken is None else spoken)
        if speaking is None:
            self.leave_layer("lips", SPEECH)
        elif speaking.moves:
            mouth = mouth_of_speaking(speaking)
            frame = speech_frame(mouth, self._cast.expressions, source=SPEECH, share=share)
            self.drive_layer("lips", frame)

    def _begun_layers(self) -> Layers:
        return begin(self._cast, self._held()) if self._layers is None else self._layers

    def _advance_layers(self, before: Layers | None, dt: float) -> Layers | None:
        if before is None:
            return None
        layers = advance(self._cast, before, self._held(), dt, still=self._now.easing_to_rest is None)
        return None if is_at_rest(layers) else layers

    def _frame(self) -> Frame:
        return with_gestures(
            self._frame_without_gestures(), self._now.gestures, self._cast.expressions, self.held_by_faders
        )

    def _frame_without_gestures(self) -> Frame:
        now = self._now
        held = self._held()
        frame = _frame(now, held, self._macros)
        if now.clips:
            frame = with_fields(frame, clips=self._clip_statuses())
            frame = self._with_body(frame)
        if now.pads:
            frame = with_fields(frame, pads=self._pad_statuses())
        if self._layers is not None:
            frame = with_layers(frame, self._layers, held, now.easing_to_rest, self._mixes)
        return self._with_faders(frame) if self._gives else frame

    def _show_soon(self) -> tuple[Frame, Frame]:
        """What would show a moment and two moments later, beside gestures; what shows now where that cannot be told:
        what stops a show must not depend on what moves."""
        later = copy(self)
        try:
            later.advance(MOMENT)
            soon = later._frame_without_gestures()
            later.advance(MOMENT)
            return soon, later._frame_without_gestures()
        except Exception:  # whatever it is, a panic is what ends it
            stands = self._frame_without_gestures()
            return stands, stands

    def _with_played_mixes(self, now: Snapshot, later: Frame) -> Snapshot:
        """A panic where clips play: what is called over from now on are the mixes that show with theirs, at their
        speed. now: as it is; later: what would show a moment later."""
        if not now.clips:
            return now
        body = self._body_on_air()
        if body is not None:
            now = replace(now, figure=replace(now.figure or AT_REST, tracked=left_body(body)))
        if not self._mixes:
            return replace(now, clips=())
        frame = self._frame_without_gestures()

        def at(mix: Mapping[str, float], after: Mapping[str, float]) -> Axis:
            return axis.moving(mix, combine(((1.0 / MOMENT, after), (-1.0 / MOMENT, mix))))

        parts = {**frame.regions, **later.regions}
        regions = {
            region: at(
                mix_in(region, frame.expressions, frame.regions), mix_in(region, later.expressions, later.regions)
            )
            for region in parts
        }
        return replace(now, expression=at(frame.expressions, later.expressions), regions=regions, clips=())

    def _without_layers(self, rested: Snapshot) -> Snapshot:
        """A panic where layers play: all that they had on air eases to rest, and sources are off."""
        layers = self._advance_layers(self._layers, 0.0)
        if layers is None:
            self._layers = None
            return rested
        self._layers = layers
        frame = self._frame_without_gestures()  # which go on their own way
        kept = [1.0] * len(PLAY_REGIONS) if self._mixes else kept_of_mix(layers, influences(layers))
        self._layers = switch_off(layers, kept)
        self._forget_clips()
        return replace(rested, easing_to_rest=EasingToRest(frame.channels, frame.head, frame.gaze))


def _at_rest(now: Snapshot, held: Held) -> Snapshot:
    easing_to_rest = EasingToRest(**vars(eased(held, now.easing_to_rest)))

    def rest(on: Axis) -> Axis:
        return axis.called(replace(on, hand=0.0), NEUTRAL, PANIC_SECONDS, PANIC_EASING)

    return replace(
        now,
        face=axis.halted(now.face, PANIC_SECONDS),
        expression=rest(now.expression),
        regions=call_regions(now.regions, now.expression, rest),
        channels={},
        head=Head(),
        gaze=Gaze(),
        easing_to_rest=easing_to_rest,
        motion=None
        if now.motion is None
        else replace(set_motion(now.motion, now.motion.settings.change(liveliness=0.0, target=NO_TARGET)), lost=False),
        speaking=None,
        gestures=release_gestures(now.gestures),
        pads={},
        springs=release_springs(now.springs),
        skin=calm_skin(now.skin),
        figure=halt_figure(now.figure, PANIC_SECONDS),
    )


_NOTHING = Frame({}, {})


def _frame(now: Snapshot, held: Held, macros: MacroVectors | None) -> Frame:
    return with_fields(
        _NOTHING,
        faces=axis.weights(now.face),
        expressions=axis.weights(now.expression),
        **vars(eased(held, now.easing_to_rest)),
        time=now.time,
        face_call=axis.status(now.face),
        expression_call=axis.status(now.expression),
        face_fader=now.face.hand,
        expression_fader=now.expression.hand,
        light=axis.weights(now.light),
        light_call=axis.status(now.light),
        home=now.home,
        home_next=is_home_next(now),
        panics=now.panics,
        regions={region: axis.weights(on) for region, on in now.regions.items()},
        region_calls={region: call for region, on in now.regions.items() if (call := axis.status(on)) is not None},
        motion=None if now.motion is None else now.motion.settings,
        speech=speech_status(now.speaking),
        spoken=now.spoken,
        macros=macro_statuses(now.mappings.kept, macros),
        figure=None if now.figure is None else figure_frame(now.figure),
        idle=NO_IDLE if now.motion is None else (*figure_idle(now.motion), 0.0),
    )
