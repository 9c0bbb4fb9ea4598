"""Performers of a show: stored, renamed, deleted, each of these undone; what cannot be is rejected."""

from collections.abc import Callable, Mapping

import pytest

from omote.inputs.performers.performer_list import (
    LONGEST_DOCUMENT,
    MOST_PERFORMERS,
    MOST_UNDOS,
    PerformerList,
    check_performer_name,
)


class File:
    """What a show file would hold."""

    def __init__(self) -> None:
        self.documents: dict[str, bytes] = {}

    def keep(self, documents: Mapping[str, bytes], gone: list[str]) -> None:
        for name in gone:
            del self.documents[name]
        self.documents.update(documents)


@pytest.fixture
def file() -> File:
    return File()


@pytest.fixture
def performers(file: File) -> PerformerList:
    made = PerformerList({}, file.keep)
    made.store("Ada", b'{"a":1}', guided=True)
    return made


def test_what_is_stored_is_found_also_by_the_next_server(performers: PerformerList, file: File) -> None:
    document = PerformerList(file.documents, file.keep).find("Ada")
    assert document is not None
    assert (bytes(document.calibration), document.guided) == (b'{"a":1}', True)
    assert performers.find("Bo") is None


def test_every_change_is_stored_and_undone(performers: PerformerList, file: File) -> None:
    states = [dict(file.documents)]
    performers.store("Bo", b"2", guided=False)
    states.append(dict(file.documents))
    performers.rename("Ada", "Cy")
    assert performers.names == ["Bo", "Cy"]
    states.append(dict(file.documents))
    performers.delete("Bo")
    assert performers.names == ["Cy"]
    assert performers.undo_label == "the deletion of Bo"
    while performers.undo_label:
        performers.undo()
        assert file.documents == (states.pop() if states else {}) == dict(performers.documents)
    with pytest.raises(ValueError, match="nothing to undo"):
        performers.undo()


def test_only_the_last_changes_can_be_undone(performers: PerformerList) -> None:
    for count in range(2 * MOST_UNDOS):
        performers.store("Ada", str(count).encode(), guided=True)
    for _ in range(MOST_UNDOS):
        performers.undo()
    assert performers.undo_label == ""
    assert performers.find("Ada") is not None


def test_what_cannot_be_changed_is_rejected_and_stays(performers: PerformerList, file: File) -> None:
    performers.store("Bo", b"2", guided=False)
    before = dict(file.documents)
    cases: tuple[tuple[Callable[[], None], str], ...] = (
        (lambda: performers.rename("Nobody", "Cy"), "no performer 'Nobody'"),
        (lambda: performers.rename("Ada", "Bo"), "Bo is a performer already"),
        (lambda: performers.delete("Nobody"), "no performer 'Nobody'"),
        (lambda: performers.store("Ada", b'"' + b"x" * LONGEST_DOCUMENT + b'"', guided=True), "too long"),
    )
    for wrong, reason in cases:
        with pytest.raises(ValueError, match=reason):
            wrong()
    assert file.documents == before


def test_a_show_knows_so_many_performers_at_most(performers: PerformerList) -> None:
    for number in range(MOST_PERFORMERS - 1):
        performers.store(f"p{number}", b"1", guided=False)
    with pytest.raises(ValueError, match="delete one"):
        performers.store("one too many", b"1", guided=False)
    performers.store("Ada", b"1", guided=False)


def test_a_document_that_is_damaged_is_said(file: File) -> None:
    with pytest.raises(ValueError, match=r"stored of Ada cannot be read .* guided minute again"):
        PerformerList({"Ada": b"{"}, file.keep).find("Ada")


def test_a_name_is_trimmed_and_one_without_letters_is_rejected() -> None:
    assert check_performer_name("  Ada\n") == "Ada"
    with pytest.raises(ValueError, match="give a name of 1 to 40 letters"):
        check_performer_name(" \t ")
