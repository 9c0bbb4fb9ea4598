"""Lists of items: what people read and where it stands; what is on air stays; what was deleted comes back."""

import math

import pytest

from omote.edit.protocol import messages as wire
from omote.edit.protocol.wire import encode
from omote.edit.session.items import own_things
from omote.edit.store.authored_state import AuthoredState
from omote.edit.store.on_air_recipes import OnAir
from omote.model.cast import Cast
from omote.showfile.changes import Item, Revision, Stored
from omote.stage_data.playing_cast import digest_of
from tests.authoring import WALL, EditHarness


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """Ann with two saved expressions."""
    harness = EditHarness(cast)
    harness.greet("ann")
    for number, label in enumerate(("Grin", "Sneer"), 1):
        harness.ask("ann", wire.CreateExpression, label, {}, False)
        harness.ask("ann", wire.Save, number, "")
    return harness


def test_what_people_read_changes_and_the_name_stays(harness: EditHarness) -> None:
    digest = harness.session.digest
    answers = harness.say("ann", wire.Describe(9, 1, " Wide grin ", ["mouth", "act 2", "mouth"], 7.5))
    done, listed = answers
    assert done == wire.Done(9)
    assert [(item.name, item.label) for item in listed.items] == [("sneer", "Sneer"), ("grin", "Wide grin")]
    assert listed.items[1].tags == ["mouth", "act 2"]
    assert [own.name for own in harness.session.own()] == ["sneer", "grin"], "in the order of places"
    assert listed.digest == harness.session.digest != digest


@pytest.mark.parametrize(
    ("label", "tags", "place", "sentence"),
    [
        ("\n", [], 0.0, "the label"),
        ("Grin", ["a\tb"], 0.0, "a tag"),
        ("Grin", [], math.nan, "a place in the list"),
        ("Grin", [], math.inf, "a place in the list"),
    ],
)
def test_what_nobody_can_read_is_refused(
    harness: EditHarness, label: str, tags: list[str], place: float, sentence: str
) -> None:
    before = harness.tables.stored()
    assert sentence in harness.ask("ann", wire.Describe, 1, label, tags, place).reason
    assert harness.tables.stored() == before


@pytest.mark.parametrize(
    "on_air",
    [
        OnAir(expressions={"grin": 0.01}),
        OnAir(channels={"grin": -0.5}),
        OnAir(coming=frozenset({"grin"})),
    ],
)
def test_what_is_on_air_or_coming_cannot_be_deleted(harness: EditHarness, on_air: OnAir) -> None:
    harness.on_air = on_air
    assert "'Grin' is on air or coming" in harness.ask("ann", wire.Delete, 1).reason
    assert harness.ask("ann", wire.Delete, 2) == wire.Done(2 + 3 + 1)
    assert [own.name for own in harness.session.own()] == ["grin"]


def test_a_deletion_can_be_undone(harness: EditHarness) -> None:
    before = harness.tables.stored()
    digest = harness.session.digest
    harness.ask("ann", wire.Delete, 1)
    assert harness.session.digest != digest
    assert [own.name for own in harness.session.own()] == ["sneer"]
    harness.ask("ann", wire.Restore, 1)
    assert (harness.tables.stored(), harness.session.digest) == (before, digest)


def test_what_was_deleted_is_not_touched_but_its_history_is_there(harness: EditHarness) -> None:
    harness.ask("ann", wire.Delete, 1)
    for request, arguments in ((wire.OpenItem, ()), (wire.Save, ("",)), (wire.Undo, ()), (wire.Duplicate, ("Copy",))):
        assert harness.ask("ann", request, 1, *arguments).reason == "'Grin' was deleted: restore it first."
    assert len(harness.ask("ann", wire.AskHistory, 1).revisions) == 1
    assert isinstance(harness.ask("ann", wire.CloseItem, 1), wire.Done)
    harness.ask("ann", wire.CreateExpression, "Grin", {}, False)
    assert harness.tables.items[3].name == "grin_2", "its name stays its own"


def test_the_history_is_told_oldest_first(harness: EditHarness) -> None:
    for pupil in (0.1, 0.2):
        harness.ask("ann", wire.SetEyes, 1, (0.0, 0.0, 0.0, 0.0), pupil)
        harness.ask("ann", wire.Save, 1, f"pupil {pupil}")
    history = harness.ask("ann", wire.AskHistory, 1)
    assert [(r.number, r.parent, r.note, r.aside) for r in history.revisions] == [
        (1, 0, "", False), (2, 1, "pupil 0.1", False), (3, 2, "pupil 0.2", False)
    ]  # fmt: skip
    assert WALL < history.revisions[0].written < history.revisions[1].written


def test_lists_say_who_is_at_an_item(harness: EditHarness) -> None:
    harness.greet("bob")
    answers = harness.receive_bytes("bob", encode(wire.OpenItem(77, 1)))
    lists = [message for who, message in answers if isinstance(message, wire.Items) and who == "ann"]
    assert [item.editors for item in lists[-1].items] == [["Ann", "Bob"], ["Ann"]]
    told = harness.carry_out(harness.session.leave("ann"))
    assert [(who, [item.editors for item in message.items]) for who, message in told] == [("bob", [["Bob"], []])]


def test_nothing_of_ones_own_leaves_the_cast_as_it_is(cast: Cast) -> None:
    assert EditHarness(cast).session.digest == cast.digest


def test_the_digest_names_exactly_what_plays(harness: EditHarness) -> None:
    assert harness.session.digest == digest_of(harness.cast.digest, harness.session.own())
    digest = harness.session.digest
    harness.ask("ann", wire.SetEyes, 1, (0.0, 0.0, 0.0, 0.0), 0.5)
    assert harness.session.digest == digest, "drafts play nowhere"
    assert not any(outcome.cast for outcome in harness.outcomes[-1:])
    harness.ask("ann", wire.Save, 1, "")
    assert harness.session.digest != digest


def test_own_things_are_whole_even_when_a_file_is_not() -> None:
    items = (Item(1, "face", "aunt", "Aunt", head=3), Item(2, "face", "uncle", "Uncle", head=1))
    state = AuthoredState(Stored(items, (Revision(2, 1, 0, b"{}", "key", WALL, "Ann"),)))
    assert [own.name for own in own_things(state)] == ["uncle"]
