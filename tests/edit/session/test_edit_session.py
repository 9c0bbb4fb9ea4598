"""Editors of one show file: whatever was acknowledged is stored, both versions of two, and undo always works."""

from __future__ import annotations

from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule, run_state_machine_as_test

from omote.edit.protocol import messages as wire
from omote.edit.protocol.orders import Baked
from omote.edit.protocol.wire import encode, read_recipe
from omote.edit.session.console_requests import keep_on_air
from omote.edit.session.draft_queue import MOST_WAITING
from omote.edit.session.edit_session import EditorReply, EditSession, Outcome
from omote.edit.store.on_air_recipes import OnAir
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, FaceRecipe, Layer, Pull, Recipe
from omote.show.access.people_list import Visitor
from omote.showfile.changes import Stored
from omote.showfile.show_file import ShowFile, open_show
from omote.stage_data.playing_cast import digest_of
from tests import synthetic
from tests.authoring import MUSCLES, POINTS, WALL, EditHarness, make_baked, net_of, welcome

REST = (0.0, 0.0, 1.0)
NOBODY = OnAir({"generic": 1.0}, {"neutral": 1.0})


def session_of(cast: Cast) -> EditSession:
    """A session over an empty file."""
    return EditSession(cast, Stored(), {}, net=net_of(cast), welcome=welcome())


def told(outcome: Outcome, kind: type) -> list[Any]:
    """The replies of a kind."""
    return [each.message for each in outcome.replies if isinstance(each.message, kind)]


def test_greet_is_answered_with_everything_there_is(cast: Cast) -> None:
    harness = EditHarness(cast)
    greeted = harness.greet("ann")
    assert (greeted.version, greeted.digest, greeted.items) == (wire.EDITING_VERSION, cast.digest, [])
    assert [muscle.name for muscle in greeted.muscles] == list(MUSCLES)
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    assert [item.label for item in harness.greet("bob").items] == ["Grin"]


def test_greet_tells_which_show_this_is_and_what_the_editor_has_not_saved(cast: Cast) -> None:
    harness = EditHarness(cast)
    harness.session.show = "a5"
    assert (harness.greet("ann").show, harness.greet("ann").unsaved) == ("a5", [])
    item = harness.ask("ann", wire.CreateExpression, "Grin", {}, False).item
    assert (harness.greet("ann").unsaved, harness.greet("bob").unsaved) == ([item], [])  # drafts are one's own
    harness.ask("ann", wire.Save, item, "")
    assert harness.greet("ann").unsaved == []
    harness.ask("ann", wire.SetEyes, item, [0.1, 0.0, 0.1, 0.0], 0.0)
    assert harness.greet("ann").unsaved == [item]
    harness.ask("ann", wire.Undo, item)
    assert harness.greet("ann").unsaved == []
    harness.ask("ann", wire.Redo, item)
    harness.ask("ann", wire.Delete, item)
    assert harness.greet("ann").unsaved == []


def unasked() -> OnAir:
    """What shows now takes longer to tell than a refusal: sixty pages that send rot held the ticks."""
    raise AssertionError("it was asked what shows now")


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"", "cannot be read"),
        (b"\xff" * 100, "cannot be read"),
        (b"\x00" * 65537, "at most 65536"),
        (encode(wire.Greet("ann", "Ann", 99)), "reload the page"),
        (encode(wire.Greet("ann", "\n", wire.EDITING_VERSION)), "your name"),
    ],
)
def test_bytes_that_are_no_message_are_refused_and_counted(cast: Cast, data: bytes, sentence: str) -> None:
    session = session_of(cast)
    outcome = session.receive_bytes("ann", data, wall=WALL, on_air=unasked)
    ((who, refusal),) = [(each.who, each.message) for each in outcome.replies]
    assert who == "ann"
    assert isinstance(refusal, wire.EditRefused)
    assert (refusal.request, sentence in refusal.reason, session.refused) == (-1, True, 1)
    assert (session.crew, session.stored()) == ({}, Stored())


def test_messages_before_greet_are_rejected(cast: Cast) -> None:
    session = session_of(cast)
    outcome = session.receive_bytes(
        "ann", encode(wire.CreateFace(4, "Aunt", {"broad": 1.0}, False)), wall=WALL, on_air=unasked
    )
    sentence = "nothing is heard before greet: send greet with editor, name and version first."
    assert outcome == Outcome(replies=(EditorReply("ann", wire.EditRefused(4, sentence)),))


