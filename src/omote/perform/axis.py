"""One axis of the mix (faces, expressions or lights): what is on air, the running call, and the T-bar.

An axis is a value; every function here returns a changed copy. A call moves the weights along
(1 - y) start + y target + velocity term; its progress y follows the easing, or the T-bar. A pad plays an axis as a call
does whose target moves with the pad's point.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple, TypeVar

from omote.perform.easing import (
    DECAY_SECONDS,
    DEFAULT_EASING,
    HAND_SECONDS,
    Glide,
    bump,
    bump_rate,
    decay_seconds,
    find_easing,
    glide_after,
    glide_state,
    is_over,
    plan_glide,
)
from omote.perform.frame import CallStatus, with_fields
from omote.perform.mix import Weights, combine, mix_of_one, normalise, share_in_range
from omote.perform.pads.blend_space import PadPlace
from omote.perform.pads.pad_point import FOLLOW_SECONDS, PadPoint, point_after, point_at, point_moved, point_rates

LEAST_STANDING = 1e-3
"""What weighs less when a mix comes to a stand goes: nobody sees it, and nobody would find it."""


@dataclass(frozen=True)
class Call:
    """A running call (an inertialised transition): from the mix `start`, moving at `velocity` per second, to `target`
    alone.

    `seconds` None: only the T-bar moves it. `way` is the way of the T-bar, or the rest of the way after its release;
    without it the easing decides. `held`: the T-bar has picked it up. `goal`: the mix to come to a stand at, where that
    is not the target alone (`halted`). `pace`: how fast its time goes, 0..1 of the show's, where cues have called it
    (`with_pace`); None: with the show's, whatever pauses. `since`: seconds of the show since it has a pace, from its
    elapsed time then, for the velocity dies out in the show's time: what moved comes to a stand in a pause and does not
    stop at once. None: as elapsed.
    """

    target: str
    start: Mapping[str, float]
    velocity: Mapping[str, float]
    decay: float
    easing: str
    seconds: float | None
    elapsed: float = 0.0
    way: Glide | None = None
    held: bool = False
    goal: Mapping[str, float] | None = None
    pace: float | None = None
    since: float | None = None


@dataclass(frozen=True)
class Axis:
    """The state of one axis: `on_air` alone, or the mix `stands`, or a call running from there; `hand` is its T-bar's
    position, 0..1. `point`: that of the pad that plays it; then the mix that stands, or is called, moves with that."""

    on_air: str
    call: Call | None = None
    hand: float = 0.0
    flipped: bool = field(default=False)
    stands: Mapping[str, float] | None = None
    point: PadPoint | None = None


class Slots(NamedTuple):
    """The weights of a call's start, target and velocity; the paper's s (or t), with the velocity as third slot."""

    start: float
    target: float
    velocity: float


REST = Slots(0.0, 1.0, 0.0)


def progress(call: Call) -> tuple[float, float]:
    """How far a call is, 0..1, and its rate per second."""
    if call.way is not None:
        return glide_state(call.way)
    if call.seconds is None:
        return 0.0, 0.0
    x = min(1.0, call.elapsed / call.seconds)
    easing = find_easing(call.easing)
    return easing.value(x), easing.rate(x) / call.seconds


def _position(call: Call) -> float:
    """How far a call is, as `progress`, without its rate: what each frame asks for, more than once."""
    if call.way is not None or call.seconds is None:
        return progress(call)[0]
    return find_easing(call.easing).value(min(1.0, call.elapsed / call.seconds))


def slots(axis: Axis) -> Slots:
    """The slot weights now: start and target sum to one, the velocity's names sum to nothing."""
    call = axis.call
    if call is None:
        return REST
    y = _position(call)
    return Slots(1.0 - y, y, call.decay * bump(_since(call) / call.decay) * _share(call) if call.decay else 0.0)


def slot_rates(axis: Axis) -> Slots:
    """The change of the slot weights per second."""
    call = axis.call
    if call is None:
        return Slots(0.0, 0.0, 0.0)
    _, rate = progress(call)
    carried = bump_rate(_since(call) / call.decay) * _share(call) if call.decay else 0.0
    pace = 1.0 if call.pace is None else call.pace
    return Slots(-rate * pace, rate * pace, carried)


def weights(axis: Axis) -> dict[str, float]:
    """The mix on air; it sums to one."""
    if axis.call is not None:
        return _mix_at(axis.call, slots(axis))
    return mix_of_one(axis.on_air) if axis.stands is None else dict(axis.stands)


