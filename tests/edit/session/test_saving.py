"""Saving: what is saved plays, and of two who save over each other both keep everything."""

from itertools import pairwise

import pytest

from omote.edit.protocol import messages as wire
from omote.edit.protocol.wire import encode
from omote.edit.session.edit_session import Outcome
from omote.edit.store.on_air_recipes import OnAir
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe, Pull
from tests.authoring import EditHarness


def pulled(pull: float) -> list[Pull]:
    """One muscle."""
    return [Pull("smiler", pull)]


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """Ann and Bob at an expression that Ann saved, item 1, revision 1."""
    harness = EditHarness(cast)
    harness.greet("ann")
    harness.greet("bob")
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    harness.ask("ann", wire.Save, 1, "first")
    harness.ask("bob", wire.OpenItem, 1)
    return harness


def test_what_is_saved_plays_and_its_bytes_are_kept(harness: EditHarness) -> None:
    state = harness.ask("ann", wire.SetPulls, 1, pulled(0.5))
    saved = harness.ask("ann", wire.Save, 1, "better")
    assert (saved.revision, saved.head, saved.aside) == (2, 2, False)
    assert saved.sentence == "Revision 2 of 'Grin' plays from now on: consoles have it under Own."
    (own,) = harness.session.own()
    assert own.source == state.content
    assert harness.tables.contents[own.content] == harness.session.contents[own.content]
    assert any(outcome.cast for outcome in harness.outcomes[-1:])


def test_saving_what_is_on_air_says_that_it_is(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, pulled(0.5))
    harness.on_air = OnAir({"generic": 1.0}, {"grin": 0.25, "neutral": 0.75})
    saved = harness.ask("ann", wire.Save, 1, "")
    assert saved.sentence == "Revision 2 of 'Grin' plays from now on: it is on air, so every stage has changed."


def test_the_page_learns_that_its_draft_is_saved(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, pulled(0.5))
    answers = harness.say("ann", wire.Save(99, 1, ""))
    saved, state, items = answers
    assert (saved.request, state.request, state.dirty, state.base) == (99, -1, False, 2)
    assert items.items[0].head == 2


def test_nothing_new_is_no_revision(harness: EditHarness) -> None:
    saved = harness.ask("ann", wire.Save, 1, "again")
    assert (saved.revision, saved.sentence) == (1, "Nothing has changed since revision 1.")
    harness.ask("bob", wire.SetPulls, 1, pulled(0.5))
    harness.ask("bob", wire.Save, 1, "")
    saved = harness.ask("ann", wire.Save, 1, "again")
    assert (saved.revision, saved.head) == (1, 2)
    assert saved.sentence.endswith("What plays is revision 2 of Bob.")
    assert len(harness.tables.revisions) == 2


def test_whoever_saves_second_is_told_and_both_versions_are_kept(harness: EditHarness) -> None:
    theirs = harness.ask("ann", wire.SetPulls, 1, pulled(0.1)).content
    ours = harness.ask("bob", wire.SetPulls, 1, pulled(0.2)).content
    harness.ask("ann", wire.Save, 1, "")
    saved = harness.ask("bob", wire.Save, 1, "")
    assert (saved.revision, saved.head, saved.aside) == (3, 2, True)
    assert "Ann saved 'Grin' meanwhile: their revision 2 plays" in saved.sentence
    assert "revision 3" in saved.sentence
    (own,) = harness.session.own()
    assert own.source == theirs
    history = harness.ask("bob", wire.AskHistory, 1).revisions
    assert [(r.number, r.editor, r.aside, r.content) for r in history[1:]] == [
        (2, "Ann", False, theirs), (3, "Bob", True, ours)
    ]  # fmt: skip


def test_the_second_save_of_whoever_was_told_plays(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, pulled(0.1))
    ours = harness.ask("bob", wire.SetPulls, 1, pulled(0.2)).content
    harness.ask("ann", wire.Save, 1, "")
    harness.ask("bob", wire.Save, 1, "")
    saved = harness.ask("bob", wire.Save, 1, "mine after all")
    assert (saved.revision, saved.head, saved.aside) == (4, 4, False)
    assert harness.session.own()[0].source == ours
    assert harness.tables.revisions[1, 4].parent == 2, "they knew of revision 2"


def test_both_versions_can_be_brought_back(harness: EditHarness) -> None:
    theirs = harness.ask("ann", wire.SetPulls, 1, pulled(0.1))
    ours = harness.ask("bob", wire.SetPulls, 1, pulled(0.2))
    harness.ask("ann", wire.Save, 1, "")
    harness.ask("bob", wire.Save, 1, "")
    for revision, wanted in ((3, ours), (2, theirs), (1, None)):
        state = harness.ask("ann", wire.BringBack, 1, revision)
        assert wanted is None or (state.recipe, state.content) == (wanted.recipe, wanted.content)
        assert f"revision {revision} of" in state.what
        saved = harness.ask("ann", wire.Save, 1, "")
        assert (saved.aside, harness.session.own()[0].source) == (False, state.content)


