"""The state of a cue list against a stage that keeps nothing but the goal of each part."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from omote.perform.cues import cue_state as cue_states
from omote.perform.cues.cue import Cue, CueList, Move
from omote.perform.cues.cue_action import CueAction
from omote.perform.cues.cue_state import (
    Call,
    CueState,
    advance,
    assert_look,
    begin,
    drop_waiting,
    edited,
    go,
    go_back,
    go_to,
    next_from,
    place_of,
    set_standby,
    without_parts,
)
from omote.perform.cues.tracking import tracked_after, tracked_at
from omote.perform.scene.goals import WITH_FACE, Goal, Part, regions_of, whole_of

PARTS = ("a/face", "a/expression", "a/brows", "b/brows", "*/light")
GOALS: tuple[Goal, ...] = tuple({name: 1.0} for name in ("joy", "fear", "calm"))
TIMES = (0.0, 0.0, 0.5, 0.75, 2.0)
"""Seconds; exact in binary, so that sums of them are."""


class Goals(dict[Part, Goal]):
    """Where the parts of a stage go: an expression of a whole face takes its regions along."""

    def read(self, part: Part) -> Goal:
        return self.get(part, WITH_FACE if whole_of(part) else {"first": 1.0})

    def call(self, calls: tuple[Call, ...]) -> Goals:
        for call in calls:
            for region in regions_of(call.part):
                self.pop(region, None)
            self[call.part] = call.move.goal
        return self

    def shown(self) -> Mapping[Part, Goal]:
        return {part: dict(self.read(part)) for part in PARTS}


class Rehearsal:
    """A list, its state and a stage, through random acts; each act is asked for all that it promises."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.made = 0
        self.goals = Goals()
        self.cues: CueList = tuple(self.new_cue() for _ in range(8))
        self.at = begin(self.cues)

    def new_cue(self) -> Cue:
        self.made += 1
        chosen = self.rng.permutation(PARTS)[: self.rng.integers(1, 4)]
        return Cue(
            f"cue {self.made}",
            str(self.made),
            {str(part): self.new_move() for part in chosen},
            pre_wait=self.time(),
            post_wait=self.time(),
            goes_on=("", "", "continue", "follow")[self.rng.integers(4)],
            skip=bool(self.rng.random() < 0.2),
            actions=tuple(self.new_action(place) for place in range(self.rng.integers(3))),
        )

    def new_action(self, place: int) -> CueAction:
        return CueAction("osc", "desk:9000", f"/{self.made}/{place}", self.time())

    def new_move(self) -> Move:
        return Move(GOALS[self.rng.integers(3)], self.time(), delay=self.time())

    def time(self) -> float:
        return TIMES[self.rng.integers(len(TIMES))]

    def play(self, steps: int) -> None:
        acts = (self.go, self.go, self.go, self.wait, self.wait, self.wait, self.go_to, self.go_back, self.edit)
        for _ in range(steps):
            acts[self.rng.integers(len(acts))]()
            self.check_panic()
            if self.at.standby is None:
                self.end()

    def obey(self, later: CueState) -> None:
        assert all(one.at > later.clock for one in later.planned)
        assert all(one.at <= later.clock for one in later.done)
        assert [one.at for one in later.done] == sorted(one.at for one in later.done)
        self.at = replace(later, done=())
        self.goals.call(later.calls)

    def go(self) -> None:
        """It calls the cue that stands by; what waited for its parts is forgotten, all else waits on."""
        before = self.at
        self.check_back(go(self.asserted(), self.cues, self.goals.read))
        later = go(before, self.cues, self.goals.read)
        place = place_of(self.cues, before.standby)
        assert place is not None
        cue = self.cues[place]
        taken = {one for part in cue.moves for one in (part, *regions_of(part))}
        begun = before.clock + cue.pre_wait
        planned = {part: (move, begun + move.delay) for part, move in cue.moves.items()}
        old = [one for one in before.waiting if one.part not in taken]
        new = later.waiting[len(old) :]
        assert list(later.waiting[: len(old)]) == old
        called: list[Call | cue_states.Waiting] = [*new, *later.calls]
        assert {one.part: (one.move, one.at) for one in called} == planned
        assert all(one.at > before.clock for one in new)
        actions = [(action, begun + action.delay) for action in cue.actions]
        assert later.planned[: len(before.planned)] == before.planned
        ours = [*later.done, *later.planned[len(before.planned) :]]
        assert sorted((one.action.what, one.at) for one in ours) == sorted((each.what, at) for each, at in actions)
        assert dict(later.tracked) == dict(tracked_after(before.tracked, cue))
        assert later.standby == next_from(self.cues, place + 1)
        assert all(not each.skip for each in self.cues if each.identity == later.standby)
        self.obey(later)

    def wait(self) -> None:
        """One long step calls what two short ones call."""
        first = self.time()
        second = self.time()
        short = advance(self.at, self.cues, first, self.goals.read)
        later = advance(short, self.cues, second, self.goals.read)
        calls = (*short.calls, *later.calls)
        long = advance(self.at, self.cues, first + second, self.goals.read)
        assert (long, long.calls, long.done) == (later, calls, later.done)
        assert [call.at for call in calls] == sorted(call.at for call in calls)
        assert all(one.at > long.clock for one in long.waiting)
        follows = self.at.following
        if follows is None or follows.at > long.clock:
            due = sorted((one.at, one.part, one.move.seconds) for one in self.at.waiting if one.at <= long.clock)
            assert sorted((call.at, call.part, call.move.seconds) for call in calls) == due
            assert long.current == self.at.current
            assert len(long.done) + len(long.planned) == len(self.at.planned)
        elif (chosen := next_from(self.cues, place_of(self.cues, follows.cue) or 0)) is not None:
            assert chosen in [step.left for step in long.steps]
            assert long.steps != self.at.steps
        self.obey(long)

    def go_to(self) -> None:
        """Any cue, whatever stands by, alone or with all that those before it leave."""
        place = int(self.rng.integers(len(self.cues)))
        whole = bool(self.rng.integers(2))
        self.check_back(go_to(self.asserted(), self.cues, place, self.goals.read, whole=whole))
        later = go_to(self.at, self.cues, place, self.goals.read, whole=whole)
        assert dict(later.tracked) == dict(tracked_at(self.cues, place))
        begun = {one.cue for one in later.waiting} | {one.cue for one in (*later.planned, *later.done)}
        assert begun <= {self.cues[place].identity}
        called = [call.part for call in later.calls]
        assert len(called) == len(set(called))
        assert not whole or {*called, *(one.part for one in later.waiting)} == set(later.tracked)
        self.obey(later)

    def go_back(self) -> None:
        """What was sent is not sent again."""
        later = go_back(self.at)
        assert (later.planned, later.done) == (() if self.at.steps else self.at.planned, ())
        self.obey(later)

    def asserted(self) -> CueState:
        """Where all that the list has left standing shows, nothing waits, and nobody has moved anything since."""
        later = assert_look(self.at)
        assert (later.planned, later.done) == ((), ())
        self.obey(later)
        return self.at

    def check_back(self, called: CueState) -> None:
        """Back brings back every goal, and the list to where it was."""
        before = self.at
        if called.steps == before.steps:
            return
        goals = Goals(self.goals).call(called.calls)
        back = go_back(called)
        assert goals.call(back.calls).shown() == self.goals.shown()
        assert (back.current, dict(back.tracked)) == (before.current, dict(before.tracked))
        assert len(back.steps) >= len(before.steps) - 1
        assert back.standby == called.current

    def edit(self) -> None:
        """It moves nothing; what waits, and what Back brings back, are copies of what was called."""
        order = [self.cues[place] for place in self.rng.permutation(len(self.cues))]
        kinds = {
            "order": order,
            "another": [*self.cues, self.new_cue()],
            "fewer": [cue for cue in self.cues if self.rng.random() < 0.8] or order,
            "moves": [replace(cue, moves={PARTS[0]: self.new_move()}, actions=()) for cue in self.cues],
        }
        cues = tuple(kinds[str(self.rng.choice(list(kinds)))])
        later = edited(self.at, self.cues, cues)
        assert later.calls == ()
        assert (later.current, later.tracked, later.waiting) == (self.at.current, self.at.tracked, self.at.waiting)
        assert (later.planned, later.done) == (self.at.planned, ())
        assert go_back(later).calls == go_back(self.at).calls
        self.check_left(self.at.standby, later.standby, cues)
        for step, kept in zip(self.at.steps, later.steps, strict=True):
            self.check_left(step.left, kept.left, cues)
        self.at = later
        self.cues = cues

    def check_left(self, before: str | None, after: str | None, cues: CueList) -> None:
        """A cue that is gone leaves its place to the next one behind it."""
        place = place_of(self.cues, before)
        behind = (
            [] if place is None else [each for each in self.cues[place:] if place_of(cues, each.identity) is not None]
        )
        left = [each.identity for each in behind if not each.skip or each.identity == before]
        assert after == next(iter(left), None if place is not None else before)

    def check_panic(self) -> None:
        """It, and another list that moves a part, take what waits and move nothing."""
        after = drop_waiting(self.at, ("a",))
        assert {one.part for one in after.waiting} == {o.part for o in self.at.waiting if not o.part.startswith("a/")}
        assert (after.following, after.calls) == (None, ())
        left = without_parts(self.at, ("a/brows",))
        assert [one for one in self.at.waiting if one.part != "a/brows"] == list(left.waiting)

    def end(self) -> None:
        """Once nothing waits, all that is tracked shows where nobody else has moved it; then from the top."""
        self.obey(assert_look(self.at))
        assert {part: self.goals.read(part) for part in self.at.tracked} == dict(self.at.tracked)
        self.at = replace(begin(self.cues), clock=self.at.clock)
        if self.at.standby is None:
            self.cues = tuple(self.new_cue() for _ in range(8))
            self.at = begin(self.cues)