def rates(axis: Axis) -> dict[str, float]:
    """The change of the mix per second; it sums to nothing."""
    called_rates = {} if axis.call is None else _mix_at(axis.call, slot_rates(axis))
    if axis.point is None:
        return called_rates
    return combine(((1.0, called_rates), (slots(axis).target, point_rates(axis.point))))


def called(
    axis: Axis, target: str, seconds: float | None, easing: str, goal: Mapping[str, float] | None = None
) -> Axis:
    """The axis with a call to `target` from whatever is showing: 0 seconds cut, None wait for the T-bar. goal: the mix
    with other things that it comes to, where that is not the target alone; no T-bar moves such a call.

    easing: the curve of the way.

    The end nearest to the hand becomes the start of the call, so a T-bar left at either end picks up at once.
    """
    if axis.call is None and axis.stands == goal and axis.on_air == target and axis.point is None:
        return axis
    if seconds == 0.0:
        return replace(axis, on_air=target, call=None, stands=goal, point=None)
    start = weights(axis)  # eq. 4 to 7 of Arai (1993) freeze the blend that shows; its weights say all of it
    velocity = rates(axis)
    end = mix_of_one(target) if goal is None else goal
    decay = decay_seconds(start, velocity, end, seconds, find_easing(easing))
    call = Call(target, start, velocity, decay, easing, seconds, goal=goal)
    return replace(axis, call=call, flipped=axis.hand > 0.5, point=None)


def halted(axis: Axis, seconds: float) -> Axis:
    """The axis that comes to a stand within `seconds`, where its speed carries it, with its T-bar at rest and no call.

    Half of speed times seconds is where a brake that eases leaves a mix; it never goes back.
    """
    axis = replace(axis, hand=0.0, flipped=False)
    call = axis.call
    if axis.point is not None and call is None:
        return let_go(axis, seconds)
    if call is None or (axis.point is None and call.goal is not None):
        return axis
    start = weights(axis)
    velocity = rates(axis)
    easing = DEFAULT_EASING
    if axis.point is None:
        goal = standing_mix(combine(((1.0, start), (seconds / 2.0, velocity))))
    else:  # the pad's mix moves too, and soon stands where its point is
        y, rate = progress(call)
        y = min(1.0, y + rate * seconds / 2.0)
        goal = standing_mix(combine(((1.0 - y, call.start), (y, axis.point.goal))))
    decay = decay_seconds(start, velocity, goal, seconds, find_easing(easing))
    return replace(axis, call=Call(_heaviest(goal), start, velocity, decay, easing, seconds, goal=goal), point=None)


def called_to_mix(axis: Axis, mix: Weights, seconds: float, easing: str) -> Axis:
    """The axis with a call to a whole mix, as of `called`. mix: what it comes to, one name or several; seconds: 0 cuts;
    easing: the curve of the way."""
    return called(axis, _heaviest(mix), seconds, easing, mix if len(mix) > 1 else None)


def moving(mix: Weights, velocity: Weights) -> Axis:
    """An axis that shows a mix which moves, per second, at a velocity that sums to nothing: for a call to take over."""
    name = _heaviest(mix)
    return Axis(name, Call(name, mix, velocity, DECAY_SECONDS, DEFAULT_EASING, DECAY_SECONDS))


def played(
    axis: Axis,
    pad: str,
    place: PadPlace,
    mix: Weights,
    seconds: float,
    easing: str = DEFAULT_EASING,
    follow: float = FOLLOW_SECONDS,
) -> Axis:
    """The axis that the point of a pad plays from now on: from whatever shows, at its speed.

    pad: its name; place: of the point; mix: what the pad shows there; seconds: in which what shows makes way where
    another plays, 0 cuts; easing: the curve of that; follow: seconds in which the mix is followed. No T-bar moves such
    an axis.
    """
    if axis.point is not None and axis.point.pad == pad and seconds:
        return with_fields(axis, point=point_moved(axis.point, place, mix))
    taken = called(axis, _heaviest(mix), seconds, easing, dict(mix))
    return replace(taken, point=point_at(pad, place, mix, follow))


def replayed(axis: Axis, pad: str, place: PadPlace, mix: Weights) -> Axis:
    """The axis whose pad has changed: it is called another name, or shows another mix where its point is.

    pad: its name; place: of the point; mix: what the pad shows there.
    """
    point = axis.point
    if point is None or (point.pad, point.place, point.goal) == (pad, place, mix):
        return axis
    return replace(axis, point=with_fields(point_moved(point, place, mix), pad=pad))