def test_who_has_a_token_of_a_name_edits_under_it(cast: Cast) -> None:
    session = session_of(cast)
    greet = encode(wire.Greet("ann", "Somebody", wire.EDITING_VERSION))
    session.receive_bytes("a", greet, wall=WALL, on_air=unasked, visitor=Visitor("edit", "Ann", "id"))
    session.receive_bytes("b", greet, wall=WALL, on_air=unasked, visitor=Visitor("edit", "", "shared"))
    assert {who: member.name for who, member in session.crew.items()} == {"a": "Ann", "b": "Somebody"}


@given(st.binary(max_size=200))
def test_no_bytes_change_anything(data: bytes) -> None:
    session = session_of(synthetic.cast())
    session.receive_bytes(
        "ann", encode(wire.Greet("ann", "Ann", wire.EDITING_VERSION)), wall=WALL, on_air=lambda: NOBODY
    )
    outcome = session.receive_bytes("ann", data, wall=WALL, on_air=lambda: NOBODY)
    assert (outcome.changes, outcome.orders, outcome.cast, session.stored()) == ((), (), False, Stored())


# --- orders under way -------------------------------------------------------------------------------------------------


@pytest.fixture
def slow(cast: Cast) -> EditHarness:
    """Ann at item 1, and a workshop that takes its time."""
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    harness.slow = True
    return harness


def pull(harness: EditHarness, number: int, who: str = "ann") -> list[tuple[str, Any]]:
    """A step that needs the workshop."""
    return harness.receive_bytes(who, encode(wire.SetPulls(number, 1, [Pull("smiler", number / 100)])))


def test_nothing_is_acknowledged_before_it_is_made(slow: EditHarness) -> None:
    before = slow.tables.stored()
    assert pull(slow, 10) == []
    assert (len(slow.orders), slow.tables.stored()) == (1, before)
    ((who, state),) = slow.carry_out(slow.answer(*slow.orders.pop()))
    assert (who, state.request, state.undo) == ("ann", 10, 1)


def test_one_order_at_a_time_for_a_draft_and_answers_in_order(slow: EditHarness) -> None:
    for number in (10, 11, 12):
        pull(slow, number)
    slow.receive_bytes("ann", encode(wire.Undo(13, 1)))
    slow.receive_bytes("ann", encode(wire.Save(14, 1, "")))
    assert len(slow.orders) == 1, "each stands on the one before"
    answered = []
    while slow.orders:
        answered += [m.request for _, m in slow.carry_out(slow.answer(*slow.orders.pop(0))) if hasattr(m, "request")]
    assert [request for request in answered if request >= 0] == [10, 11, 12, 13, 14]
    assert read_recipe(slow.tables.revisions[1, 1].recipe).pulls == (Pull("smiler", 0.11),)  # type: ignore[union-attr]


def test_drafts_do_not_wait_for_each_other(slow: EditHarness) -> None:
    slow.slow = False
    slow.greet("bob")
    slow.ask("bob", wire.OpenItem, 1)
    slow.slow = True
    pull(slow, 10)
    pull(slow, 11, "bob")
    assert len(slow.orders) == 2
    later = slow.carry_out(slow.answer(*slow.orders.pop(1)))
    assert [(who, message.request) for who, message in later] == [("bob", 11)]


def test_too_much_that_waits_is_refused_at_once(slow: EditHarness) -> None:
    answers = [pull(slow, number) for number in range(10, 12 + MOST_WAITING)]
    assert [len(each) for each in answers] == [0] * (MOST_WAITING + 1) + [1]
    assert "wait until they are answered" in answers[-1][0][1].reason


