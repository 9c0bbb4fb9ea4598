"""Old files are read for ever, newer ones refused, and a migration is all or nothing."""

import sqlite3
from pathlib import Path

import pytest

from omote.showfile import schema
from omote.showfile.schema import APPLICATION_ID, SCHEMA_VERSION, CorruptShowFileError, ShowFileError
from omote.showfile.show_file import open_show

FIRST_VERSION = """
CREATE TABLE journal (
    slot INTEGER PRIMARY KEY CHECK (slot = 1),
    epoch INTEGER NOT NULL,
    written REAL NOT NULL,
    snapshot BLOB
) STRICT;
CREATE TABLE journal_aside (
    epoch INTEGER PRIMARY KEY,
    reason TEXT NOT NULL,
    snapshot BLOB NOT NULL
) STRICT;
"""
"""As Omote wrote it until the editor came; never changed."""


@pytest.fixture
def first(tmp_path: Path) -> Path:
    """A show file of version 1, with a state and one set aside."""
    path = tmp_path / "old.omote"
    connection = sqlite3.connect(path)
    connection.execute("PRAGMA journal_mode = WAL").fetchone()
    connection.executescript(
        f"BEGIN; PRAGMA application_id = {APPLICATION_ID}; PRAGMA user_version = 1; {FIRST_VERSION} COMMIT;"
    )
    connection.execute("INSERT INTO journal VALUES (1, 1234, 5.5, x'0102')")
    connection.execute("INSERT INTO journal_aside VALUES (1200, 'it crashed', x'03')")
    connection.commit()
    connection.close()
    return path


def version(path: Path) -> int:
    """What the header says."""
    connection = sqlite3.connect(path)
    (found,) = connection.execute("PRAGMA user_version").fetchone()
    connection.close()
    return int(found)


def test_a_file_brought_up_has_the_tables_of_a_new_one(first: Path, tmp_path: Path) -> None:
    def tables(path: Path) -> list[tuple[str, str]]:
        open_show(path).close()
        connection = sqlite3.connect(path)
        found = connection.execute("SELECT name, sql FROM sqlite_schema ORDER BY name").fetchall()
        connection.close()
        return found

    assert tables(first) == tables(tmp_path / "new.omote")


def test_a_migration_that_fails_leaves_the_old_version(first: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = (schema.MIGRATIONS[0], schema.MIGRATIONS[1] + "INSERT INTO item VALUES (1);")
    monkeypatch.setattr(schema, "MIGRATIONS", broken)
    with pytest.raises(ShowFileError):
        open_show(first)
    monkeypatch.undo()
    assert version(first) == 1
    show = open_show(first)
    assert show.journal().epoch == 1234
    show.close()


def test_a_first_version_without_its_tables_is_corrupt(first: Path) -> None:
    with sqlite3.connect(first) as connection:
        connection.execute("DROP TABLE journal")
    connection.close()
    with pytest.raises(CorruptShowFileError, match="its tables are not those of"):
        open_show(first)


@pytest.mark.parametrize("beyond", [1, 1000])
def test_a_newer_version_is_refused_untouched(tmp_path: Path, beyond: int) -> None:
    path = tmp_path / "a.omote"
    open_show(path).close()
    with sqlite3.connect(path) as connection:
        connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION + beyond}")
    connection.close()
    before = path.read_bytes()
    sentence = rf"schema {SCHEMA_VERSION + beyond}, this one reads up to {SCHEMA_VERSION}\); update Omote"
    with pytest.raises(ShowFileError, match=sentence) as refused:
        open_show(path)
    assert not isinstance(refused.value, CorruptShowFileError)
    assert path.read_bytes() == before
    assert [file.name for file in tmp_path.iterdir()] == ["a.omote"]


def test_a_version_that_no_omote_wrote_is_corrupt(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    open_show(path).close()
    with sqlite3.connect(path) as connection:
        connection.execute("PRAGMA user_version = -1")
    connection.close()
    with pytest.raises(CorruptShowFileError, match="schema -1 was written by no Omote"):
        open_show(path)
