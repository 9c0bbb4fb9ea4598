"""Authored work comes back as it was put, all or nothing, and nothing damaged is taken for it."""

import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from omote.showfile.authored_rows import TABLES, Table, row_checksum
from omote.showfile.changes import Change, Draft, Edit, Stored, StoredDocument
from omote.showfile.schema import CorruptShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show
from tests.showfile.authored_work import DATA, FIRST, KEYS, AuthoredTables, item, puts, revision


@pytest.fixture
def show(tmp_path: Path) -> Iterator[ShowFile]:
    """A new show file."""
    opened = open_show(tmp_path / "a.omote")
    yield opened
    opened.close()


def test_a_new_file_holds_nothing(show: ShowFile) -> None:
    assert show.stored() == Stored()
    assert show.contents() == {}


def test_what_belongs_together_may_come_in_any_order(show: ShowFile) -> None:
    show.apply(FIRST)
    assert show.stored() == Stored(items=(item(head=1, tags=("wry", "left")),), revisions=(revision(),))
    assert show.contents() == {KEYS[1]: DATA[1]}


@given(st.lists(st.lists(puts, max_size=6), max_size=8))
@settings(max_examples=30, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
def test_a_list_of_changes_is_made_whole_or_not_at_all(tmp_path: Path, lists: list[list[Change]]) -> None:
    (tmp_path / "a.omote").unlink(missing_ok=True)
    show = open_show(tmp_path / "a.omote")
    kept = AuthoredTables()
    for changes in [FIRST, *lists]:
        wanted = kept.copy()
        possible = all(wanted.make(change) for change in changes) and wanted.whole
        if possible:
            show.apply(changes)
            kept = wanted
        else:
            with pytest.raises(sqlite3.IntegrityError):
                show.apply(changes)
        assert show.stored() == kept.stored()
    assert show.contents() == kept.contents
    show.close()
    again = open_show(tmp_path / "a.omote")
    assert again.stored() == kept.stored()
    again.close()


def test_making_the_same_changes_again_does_nothing(show: ShowFile) -> None:
    changes = [*FIRST, Draft(1, "ada", 1, 0), Edit(1, "ada", 0, b"{}", "opened")]
    show.apply(changes)
    before = show.stored()
    show.apply(changes)
    assert show.stored() == before


def test_a_revision_is_never_changed_or_removed(show: ShowFile) -> None:
    show.apply(FIRST)
    with pytest.raises(sqlite3.IntegrityError, match="revision 1 of item 1 is there and is another"):
        show.apply([revision(note="another")])
    other = sqlite3.connect(show.path)
    for statement in ("UPDATE revision SET note = 'x'", "DELETE FROM revision"):
        with pytest.raises(sqlite3.IntegrityError, match="a revision is never"):
            other.execute(statement)
    other.close()
    assert show.stored().revisions == (revision(),)


def test_an_item_keeps_its_name(show: ShowFile) -> None:
    show.apply(FIRST)
    with pytest.raises(sqlite3.IntegrityError, match="keeps its kind and its name for ever"):
        show.apply([item(name="other")])
    with pytest.raises(sqlite3.IntegrityError, match="UNIQUE"):
        show.apply([item(2, name="own-1")])
    show.apply([item(2, name="own-1", kind="face")])  # faces and expressions are called apart


@pytest.mark.parametrize(
    "change",
    [
        item(2, label=None),
        item(2, place="first"),
        item(2, place=float("nan")),
        item(2, kind="hat"),
        item(2**70),
        item(2, label="\ud800"),
        Draft(1, "ada", 0.5, 0),  # type: ignore[arg-type]
        Edit(1, "ada", 0, "text", "no draft"),  # type: ignore[arg-type]
    ],
)
def test_what_could_not_come_back_is_refused(show: ShowFile, change: Change) -> None:
    show.apply(FIRST)
    before = show.stored()
    with pytest.raises((sqlite3.IntegrityError, ValueError, OverflowError)):
        show.apply([StoredDocument("layout", "other", b"{}"), change])
    assert show.stored() == before
    show.apply([StoredDocument("layout", "console", b"{}")])


def test_whole_numbers_given_as_places_come_back(show: ShowFile) -> None:
    for place in (1, -0.0, 2.0**60):
        show.apply([item(place=place)])
        assert show.stored().items[0].place == place


@pytest.mark.parametrize(
    ("statement", "sentence"),
    [
        ("UPDATE item SET label = 'Other'", "its item 1 is damaged"),
        ("UPDATE item SET tags = '['", "its item 1 is damaged"),
        ("UPDATE item SET head = 7", "row 1 of item belongs to no revision"),
        ("UPDATE content SET data = x'00'", f"its content {KEYS[1]} is damaged"),
        ("DELETE FROM content", "row 1 of revision belongs to no content"),
        ("UPDATE draft SET cursor = 5", "its draft 1, ada is damaged"),
        ("UPDATE edit SET recipe = x'00'", "its edit 1, ada, 0 is damaged"),
        ("UPDATE document SET body = x'00'", "its document layout, console is damaged"),
        ("UPDATE item SET label = CAST(x'ff' AS TEXT)", "what it holds cannot be read"),
        ("UPDATE journal SET snapshot = x'00'", "its last state is damaged"),
        ("DROP TABLE document", "its tables are not those of a show"),
        ("DROP TABLE journal_aside", "its tables are not those of a show"),
        ("ALTER TABLE journal DROP COLUMN written", "its tables are not those of a show"),
        ("ALTER TABLE edit DROP COLUMN what", "its tables are not those of a show"),
    ],
)
def test_rows_that_are_not_what_was_written_make_a_file_corrupt(
    tmp_path: Path, statement: str, sentence: str
) -> None:  # fmt: skip
    show = open_show(tmp_path / "a.omote")
    show.apply(
        [
            *FIRST,
            Draft(1, "ada", 1, 0),
            Edit(1, "ada", 0, b"{}", ""),
            StoredDocument("layout", "console", b"{}"),
        ]
    )
    show.write_journal(JournalEntry(1, 0.0, b"state"))
    show.close()
    with sqlite3.connect(tmp_path / "a.omote") as connection:
        connection.execute(statement)
    connection.close()
    with pytest.raises(CorruptShowFileError, match=sentence):
        open_show(tmp_path / "a.omote")


@pytest.mark.parametrize("table", TABLES, ids=lambda table: table.name)
def test_every_column_of_every_row_is_sealed(show: ShowFile, table: Table) -> None:
    draft = Draft(1, "ada", 1, 0)
    edit = Edit(1, "ada", 0, b"{}", "")
    show.apply([*FIRST, draft, edit, StoredDocument("layout", "console", b"{}")])
    connection = show._connection
    connection.execute("PRAGMA foreign_keys = OFF")
    connection.execute("PRAGMA ignore_check_constraints = ON")
    connection.executescript("DROP TRIGGER revisions_are_not_changed; DROP TRIGGER items_keep_their_name;")
    for column in table.columns:
        (value,) = connection.execute(f"SELECT {column} FROM {table.name}").fetchone()
        other = "face" if column == "kind" else value + {int: 1, float: 1.0, str: "x", bytes: b"x"}[type(value)]
        connection.execute(f"UPDATE {table.name} SET {column} = ?", (other,))
        with pytest.raises(sqlite3.DatabaseError, match=f"its {table.name} .* is damaged"):
            show.stored()
        connection.execute(f"UPDATE {table.name} SET {column} = ?", (value,))
        show.stored()


@pytest.mark.parametrize("data", [1, 1.5, "text", b"other"])
def test_only_bytes_are_the_content_of_their_key(show: ShowFile, data: object) -> None:
    show.apply(FIRST)
    connection = show._connection
    connection.executescript("PRAGMA foreign_keys = OFF; DROP TABLE content; CREATE TABLE content (key, data)")
    connection.execute("INSERT INTO content VALUES (?, ?)", (KEYS[1], data))
    with pytest.raises(sqlite3.DatabaseError, match=f"its content {KEYS[1]} is damaged"):
        show.contents()
    connection.execute("UPDATE content SET data = ?", (DATA[1],))
    assert show.contents() == {KEYS[1]: DATA[1]}


@pytest.mark.parametrize("tags", ["none", "[1, 2]", "[" * 100_000])
def test_rows_that_another_program_sealed_over_nonsense_make_a_file_corrupt(tmp_path: Path, tags: str) -> None:
    path = tmp_path / "a.omote"
    opened = open_show(path)
    opened.apply(FIRST)
    opened.close()
    connection = sqlite3.connect(path)
    table = TABLES[0]
    row = connection.execute(f"SELECT {', '.join(table.columns)} FROM {table.name}").fetchone()
    values = [tags if column == "tags" else value for column, value in zip(table.columns, row, strict=True)]
    connection.execute(f"UPDATE {table.name} SET tags = ?, sum = ?", (tags, row_checksum(values)))
    connection.commit()
    connection.close()
    with pytest.raises(CorruptShowFileError, match="item 1 is damaged"):
        open_show(path)