@pytest.mark.parametrize("seed", range(4))
def test_random_acts_keep_what_each_promises(seed: int) -> None:
    Rehearsal(seed).play(300)


KEPT_STEP = cue_states._step
KEPT_DONE = cue_states._done_until


def done_twice(before: CueState, after: CueState) -> CueState:
    return replace(after, done=(*after.done, *after.done[len(before.done) :]))


FAULTS: dict[str, tuple[str, object]] = {
    "regions stay where their whole expression is called": ("regions_of", lambda part: ()),
    "a region may be called before its face": ("rank_of", lambda part: (False, part)),
    "what no cue had moved is not kept": (
        "_step",
        lambda *asked: replace(KEPT_STEP(*asked), before={}),
    ),
    "what was tracked is not kept": (
        "_step",
        lambda *asked: replace(KEPT_STEP(*asked), stood={}),
    ),
    "a cue forgets what those before it have left": (
        "tracked_after",
        lambda tracked, cue: {part: move.goal for part, move in cue.moves.items()},
    ),
    "what waited for a part goes on": ("_without", lambda waiting, parts: iter(waiting)),
    "a skipped cue stands by": ("next_from", lambda cues, at: cues[at].identity if at < len(cues) else None),
    "what waits is called at the end of a step": (
        "_called_waiting",
        lambda at, due: replace(
            KEPT_DONE(at, due), waiting=(), calls=tuple(Call(one.part, one.move, due) for one in at.waiting)
        ),
    ),
    "nothing follows by itself": ("_next_due", lambda at: min([one.at for one in at.waiting], default=np.inf)),
    "what is done is done twice": ("_done_until", lambda at, due: done_twice(at, KEPT_DONE(at, due))),
    "what waits to be done is done at once": ("_done_until", lambda at, due: KEPT_DONE(at, np.inf)),
    "what was sent is sent again by Back": (
        "_waiting_for_nothing",
        lambda at: replace(at, waiting=(), following=None, done=at.planned, planned=()),
    ),
    "what waits to be done survives Back": (
        "_waiting_for_nothing",
        lambda at: replace(at, waiting=(), following=None),
    ),
    "panic is deaf": ("is_of", lambda part, characters: False),
}