@pytest.mark.parametrize(
    ("result", "sentence"),
    [
        (None, "the workshop gave no answer: try again."),
        ("the mesh would fold.", "the mesh would fold."),
        (b"\xff", "the workshop's answer cannot be read"),
        (encode(Baked(FaceRecipe({"broad": 1.0}), "key", {})), "without its content"),
    ],
)
def test_an_order_that_fails_is_refused_and_the_next_goes_on(
    slow: EditHarness, result: bytes | str | None, sentence: str
) -> None:
    pull(slow, 10)
    pull(slow, 11)
    before = slow.tables.stored()
    number, _ = slow.orders.pop()
    outcome = slow.session.finish_order(number, result)
    (refusal,) = told(outcome, wire.EditRefused)
    assert (refusal.request, sentence in refusal.reason) == (10, True)
    assert slow.tables.stored() == before
    assert len(outcome.orders) == 1, "the one that waited has its turn"


def test_an_answer_that_nobody_waits_for_does_nothing(slow: EditHarness) -> None:
    pull(slow, 10)
    number, order = slow.orders.pop()
    slow.carry_out(slow.answer(number, order))
    assert (
        slow.session.finish_order(number, encode(make_baked(order)))
        == slow.session.finish_order(999, None)
        == Outcome()
    )


def test_what_was_asked_is_done_when_the_page_is_gone(slow: EditHarness) -> None:
    pull(slow, 10)
    pull(slow, 11)
    slow.carry_out(slow.session.leave("ann"))
    slow.slow = False
    assert slow.carry_out(Outcome()) == []
    slow.greet("page 2", editor="ann")
    state = slow.ask("page 2", wire.OpenItem, 1)
    assert (state.undo, state.recipe.pulls) == (2, (Pull("smiler", 0.11),))


def test_what_is_on_air_is_kept_as_it_was_when_the_key_was_pressed(slow: EditHarness) -> None:
    keep_on_air(slow.session, "face", OnAir({"broad": 1.0}), label=None, wall=WALL, editor="console", ticket="a")
    first = keep_on_air(slow.session, "face", OnAir({"long": 1.0}), label=None, wall=WALL, editor="console", ticket="b")
    assert (first.orders, first.kept) == ((), ()), "it waits for the one before, so that labels are in order"


def test_too_many_presses_are_refused(slow: EditHarness) -> None:
    presses = [
        keep_on_air(
            slow.session, "face", OnAir({"broad": 1.0}), label=None, wall=WALL, editor="console", ticket=str(number)
        )
        for number in range(MOST_WAITING + 2)
    ]
    (kept,) = presses[-1].kept
    assert (kept.ticket, "wait until" in kept.trouble) == (str(MOST_WAITING + 1), True)


def test_two_windows_of_one_editor_show_one_draft(cast: Cast) -> None:
    harness = EditHarness(cast)
    harness.greet("left", editor="ann", name="Ann")
    harness.greet("right", editor="ann", name="Ann")
    harness.ask("left", wire.CreateExpression, "Grin", {}, False)
    assert harness.ask("right", wire.OpenItem, 1).others == []
    answers = pull(harness, 10, "left")
    states = {who: message for who, message in answers if isinstance(message, wire.DraftState)}
    assert (states["left"].request, states["right"].request) == (10, -1)
    assert states["left"].recipe == states["right"].recipe
    harness.ask("right", wire.CloseItem, 1)
    assert [who for who, _ in pull(harness, 11, "left")] == ["left"]


def test_a_file_with_a_recipe_of_another_time_opens_all_the_same(cast: Cast) -> None:
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    harness.ask("ann", wire.Save, 1, "")
    harness.ask("ann", wire.SetPulls, 1, [Pull("smiler", 0.5)])
    revision = harness.tables.revisions[1, 1]
    harness.tables.revisions[1, 1] = type(revision)(**{**_fields(revision), "recipe": b"{"})
    harness.start()
    harness.greet("ann")
    assert harness.ask("ann", wire.OpenItem, 1).dirty, "the draft is there"
    assert "cannot be read" in harness.ask("ann", wire.BringBack, 1, 1).reason
    assert harness.ask("ann", wire.Save, 1, "").revision == 2


def _fields(struct: Any) -> dict[str, Any]:
    return {name: getattr(struct, name) for name in struct.__struct_fields__}


# --- two editors, a console and restarts ------------------------------------------------------------------------------

pages = st.sampled_from(["ann", "bob"])
numbers = st.integers(0, 7)
amounts = st.sampled_from([-1.0, -0.5, 0.0, 0.25, 0.5, 1.0])
MOST_ITEMS = 3


