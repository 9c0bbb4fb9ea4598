"""What consoles ask of the show file: kept and taken back, layouts saved, renamed and deleted."""

from collections.abc import Callable
from typing import Any

import pytest

from omote.edit.protocol import messages as editing
from omote.edit.session.console_requests import AskedOfItem, answer_console, change_documents
from omote.edit.session.plan import KeepOutcome
from omote.edit.store.on_air_recipes import OnAir
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe
from omote.show.declaration import FileRequest, KeepRequest
from omote.show.objects.items import CopyItem, DeleteItem, KeepFace, RenameItem, RestoreItem
from omote.show.objects.layouts import DropLayout, Layout, RenameLayout, SetLayout
from omote.show.validation import Refusal
from omote.showfile.changes import DocumentRemoval, StoredDocument
from tests.authoring import WALL, EditHarness

LAYOUTS = {"Default": b"1", "left": b"2"}
LAYOUT = Layout(2, {"face": {"seconds": 2.0, "easing": "smooth"}}, "own", "brows", linked=True).encode()


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """A session with a file and a worker, both in memory."""
    return EditHarness(cast)


def ask(harness: EditHarness, message: FileRequest, on_air: OnAir | None = None) -> KeepOutcome | None:
    """What became of a console's request."""
    before = len(harness.outcomes)
    harness.carry_out(
        answer_console(harness.session, KeepRequest("a", message), on_air or harness.on_air, WALL)
    )  # fmt: skip
    kept = [each for outcome in harness.outcomes[before:] for each in outcome.kept]
    return kept[0] if kept else None


def keep_face(harness: EditHarness) -> KeepOutcome:
    kept = ask(harness, KeepFace("one", "k"))
    assert kept is not None
    assert not kept.trouble
    return kept


def own(harness: EditHarness) -> list[str]:
    return [each.name for each in harness.session.own()]


def change(harness: EditHarness, message: AskedOfItem, on_air: OnAir | None = None) -> KeepOutcome:
    """What became of what a console asked of an item."""
    outcome = ask(harness, message, on_air)
    assert outcome is not None
    return outcome


def test_what_was_kept_is_taken_back_and_brought_again_as_often_as_one_likes(harness: EditHarness) -> None:
    kept = keep_face(harness)
    for turn in range(3):
        undone = change(harness, DeleteItem(f"u{turn}", "face", kept.name, unedited=True))
        assert (undone.ticket, undone.label, undone.trouble) == (f"a u{turn}", kept.label, "")
        assert own(harness) == []
        assert harness.tables.items[kept.item].deleted
        again = change(harness, RestoreItem(f"r{turn}", "face", kept.name))
        assert (again.label, again.before) == (kept.label, kept.label)
        assert own(harness) == [kept.name]
    change(harness, DeleteItem("d", "face", kept.name))
    harness.greet("page")
    harness.ask("page", editing.Restore, kept.item)  # so can an editor
    assert own(harness) == [kept.name]


@pytest.mark.parametrize(
    ("on_air", "why"),
    [
        (lambda name: OnAir({name: 0.1}), "on air or coming: call another first"),
        (lambda name: OnAir(coming=frozenset({name})), "on air or coming: call another first"),
        (lambda name: OnAir(coming=frozenset({name}), homes=frozenset({name})), "is the home face, which panic brings"),
    ],
    ids=["on air", "coming", "home"],
)
def test_what_is_in_use_is_not_deleted(harness: EditHarness, on_air: Callable[[str], OnAir], why: str) -> None:
    kept = keep_face(harness)
    for unedited in (False, True):
        refused = change(harness, DeleteItem(f"u{unedited}", "face", kept.name, unedited), on_air(kept.name))
        assert why in refused.trouble
    assert own(harness) == [kept.name]


def test_what_somebody_has_worked_on_is_not_taken_back_but_can_be_deleted(harness: EditHarness) -> None:
    kept = keep_face(harness)
    harness.greet("page")
    harness.ask("page", editing.OpenItem, kept.item)
    state: Any = harness.ask("page", editing.SetFace, kept.item, FaceRecipe({"long": 1.0}), "another")
    assert state.dirty
    for save in (False, True):
        if save:
            harness.ask("page", editing.Save, kept.item, "")
        refused = change(harness, DeleteItem(f"u{save}", "face", kept.name, unedited=True))
        assert "has been edited since" in refused.trouble
    assert own(harness) == [kept.name]
    change(harness, DeleteItem("d", "face", kept.name))
    assert own(harness) == []


