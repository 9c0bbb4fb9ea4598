"""Calls of faces, expressions, poses and bodies, their T-bars, panic and the home face."""

from __future__ import annotations

import math
from collections.abc import Sequence

from omote.model.body.pose import STAND
from omote.model.body.pose_regions import POSE_REGIONS, PoseRegion
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.limits import LONGEST_CALL
from omote.perform.performer import Performer
from omote.show.declaration import (
    BodyName,
    CallId,
    CallSeconds,
    CharacterCommand,
    ExpressionName,
    FaceName,
    Name,
    OptionalCallId,
    Outgoing,
    PoseName,
    Position,
    Session,
    characters_of,
)
from omote.show.objects.state import CharacterState, named_most
from omote.show.osc import PRESS, Osc, Value, osc
from omote.show.validation import Refusal

STRENGTH = Value(default=1.0, name="strength")


def seconds_of(seconds: float | None) -> float:
    """The seconds of a call as a performer takes them: infinite for one by hand, which waits for its T-bar."""
    if seconds is None:
        return math.inf
    if seconds == math.inf:
        raise Refusal("the time of a call (seconds) is inf; give a number of seconds, or nil for a call by hand.")
    return seconds


def _named_in_region(state: CharacterState, region: str) -> tuple[str, ...]:
    """What a region shows or comes to show: its own, or that of the whole face; nothing for none that there is."""
    if region not in PLAY_REGIONS:
        return ()
    own = {str(part): mix for part, mix in state.regions.items()}
    if region not in own:
        return (named_most(state.expressions, state.expression_call),)
    calls = {str(part): call for part, call in state.region_calls.items()}
    return (named_most(own[region], calls.get(region)),)


class CallFace(CharacterCommand, frozen=True):
    """Brings a face on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once."""

    plays = "face"
    osc = (
        Osc(
            "face",
            "brings a face on air",
            ("name", "seconds"),
            on_air=lambda state: (named_most(state.faces, state.face_call),),
        ),
    )

    id: CallId
    name: FaceName
    seconds: CallSeconds = 1.0
    easing: Name = DEFAULT_EASING

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.call_face(self.name, seconds=seconds_of(self.seconds), easing=self.easing)


class CallExpression(CharacterCommand, frozen=True):
    """Brings an expression on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once.

    `region`: where alone it is called, in its own time, which no T-bar moves; `None`: on the whole face. `strength`:
    how much of it, 0 (neutral) to 1; no T-bar moves a call of less than all.
    """

    plays = "expression"
    osc = (
        Osc(
            "expression",
            "brings an expression on air, all of it or a part (strength)",
            ("name", "seconds", STRENGTH),
            on_air=lambda state: (named_most(state.expressions, state.expression_call),),
        ),
        Osc(
            "expression/{region}",
            "brings an expression on air in one region of the face alone: brows, eyes, mouth or rest",
            (Value("region", name="region"), "name", Value("time", high=LONGEST_CALL, unit="s", name="seconds")),
            on_air=_named_in_region,
            reported=lambda _: ((region,) for region in PLAY_REGIONS),
        ),
    )

    id: CallId
    name: ExpressionName
    seconds: CallSeconds = 1.0
    easing: Name = DEFAULT_EASING
    region: PlayRegion | None = None
    strength: float = 1.0

    def play(self, performer: Performer) -> None:
        """Plays it."""
        if self.region is not None and self.seconds is None:
            raise Refusal("a region of a face has no T-bar: give the seconds of the call, or call the whole face.")
        performer.call_expression(
            self.name, seconds=seconds_of(self.seconds), easing=self.easing, region=self.region, strength=self.strength
        )


class FadeFace(CharacterCommand, frozen=True):
    """The position of the face T-bar, 0..1."""

    plays = "face"
    hand = "plays"
    osc = (Osc("fade/face", "moves the T-bar of the faces", ("value",), on_air=lambda state: (state.face_fader,)),)

    value: Position

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.fade_face(self.value)


class ReleaseFace(CharacterCommand, frozen=True):
    """The operator lets go of the face T-bar."""

    plays = "face"
    osc = (osc("release/face", "lets go of the T-bar of the faces", PRESS),)

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.release_face()


class FadeExpression(CharacterCommand, frozen=True):
    """The position of the expression T-bar, 0..1."""

    plays = "expression"
    hand = "plays"
    osc = (
        Osc(
            "fade/expression",
            "moves the T-bar of the expressions",
            ("value",),
            on_air=lambda state: (state.expression_fader,),
        ),
    )

    value: Position

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.fade_expression(self.value)


