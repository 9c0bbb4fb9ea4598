"""The state of a cue list: GO, Back, waits and what follows by itself. It owns no clock and touches no scene.

Every act takes a state and returns a changed copy with the calls that it makes, in their order. What has been called
is a copy: editing a cue moves nothing that is on its way, waits, or is undone later.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from omote.perform.cues.cue import CueList, Move, is_of
from omote.perform.cues.cue_action import CueAction, SpokenLine
from omote.perform.cues.tracking import NOTHING_TRACKED, Tracked, tracked_after, tracked_at
from omote.perform.scene.character_names import ALL
from omote.perform.scene.goals import Goal, Part, rank_of, regions_of

GAP_SECONDS = 0.25
"""A GO that comes sooner after another is a key that bounces, or a finger that slips."""
RETURN_SECONDS = 1.0
"""In which Back and an assertion bring what they bring."""
BACK = "Back"
ASSERT = "Assert"
MOST_STEPS = 100
"""That Back undoes."""
ReadGoal = Callable[[Part], Goal]
"""Where a part goes now, on air."""


@dataclass(frozen=True)
class Call:
    """A part that is called: its move, when, seconds of the state's clock, and by which cue, by identity; None where it
    is called by an act of the whole list, "Back" or "Assert"."""

    part: Part
    move: Move
    at: float
    cue: str | None = None
    act: str = ""


@dataclass(frozen=True)
class Waiting:
    """A move that waits. cue: the identity of its cue; at: when it is called, seconds of the state's clock."""

    cue: str
    part: Part
    move: Move
    at: float


@dataclass(frozen=True)
class Planned:
    """An action that waits. cue: the identity of its cue; at: when it is done, seconds of the state's clock."""

    cue: str
    action: CueAction
    at: float


@dataclass(frozen=True)
class Following:
    """The cue that follows by itself, and when: seconds of the state's clock."""

    cue: str
    at: float


@dataclass(frozen=True)
class Step:
    """What Back goes back to.

    left: the cue that was called, by identity, None where it and all behind it are gone; current: as it was before;
    stood: what was tracked where that has changed, None for nothing; moved: the parts that it moved; before: the goals
    of those of them that no cue had moved.
    """

    left: str | None
    current: str | None
    stood: Mapping[Part, Goal | None]
    moved: tuple[Part, ...]
    before: Tracked


@dataclass(frozen=True)
class Moving:
    """A part that has been called, and when it arrives, seconds of the state's clock. cue, act: as of `Call`."""

    part: Part
    cue: str | None
    until: float
    act: str = ""


@dataclass(frozen=True)
class CueState:
    """How far a list is. current, standby: cues by identity; clock: seconds; steps: the oldest first."""

    current: str | None = None
    standby: str | None = None
    tracked: Tracked = field(default_factory=lambda: NOTHING_TRACKED)
    waiting: tuple[Waiting, ...] = ()
    following: Following | None = None
    steps: tuple[Step, ...] = ()
    clock: float = 0.0
    moving: tuple[Moving, ...] = ()
    planned: tuple[Planned, ...] = ()
    calls: tuple[Call, ...] = field(default=(), compare=False)
    """What the last act called, in order."""
    done: tuple[Planned, ...] = field(default=(), compare=False)
    """What it did beside, in order."""


def place_of(cues: CueList, identity: str | None) -> int | None:
    """The place of a cue in its list, from 0; None where it is not there. cues: the list; identity: of the cue."""
    return next((place for place, cue in enumerate(cues) if cue.identity == identity), None)


def next_from(cues: CueList, place: int) -> str | None:
    """The first cue from a place on that GO does not pass by, by identity; None at the end. cues: the list."""
    return next((cue.identity for cue in cues[place:] if not cue.skip), None)


def begin(cues: CueList) -> CueState:
    """The state of a list of which nothing has been called: its first cue stands by."""
    return CueState(standby=next_from(cues, 0))


def go(state: CueState, cues: CueList, read: ReadGoal) -> CueState:
    """Calls the cue that stands by; nothing where none does.

    state: as it is; cues: of the list; read: where parts go on air.
    """
    place = place_of(cues, state.standby)
    return replace(state, calls=()) if place is None else _called(state, cues, place, state.clock, read)