@pytest.mark.parametrize(("kind", "name"), [("expression", None), ("face", "dog"), ("face", "nobody")])
@pytest.mark.parametrize("asked", [DeleteItem, RestoreItem, CopyItem])
def test_only_own_items_can_be_changed(harness: EditHarness, asked: Any, kind: Any, name: str | None) -> None:
    kept = keep_face(harness)
    refused = change(harness, asked("u", kind, name or kept.name))
    assert "there is no" in refused.trouble


def test_an_item_is_renamed_where_nothing_of_its_kind_is_called_so(harness: EditHarness) -> None:
    kept = keep_face(harness)
    other = keep_face(harness)
    renamed = change(harness, RenameItem("r", "face", kept.name, " Catdog "))
    assert (renamed.label, renamed.before, renamed.trouble) == ("Catdog", kept.label, "")
    assert [each.label for each in harness.session.own()] == ["Catdog", other.label]
    assert change(harness, RenameItem("s", "face", kept.name, "CATDOG")).label == "CATDOG"
    for taken in (other.label.upper(), "generic"):
        refused = change(harness, RenameItem(f"t{taken}", "face", kept.name, taken))
        assert "already: give another name" in refused.trouble
    assert "the name is" in change(harness, RenameItem("u", "face", kept.name, " ")).trouble
    change(harness, DeleteItem("d", "face", other.name))
    assert change(harness, RenameItem("v", "face", kept.name, other.label)).trouble == ""


def test_a_copy_has_a_label_of_its_own(harness: EditHarness) -> None:
    kept = keep_face(harness)
    copies = [change(harness, CopyItem(f"c{turn}", "face", kept.name)) for turn in (1, 2)]
    assert [each.label for each in copies] == [f"{kept.label} 2", f"{kept.label} 3"]
    assert len({each.content for each in harness.session.own()}) == 1


def test_layouts_are_stored_renamed_and_deleted(harness: EditHarness) -> None:
    for message in (
        SetLayout("left", LAYOUT.decode()),
        RenameLayout("left", " right "),
        SetLayout("other", LAYOUT.decode()),
    ):
        assert ask(harness, message) is None
    assert harness.session.authored.state.documents == {"layout": {"right": LAYOUT, "other": LAYOUT}}
    ask(harness, DropLayout("other"))
    assert harness.tables.documents == {("layout", "right"): LAYOUT}


def test_a_layout_may_change_the_case_of_its_name() -> None:
    assert change_documents(LAYOUTS, RenameLayout("left", "LEFT")) == (
        DocumentRemoval("layout", "left"),
        StoredDocument("layout", "LEFT", b"2"),
    )


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        (DropLayout("right"), "there is no layout 'right' any more"),
        (RenameLayout("right", "x"), "there is no layout 'right' any more"),
        (RenameLayout("left", "DEFAULT"), "there is a layout 'Default' already"),
        (RenameLayout("left", "  "), "the name of a layout is"),
        (SetLayout("\n", LAYOUT.decode()), "the name of a layout is"),
        (SetLayout("left", "{no JSON"), "'left' is not kept, for this is no layout"),
        (SetLayout("left", "[" * 3000), "'left' is not kept, for this is no layout"),
    ],
)
def test_what_cannot_be_done_to_layouts_is_told(asked: Any, why: str) -> None:
    with pytest.raises(Refusal, match=why):
        change_documents(LAYOUTS, asked)


def test_there_are_so_many_layouts_and_no_more() -> None:
    full = {str(number): b"1" for number in range(Layout.most)}
    with pytest.raises(Refusal, match="delete one"):
        change_documents(full, SetLayout("one more", "1"))
    assert change_documents(full, SetLayout("0", LAYOUT.decode())) == (StoredDocument("layout", "0", LAYOUT),)
