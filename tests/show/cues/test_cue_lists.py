"""Nights of four consoles and two senders of OSC at random: a number executes once, and nothing moves by an edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import msgspec
import numpy as np
import pytest

from omote.perform.cues import cue_state
from omote.perform.cues.cue_state import GAP_SECONDS
from omote.perform.cues.tracking import tracked_after, tracked_at
from omote.perform.scene.goals import Goal, Part, regions_of
from omote.show.cues import cue_book, cue_edits, cue_lists
from omote.show.cues.cue_book import CueBook, read_book
from omote.show.cues.cue_edits import shown_goals
from omote.show.declaration import ClientMessage
from omote.show.executed_calls import ExecutedCalls
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import cues as wire
from omote.show.objects.calls import CallExpression, CallFace, Panic
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.showfile.changes import DocumentRemoval, StoredDocument
from tests import synthetic

CAST = synthetic.cast()
FACES = tuple(CAST.faces)[:3]
EXPRESSIONS = tuple(CAST.expressions)[:3]
CONSOLES = ("ana", "bo", "cy", "di")
SENDERS = ("osc one", "osc two")
KINDS = (wire.StoredCue.kind, wire.StoredCueList.kind, wire.CueEdit.kind)


class Night:
    """A session through random acts; each is asked for all that it promises."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.session = ShowSession(CAST)
        self.now = 10.0
        self.sent = 0
        self.executed: list[tuple[str, ClientMessage]] = []
        self.identities: set[str] = set()
        self.stored: dict[str, dict[str, bytes]] = {kind: {} for kind in KINDS}
        self.meet()
        for number in range(5):
            self.obeyed("ana", wire.PutCue(self.id("ana"), number=str(number + 1), goes_on="follow", post_wait=1.0))
            self.put_move()
        self.identities |= self.book.cues.keys()

    def meet(self) -> None:
        for who in CONSOLES:
            self.session.receive(who, Hello(role="console", version=PROTOCOL_VERSION, name=who), self.now)
        for who in SENDERS:
            self.session.join(who, who)

    # --- what there is ---

    @property
    def lists(self) -> cue_lists.CueLists:
        return self.session.cues

    @property
    def book(self) -> CueBook:
        return self.lists.book

    @property
    def player(self) -> Any:
        return self.lists._players[self.lists.chosen]

    def goals(self) -> dict[Part, Goal]:
        return {part: self.session.scene.goal_of(part) for part in shown_goals(self.session.scene)}

    def id(self, who: str) -> str:
        self.sent += 1
        return f"{who}-{self.sent}"

    def pick(self, things: Any) -> Any:
        listed = list(things)
        return listed[self.rng.integers(len(listed))]

    def anybody(self) -> str:
        return str(self.pick((*CONSOLES, *SENDERS)))

    # --- what happens ---

    def send(self, who: str, message: ClientMessage) -> list[Any]:
        """Sends a message, which from now on may come again."""
        answers = self.session.receive(who, message, self.now)
        if not any(isinstance(one.message, Refused) for one in answers) or (
            isinstance(message, wire.Go) and not message.cue
        ):
            self.executed = [*self.executed[-40:], (who, message)]
        return answers

    def obeyed(self, who: str, message: ClientMessage) -> None:
        assert self.send(who, message) == []

    def go(self) -> None:
        """GO by one, and often by another who pressed at once, both for what stands by."""
        who = self.anybody()
        standby, tracked, steps = self.player.standby, self.player.state.tracked, len(self.player.state.steps)
        paused = self.lists._paused
        soon = self.now - self.lists._last_go < GAP_SECONDS
        answers = self.send(who, wire.Go(self.id(who), seen=standby.identity if standby else "none"))
        if standby is None or soon:
            assert isinstance(answers[0].message, Refused)
            assert len(self.player.state.steps) == steps
            return
        assert answers == []
        if paused:
            assert not self.lists._paused
            assert self.player.standby == standby
            return
        assert self.player.current == standby
        assert self.player.state.tracked == tracked_after(tracked, standby)
        if self.rng.random() < 0.5:
            other = self.pick(one for one in CONSOLES if one != who)
            self.now += float(self.rng.choice([0.0, 0.1, 0.3]))
            counted = self.lists._ignored_count
            before = self.goals()
            said = self.send(other, wire.Go(self.id(other), seen=standby.identity))
            assert isinstance(said[0].message, Refused)
            assert self.lists._ignored_count == counted + 1
            assert (self.goals(), self.player.current) == (before, standby)

    def go_and_back(self) -> None:
        """Back brings the goals back: of what cues track the tracked ones, of all else those that stood."""
        self.now += 1.0
        self.tick()
        state, before = self.player.state, self.goals()
        cue = self.pick(self.player.cues) if self.player.cues else None
        if cue is None or self.lists._paused:
            return
        whole = bool(self.rng.random() < 0.5)
        self.obeyed("bo", wire.GoToCue(self.id("bo"), cue.number, whole=whole))
        assert self.player.state.tracked == tracked_at(self.player.cues, self.player.cues.index(cue))
        moved = self.player.state.steps[-1].moved
        self.now += 0.3
        self.obeyed("bo", wire.GoBack(self.id("bo")))
        after = self.goals()
        for part, goal in after.items():
            wanted = state.tracked.get(part, before[part]) if part in moved else before[part]
            assert goal == wanted or (
                part in self.regions_taken(moved) and goal in (wanted, {}, after_face(after, part))
            )
        assert (self.player.state.current, self.player.state.tracked) == (state.current, state.tracked)
        assert self.player.state.standby == cue.identity
        assert (self.player.state.waiting, self.player.state.following) == ((), None)

    def regions_taken(self, moved: tuple[Part, ...]) -> set[Part]:
        return {region for part in moved for region in (part, *regions_of(part))}

    def act(self) -> None:
        who = self.anybody()
        number = self.pick(self.player.cues).number if self.player.cues else "1"
        name = self.pick(self.book.orders)
        messages: list[ClientMessage] = [
            wire.Go(self.id(who)),
            wire.Go(self.id(who), cue=number),
            wire.GoBack(self.id(who)),
            wire.AssertLook(self.id(who)),
            wire.SetStandby(self.id(who), number),
            wire.PauseCues(self.id(who), on=bool(self.rng.random() < 0.5)),
            wire.ChooseCueList(self.id(who), name),
            CallFace(character="one", id=self.id(who), name=self.pick(FACES), seconds=1.0),
            CallExpression(character="one", id=self.id(who), name=self.pick(EXPRESSIONS), seconds=0.5),
            Panic(character="one", id=self.id(who)),
        ]
        self.send(who, self.pick(messages))

    def edit(self) -> None:
        """An edit moves nothing on air, waits for nothing more, and is taken back to what was there."""
        who = self.pick(CONSOLES)
        self.session.tick(self.now)  # what a panic has dropped is gone
        scene, waiting, book = self.session.scene.snapshot(), self.player.state.waiting, self.book
        chosen = self.lists.chosen
        cue = self.pick(book.cues) if book.cues else "none"
        other = self.pick(book.cues) if book.cues else "none"
        messages: list[ClientMessage] = [
            wire.PutCue(
                self.id(who), goes_on=self.pick(("", "continue", "follow")), pre_wait=float(self.pick((0, 0.4)))
            ),
            wire.PutCue(self.id(who), cue=cue, label=f"scene {self.sent}", skip=bool(self.rng.random() < 0.2)),
            wire.RecordCue(self.id(who)),
            wire.UpdateCue(self.id(who), cue=cue),
            wire.CopyCue(self.id(who), cue),
            wire.MoveCue(self.id(who), cue, after=other),
            wire.DropCue(self.id(who), cue),
            wire.RenumberCues(self.id(who), first="1", step=self.pick(("1", "0.5"))),
            wire.AddCueList(self.id(who), f"list {self.sent}"),
            wire.RenameCueList(self.id(who), self.pick(book.orders), f"list {self.sent}"),
            wire.DropCueList(self.id(who), self.pick(book.orders)),
        ]
        message = self.pick(messages)
        answers = self.send(who, message)
        new = self.book.cues.keys() - book.cues.keys()
        made = isinstance(message, wire.RecordCue | wire.CopyCue) or (
            isinstance(message, wire.PutCue) and not message.cue
        )
        assert len(new) == (made and answers == [])
        assert not new & self.identities
        self.identities |= new
        assert self.session.scene.snapshot() == scene
        if self.lists.chosen == chosen:
            assert self.player.state.waiting == waiting
        if self.book is not book:
            if self.rng.random() < 0.3:
                after = self.book
                self.obeyed(who, wire.UndoCues(self.id(who), seen=len(after.edits)))
                assert (self.book.cues, self.book.orders) == (book.cues, book.orders)
                self.obeyed(who, wire.RedoCues(self.id(who)))
                assert (self.book.cues, self.book.orders) == (after.cues, after.orders)
            assert isinstance(self.send("cy", wire.UndoCues(self.id("cy"), seen=len(book.edits)))[0].message, Refused)

    def put_move(self) -> None:
        if not self.book.cues:
            return
        part = str(self.pick(("one/face", "one/expression", "one/brows", "*/light", "*/black", "one/head")))
        goal: Goal = {
            "face": {self.pick(FACES): 1.0},
            "light": {"flat": 1.0},
            "black": {"black": float(self.pick((0.0, 0.5)))},
            "head": {"yaw": 0.2, "pitch": 0.0, "roll": 0.0},
        }.get(part.rpartition("/")[2], {self.pick(EXPRESSIONS): 1.0})
        delay, seconds = float(self.pick((0, 0, 0.3))), float(self.pick((0, 1)))
        self.obeyed(
            "di", wire.PutMove(self.id("di"), self.pick(self.book.cues), part, dict(goal), seconds, delay=delay)
        )

    def repeat(self) -> None:
        """What was executed once comes again, by a retry: nothing changes."""
        if not self.executed:
            return
        who, message = self.pick(self.executed)
        before, book = self.session.snapshot(), self.book
        assert self.session.receive(who, message, self.now) == []
        assert self.session.snapshot() == before
        assert self.book is book

    def tick(self) -> None:
        self.now += float(self.pick((1 / 60, 1 / 60, 0.2, 1.0)))
        state = self.session.tick(self.now)
        if state.cues is None:
            assert not self.book.cues
            return
        told = state.cues.lists[self.lists.chosen]
        assert (told.standby and told.standby.identity) == self.player.state.standby
        assert all(wait.seconds >= 0.0 for wait in told.waits)
        assert all(one.seconds > 0.0 for one in told.moving)

    def store(self) -> None:
        """The show file has the book, however it came about."""
        for change in self.lists.take_changes():
            self.keep(change)
        book, lost = read_book(self.stored.__getitem__)
        assert (book, lost) == (self.book, [])

    def keep(self, change: StoredDocument | DocumentRemoval) -> None:
        if isinstance(change, DocumentRemoval):
            self.stored[change.kind].pop(change.name, None)
        else:
            self.stored[change.kind][change.name] = change.body

    def kill(self) -> None:
        """Another process goes on from the journal and the show file, with what waits and follows."""
        if self.player.cues:
            self.now += 1.0
            self.obeyed("ana", wire.GoToCue(self.id("ana"), self.player.cues[0].number))
        self.store()
        saved = msgspec.msgpack.decode(msgspec.msgpack.encode(self.session.snapshot()))
        snapshot, _ = read_session_snapshot(saved)
        book, _ = read_book(self.stored.__getitem__)
        told = self.lists.status(self.now)
        states = self.lists.snapshot()
        self.session = ShowSession.restored(CAST, snapshot, epoch=2)
        self.lists.load(book)
        self.meet()
        again = self.lists.status(self.now)
        assert self.lists.snapshot() == states
        if told is not None and again is not None:
            for name, each in told.lists.items():
                assert msgspec.structs.replace(each, since=None, by="", pressed="") == again.lists[name]
        self.session.tick(self.now)

    def play(self, steps: int) -> None:
        acts: list[Callable[[], None]] = [
            self.go, self.go_and_back, self.act, self.act, self.edit, self.put_move, self.repeat,
            self.tick, self.tick, self.tick, self.tick,
        ]  # fmt: skip
        for step in range(steps):
            self.pick(acts)()
            if step % 50 == 49:
                self.pick((self.store, self.kill))()