def go_to(state: CueState, cues: CueList, place: int, read: ReadGoal, *, whole: bool = False) -> CueState:
    """Calls a cue out of its order; nothing waits any more.

    state: as it is; cues: of the list; place: of the cue, from 0; read: where parts go on air; whole: whether all
    that the cues before it leave standing is called too.
    """
    tracked = tracked_at(cues, place)
    cue = cues[place]
    stands = {part: goal for part, goal in tracked.items() if whole and part not in cue.moves}
    later = _called(_waiting_for_nothing(state), cues, place, state.clock, read)
    moved = _taken((*stands, *cue.moves))
    steps = (*state.steps, _step(state, tracked, moved, read, cue.identity))[-MOST_STEPS:]
    standing = (replace(call, cue=cue.identity) for call in _returning(stands, state.clock, ""))
    calls = _face_first((*standing, *later.calls))
    return replace(later, tracked=tracked, steps=steps, calls=calls)


def go_back(state: CueState) -> CueState:
    """Brings back what stood before the last cue was called; nothing where none was."""
    if not state.steps:
        return replace(state, calls=())
    step = state.steps[-1]
    stood = {**state.tracked, **step.stood}
    tracked = {part: goal for part, goal in stood.items() if goal is not None}
    goals = {part: tracked.get(part, step.before.get(part)) for part in step.moved}
    calls = _returning({part: goal for part, goal in goals.items() if goal is not None}, state.clock, BACK)
    back = replace(_waiting_for_nothing(state), current=step.current, standby=step.left, tracked=tracked)
    return replace(back, steps=state.steps[:-1], calls=calls)


def with_moving(state: CueState) -> CueState:
    """The state after an act or a step, with what its calls have set on its way and without what has arrived."""
    called = {part for call in state.calls for part in (call.part, *regions_of(call.part))}
    begun = (Moving(call.part, call.cue, call.at + call.move.seconds, call.act) for call in state.calls)
    under_way = (*(one for one in state.moving if one.part not in called), *begun)
    moving = tuple(one for one in under_way if one.until > state.clock)
    return state if moving == state.moving else replace(state, moving=moving)


def assert_look(state: CueState) -> CueState:
    """Calls all that the cues have left standing again, whoever has moved it since; nothing waits any more."""
    calls = _returning(state.tracked, state.clock, ASSERT)
    return replace(_waiting_for_nothing(state), calls=calls)


def set_standby(state: CueState, identity: str) -> CueState:
    """Has another cue stand by; nothing moves. state: as it is; identity: of the cue."""
    return replace(state, standby=identity, calls=())


def drop_waiting(state: CueState, characters: Sequence[str]) -> CueState:
    """Forgets what waits for some characters, and what follows: somebody has pressed panic.

    state: as it is; characters: their names.
    """
    waiting = tuple(one for one in state.waiting if not is_of(one.part, characters))
    planned = tuple(one for one in state.planned if not _says(one.action, characters))
    return replace(state, waiting=waiting, planned=planned, following=None, calls=())


def _says(action: CueAction, characters: Sequence[str]) -> bool:
    meant = action.meant
    return isinstance(meant, SpokenLine) and meant.character in (ALL, *characters)


def _waiting_for_nothing(state: CueState) -> CueState:
    return replace(state, waiting=(), planned=(), following=None)


def without_parts(state: CueState, parts: Collection[Part]) -> CueState:
    """Forgets what waits for parts that another list has moved. state: as it is."""
    return replace(state, waiting=tuple(_without(state.waiting, parts)), calls=())


def edited(state: CueState, before: CueList, after: CueList) -> CueState:
    """The state of a list that has been edited: nothing moves.

    A cue that stood by, or would again after Back, and is gone leaves its place to the next one behind it; nothing
    follows in the place of one that is gone. Where the list was at its end, what has come behind it stands by.

    state: as it is; before, after: the list.
    """
    there = {cue.identity for cue in after}

    def kept(identity: str | None) -> str | None:
        if identity is None or identity in there:
            return identity
        behind = before[place_of(before, identity) or 0 :]
        return next((cue.identity for cue in behind if cue.identity in there and not cue.skip), None)

    steps = tuple(replace(step, left=kept(step.left)) for step in state.steps)
    following = state.following
    gone = following is None or following.cue not in there
    return replace(
        state,
        standby=kept(state.standby) if state.standby is not None else next_from(after, _behind(after, state.current)),
        following=None if gone else following,
        steps=steps,
        calls=(),
    )


def _behind(cues: CueList, identity: str | None) -> int:
    """The place behind a cue; the first one where no cue has been called, the end where that one is gone."""
    if identity is None:
        return 0
    place = place_of(cues, identity)
    return len(cues) if place is None else place + 1