def let_go(axis: Axis, seconds: float) -> Axis:
    """The axis without its pad, which comes to a stand, within `seconds`, at what the pad shows where its point is."""
    if axis.point is None:
        return axis
    goal = standing_mix(axis.point.goal)
    return called(axis, _heaviest(goal), seconds, DEFAULT_EASING, goal)


def with_pace(axis: Axis, pace: float | None) -> Axis:
    """The axis with its call at a pace, 0..1 of the show's time; None: with the show, whatever pauses."""
    call = axis.call
    return axis if call is None else replace(axis, call=replace(call, pace=pace, since=_since(call)))


def repaced(axis: Axis, pace: float) -> Axis:
    """The axis with its call at another pace, 0..1, where it has one."""
    return axis if axis.call is None or axis.call.pace is None else with_pace(axis, pace)


def goal_of(axis: Axis) -> Weights:
    """The mix that an axis comes to, by its call, its T-bar or the pad that plays it, or stands at."""
    if axis.point is not None:
        return axis.point.goal
    return weights(axis) if axis.call is None else _goal(axis.call)


def standing_mix(mix: Weights) -> dict[str, float]:
    """A mix that shows, as one to come to a stand at: what nobody sees of it goes. mix: as on air."""
    return normalise({name: weight for name, weight in mix.items() if weight >= LEAST_STANDING})


def _heaviest(mix: Weights) -> str:
    return max(mix, key=lambda name: (mix[name], name))


def faded(axis: Axis, hand: float) -> Axis:
    """The axis with its T-bar moved to `hand`, 0..1: a call follows once the hand has passed its progress."""
    moved = replace(axis, hand=hand)
    call = axis.call
    if call is None or call.goal is not None:
        return moved
    y, rate = progress(call)
    before = _along(axis, axis.hand)
    now = _along(axis, hand)
    if not call.held and (before - y) * (now - y) > 0.0:
        return moved
    rate *= 1.0 if call.pace is None else call.pace
    return replace(moved, call=replace(call, held=True, way=plan_glide(y, rate, now, HAND_SECONDS), pace=None))


def released(axis: Axis) -> Axis:
    """The axis let go by the hand: a timed call goes on over the remaining share of its time, one by hand stays."""
    call = axis.call
    if call is None or not call.held:
        return axis
    call = replace(call, held=False)
    if call.seconds is not None:
        y, rate = progress(call)
        call = replace(call, way=plan_glide(y, rate, 1.0, (1.0 - y) * call.seconds))
    return replace(axis, call=call)


def advanced(axis: Axis, dt: float) -> Axis:
    """The axis `dt` seconds later; a call that has arrived leaves its target alone on air, or the pad that plays."""
    if axis.point is not None:
        axis = _follow(axis, point_after(axis.point, dt))
    if axis.call is None:
        return axis
    since = None if axis.call.since is None else axis.call.since + dt
    if axis.call.pace is not None:
        dt *= axis.call.pace
    way = None if axis.call.way is None else glide_after(axis.call.way, dt)
    call = with_fields(axis.call, elapsed=axis.call.elapsed + dt, way=way, since=since)
    if not _has_arrived(call):
        return with_fields(axis, call=call)
    goal = _goal(call)
    return _standing(axis, goal, call.target if axis.point is None else _heaviest(goal))


def _follow(axis: Axis, point: PadPoint) -> Axis:
    """The axis with the point of its pad farther: what is called, or stands, goes with that."""
    if point is axis.point:
        return axis
    if axis.call is None:
        return _standing(with_fields(axis, point=point), point.second, _heaviest(point.second))
    return with_fields(axis, point=point, call=with_fields(axis.call, goal=point.second))


def _standing(axis: Axis, mix: Weights, name: str) -> Axis:
    """The axis that shows a mix, in which a name weighs most."""
    return with_fields(axis, on_air=name, call=None, stands=mix if len(mix) > 1 else None)


def status(axis: Axis) -> CallStatus | None:
    """The status of the running call, for the operator; None at rest and on the way to a stand."""
    call = axis.call
    if call is None or call.goal is not None:
        return None
    y = _position(call)
    by_hand = call.held or call.seconds is None
    remaining = None if by_hand else _remaining(call)
    return CallStatus(call.target, y, remaining, by_hand, axis.hand, _along(axis, y), call.start)