def after_face(goals: dict[Part, Goal], part: Part) -> Goal:
    """Where a region goes that goes with its face."""
    character, _, _ = part.rpartition("/")
    return goals[f"{character}/expression"]


@pytest.mark.parametrize("seed", range(4))
def test_a_night_of_random_acts_keeps_what_each_promises(seed: int) -> None:
    Night(seed).play(250)


STEP = cue_state._step
GO_BACK = cue_state.go_back
EDITED = cue_state.edited
SNAPSHOT = cue_lists.CueLists.snapshot
BETWEEN = cue_book.changes_between
FAULTS: dict[str, tuple[object, str, object]] = {
    "a retry executes again": (ExecutedCalls, "has", lambda self, seat, call: False),
    "a key that bounces calls twice": (cue_lists, "GAP_SECONDS", 0.0),
    "a GO that was ignored may come again": (cue_lists.CueLists, "_ignore", lambda *_: raise_ignored()),
    "what was tracked is not kept": (cue_state, "_step", lambda *asked: replace(STEP(*asked), stood={})),
    "what no cue had moved is not kept": (cue_state, "_step", lambda *asked: replace(STEP(*asked), before={})),
    "a cue forgets what those before it left": (
        cue_state,
        "tracked_after",
        lambda tracked, cue: {part: move.goal for part, move in cue.moves.items()},
    ),
    "Back leaves what waits": (cue_state, "go_back", lambda state: replace(GO_BACK(state), waiting=state.waiting)),
    "an edit forgets what waits": (
        cue_state,
        "edited",
        lambda state, before, after: replace(EDITED(state, before, after), waiting=()),
    ),
    "identities are used again": (cue_edits, "new_identities", lambda book, count: [str(len(book.cues))] * count),
    "the file misses what goes": (
        cue_lists,
        "changes_between",
        lambda before, after: [kept for kept in BETWEEN(before, after) if isinstance(kept, StoredDocument)],
    ),
    "the file misses who moved": (
        cue_lists,
        "changes_between",
        lambda before, after: [kept for kept in BETWEEN(before, after) if kept.kind != "cue_list"],
    ),
    "undo does it again": (
        cue_lists,
        "undo",
        lambda book, by: replace(book, edits=(*book.edits, wire.CueEdit("nothing", by, does="undo"))),
    ),
    "a restart forgets what follows": (
        cue_lists.CueLists,
        "snapshot",
        lambda self: replace(
            SNAPSHOT(self),
            states={name: replace(each, following=None) for name, each in SNAPSHOT(self).states.items()},
        ),
    ),
    "recording calls what it records": (
        cue_edits,
        "shown_goals",
        lambda scene: scene.call_black(0.3, seconds=0) or shown_goals(scene),
    ),
}


