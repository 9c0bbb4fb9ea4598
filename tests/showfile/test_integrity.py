"""A show file is proved without being touched."""

import shutil
import sqlite3
from pathlib import Path

import pytest

from omote.showfile.changes import PutLayout
from omote.showfile.integrity import SHORTEST, check_integrity, open_read_only, prove
from omote.showfile.schema import SCHEMA_VERSION, CorruptShowFileError, ShowFileError
from omote.showfile.show_file import ShowFile, open_show


def filled(path: Path) -> ShowFile:
    """An open show file whose last change is in its log only."""
    show = open_show(path)
    show.apply([PutLayout("console", b"{}")])
    return show


def test_a_whole_file_is_proved_while_it_is_open(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    prove(show.path)
    assert check_integrity(show.path) == SCHEMA_VERSION
    show.close()
    prove(show.path)
    assert [file.name for file in tmp_path.iterdir()] == ["a.omote"]


def test_a_file_that_a_killed_server_left_is_proved_and_keeps_its_log(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    (tmp_path / "killed").mkdir()
    for name in ("a.omote", "a.omote-wal"):
        shutil.copyfile(tmp_path / name, tmp_path / "killed" / name)
    show.close()
    before = {file.name: file.read_bytes() for file in (tmp_path / "killed").iterdir()}
    path = tmp_path / "killed" / "a.omote"
    prove(path)
    connection = open_read_only(path)
    assert connection.execute("SELECT name FROM layout").fetchall() == [("console",)]
    connection.close()
    assert {name: (tmp_path / "killed" / name).read_bytes() for name in before} == before


def test_a_new_file_has_no_version(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    assert check_integrity(path) == 0
    assert not path.exists()
    path.write_bytes(b"")
    assert check_integrity(path) == 0
    with pytest.raises(ShowFileError, match="schema 0; expected"):
        prove(path)


@pytest.mark.parametrize("length", [1, 99, SHORTEST - 1])
def test_a_file_that_is_shorter_than_any_is_corrupt_not_new(tmp_path: Path, length: int) -> None:
    show = filled(tmp_path / "a.omote")
    show.close()
    show.path.write_bytes(show.path.read_bytes()[:length])
    with pytest.raises(CorruptShowFileError, match="cut off"):
        check_integrity(show.path)
    with pytest.raises(CorruptShowFileError, match="cut off"):
        open_show(show.path)
    assert show.path.stat().st_size == length


def test_what_is_no_database_is_corrupt_and_stays(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    path.write_bytes(b"no database" * 100)
    with pytest.raises(CorruptShowFileError, match="not a database"):
        prove(path)
    assert path.read_bytes() == b"no database" * 100


@pytest.mark.parametrize("version", [1, SCHEMA_VERSION])
def test_a_broken_page_is_told_in_one_line(tmp_path: Path, version: int) -> None:
    show = filled(tmp_path / "a.omote")
    show._connection.execute(f"PRAGMA user_version = {version}")
    show.close()
    with show.path.open("r+b") as file:
        file.seek(3 * 4096)
        file.write(b"\xa5" * 4096)
    with pytest.raises(CorruptShowFileError, match=r"Page 4: .*\)\.$") as refused:
        check_integrity(show.path)
    assert "\n" not in str(refused.value)


def test_what_cannot_be_opened_is_said(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    with pytest.raises(ShowFileError, match="cannot be read"):
        check_integrity(tmp_path / "folder")


def test_reading_writes_nothing_and_sees_what_is_committed(tmp_path: Path) -> None:
    show = filled(tmp_path / "a #1?.omote")
    connection = open_read_only(show.path)
    assert connection.execute("SELECT name FROM layout").fetchall() == [("console",)]
    show.apply([PutLayout("other", b"{}")])
    assert len(connection.execute("SELECT name FROM layout").fetchall()) == 2
    with pytest.raises(sqlite3.OperationalError, match="readonly"):
        connection.execute("DELETE FROM layout")
    connection.close()
    show.close()