def _mix_at(call: Call, share: Slots) -> dict[str, float]:
    return combine(((share.start, call.start), (share.target, _goal(call)), (share.velocity, call.velocity)))


def _goal(call: Call) -> Mapping[str, float]:
    return mix_of_one(call.target) if call.goal is None else call.goal


def _share(call: Call) -> float:
    """Limits the velocity's share: a T-bar pushed at once after an interruption may outrun the decay that was
    planned."""
    y = _position(call)
    base = combine(((1.0 - y, call.start), (y, _goal(call))))
    return share_in_range(base, combine(((call.decay * bump(_since(call) / call.decay), call.velocity),)))


def _since(call: Call) -> float:
    """Seconds in which the velocity of a call has died out so far."""
    return call.elapsed if call.since is None else call.since


def _along(axis: Axis, position: float) -> float:
    """A T-bar position as progress of the call, and back."""
    return 1.0 - position if axis.flipped else position


def _remaining(call: Call) -> float:
    if call.way is not None:
        return max(0.0, call.way.seconds - call.way.elapsed)
    return 0.0 if call.seconds is None else max(0.0, call.seconds - call.elapsed)


def _has_arrived(call: Call) -> bool:
    if not is_over(_since(call), call.decay):
        return False
    if call.way is not None:
        return call.way.goal == 1.0 and is_over(call.way.elapsed, call.way.seconds)
    return call.seconds is not None and is_over(call.elapsed, call.seconds)


Region = TypeVar("Region", bound=str)
"""Of a face or of a figure."""


def plays_same_pad(region: Axis, whole: Axis) -> bool:
    """Whether a region is on its way to what the pad of the whole shows."""
    return region.point is not None and whole.point is not None and region.point.pad == whole.point.pad


def call_regions(
    regions: Mapping[Region, Axis], face: Axis, call: Callable[[Axis], Axis]
) -> dict[Region, Axis]:  # fmt: skip
    """All regions that go their own way, called with the whole face, whose T-bar they then have.

    call: what calls an axis.
    """
    return {region: call(replace(on, hand=face.hand)) for region, on in regions.items()}


def call_part(
    whole: Axis, regions: Mapping[Region, Axis], region: Region | None, call: Callable[[Axis], Axis]
) -> tuple[Axis, Mapping[Region, Axis]]:  # fmt: skip
    """A face or a figure, and its regions, of which all are called, or one region alone.

    whole: its axis; regions: those that go their own way; region: which is called, None for all; call: what calls an
    axis.
    """
    if region is None:
        return call(whole), call_regions(regions, whole, call)
    return whole, {**regions, region: call(regions.get(region, whole))}


def move_whole(
    whole: Axis, regions: Mapping[Region, Axis], move: Callable[[Axis], Axis]
) -> tuple[Axis, Mapping[Region, Axis]]:  # fmt: skip
    """A face or a figure, and its regions, after its T-bar has moved. whole, regions: as of `call_part`; move: what
    moves the T-bar of an axis."""
    return move(whole), move_with_face(regions, whole, move)


def move_with_face(
    regions: Mapping[Region, Axis], face: Axis, move: Callable[[Axis], Axis]
) -> dict[Region, Axis]:  # fmt: skip
    """The regions after the T-bar of the whole face has moved: it moves those whose call is the face's too, and passes
    the others by.

    move: what moves the T-bar of an axis.
    """
    return {region: move(on) if _is_called_with(face, on) else on for region, on in regions.items()}


def _is_called_with(face: Axis, on: Axis) -> bool:
    if face.call is None or on.call is None:
        return False
    mine = face.call
    own = on.call
    return (mine.target, mine.seconds, mine.elapsed, mine.easing) == (own.target, own.seconds, own.elapsed, own.easing)


def advance_regions(regions: Mapping[Region, Axis], face: Axis, dt: float) -> dict[Region, Axis]:
    """The regions `dt` seconds later, without those that have come to show what the whole face does; face: its axis,
    advanced already."""
    later = {region: advanced(on, dt) for region, on in regions.items()}
    return {region: on for region, on in later.items() if not _shows_the_same(on, face)}


def _shows_the_same(on: Axis, face: Axis) -> bool:
    stand = on.call is None and face.call is None and on.point == face.point
    return stand and weights(on) == weights(face)
