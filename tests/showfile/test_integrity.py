"""A show file is proved without being touched."""

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from omote.showfile.changes import StoredDocument
from omote.showfile.database_errors import technical_texts
from omote.showfile.identification import ForeignFileError
from omote.showfile.integrity import SHORTEST, open_read_only, verify_integrity
from omote.showfile.schema import SCHEMA_VERSION, CorruptShowFileError
from omote.showfile.show_file import ShowFile, open_show


def filled(path: Path) -> ShowFile:
    """An open show file whose last change is in its log only."""
    show = open_show(path)
    show.apply([StoredDocument("layout", "console", b"{}")])
    return show


def test_a_whole_file_is_proved_while_it_is_open(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    assert verify_integrity(show.path) == SCHEMA_VERSION
    show.close()
    assert verify_integrity(show.path) == SCHEMA_VERSION
    assert [file.name for file in tmp_path.iterdir()] == ["a.omote"]


def test_a_file_that_a_killed_server_left_is_proved_and_keeps_its_log(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    (tmp_path / "killed").mkdir()
    for name in ("a.omote", "a.omote-wal"):
        shutil.copyfile(tmp_path / name, tmp_path / "killed" / name)
    show.close()
    before = {file.name: file.read_bytes() for file in (tmp_path / "killed").iterdir()}
    path = tmp_path / "killed" / "a.omote"
    verify_integrity(path)
    connection = open_read_only(path)
    assert connection.execute("SELECT name FROM document").fetchall() == [("console",)]
    connection.close()
    assert {name: (tmp_path / "killed" / name).read_bytes() for name in before} == before


def test_a_new_file_has_no_version(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    assert verify_integrity(path) == 0
    assert not path.exists()
    path.write_bytes(b"")
    assert verify_integrity(path) == 0


@pytest.mark.parametrize("length", [1, 99, SHORTEST - 1])
def test_a_file_that_is_shorter_than_any_is_corrupt_not_new(tmp_path: Path, length: int) -> None:
    show = filled(tmp_path / "a.omote")
    show.close()
    show.path.write_bytes(show.path.read_bytes()[:length])
    with pytest.raises(CorruptShowFileError, match="cut off"):
        verify_integrity(show.path)
    with pytest.raises(CorruptShowFileError, match="cut off"):
        open_show(show.path)
    assert show.path.stat().st_size == length


def test_what_is_no_database_is_rejected_and_stays(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    path.write_bytes(b"no database" * 100)
    with pytest.raises(ForeignFileError, match="is a text file, not a show"):
        verify_integrity(path)
    assert path.read_bytes() == b"no database" * 100


@pytest.mark.parametrize("version", [1, SCHEMA_VERSION])
def test_a_broken_page_is_told_in_words_and_what_sqlite_found_is_kept(tmp_path: Path, version: int) -> None:
    show = filled(tmp_path / "a.omote")
    show._connection.execute(f"PRAGMA user_version = {version}")
    show.close()
    with show.path.open("r+b") as file:
        file.seek(3 * 4096)
        file.write(b"\xa5" * 4096)
    with pytest.raises(CorruptShowFileError, match=r"is damaged: parts of it are lost or overwritten\.$") as refused:
        verify_integrity(show.path)
    assert any("Page 4" in text for text in technical_texts(refused.value))


def test_what_cannot_be_opened_is_said(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    with pytest.raises(ForeignFileError, match="is a folder, not a show"):
        verify_integrity(tmp_path / "folder")


def test_reading_writes_nothing_and_sees_what_is_committed(tmp_path: Path) -> None:
    show = filled(tmp_path / "a #1?.omote")
    connection = open_read_only(show.path)
    assert connection.execute("SELECT name FROM document").fetchall() == [("console",)]
    show.apply([StoredDocument("layout", "other", b"{}")])
    assert len(connection.execute("SELECT name FROM document").fetchall()) == 2
    with pytest.raises(sqlite3.OperationalError, match="readonly"):
        connection.execute("DELETE FROM document")
    connection.close()
    show.close()


@pytest.mark.parametrize("byte", [b"\x00", b"\xa5", b"\xff"])
def test_a_file_that_lost_any_page_is_corrupt(tmp_path: Path, byte: bytes) -> None:
    """Also one of its tables' names and columns, which stand in SQLite's sentences: what is no text is none of them."""
    path = tmp_path / "a.omote"
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA page_size = 512")
        connection.execute("PRAGMA journal_mode = WAL")
    show = filled(path)
    show.close()
    whole = path.read_bytes()
    for start in range(0, len(whole), 512):
        path.write_bytes(whole[:start] + byte * 512 + whole[start + 512 :])
        with pytest.raises(CorruptShowFileError, match="is damaged"):
            verify_integrity(path)
