"""Snapshots: the whole state of a performer beside its cast, and their validation when they come from a file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol

from omote.model.body.pose_regions import check_pose_region
from omote.model.known_names import PlayRegion, check_play_region
from omote.model.space.expression import Expression, Title
from omote.perform.axis import Axis, Call
from omote.perform.channels import highest_weight, with_channel
from omote.perform.clips.clip_runs import ClipRun, check_runs
from omote.perform.complexion import Skin, check_skin
from omote.perform.easing import DECAY_SECONDS, Glide, find_easing
from omote.perform.figures.figure_axes import FACES_OWN, FigureAxes
from omote.perform.figures.tracked_body import check_tracked
from omote.perform.frame import Gaze, Head, Home
from omote.perform.gestures import Gesture, check_gestures
from omote.perform.layers.layers_snapshot import LayersSnapshot, names_driven, restored
from omote.perform.lights import FIRST_LIGHT, LIGHTS
from omote.perform.limits import (
    CHANNEL_LOWEST,
    FOREVER,
    GAZE_LIMITS,
    LONGEST_CALL,
    SHORTEST_CALL,
    check_known,
    check_within,
)
from omote.perform.mappings.kept_mappings import NO_MAPPINGS, Mappings, check_mappings
from omote.perform.mappings.macro_vectors import channels_given
from omote.perform.mappings.macros import NO_MACROS, Macros, check_macros
from omote.perform.mix import HIGHEST, LOWEST, Weights
from omote.perform.motion.automatic_motion import AutomaticMotion, check_motion
from omote.perform.motion.chest_following import AT_HOME, Chest
from omote.perform.pads.blend_space import AXES, MOST_PADS, PLACE_RANGE, PadPlace, check_pad_name
from omote.perform.pads.pad_point import FACE_SECONDS, FOLLOW_SECONDS
from omote.perform.panic import FASTEST, PANIC_SECONDS, SAME_PRESS, EasingToRest
from omote.perform.speech.speaking import Speaking, check_speaking
from omote.perform.springs.springs import Springs, check_springs


class Playable(Protocol):
    """What can be called: a cast, or any other faces and expressions by name."""

    @property
    def faces(self) -> Mapping[str, object]:
        """The faces, whatever stands for them."""

    @property
    def expressions(self) -> Mapping[str, Expression]:
        """The expressions: the engine itself needs their eyes."""

    @property
    def titles(self) -> Mapping[str, Title]:
        """What expressions are called and where they act."""

    @property
    def face_labels(self) -> Mapping[str, str]:
        """What faces are called that have another label than their name."""

    @property
    def poses(self) -> Mapping[str, object]:
        """The poses, whatever stands for them."""

    @property
    def bones(self) -> tuple[str, ...]:
        """The bones that poses turn, in their order; none without figures."""

    @property
    def bodies(self) -> Mapping[str, object]:
        """The bodies, whatever stands for them."""

    @property
    def digest(self) -> str:
        """The digest of exactly these."""


ROUNDING = 1e-6
"""How far sums and ranges may be off after a long show."""
FOLLOW_LIMITS = (FOLLOW_SECONDS, FACE_SECONDS)


@dataclass(frozen=True)
class Snapshot:
    """The state of a performer: plain values, so msgspec writes and reads it exactly.

    `panicked`: the time of the last panic, None once something has been played after it; `panics` counts all of them.
    `regions`: the expressions of the regions that go their own way; all others go with `expression`. `layers`: None
    while nothing but calls and hands plays. `motion`: the automatic one, None while none has been set. `speaking`: what
    is said; `said` counts all that was, `spoken` is the key of what was said to its end last. `gestures`: those that
    run. `clips`: those that play, the oldest first; `played` counts all. `pads`: where the points of pads are that have
    been moved. `mappings`: what macros play; `macros`: those that were moved.
    `springs`: how much of them is set and how they move, None while none has moved. `skin`: blood, tears and
    sweat as they show and the faders of the skin, None where there is nothing of that.
    `figure`: poses and bodies, None while none has been called. `chest`: how far it has followed the head.
    """

    face: Axis
    expression: Axis
    channels: Mapping[str, float] = field(default_factory=dict)
    head: Head = field(default_factory=Head)
    gaze: Gaze = field(default_factory=Gaze)
    time: float = 0.0
    light: Axis = field(default_factory=lambda: Axis(FIRST_LIGHT))  # older snapshots have no light, nor what follows
    easing_to_rest: EasingToRest | None = None
    home: Home = field(default_factory=Home)
    panicked: float | None = None
    panics: int = 0
    regions: Mapping[PlayRegion, Axis] = field(default_factory=dict)
    layers: LayersSnapshot | None = None
    motion: AutomaticMotion | None = None
    speaking: Speaking | None = None
    said: int = 0
    spoken: str = ""
    gestures: tuple[Gesture, ...] = ()
    clips: tuple[ClipRun, ...] = ()
    played: int = 0
    mappings: Mappings = NO_MAPPINGS
    macros: Macros = NO_MACROS
    pads: Mapping[str, PadPlace] = field(default_factory=dict)
    springs: Springs | None = None
    skin: Skin | None = None
    figure: FigureAxes | None = None
    chest: Chest = AT_HOME


def refuse_no_cast(cast: object) -> None:
    """Raises TypeError where a cast was expected and something else came."""
    if not all(isinstance(getattr(cast, what, None), Mapping) for what in ("faces", "expressions")):
        raise TypeError(f"the cast is a {type(cast).__name__}; expected an omote.Cast, such as omote.load_cast()")


def is_home_next(snapshot: Snapshot) -> bool:
    """Whether the next panic brings the home face: nothing has been played since the last, which was another press."""
    if snapshot.panicked is None or snapshot.time - snapshot.panicked < SAME_PRESS:
        return False
    axis = snapshot.face
    return (axis.on_air if axis.call is None else axis.call.target) != snapshot.home.face or _mixes(axis)


def _mixes(axis: Axis) -> bool:
    return axis.stands is not None if axis.call is None else axis.call.goal is not None


def check_snapshot(snapshot: Snapshot, cast: Playable) -> Snapshot:
    """Validates a snapshot and returns it; rejects one that the cast cannot play, or that no performer wrote."""
    refuse_no_cast(cast)
    if not isinstance(snapshot, Snapshot):
        raise TypeError(f"the snapshot is a {type(snapshot).__name__}; expected what Performer.snapshot() gives")
    check_axis(snapshot.face, cast.faces, "face")
    check_axis(snapshot.expression, cast.expressions, "expression")
    check_axis(snapshot.light, LIGHTS, "light")
    for region, axis in snapshot.regions.items():
        check_axis(axis, cast.expressions, f"expression ({check_play_region(region)})")
    for name, value in snapshot.channels.items():
        with_channel({}, cast.expressions, name, value)
    _check_easing_to_rest(snapshot.easing_to_rest, cast)
    restored(cast, snapshot.layers)
    check_motion(snapshot.motion)
    check_speaking(snapshot.speaking)
    check_gestures(snapshot.gestures)
    check_runs(snapshot.clips)
    check_mappings(snapshot.mappings)
    check_macros(snapshot.macros, snapshot.mappings.kept)
    check_within(len(snapshot.pads), 0, MOST_PADS, "the number of pads that have been moved")
    for name, place in snapshot.pads.items():
        _check_point(name, place)
    check_springs(snapshot.springs)
    check_skin(snapshot.skin)
    _check_figure(snapshot.figure, cast)
    for turned in snapshot.chest:
        check_within(turned, -1.0, 1.0, "how far the chest has followed the head")
    check_known(snapshot.home.face, cast.faces, "face")
    check_within(snapshot.time, 0.0, FOREVER, "the snapshot's time (seconds)")
    if snapshot.panicked is not None:
        check_within(snapshot.panicked, 0.0, snapshot.time, "the time of the last panic (seconds)")
    return snapshot


def _check_figure(figure: FigureAxes | None, cast: Playable) -> None:
    if figure is None:
        return
    check_axis(figure.pose, cast.poses, "pose")
    for region, axis in figure.regions.items():
        check_axis(axis, cast.poses, f"pose ({check_pose_region(region)})")
    if figure.tracked is not None:
        check_tracked(figure.tracked)
    check_axis(figure.body, {FACES_OWN: None, **cast.bodies}, "body")


def _check_easing_to_rest(left: EasingToRest | None, cast: Playable) -> None:
    if left is None:
        return
    check_within(left.elapsed, 0.0, PANIC_SECONDS, "the elapsed time of a panic (seconds)")
    for name, value in left.channels.items():
        with_channel({}, cast.expressions, name, 0.0)
        check_within(value, CHANNEL_LOWEST, highest_weight(cast.expressions, name), f"the channel {name}")
    for part in left.moving.values():
        for name, each in part.items():
            check_within(each.speed, -FASTEST, FASTEST, f"the speed of {name} after a panic (per second)")
            check_within(each.decay, 0.0, PANIC_SECONDS, f"the decay of the speed of {name} after a panic (seconds)")


def limit_gaze(saved: object) -> bool:
    """Brings the gaze of a snapshot's plain values into its range, which older ones do not know; whether it was beyond.

    Everything else is left as it is, for `check_snapshot` and the types to reject.
    """
    gaze = saved.get("gaze") if isinstance(saved, dict) else None
    if not isinstance(gaze, dict):
        return False
    beyond = [name for name, limit in GAZE_LIMITS.items() if _is_beyond(gaze.get(name), limit)]
    gaze.update({name: math.copysign(GAZE_LIMITS[name], gaze[name]) for name in beyond})
    return bool(beyond)


def _is_beyond(angle: object, limit: float) -> bool:
    return isinstance(angle, float) and math.isfinite(angle) and abs(angle) > limit


class NamesHeld(NamedTuple):
    """Names that the cast must not lose; channels are expressions too."""

    faces: frozenset[str] = frozenset()
    expressions: frozenset[str] = frozenset()
    poses: frozenset[str] = frozenset()

    def with_others(self, *others: NamesHeld) -> NamesHeld:
        """These names and those of others."""
        return NamesHeld(*(frozenset().union(*names) for names in zip(self, *others, strict=True)))


def names_held(snapshot: Snapshot) -> NamesHeld:
    """The names that a snapshot cannot be played without."""
    given = channels_given(snapshot.macros, snapshot.mappings.kept)
    channels = frozenset(snapshot.channels) | names_driven(snapshot.layers) | given
    if snapshot.easing_to_rest is not None:
        channels |= frozenset(snapshot.easing_to_rest.channels)
    expressions = frozenset[str]().union(*map(axis_names, (snapshot.expression, *snapshot.regions.values())))
    figure = snapshot.figure
    poses = () if figure is None else map(axis_names, (figure.pose, *figure.regions.values()))
    return NamesHeld(
        axis_names(snapshot.face) | {snapshot.home.face}, expressions | channels, frozenset[str]().union(*poses)
    )


def axis_names(axis: Axis) -> frozenset[str]:
    """All names that an axis has on air, called or going."""
    call = axis.call
    point = axis.point
    stands = (axis.on_air, *(axis.stands or ()), *(() if point is None else (*point.goal, *point.first, *point.second)))
    if call is None:
        return frozenset(stands)
    return frozenset((*stands, call.target, *call.start, *call.velocity, *(call.goal or ())))


def check_axis(axis: Axis, names: Mapping[str, object], what: str) -> None:
    """Rejects an axis that was read and that none can be, or that has a name that is not among `names`.

    what: what messages call it.
    """
    check_known(axis.on_air, names, what)
    check_within(axis.hand, 0.0, 1.0, f"the {what} T-bar")
    if axis.stands is not None:
        _check_mix(axis.stands, names, what)
    if axis.call is not None:
        _check_call(axis.call, names, what)
    if axis.point is not None:
        _check_point(axis.point.pad, axis.point.place)
        check_within(
            axis.point.seconds, *FOLLOW_LIMITS, f"the time in which the {what}s of a pad are followed (seconds)"
        )
        for mix in (axis.point.goal, axis.point.first, axis.point.second):
            _check_mix(mix, names, what)


def _check_point(pad: str, place: PadPlace) -> None:
    check_pad_name(pad)
    check_within(len(place), 1, len(AXES), f"the number of dimensions of the pad {pad}")
    for at in place:
        check_within(at, *PLACE_RANGE, f"the place on the pad {pad}")


def _check_call(call: Call, names: Mapping[str, object], what: str) -> None:
    for name in (call.target, *call.start, *call.velocity):
        check_known(name, names, what)
    find_easing(call.easing)
    for mix in (call.start, *([] if call.goal is None else [call.goal])):
        _check_mix(mix, names, what)
    _check_sum(call.velocity, 0.0, f"the velocities of the {what}s")
    check_within(call.decay, 0.0, DECAY_SECONDS, "the decay of a call (seconds)")
    check_within(call.elapsed, 0.0, FOREVER, "the elapsed time of a call (seconds)")
    if call.since is not None:
        check_within(call.since, 0.0, FOREVER, "the time in which the velocity of a call dies out (seconds)")
    if call.seconds is not None:
        check_within(call.seconds, SHORTEST_CALL, LONGEST_CALL, "the time of a call (seconds)")
    if call.way is not None:
        _check_way(call.way)
    if call.pace is not None:
        check_within(call.pace, 0.0, 1.0, "the pace of a call")


def _check_mix(mix: Weights, names: Mapping[str, object], what: str) -> None:
    for name, weight in mix.items():
        check_known(name, names, what)
        check_within(weight, LOWEST - ROUNDING, HIGHEST + ROUNDING, f"the weight of the {what} {name}")
    _check_sum(mix, 1.0, f"the weights of the {what}s")


def _check_way(way: Glide) -> None:
    check_within(way.origin, -ROUNDING, 1.0 + ROUNDING, "the origin of a T-bar's way")
    check_within(way.goal, 0.0, 1.0, "the goal of a T-bar's way")
    check_within(way.rate, -FOREVER, FOREVER, "the rate of a T-bar (per second)")
    check_within(way.seconds, 0.0, LONGEST_CALL, "the time of a T-bar's way (seconds)")
    check_within(way.elapsed, 0.0, FOREVER, "the elapsed time of a T-bar's way (seconds)")


def _check_sum(weights: Weights, expected: float, what: str) -> None:
    total = math.fsum(weights.values())
    slack = ROUNDING * (1.0 + math.fsum(abs(weight) for weight in weights.values()))
    if not abs(total - expected) <= slack:
        raise ValueError(f"{what} in the snapshot sum to {total!r}; they must sum to {expected:g}")
