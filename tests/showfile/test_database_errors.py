"""SQLite's internal texts are turned into words."""

import errno
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from omote.showfile.database_errors import (
    DATABASE_REASONS,
    LOCKLESS,
    DamageError,
    describe_error,
    explain_database_error,
    technical_texts,
)


def test_each_code_has_its_words_extended_or_not() -> None:
    for code, reason in DATABASE_REASONS.items():
        for extended in (0, 1 << 8, 33 << 8):
            error = sqlite3.OperationalError("internal text")
            error.sqlite_errorcode = code | extended
            assert explain_database_error(error) == reason


def test_real_errors_come_without_their_texts(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"noise" * 500)
    for address, statement in ((f"file:{tmp_path}/a?mode=ro", "SELECT * FROM a"), ("file::memory:", "SELECT * FROM a")):
        with closing(sqlite3.connect(address, uri=True)) as connection:
            with pytest.raises(sqlite3.Error) as raised:
                connection.execute(statement)
            assert explain_database_error(raised.value) in DATABASE_REASONS.values()
    with pytest.raises(sqlite3.ProgrammingError) as closed:
        connection.execute("SELECT 1")
    assert explain_database_error(closed.value) == "it is closed already"


def test_our_own_words_and_other_errors_come_through() -> None:
    assert explain_database_error(DamageError("its item 1 is damaged")) == "its item 1 is damaged"
    assert explain_database_error(OSError(errno.ENOSPC, "No space left on device")) == "the disk is full"
    assert explain_database_error(sqlite3.OperationalError("Could not decode")) == "what it holds cannot be read"


def test_the_texts_behind_an_error_are_there_for_whoever_repairs_the_file() -> None:
    inner = DamageError("parts of it are lost")
    inner.__cause__ = sqlite3.DatabaseError("btreeInitPage() returns error code 11")
    outer = RuntimeError("a.omote is damaged")
    outer.__cause__ = inner
    assert list(technical_texts(outer)) == ["parts of it are lost", "btreeInitPage() returns error code 11"]


def test_a_real_error_of_the_system_is_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(OSError) as raised:  # noqa: PT011  (whichever it is)
        (tmp_path / "none").read_bytes()
    assert describe_error(raised.value) == f"{tmp_path / 'none'} cannot be used: it is not there."


def test_whatever_a_command_ends_with_is_a_sentence() -> None:
    error = OSError(errno.EACCES, "Permission denied", "/somewhere/a.omote")
    assert describe_error(error) == "/somewhere/a.omote cannot be used: you are not allowed to."
    busy = sqlite3.OperationalError("database is locked")
    busy.sqlite_errorcode = sqlite3.SQLITE_BUSY
    assert (
        describe_error(busy)
        == "the show file cannot be used: another program has it open, or its disk does not answer."
    )
    assert describe_error(ValueError("a face is missing")) == "a face is missing"


def test_a_folder_whose_files_cannot_be_shared_is_named_as_the_reason() -> None:
    error = sqlite3.OperationalError("disk I/O error")
    error.sqlite_errorcode = sqlite3.SQLITE_IOERR_SHMMAP
    assert explain_database_error(error) == LOCKLESS
    error.sqlite_errorcode = sqlite3.SQLITE_IOERR_WRITE
    assert explain_database_error(error) == "the disk fails"