def advance(state: CueState, cues: CueList, dt: float, read: ReadGoal) -> CueState:
    """The state some time later: what was due has been called, as at the time at which it was due.

    Parameters
    ----------
    state : CueState
        As it is.
    cues : tuple of Cue
        The list.
    dt : float
        Seconds, 0 or more.
    read : callable
        Where a part goes on air.

    Returns
    -------
    CueState
        With its calls and what it has done, the earliest first.
    """
    end = state.clock + dt
    calls: list[Call] = []
    while (due := _next_due(state)) <= end:
        if state.following is not None and state.following.at <= due:
            state = _followed(state, cues, state.following, read)
        else:
            state = _called_waiting(state, due)
        calls += state.calls
    return replace(state, clock=end, calls=tuple(calls))


def _next_due(state: CueState) -> float:
    """When something is due next, infinite where nothing is: of what is due at once a cue comes before what waits."""
    following = math.inf if state.following is None else state.following.at
    return min([following, *(one.at for one in state.waiting), *(one.at for one in state.planned)])


def _followed(state: CueState, cues: CueList, following: Following, read: ReadGoal) -> CueState:
    """The cue that follows by itself is called; nothing where it, and all behind it, is gone or skipped by now."""
    place = place_of(cues, following.cue)
    alone = replace(state, following=None, calls=())
    chosen = None if place is None else place_of(cues, next_from(cues, place))
    return alone if chosen is None else _called(alone, cues, chosen, following.at, read)


def _called_waiting(state: CueState, due: float) -> CueState:
    """What waits until then is called, and done."""
    ready = tuple(Call(one.part, one.move, one.at, one.cue) for one in state.waiting if one.at <= due)
    left = tuple(one for one in state.waiting if one.at > due)
    return _done_until(replace(state, waiting=left, calls=_face_first(ready)), due)


def _done_until(state: CueState, due: float) -> CueState:
    """The actions that wait until then are done, the earliest first."""
    if not state.planned:
        return state
    ready = sorted((one for one in state.planned if one.at <= due), key=lambda one: one.at)
    left = tuple(one for one in state.planned if one.at > due)
    return replace(state, planned=left, done=(*state.done, *ready))


def _called(state: CueState, cues: CueList, place: int, at: float, read: ReadGoal) -> CueState:
    """The cue at a place of its list is called at a time of the clock: what waits for its parts, and what followed the
    cue before it, is forgotten."""
    cue = cues[place]
    moved = _taken(cue.moves)
    begun = at + cue.pre_wait
    planned = [Waiting(cue.identity, part, move, begun + move.delay) for part, move in cue.moves.items()]
    ready = tuple(Call(one.part, one.move, one.at, one.cue) for one in planned if one.at <= at)
    waiting = (*_without(state.waiting, moved), *(one for one in planned if one.at > at))
    after = next_from(cues, place + 1)
    follows = None if after is None or cue.next_after is None else Following(after, at + cue.next_after)
    tracked = tracked_after(state.tracked, cue)
    steps = (*state.steps, _step(state, tracked, moved, read, cue.identity))[-MOST_STEPS:]
    later = replace(state, current=cue.identity, standby=after, tracked=tracked, waiting=waiting, following=follows)
    actions = tuple(Planned(cue.identity, action, begun + action.delay) for action in cue.actions)
    later = replace(later, steps=steps, calls=ready, planned=(*state.planned, *actions))
    return _done_until(later, at)


def _taken(parts: Iterable[Part]) -> tuple[Part, ...]:
    """Some parts and the regions that go with a whole expression among them; a face before its regions."""
    taken = {one for part in parts for one in (part, *regions_of(part))}
    return tuple(sorted(taken, key=rank_of))


def _step(state: CueState, tracked: Tracked, moved: tuple[Part, ...], read: ReadGoal, left: str) -> Step:
    before = {part: read(part) for part in moved if part not in state.tracked}
    changed = [part for part in {**state.tracked, **tracked} if state.tracked.get(part) != tracked.get(part)]
    return Step(left, state.current, {part: state.tracked.get(part) for part in changed}, moved, before)


def _without(waiting: Iterable[Waiting], parts: Collection[Part]) -> Iterator[Waiting]:
    return (one for one in waiting if one.part not in parts)


def _returning(goals: Tracked, at: float, act: str) -> tuple[Call, ...]:
    """Calls of goals that stood before, by an act."""
    return _face_first(Call(part, Move(goal, RETURN_SECONDS), at, act=act) for part, goal in goals.items())


def _face_first(calls: Iterable[Call]) -> tuple[Call, ...]:
    """Calls at their times; of those at one time a whole expression before its regions, which it would take along."""
    return tuple(sorted(calls, key=lambda call: (call.at, rank_of(call.part))))
