"""The cues of a show as a value: numbers that are free, edits that come back, and a file that is damaged."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.perform.cues.cue import Cue, Move
from omote.show.cues.cue_book import (
    FIRST_LIST,
    CueBook,
    changes_between,
    edit_cues,
    find_cue,
    next_number,
    read_book,
    redo,
    renumbered,
    thousandths,
    undo,
)
from omote.show.objects.cues import CueEdit, StoredCue, StoredCueList
from omote.showfile.changes import StoredDocument

NUMBERS = st.builds(
    lambda whole, decimals: f"{whole}.{decimals:03d}".rstrip("0").rstrip("."), st.integers(0, 99), st.integers(0, 999)
)


def book_of(*numbers: str) -> CueBook:
    cues = {f"c{place}": Cue(f"c{place}", number) for place, number in enumerate(numbers)}
    return edit_cues(CueBook(), "write", "Ana", cues, {FIRST_LIST: list(cues)})


@given(st.lists(NUMBERS, unique=True, max_size=8), st.data())
def test_the_next_number_is_free_and_lies_between_its_neighbours(numbers: list[str], data: st.DataObject) -> None:
    ordered = sorted(numbers, key=thousandths)
    book = book_of(*ordered)
    place = data.draw(st.integers(-1, len(ordered) - 1))
    after = None if place < 0 else f"c{place}"
    low = thousandths(ordered[-1] if after is None else ordered[place]) if ordered else 0
    high = thousandths(ordered[place + 1]) if after is not None and place + 1 < len(ordered) else 99_999_000
    try:
        number = next_number(book, FIRST_LIST, after)
    except ValueError:
        assert high <= low + 1  # nothing is between a thousandth
        return
    assert low < thousandths(number) < high


def test_new_numbers_are_in_the_order_of_the_list() -> None:
    book = book_of("7", "3", "5")
    assert [cue.number for cue in renumbered(book, FIRST_LIST, "10", "0.5").values()] == ["10", "10.5", "11"]
    with pytest.raises(ValueError, match="the step between two numbers is 0"):
        renumbered(book, FIRST_LIST, "1", "0")


def test_an_edit_that_would_give_two_cues_a_number_is_none() -> None:
    book = book_of("1", "2")
    with pytest.raises(ValueError, match="two cues have the number 1"):
        edit_cues(book, "number", "Bo", {"c1": Cue("c1", "1")}, {})
    assert edit_cues(book, "nothing", "Bo", {"c1": Cue("c1", "2")}, {}) is book


def test_a_cue_is_found_by_its_number_and_near_ones_are_named() -> None:
    assert find_cue(book_of("1", "12.5"), FIRST_LIST, "12.5").identity == "c1"
    with pytest.raises(ValueError, match=r"there is no cue of this list '12'"):
        find_cue(book_of("1", "12.5"), FIRST_LIST, "12")


def test_what_is_taken_back_and_done_again_is_a_step_of_its_own_in_the_log() -> None:
    book = book_of("1")
    later = edit_cues(book, "label", "Bo", {"c0": Cue("c0", "1", label="Night")}, {})
    back = undo(later, "Cy")
    assert (back.cues, len(back.edits)) == (book.cues, 3)
    assert redo(back, "Di").cues == later.cues
    with pytest.raises(ValueError, match="no edit of cues to do again"):
        redo(later, "Di")
    with pytest.raises(ValueError, match="no edit of cues to take back"):
        undo(undo(undo(later, "Cy"), "Cy"), "Cy")


def test_a_damaged_document_costs_what_it_had() -> None:
    """A cue that cannot be read is left out and said; nothing is taken back across an edit that cannot be read."""
    book = edit_cues(book_of("1", "2"), "label", "Bo", {"c1": Cue("c1", "2", label="Night")}, {})
    stored: dict[str, dict[str, bytes]] = {StoredCue.kind: {}, StoredCueList.kind: {}, CueEdit.kind: {}}
    for change in changes_between(CueBook(), book):
        assert isinstance(change, StoredDocument)
        stored[change.kind][change.name] = change.body
    stored[StoredCue.kind]["c0"] = b'{"cue": {"identity": "c0", "number": "x"}}'
    stored[CueEdit.kind]["00000001"] = b"{"
    read, lost = read_book(stored.__getitem__)
    assert read.cues_of(FIRST_LIST) == (book.cues["c1"],)
    assert [sentence.split(" cannot be read")[0] for sentence in lost] == ["the cue c0", "the edit of cues 00000001"]
    assert read.undone == ([], [])


def test_a_stored_cue_names_what_its_moves_bring() -> None:
    moves = {
        "kaori/face": Move({"dog": 0.5, "old": 0.5}),
        "*/framing": Move({"kaori+rex": 1.0}),
        "*/light": Move({"flat": 1.0}),
    }
    cue = Cue("c", "1", moves)
    named = {"kaori", "rex", "dog", "old"}
    assert {*StoredCue(cue).names()} == named
    assert {*CueEdit("delete", "Ana", cues_before={"c": cue}, cues_after={"c": None}).names()} == named
