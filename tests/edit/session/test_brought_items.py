"""What a file of other people brought: new items under labels of their own, or what is there already."""

import pytest
from msgspec.structs import replace

from omote.edit.session.brought_items import TakenIn, take_in, take_made
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.cast import Cast
from omote.server.workers.file_jobs import bring_items
from omote.show.validation import Refusal
from omote.showfile.changes import BroughtItem, Stored
from tests.authoring import EditHarness


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """A session with a file and a worker, both in memory."""
    return EditHarness(cast)


def bring(cast: Cast, *names: str, label: str = "Grin") -> list[BroughtItem]:
    """Expressions of the cast as a file brings them, all under one label."""
    arrivals = [ImportedItem(label, cast.expressions[name]) for name in names]
    return list(bring_items(changes_to_import(cast, Stored(), arrivals, wall=1.0)))


def take(harness: EditHarness, brought: list[BroughtItem]) -> list[TakenIn]:
    result, taken = take_in(harness.session.authored, brought)
    harness.carry_out(harness.session.carry_out(lambda: result, "a t"))
    return taken


def test_each_item_has_a_label_of_its_own_and_plays(harness: EditHarness, cast: Cast) -> None:
    taken = take(harness, bring(cast, "smile", "jawOpen"))
    assert [(each.label, each.known) for each in taken] == [("Grin", False), ("Grin 2", False)]
    assert [(each.name, each.label) for each in harness.session.own()] == [(each.name, each.label) for each in taken]
    (more,) = take(harness, bring(cast, "neutral", label="smile"))
    assert more.label == "smile 2", "a built-in expression is called so"


def test_what_is_there_is_not_added_again_in_one_file_with_what_is_new(harness: EditHarness, cast: Cast) -> None:
    (first,) = take(harness, bring(cast, "smile"))
    taken = take(harness, bring(cast, "jawOpen", "smile", "neutral", label="Other"))
    assert [(each.label, each.known) for each in taken] == [("Other", False), ("Grin", True), ("Other 2", False)]
    assert taken[1].name == first.name
    assert len(harness.session.own()) == 3


def test_what_was_deleted_comes_in_again(harness: EditHarness, cast: Cast) -> None:
    brought = bring(cast, "smile")
    take(harness, brought)
    (item,) = harness.session.authored.state.items.values()
    harness.session.authored.state.apply([replace(item, deleted=True)])
    (again,) = take(harness, brought)
    assert (again.known, again.label) == (False, "Grin")


def test_what_somebody_made_and_named_is_an_item_of_its_own_though_the_same_plays(
    harness: EditHarness, cast: Cast
) -> None:
    take(harness, bring(cast, "smile"))
    result, (made,) = take_made(harness.session.authored, bring(cast, "smile", label="My smile"))
    harness.carry_out(harness.session.carry_out(lambda: result, "a t"))
    assert (made.label, made.known) == ("My smile", False)
    assert [each.label for each in harness.session.own()] == ["Grin", "My smile"]


def test_one_item_is_replaced_and_keeps_its_name_its_label_and_its_history(harness: EditHarness, cast: Cast) -> None:
    (first,) = take(harness, bring(cast, "smile"))
    state = harness.session.authored.state
    (item,) = state.items.values()
    result, (taken,) = take_made(harness.session.authored, bring(cast, "jawOpen", label="Other"), item.id)
    harness.carry_out(harness.session.carry_out(lambda: result, "a t"))
    assert taken == first
    (now,) = state.items.values()
    assert (now.name, now.label, now.head) == (item.name, item.label, 2)
    assert state.revisions[item.id][2].parent == 1
    assert state.revisions[item.id][2].content != state.revisions[item.id][1].content
    (own,) = harness.session.own()
    assert own.name == item.name


@pytest.mark.parametrize("gone", ["missing", "deleted", "of another kind"])
def test_what_is_not_there_is_not_replaced(harness: EditHarness, cast: Cast, gone: str) -> None:
    take(harness, bring(cast, "smile"))
    state = harness.session.authored.state
    (item,) = state.items.values()
    if gone == "deleted":
        state.apply([replace(item, deleted=True)])
    if gone == "of another kind":
        state.apply([replace(item, kind="face")])
    with pytest.raises(Refusal, match="there is no expression"):
        take_made(harness.session.authored, bring(cast, "jawOpen"), item.id + (gone == "missing"))
