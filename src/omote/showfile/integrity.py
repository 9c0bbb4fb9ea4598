"""Reads a show file without writing: whether it is one, whole, and of which version."""

from __future__ import annotations

import sqlite3
from pathlib import Path

from omote.showfile.authored_rows import refuse_damaged
from omote.showfile.schema import SCHEMA_VERSION, CorruptShowFileError, ShowFileError, refuse_without_tables, version_of

SHORTEST = 512
"""Bytes of the smallest database; SQLite takes what is shorter for a new one and writes over it."""


def open_read_only(path: Path, /) -> sqlite3.Connection:
    """A connection that reads a show file and writes nothing, also while a show has it open; sqlite3.Error where there
    is none."""
    # Without a log nobody has it open; SQLite would make an empty one to read, and leave it.
    alone = "" if path.with_name(path.name + "-wal").exists() else "&immutable=1"
    return sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro{alone}", uri=True, timeout=1.0)


def check_integrity(path: Path, /) -> int:
    """The version of a show file's schema, 0 where it is new or empty, once all in it is proved.

    CorruptShowFileError where it is damaged, ShowFileError where it cannot be used. The file stays as it is: a
    connection that may write would merge its log on leaving, into a corrupt file too.
    """
    if not path.exists() or path.stat().st_size == 0:
        return 0
    try:
        connection = open_read_only(path)
        try:
            return _version(connection, path)
        finally:
            connection.close()
    except sqlite3.OperationalError as error:
        raise ShowFileError(f"{path} cannot be read ({error}); name another file or make it readable.") from error
    except sqlite3.DatabaseError as error:
        raise CorruptShowFileError(f"{path} is no readable show file ({error}).") from error


def prove(path: Path, /) -> None:
    """ShowFileError with a sentence where a file is no whole show file of this version; it is not touched."""
    version = check_integrity(path)
    if version != SCHEMA_VERSION:
        raise ShowFileError(f"{path} has schema {version}; expected {SCHEMA_VERSION}.")


def _version(connection: sqlite3.Connection, path: Path) -> int:
    if path.stat().st_size < SHORTEST:
        raise sqlite3.DatabaseError("it is cut off")
    version = version_of(connection, path)
    if version == SCHEMA_VERSION:
        refuse_without_tables(connection)
        refuse_damaged(connection)
    elif version:
        (verdict,) = connection.execute("PRAGMA quick_check(1)").fetchone()
        if verdict != "ok":
            raise sqlite3.DatabaseError(verdict.splitlines()[-1])
    return version