class ReleaseExpression(CharacterCommand, frozen=True):
    """The operator lets go of the expression T-bar."""

    plays = "expression"
    osc = (osc("release/expression", "lets go of the T-bar of the expressions", PRESS),)

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.release_expression()


def _pose_on_air(state: CharacterState) -> tuple[str, ...]:
    figure = state.figure
    return (STAND if figure is None else named_most(figure.poses, figure.pose_call),)


def _pose_of_region(state: CharacterState, region: str) -> tuple[str, ...]:
    """What a region of the figure does or comes to do: its own pose, or that of the whole; nothing for none that there
    is."""
    if region not in POSE_REGIONS:
        return ()
    figure = state.figure
    own = {} if figure is None else {str(part): mix for part, mix in figure.regions.items()}
    if figure is None or region not in own:
        return _pose_on_air(state)
    calls = {str(part): call for part, call in figure.region_calls.items()}
    return (named_most(own[region], calls.get(region)),)


def _body_on_air(state: CharacterState) -> tuple[str, ...]:
    figure = state.figure
    return (FACES_OWN if figure is None else named_most(figure.bodies, figure.body_call),)


class CallPose(CharacterCommand, frozen=True):
    """Brings a pose on air in `seconds`, or by hand (`None`: the T-bar moves it). An `id` executes once.

    `region`: where alone it is called, in its own time, which no T-bar moves; `None`: of the whole figure.
    """

    plays = "pose"
    osc = (
        Osc("pose", "brings a pose on air", ("name", "seconds"), on_air=_pose_on_air),
        Osc(
            "pose/{region}",
            "brings a pose on air in one region of the figure alone: head, trunk, arm_left, arm_right or stance",
            (Value("pose_region", name="region"), "name", Value("time", high=LONGEST_CALL, unit="s", name="seconds")),
            on_air=_pose_of_region,
            reported=lambda _: ((region,) for region in POSE_REGIONS),
        ),
    )

    id: CallId
    name: PoseName
    seconds: CallSeconds = 1.0
    easing: Name = DEFAULT_EASING
    region: PoseRegion | None = None

    def play(self, performer: Performer) -> None:
        """Plays it."""
        if self.region is not None and self.seconds is None:
            raise Refusal("a region of a figure has no T-bar: give the seconds of the call, or call the whole figure.")
        performer.call_pose(self.name, seconds=seconds_of(self.seconds), easing=self.easing, region=self.region)


class FadePose(CharacterCommand, frozen=True):
    """The position of the pose T-bar, 0..1."""

    plays = "pose"
    hand = "plays"
    osc = (
        Osc(
            "fade/pose",
            "moves the T-bar of the poses",
            ("value",),
            on_air=lambda state: (0.0 if state.figure is None else state.figure.fader,),
        ),
    )

    value: Position

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.fade_pose(self.value)


class ReleasePose(CharacterCommand, frozen=True):
    """The operator lets go of the pose T-bar."""

    plays = "pose"
    osc = (osc("release/pose", "lets go of the T-bar of the poses", PRESS),)

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.release_pose()


class CallBody(CharacterCommand, frozen=True):
    """Brings a body on air in `seconds`, apart from the face; `name` "own": each face has its own again. An `id`
    executes once."""

    plays = "pose"
    osc = (
        Osc(
            "body",
            "brings a body on air apart from the face; own gives each face its own again",
            ("name", Value("time", high=LONGEST_CALL, unit="s", name="seconds")),
            on_air=_body_on_air,
        ),
    )

    id: CallId
    name: BodyName
    seconds: CallSeconds = 1.0
    easing: Name = DEFAULT_EASING

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.call_body(self.name, seconds=seconds_of(self.seconds), easing=self.easing)


class Panic(CharacterCommand, frozen=True):
    """The face on air goes neutral and holds still, now; while `CharacterState.home_next` is true it brings the home
    face. An `id` executes once: a page sends it again where its link breaks."""

    follows_bus = False
    osc = (
        osc("panic", "holds it still and neutral; again, it brings its home face", PRESS),
        osc("panic", "holds all faces still and neutral; again, it brings the home face", PRESS, of_show=True),
    )

    id: OptionalCallId = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Holds faces still, and takes them out of all hands. session: the show; who: the client; now: seconds,
        monotonic."""
        super().act(session, who, now)
        session.take_hands_off(who, characters_of(session.scene, self.character), now)
        return ()

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.panic()


class SetHome(CharacterCommand, frozen=True):
    """The face that a second panic brings on air, and the seconds that it takes; it stays with the show."""

    follows_bus = False

    face: Name
    seconds: float = 2.0

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_home(self.face, seconds=self.seconds)