class Authors(RuleBasedStateMachine):
    """Ann and Bob, a console, and a server that starts anew; what was acknowledged is remembered beside it."""

    tables: Any = None

    def __init__(self) -> None:
        super().__init__()
        self.shown: dict[tuple[str, int], wire.DraftState] = {}
        self.saved: dict[tuple[int, int], str] = {}

    @initialize()
    def begin(self) -> None:
        """An empty file, both greet, one item."""
        self.harness = EditHarness(synthetic.cast(), None if self.tables is None else self.tables())
        self._greet()
        self.create("ann", 3, "Grin")
        self.save("ann", 0)
        self.open_item("bob", 0)

    @rule(who=pages, number=numbers, label=st.sampled_from(["Grin", "grin", "smile", "笑顔"]))
    def create(self, who: str, number: int, label: str) -> None:
        """A new item, from something."""
        start = {synthetic.EXPRESSIONS[number]: 0.5}
        request: tuple[Any, ...] = (wire.CreateExpression, label, start, False)
        if number == 7:
            request = (wire.CreateFace, label, {"broad": 0.5, "long": 0.5}, False)
        if len(self.harness.session.stored().items) < MOST_ITEMS:
            self._heard(who, self.harness.ask(who, *request))

    @rule(who=pages, number=numbers)
    def open_item(self, who: str, number: int) -> None:
        """An editor comes to an item."""
        item = self._item(number)
        before = self.shown.get((who, item))
        state = self.harness.ask(who, wire.OpenItem, item)
        if isinstance(state, wire.DraftState) and before is not None and state.what == before.what:
            assert (state.recipe, state.content, state.undo, state.redo, state.base) == (
                before.recipe, before.content, before.undo, before.redo, before.base
            )  # fmt: skip
        self._heard(who, state)

    @rule(who=pages, number=numbers)
    def close_item(self, who: str, number: int) -> None:
        """An editor leaves an item."""
        self.harness.ask(who, wire.CloseItem, self._item(number))

    @rule(who=pages, number=numbers, kind=st.integers(0, 6), amount=amounts)
    def edit(self, who: str, number: int, kind: int, amount: float) -> None:
        """One step, which is shown, and nothing is left to redo."""
        before = self._at(who, number)
        if before is not None:
            state = self.harness.ask(who, *self._edit(kind, before, amount))
            assert isinstance(state, wire.DraftState)
            self._see(state, kind, amount)
            if state.recipe == before.recipe:
                assert (state.undo, state.redo) == (before.undo, before.redo)
            else:
                assert (state.undo, state.redo) == (before.undo + 1, 0)
            self._heard(who, state)

    @rule(number=numbers, pulls=st.tuples(amounts, amounts), first=pages)
    def clash(self, number: int, pulls: tuple[float, float], first: str) -> None:
        """Both work on one item and save; what both saved can be brought back."""
        item = self._item(number)
        second = "bob" if first == "ann" else "ann"
        for who, pull in zip((first, second), pulls, strict=True):
            self.edit(who, number, 4, pull)
        for who in (first, second):
            self.save(who, number)
        for who in (first, second):
            for revision in [each[1] for each in self.saved if each[0] == item][-2:]:
                self.bring_back(who, number, revision)

    @rule(who=pages, number=numbers)
    def undo_and_redo(self, who: str, number: int) -> None:
        """Undo then redo is as if nothing had been done."""
        item = self._item(number)
        before = self._at(who, number)
        tables = self.harness.tables.stored()
        state = self.harness.ask(who, wire.Undo, item)
        if isinstance(state, wire.DraftState) and before is not None:
            assert (state.undo, state.redo) == (before.undo - 1, before.redo + 1)
            again = self.harness.ask(who, wire.Redo, item)
            assert (again.recipe, again.content, again.undo) == (before.recipe, before.content, before.undo)
            assert self.harness.tables.stored() == tables

    @rule(who=pages, number=numbers, back=st.booleans())
    def step(self, who: str, number: int, back: bool) -> None:
        """Undo, or redo."""
        self._heard(who, self.harness.ask(who, wire.Undo if back else wire.Redo, self._item(number)))

    @rule(who=pages, number=numbers)
    def save(self, who: str, number: int) -> None:
        """A revision: it plays unless another played that this editor was not told of."""
        item = self._item(number)
        state = self._at(who, number)
        head = self._head(item)
        saved = self.harness.ask(who, wire.Save, item, "")
        if isinstance(saved, wire.Saved):
            assert state is not None
            if state.dirty:
                assert saved.aside == (state.base != head)
                self.saved[item, saved.revision] = state.content
                assert saved.head == (head if saved.aside else saved.revision)
            assert saved.head == self._head(item)
            self._refresh(who, item)

    @rule(who=pages, number=numbers, revision=st.integers(0, 9))
    def bring_back(self, who: str, number: int, revision: int) -> None:
        """Any revision ever acknowledged can be shown again, exactly."""
        item = self._item(number)
        known = [each[1] for each in self.saved if each[0] == item]
        if self._at(who, number) is not None and known:
            wanted = revision if revision in known else known[revision % len(known)]
            state = self.harness.ask(who, wire.BringBack, item, wanted)
            assert state.content == self.saved[item, wanted]
            self._heard(who, state)

    @rule(who=pages, number=numbers, label=st.sampled_from(["Copy", "Grin"]))
    def duplicate(self, who: str, number: int, label: str) -> None:
        """A copy that plays."""
        if len(self.harness.session.stored().items) < MOST_ITEMS:
            saved = self.harness.ask(who, wire.Duplicate, self._item(number), label)
            if isinstance(saved, wire.Saved):
                self.saved[saved.item, 1] = self.harness.tables.stored().revisions[-1].content
                self._note_revisions(saved.item)

    @rule(who=pages, number=numbers, label=st.sampled_from(["Grin", "Other", "\n"]), place=amounts)
    def describe(self, who: str, number: int, label: str, place: float) -> None:
        """Another label; the name stays."""
        names = {item.id: item.name for item in self.harness.session.stored().items}
        self.harness.ask(who, wire.Describe, self._item(number), label, ["tag"], place)
        assert {item.id: item.name for item in self.harness.session.stored().items} == names

    @rule(who=pages, number=numbers, on_air=st.booleans(), back=st.booleans())
    def delete(self, who: str, number: int, on_air: bool, back: bool) -> None:
        """Out of the cast, unless it is on air; and often back again."""
        item = self._item(number)
        name = next(each.name for each in self.harness.session.stored().items if each.id == item)
        self.harness.on_air = OnAir({"generic": 1.0}, {name: 1.0} if on_air else {"neutral": 1.0})
        answer = self.harness.ask(who, wire.Delete, item)
        assert isinstance(answer, wire.EditRefused) == on_air
        self.harness.on_air = NOBODY
        if back:
            self.restore(who, number)

    @rule(who=pages, number=numbers)
    def restore(self, who: str, number: int) -> None:
        """Into the cast again."""
        assert isinstance(self.harness.ask(who, wire.Restore, self._item(number)), wire.Done)

    @rule(kind=st.sampled_from(["face", "expression"]), number=numbers, amount=amounts)
    def keep(self, kind: Any, number: int, amount: float) -> None:
        """The console's one press."""
        if len(self.harness.session.stored().items) < MOST_ITEMS:
            self.harness.on_air = OnAir(
                {"broad": 0.5, "long": 0.5}, {synthetic.EXPRESSIONS[number]: 1.0}, {"jawOpen": amount}
            )  # fmt: skip
            kept = self.harness.keep(kind)
            assert not kept.trouble
            self._note_revisions(kept.item)
            self.harness.on_air = NOBODY

    @rule(who=pages, number=numbers, kind=st.integers(0, 4))
    def refused(self, who: str, number: int, kind: int) -> None:
        """What must be refused changes nothing."""
        item = self._item(number)
        bad: list[tuple[Any, ...]] = [
            (wire.SetVectors, item, [(float("nan"), 0.0, 1.0)] * POINTS, ""),
            (wire.SetNet, item, [1, 1, 2]),
            (wire.SetLayers, item, [Layer("nobody", "?")]),
            (wire.BringBack, item, 999),
            (wire.OpenItem, 999),
        ]
        before = self.harness.tables.stored(), dict(self.harness.tables.contents)
        assert isinstance(self.harness.ask(who, *bad[kind]), wire.EditRefused)
        assert (self.harness.tables.stored(), dict(self.harness.tables.contents)) == before

    @rule(who=pages)
    def workshop_fails(self, who: str) -> None:
        """An order without an answer changes nothing but the sentence."""
        before = self.harness.tables.stored()
        self.harness.make_baked = lambda order: None
        answer = self.harness.ask(who, wire.CreateExpression, "Grin", {"smile": 0.123}, False)
        self.harness.make_baked = make_baked
        assert isinstance(answer, wire.EditRefused)
        assert self.harness.tables.stored() == before

    @rule()
    def restart(self) -> None:
        """The server dies and another starts from the file: every draft is as it was."""
        before = self.harness.session.stored()
        self.harness.start()
        assert self.harness.session.stored() == before
        self._greet()
        for (who, item), state in [*self.shown.items()]:
            if not self._of(item).deleted:
                again = self.harness.ask(who, wire.OpenItem, item)
                if again.what == state.what:
                    assert (again.recipe, again.content, again.undo, again.redo) == (
                        state.recipe, state.content, state.undo, state.redo
                    )  # fmt: skip
                self._heard(who, again)

    @invariant()
    def the_file_is_what_the_session_says(self) -> None:
        """Everything acknowledged was committed, and nothing else."""
        if hasattr(self, "harness"):
            assert self.harness.session.stored() == self.harness.tables.stored()

    @invariant()
    def every_revision_stays_with_its_bytes(self) -> None:
        """No revision acknowledged vanishes or changes."""
        if hasattr(self, "harness"):
            stored = self.harness.tables.stored()
            contents = self.harness.tables.contents
            kept = {(each.item, each.number): KEY + each.content for each in stored.revisions}
            assert self.saved.items() <= kept.items()
            assert {content.removeprefix(KEY) for content in kept.values()} <= contents.keys()

    @invariant()
    def what_plays_was_never_put_aside_and_names_are_new(self) -> None:
        """Heads are there and not aside; no two names, nor one of the cast."""
        if hasattr(self, "harness"):
            stored = self.harness.tables.stored()
            aside = {(each.item, each.number): each.aside for each in stored.revisions}
            assert not any(aside[item.id, item.head] for item in stored.items if item.head)
            names = [item.name.casefold() for item in stored.items]
            cast = self.harness.cast
            assert len({*names, *map(str.casefold, cast.faces), *map(str.casefold, cast.expressions)}) == len(
                names
            ) + len(cast.faces) + len(cast.expressions)

    def _greet(self) -> None:
        for who in ("ann", "bob"):
            self.harness.greet(who)

    def _item(self, number: int) -> int:
        items = self.harness.session.stored().items
        return items[number % len(items)].id

    def _of(self, item: int) -> Any:
        return next(each for each in self.harness.session.stored().items if each.id == item)

    def _head(self, item: int) -> int:
        head: int = self._of(item).head
        return head

    def _heard(self, who: str, answer: Any) -> None:
        if isinstance(answer, wire.DraftState):
            self.shown[who, answer.item] = answer

    def _refresh(self, who: str, item: int) -> None:
        states = [
            reply.message
            for outcome in self.harness.outcomes[-2:]
            for reply in outcome.replies
            if reply.who == who and isinstance(reply.message, wire.DraftState) and reply.message.item == item
        ]
        if states:
            self.shown[who, item] = states[-1]

    def _note_revisions(self, item: int) -> None:
        for revision in self.harness.tables.stored().revisions:
            if revision.item == item:
                self.saved[item, revision.number] = KEY + revision.content

    def _at(self, who: str, number: int) -> wire.DraftState | None:
        """What an editor sees of an item, opened where it is not; None where it is deleted."""
        item = self._item(number)
        if not self._of(item).deleted and (who, item) not in self.shown:
            self._heard(who, self.harness.ask(who, wire.OpenItem, item))
        return None if self._of(item).deleted else self.shown[who, item]

    def _edit(self, kind: int, state: wire.DraftState, amount: float) -> tuple[Any, ...]:
        if isinstance(state.recipe, FaceRecipe):
            return wire.SetFace, state.item, FaceRecipe({"broad": amount, "long": 1.0 - amount}), "mix"
        assert isinstance(state.recipe, Recipe)
        vectors = [(amount / 10, 0.0, 1.0), *[REST] * (len(state.recipe.net) - 1)]
        edits: list[tuple[Any, ...]] = [
            (wire.SetVectors, state.item, vectors, "nudge"),
            (wire.DragPoints, state.item, "broad", [0], [(amount / 10, 0.01, 0.05)], vectors),
            (wire.SetNet, state.item, list(net_of(self.harness.cast, POINTS + int(2 * abs(amount))))),
            (wire.SetLayers, state.item, [Layer("smile", "Smile", amount)]),
            (wire.SetPulls, state.item, [Pull("smiler", amount)]),
            (wire.SetEyes, state.item, (amount, 0.0, amount, 0.0), amount),
            (wire.Flatten, state.item),
        ]
        return edits[kind]

    def _see(self, state: wire.DraftState, kind: int, amount: float) -> None:
        """What was asked for is what is shown."""
        recipe = state.recipe
        if isinstance(recipe, FaceRecipe):
            assert recipe.base == {"broad": amount, "long": 1.0 - amount}
            return
        assert isinstance(recipe, Recipe)
        assert {
            0: recipe.vectors[0] == (amount / 10, 0.0, 1.0),
            1: recipe.vectors[0] == (amount / 10, 0.01, 1.0),
            2: recipe.net == net_of(self.harness.cast, POINTS + int(2 * abs(amount))),
            3: recipe.layers == (Layer("smile", "Smile", amount),),
            4: recipe.pulls == (Pull("smiler", amount),),
            5: (recipe.eyes, recipe.pupil) == ((amount, 0.0, amount, 0.0), amount),
            6: recipe.ground is not None and (recipe.layers, recipe.pulls) == ((), ()),
        }[kind]


