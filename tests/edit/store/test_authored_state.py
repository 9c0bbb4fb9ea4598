"""The authored state mirrors the show file: changes mean the same to both, and a damaged file opens."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.edit.store.authored_state import AuthoredState
from omote.showfile.changes import Change, Content, DocumentRemoval, Draft, Edit, Item, Revision, Stored, StoredDocument
from tests.authoring import WALL, Tables

editors = st.sampled_from(["ann", "bob"])


def item(number: int = 1, **other: object) -> Item:
    """An item."""
    return Item(number, "expression", f"smile_{number}", "Smile", **other)  # type: ignore[arg-type]


def revision(number: int, item: int = 1) -> Revision:
    """A revision."""
    return Revision(item, number, number - 1, b"{}", f"key {number}", WALL, "Ann")


@st.composite
def histories(draw: st.DrawFn) -> list[Change]:
    """Changes as sessions make them: a draft before its steps, steps without gaps, revisions once."""
    changes: list[Change] = [item(1), item(2)]
    steps: dict[tuple[int, str], int] = {}
    saved = {1: 0, 2: 0}
    for _ in range(draw(st.integers(0, 30))):
        key = draw(st.sampled_from([1, 2])), draw(editors)
        match draw(st.sampled_from(["edit", "edit", "edit", "revision", "layout", "no layout", "content"])):
            case "edit":
                number = draw(st.integers(0, steps.get(key, 0)))
                changes += [Draft(*key, 0, number), Edit(*key, number, b"{}", "step")]
                steps[key] = number + 1
            case "revision":
                saved[key[0]] += 1
                changes += [revision(saved[key[0]], key[0]), item(key[0], head=saved[key[0]])]
            case "layout":
                changes.append(StoredDocument("layout", key[1], b"{}"))
            case "no layout":
                changes.append(DocumentRemoval("layout", key[1]))
            case _:
                changes.append(Content("key", b"bytes"))
    return changes


@given(histories())
def test_changes_mean_the_same_to_the_state_and_to_a_file(changes: list[Change]) -> None:
    state = AuthoredState(Stored())
    tables = Tables()
    state.apply(changes)
    tables.apply(changes)
    assert state.stored() == tables.stored()
    assert AuthoredState(tables.stored()).stored() == tables.stored(), "what is read is what was written"


def test_a_step_takes_the_place_of_what_was_undone() -> None:
    state = AuthoredState(Stored())
    edits = [Edit(1, "ann", number, b"{}", f"step {number}") for number in range(4)]
    state.apply([Draft(1, "ann", 0, 3), *edits])
    state.apply([Edit(1, "ann", 2, b"{}", "another"), Draft(1, "ann", 0, 2)])
    assert [edit.what for edit in state.edits[1, "ann"]] == ["step 0", "step 1", "another"]
    assert state.shown_edit((1, "ann")).what == "another"


def test_a_revision_is_never_replaced() -> None:
    state = AuthoredState(Stored())
    state.apply([revision(1)])
    with pytest.raises(ValueError, match="revision 1 is there already"):
        state.apply([revision(1)])


def test_a_damaged_file_opens_with_what_is_whole() -> None:
    drafts = (Draft(1, "ann", 1, 3), Draft(1, "bob", 1, 0))
    edits = tuple(Edit(1, "ann", number, b"{}", f"step {number}") for number in (0, 1, 3))
    state = AuthoredState(Stored((item(head=7),), (revision(1),), drafts, edits))
    assert [edit.number for edit in state.edits[1, "ann"]] == [0, 1]
    assert state.shown_edit((1, "ann")).what == "step 1"
    assert (1, "bob") not in state.drafts
    assert state.head(state.items[1]) is None


def test_new_items_stand_behind_all_others_under_ids_never_used() -> None:
    state = AuthoredState(Stored())
    assert (state.new_item(), state.new_place(), state.last_number(1)) == (1, 1.0, 0)
    state.apply([item(4, place=7.5, deleted=True), revision(3, 4)])
    assert (state.new_item(), state.new_place(), state.last_number(4)) == (5, 8.5, 3)
    assert state.find("smile_4") == item(4, place=7.5, deleted=True)
    assert state.find("nobody") is None
