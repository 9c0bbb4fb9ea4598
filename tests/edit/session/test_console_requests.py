"""What consoles ask of the show file: kept and taken back, layouts saved, renamed and deleted."""

from typing import Any

import pytest

from omote.edit.protocol import messages as editing
from omote.edit.session.console_requests import MOST_LAYOUTS, answer_console, change_layouts
from omote.edit.session.plan import KeepOutcome
from omote.edit.store.on_air_recipes import OnAir
from omote.model.cast import Cast
from omote.model.recipes.recipe import FaceRecipe
from omote.show import messages as wire
from omote.show.session import KeepMessage, KeepRequest
from omote.show.validation import Refusal
from omote.showfile.changes import DropLayout, PutLayout
from tests.authoring import WALL, EditHarness

LAYOUTS = {"Default": b"1", "left": b"2"}


@pytest.fixture
def harness(cast: Cast) -> EditHarness:
    """A session with a file and a worker, both in memory."""
    return EditHarness(cast)


def ask(harness: EditHarness, message: KeepMessage, on_air: OnAir | None = None) -> KeepOutcome | None:
    """What became of a console's request."""
    before = len(harness.outcomes)
    harness.carry_out(
        answer_console(harness.session, KeepRequest("a", message), on_air or harness.on_air, WALL)
    )  # fmt: skip
    kept = [each for outcome in harness.outcomes[before:] for each in outcome.kept]
    return kept[0] if kept else None


def keep_face(harness: EditHarness) -> KeepOutcome:
    kept = ask(harness, wire.KeepFace("k"))
    assert kept is not None
    assert not kept.trouble
    return kept


def own(harness: EditHarness) -> list[str]:
    return [each.name for each in harness.session.own()]


def test_what_was_kept_is_taken_back_and_an_editor_can_bring_it_again(harness: EditHarness) -> None:
    kept = keep_face(harness)
    assert own(harness) == [kept.name]
    undone = ask(harness, wire.UndoKeep("u", "face", kept.name))
    assert undone is not None
    assert (undone.ticket, undone.label, undone.undone, undone.trouble) == ("a u", kept.label, True, "")
    assert own(harness) == []
    assert harness.tables.items[kept.item].deleted
    harness.greet("page")
    harness.ask("page", editing.Restore, kept.item)
    assert own(harness) == [kept.name]


def test_what_is_on_air_or_coming_is_not_taken_back(harness: EditHarness) -> None:
    kept = keep_face(harness)
    refused = ask(harness, wire.UndoKeep("u", "face", kept.name), OnAir({kept.name: 1.0}, coming=frozenset()))
    assert refused is not None
    assert "on air or coming: call another first" in refused.trouble
    assert own(harness) == [kept.name]


def test_what_somebody_has_worked_on_is_not_taken_back(harness: EditHarness) -> None:
    kept = keep_face(harness)
    harness.greet("page")
    harness.ask("page", editing.OpenItem, kept.item)
    state: Any = harness.ask("page", editing.SetFace, kept.item, FaceRecipe({"long": 1.0}), "another")
    assert state.dirty
    for save in (False, True):
        if save:
            harness.ask("page", editing.Save, kept.item, "")
        refused = ask(harness, wire.UndoKeep(f"u{save}", "face", kept.name))
        assert refused is not None
        assert "has been edited since" in refused.trouble
    assert own(harness) == [kept.name]


@pytest.mark.parametrize(("kind", "name"), [("expression", None), ("face", "dog"), ("face", "nobody")])
def test_only_what_was_kept_can_be_taken_back(harness: EditHarness, kind: Any, name: str | None) -> None:
    kept = keep_face(harness)
    refused = ask(harness, wire.UndoKeep("u", kind, name or kept.name))
    assert refused is not None
    assert "there is no own" in refused.trouble


def test_layouts_are_stored_renamed_and_deleted(harness: EditHarness) -> None:
    for message in (wire.SetLayout("left", "{}"), wire.RenameLayout("left", " right "), wire.SetLayout("other", "1")):
        assert ask(harness, message) is None
    assert harness.tables.layouts == harness.session.authored.state.layouts == {"right": b"{}", "other": b"1"}
    ask(harness, wire.DropLayout("other"))
    assert harness.tables.layouts == {"right": b"{}"}


def test_a_layout_may_change_the_case_of_its_name() -> None:
    assert change_layouts(LAYOUTS, wire.RenameLayout("left", "LEFT")) == (DropLayout("left"), PutLayout("LEFT", b"2"))


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        (wire.DropLayout("right"), "there is no layout 'right' any more"),
        (wire.RenameLayout("right", "x"), "there is no layout 'right' any more"),
        (wire.RenameLayout("left", "DEFAULT"), "there is a layout 'Default' already"),
        (wire.RenameLayout("left", "  "), "the name of a layout is"),
        (wire.SetLayout("\n", "{}"), "the name of a layout is"),
        (wire.SetLayout("left", "{no JSON"), "is no JSON"),
        (wire.SetLayout("left", "[" * 3000), "is no JSON"),
    ],
)
def test_what_cannot_be_done_to_layouts_is_told(asked: Any, why: str) -> None:
    with pytest.raises(Refusal, match=why):
        change_layouts(LAYOUTS, asked)


def test_there_are_so_many_layouts_and_no_more() -> None:
    full = {str(number): b"1" for number in range(MOST_LAYOUTS)}
    with pytest.raises(Refusal, match="delete one"):
        change_layouts(full, wire.SetLayout("one more", "1"))
    assert change_layouts(full, wire.SetLayout("0", "2")) == (PutLayout("0", b"2"),)