def played(seed: int, steps: int) -> Authors:
    """Authors after as many steps, all drawn from a seed."""
    authors = Authors()
    rng = np.random.default_rng(seed)
    authors.begin()
    for _ in range(steps):
        who = str(rng.choice(["ann", "bob"]))
        number = int(rng.integers(8))
        amount = float(rng.choice([-0.5, 0.25, 1.0]))
        match int(rng.integers(8)):
            case 0:
                authors.save(who, number)
            case 1:
                authors.step(who, number, bool(rng.integers(2)))
            case 2:
                authors.keep("face", number, amount)
            case 3:
                authors.open_item(who, number)
            case _:
                authors.edit(who, number, int(rng.integers(7)), amount)
    return authors


def test_the_same_inputs_give_the_same_outcomes() -> None:
    one = played(1993, 80)
    other = played(1993, 80)
    assert one.harness.outcomes == other.harness.outcomes
    assert one.harness.tables == other.harness.tables


@pytest.mark.parametrize("seed", range(6))
def test_a_newcomer_is_told_what_everybody_was_told_last(seed: int) -> None:
    harness = played(seed, 40).harness
    lists = [each.message for out in harness.outcomes for each in out.replies if isinstance(each.message, wire.Items)]
    greeted = harness.greet("carol")
    assert (greeted.items, greeted.digest) == (lists[-1].items, lists[-1].digest)
    assert greeted.digest == digest_of(harness.cast.digest, harness.session.own())


class ShowTables:
    """A real show file, as `Tables` are asked."""

    def __init__(self, show: ShowFile) -> None:
        self.show = show
        self.apply = show.apply
        self.stored = show.stored

    @property
    def contents(self) -> dict[str, bytes]:
        """All bytes by key."""
        return self.show.contents()


def test_authors_keep_everything() -> None:
    run_state_machine_as_test(Authors, settings=settings(max_examples=40, stateful_step_count=50))


def test_authors_keep_everything_in_a_real_show_file(tmp_path: Path) -> None:
    numbered = count()

    class Filed(Authors):
        tables = staticmethod(lambda: opened[-1])

        def __init__(self) -> None:
            super().__init__()
            opened.append(ShowTables(open_show(tmp_path / f"show_{next(numbered)}.omote")))

        def teardown(self) -> None:
            opened.pop().show.close()

    opened: list[ShowTables] = []
    run_state_machine_as_test(Filed, settings=settings(max_examples=5, stateful_step_count=40))
