"""Calls of poses and bodies, and the T-bar of poses."""

from __future__ import annotations

from omote.model.body.pose import STAND
from omote.model.body.pose_regions import POSE_REGIONS, PoseRegion
from omote.perform.easing import DEFAULT_EASING
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.limits import LONGEST_CALL
from omote.perform.performer import Performer
from omote.show.declaration import BodyName, CallId, CallSeconds, CharacterCommand, Name, PoseName, Position
from omote.show.objects.calls import seconds_of
from omote.show.objects.state import CharacterState, named_most
from omote.show.osc import PRESS, Osc, Value, osc
from omote.show.validation import Refusal


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