def play_nights() -> None:
    for seed in range(6):
        Night(seed).play(250)


def raise_ignored() -> None:
    raise ValueError("ignored")


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_caught(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The nights are there to catch each of these."""
    owner, name, value = FAULTS[fault]
    monkeypatch.setattr(owner, name, value)
    with pytest.raises((AssertionError, ValueError, LookupError)):
        play_nights()


def test_a_pause_holds_waits_and_what_cues_have_called_and_nothing_else() -> None:
    night = Night(0)
    night.session = ShowSession(CAST)
    night.meet()
    session = night.session
    session.receive("ana", wire.PutCue("a1", number="1", goes_on="follow"), 0.0)
    session.receive("ana", wire.PutMove("a2", "0-0", "*/black", {"black": 1.0}, 4.0), 0.0)
    session.receive(
        "ana", wire.PutMove("a3", "0-0", "one/head", {"yaw": 0.2, "pitch": 0.0, "roll": 0.0}, 1.0, delay=3.0), 0.0
    )
    session.receive("ana", wire.PutCue("a4", number="2"), 0.0)
    session.tick(0.0)
    session.receive("ana", wire.Go("a5"), 0.0)
    assert session.tick(2.0).black == 0.5
    session.receive("ana", wire.PauseCues("a6"), 2.0)
    session.tick(2.2)
    held = session.tick(9.0)
    assert held.cues is not None
    assert (held.cues.rate, 0.5 <= held.black < 0.6) == (0.0, True)
    session.receive("ana", CallFace(character="one", id="a7", name=FACES[1], seconds=1.0), 9.0)
    later = session.tick(10.0)
    assert (later.black, later.characters["one"].faces) == (held.black, {FACES[1]: 1.0})
    assert later.cues is not None
    waits = later.cues.lists["main"].waits
    assert [wait.part for wait in waits] == ["one/head"]
    assert waits[0].seconds <= 1.0
    session.receive("ana", wire.Go("a8"), 11.0)  # lets it go on, and calls nothing
    again = session.tick(11.2).cues
    assert again is not None
    assert (again.rate, again.lists["main"].current.number) == (1.0, "1")  # type: ignore[union-attr]
    end = session.tick(16.0)
    assert (end.black, end.characters["one"].head[0]) == (1.0, 0.2)
    assert end.cues is not None
    assert end.cues.lists["main"].current.number == "2"  # type: ignore[union-attr]


def test_what_moves_and_since_when_is_named_by_what_was_pressed() -> None:
    session = ShowSession(CAST)
    session.receive("ana", Hello(role="console", version=PROTOCOL_VERSION, name="ana"), 0.0)
    for number, part, goal in (("1", "*/light", {"flat": 1.0}), ("2", "*/black", {"black": 1.0})):
        session.receive("ana", wire.PutCue(f"put-{number}", number=number), 0.0)
        session.receive("ana", wire.PutMove(f"move-{number}", session.cues.book.orders["main"][-1], part, goal), 0.0)
    for at, act, pressed, moving in (
        (10.0, wire.Go("1"), "GO 1", {("*/light", "1", "")}),
        (20.0, wire.Go("2"), "GO 2", {("*/black", "2", "")}),
        (30.0, wire.AssertLook("3"), "Assert", {("*/light", "", "Assert"), ("*/black", "", "Assert")}),
        (40.0, wire.GoBack("4"), "Back", {("*/black", "", "Back")}),
        (50.0, wire.GoToCue("5", "2", whole=True), "Go to 2", {("*/light", "2", ""), ("*/black", "2", "")}),
    ):
        session.tick(at)
        session.receive("ana", act, at)
        told = session.tick(at + 0.5).cues
        assert told is not None
        main = told.lists["main"]
        assert (main.pressed, main.by, main.since) == (pressed, "ana", 0.5)
        assert {(one.part, one.number, one.act) for one in main.moving} == moving


def test_after_a_restart_at_the_end_of_a_list_no_cue_stands_by() -> None:
    session = ShowSession(CAST)
    session.receive("ana", Hello(role="console", version=PROTOCOL_VERSION, name="ana"), 0.0)
    for number in ("1", "2"):
        session.receive("ana", wire.PutCue(f"put-{number}", number=number), 0.0)
    session.receive("ana", wire.GoToCue("go-1", "2"), 1.0)
    session.receive("ana", wire.DropCue("drop-1", session.cues.book.orders["main"][1]), 2.0)
    told = session.cues.status(2.0)
    again = ShowSession.restored(CAST, session.snapshot(), epoch=2)
    again.cues.load(session.cues.book)
    after = again.cues.status(2.0)
    assert told is not None
    assert after is not None
    assert (told.lists["main"].standby, after.lists["main"].standby) == (None, None)