def test_a_draft_that_was_brought_back_can_be_undone(harness: EditHarness) -> None:
    before = harness.ask("ann", wire.SetPulls, 1, pulled(0.1))
    harness.ask("ann", wire.BringBack, 1, 1)
    assert harness.ask("ann", wire.Undo, 1).recipe == before.recipe


def test_two_saves_under_way_at_once_do_not_both_play(harness: EditHarness) -> None:
    harness.ask("ann", wire.SetPulls, 1, pulled(0.1))
    harness.ask("bob", wire.SetPulls, 1, pulled(0.2))
    harness.start()  # what the drafts make is no longer known, so both saves need the workshop
    harness.greet("ann")
    harness.greet("bob")
    harness.slow = True
    assert (
        harness.receive_bytes("ann", encode(wire.Save(50, 1, "")))
        == harness.receive_bytes("bob", encode(wire.Save(51, 1, "")))
        == []
    )
    assert len(harness.orders) == 2
    harness.slow = False
    told = harness.carry_out(Outcome())
    saved = [message for _, message in told if isinstance(message, wire.Saved)]
    assert [each.aside for each in saved] == [False, True]


def test_a_new_item_is_not_on_any_palette_before_its_first_save(harness: EditHarness) -> None:
    harness.ask("ann", wire.CreateExpression, "Sneer", {}, False)
    assert [own.name for own in harness.session.own()] == ["grin"]
    assert [item.head for item in harness.tables.stored().items] == [1, 0]


def test_names_are_new_whatever_the_labels(harness: EditHarness) -> None:
    for label in ("Grin", "grin!", "smile", "Generic", "generic"):
        harness.ask("ann", wire.CreateFace, label, {"broad": 1.0}, False)
    names = [item.name for item in harness.tables.stored().items]
    assert names == ["grin", "grin_2", "grin_3", "smile_2", "generic_2", "generic_3"]
    places = [item.place for item in harness.tables.stored().items]
    assert all(a < b for a, b in pairwise(places))


def test_a_copy_plays_at_once_and_goes_its_own_way(harness: EditHarness) -> None:
    saved = harness.ask("bob", wire.Duplicate, 1, "Grin of Bob")
    assert (saved.item, saved.revision, saved.head) == (2, 1, 1)
    one, other = harness.session.own()
    assert (one.content, other.name) == (other.content, "grin_of_bob")
    assert harness.tables.revisions[2, 1].editor == "Bob"
    harness.ask("bob", wire.OpenItem, 2)
    harness.ask("bob", wire.SetPulls, 2, pulled(0.9))
    harness.ask("bob", wire.Save, 2, "")
    one, other = harness.session.own()
    assert one.content != other.content
    harness.ask("bob", wire.CreateExpression, "Sneer", {}, False)
    assert "has been saved yet" in harness.ask("bob", wire.Duplicate, 3, "Copy").reason


def test_what_is_on_air_is_kept_in_one_press(harness: EditHarness) -> None:
    harness.on_air = OnAir({"generic": 0.25, "broad": 0.75}, {"smile": 1.0}, {"jawOpen": 0.5})
    first = harness.keep("expression")
    second = harness.keep("face")
    named = harness.keep("face", "Uncle", "7")
    assert [(kept.label, kept.name) for kept in (first, second)] == [("On air 1", "on_air_1"), ("On air 2", "on_air_2")]
    assert (named.ticket, named.name, named.label, named.kind, named.trouble) == ("7", "uncle", "Uncle", "face", "")
    assert [own.name for own in harness.session.own()] == ["grin", "on_air_1", "on_air_2", "uncle"]
    state = harness.ask("ann", wire.OpenItem, second.item)
    assert (state.recipe, state.dirty) == (FaceRecipe({"generic": 0.25, "broad": 0.75}), False)
    (revision,) = harness.ask("ann", wire.AskHistory, first.item).revisions
    assert (revision.editor, revision.note, revision.content) == (
        "console", "saved on air", harness.session.own()[1].source
    )  # fmt: skip


def test_what_cannot_be_kept_is_said_and_changes_nothing(harness: EditHarness) -> None:
    before = harness.tables.stored()
    assert "printable" in harness.keep("face", "\n").trouble
    harness.on_air = OnAir()
    assert "from no face" in harness.keep("face").trouble
    harness.on_air = OnAir(expressions={"nobody": 1.0})
    assert "no expression 'nobody'" in harness.keep("expression", ticket="9").trouble
    harness.on_air = OnAir({"broad": 1.0})
    harness.make_baked = lambda order: "the mesh would fold."
    assert harness.keep("face").trouble == "the mesh would fold."
    assert harness.tables.stored() == before