def rehearse_all() -> None:
    for seed in range(4):
        Rehearsal(seed).play(300)


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_caught(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The rehearsals are there to catch each of these."""
    monkeypatch.setattr(cue_states, *FAULTS[fault])
    with pytest.raises(AssertionError):
        rehearse_all()


def cue(number: str, part: Part = "a/face", **options: object) -> Cue:
    return Cue(f"cue {number}", number, {part: Move(GOALS[0], 1.0)}, **options)  # type: ignore[arg-type]


def test_what_follows_by_itself_begins_at_its_time_and_no_later() -> None:
    """One is followed after its end and a pause; one goes on with the next at once, however long the tick."""
    cues = (cue("1", goes_on="follow", post_wait=0.5), cue("2", "b/face", goes_on="continue"), cue("3", "*/light"))
    goals = Goals()
    at = advance(go(begin(cues), cues, goals.read), cues, 10.0, goals.read)
    assert [(call.part, call.at) for call in at.calls] == [("b/face", 1.5), ("*/light", 1.5)]
    assert (at.current, at.standby) == ("cue 3", None)
    assert [step.left for step in at.steps] == ["cue 1", "cue 2", "cue 3"]


def test_a_go_takes_the_place_of_what_would_have_followed() -> None:
    cues = (cue("1", goes_on="follow"), cue("2"), cue("3"))
    goals = Goals()
    at = go(go(begin(cues), cues, goals.read), cues, goals.read)
    assert (at.following, at.current, at.standby) == (None, "cue 2", "cue 3")


def test_a_cue_that_is_called_out_of_order_brings_what_all_before_it_have_left() -> None:
    cues = (cue("1", "a/expression"), cue("2", "a/brows"), replace(cue("3", "b/face"), skip=True), cue("4"))
    at = go_to(begin(cues), cues, 3, Goals().read, whole=True)
    assert [call.part for call in at.calls] == ["a/expression", "a/brows", "a/face"]
    assert set(at.tracked) == {"a/expression", "a/brows", "a/face"}


def test_a_cue_that_stands_by_is_chosen_and_nothing_moves() -> None:
    cues = (cue("1"), cue("2"))
    assert set_standby(begin(cues), "cue 2") == replace(begin(cues), standby="cue 2")


def sends(number: str, *delays: float, **options: Any) -> Cue:
    actions = tuple(CueAction("osc", "desk:9000", f"/{number}/{place}", delay) for place, delay in enumerate(delays))
    return cue(number, actions=actions, **options)


def done(at: CueState) -> list[tuple[str, float]]:
    return [(one.action.what, one.at) for one in at.done]


def test_what_a_cue_does_is_done_once_at_its_time_however_long_the_tick() -> None:
    cues = (sends("1", 0.5, 0.0, pre_wait=1.0, goes_on="follow", post_wait=2.0), sends("2", 0.25))
    goals = Goals()
    long = advance(go(begin(cues), cues, goals.read), cues, 10.0, goals.read)
    assert done(long) == [("/1/1", 1.0), ("/1/0", 1.5), ("/2/0", 4.25)]
    at = go(begin(cues), cues, goals.read)
    short: list[tuple[str, float]] = []
    for _ in range(40):
        at = advance(replace(at, done=()), cues, 0.25, goals.read)
        short += done(at)
    assert short == done(long)
    assert at == long


def test_go_lets_what_is_planned_happen_and_all_that_goes_elsewhere_drops_it() -> None:
    cues = (sends("1", 0.0, 5.0), sends("2", 1.0))
    goals = Goals()
    first = go(begin(cues), cues, goals.read)
    assert done(first) == [("/1/0", 0.0)]
    second = go(first, cues, goals.read)
    assert [one.action.what for one in second.planned] == ["/1/1", "/2/0"]
    for elsewhere in (go_back(second), assert_look(second), go_to(second, cues, 1, goals.read, whole=True)):
        assert "/1/1" not in [one.action.what for one in elsewhere.planned]
    assert go_back(second).planned == ()
    assert go_back(second).done == second.done  # nothing is sent again
    assert edited(second, cues, ()).planned == second.planned


def test_a_panic_takes_the_lines_of_its_characters_and_lets_others_be_told() -> None:
    lines = tuple(CueAction("say", who, "Ho", 1.0) for who in ("a", "b", "*"))
    cues = (cue("1", actions=(*lines, CueAction("osc", "desk:9000", "/go", 1.0))),)
    at = drop_waiting(go(begin(cues), cues, Goals().read), ["a"])
    assert [one.action.to for one in at.planned] == ["b", "desk:9000"]
