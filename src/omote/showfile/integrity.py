"""Reads a show file without writing: whether it is one, whole, and of which version."""

from __future__ import annotations

import contextlib
import sqlite3
from pathlib import Path

from omote.showfile.authored_rows import read_all, read_contents, row_checksum
from omote.showfile.database_errors import DATABASE_REASONS, LOCKLESS, DamageError, explain_database_error, is_lockless
from omote.showfile.identification import reject_foreign
from omote.showfile.schema import AUTHORED_SINCE, CorruptShowFileError, ShowFileError, version_of

SHORTEST = 512
"""Bytes of the smallest database; SQLite takes what is shorter for a new one and writes over it."""


def open_read_only(path: Path, /) -> sqlite3.Connection:
    """A connection that reads a show file and writes nothing, also while a show has it open; sqlite3.Error where there
    is none."""
    # Without a log nobody has it open; SQLite would make an empty one to read, and leave it.
    alone = "" if path.with_name(path.name + "-wal").exists() else "&immutable=1"
    return sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro{alone}", uri=True, timeout=1.0)


def verify_integrity(path: Path, /) -> int:
    """The version of a show file's schema, 0 where it is new or empty, once all in it is proved.

    CorruptShowFileError where it is damaged, ForeignFileError where it was never one, ShowFileError where it cannot be
    used. The file stays as it is: a connection that may write would merge its log on leaving, into a corrupt file too.
    """
    if reject_foreign(path).kind == "missing" or path.stat().st_size == 0:
        return 0
    try:
        with contextlib.closing(open_read_only(path)) as connection:
            return _verified_version(connection, path)
    except sqlite3.DatabaseError as error:
        if is_lockless(error):
            raise ShowFileError(f"{path} cannot be played: {LOCKLESS}.") from error
        if not is_damage(error):
            raise ShowFileError(
                f"{path} cannot be read ({explain_database_error(error)}): mend that, or name another file."
            ) from error
        raise CorruptShowFileError(f"{path} is damaged: {explain_database_error(error)}.") from error
    except UnicodeDecodeError as error:  # SQLite's sentence quotes what should be a table's name
        raise CorruptShowFileError(f"{path} is damaged: parts of it are lost or overwritten.") from error


def is_damage(error: sqlite3.DatabaseError, /) -> bool:
    """Whether the file is at fault: missing tables and text that is no text are SQLITE_ERROR, a disk or a lock is not.

    Python's own errors about what was read have no code.
    """
    code = getattr(error, "sqlite_errorcode", sqlite3.SQLITE_ERROR)
    return not isinstance(error, sqlite3.OperationalError) or code == sqlite3.SQLITE_ERROR


def _verified_version(connection: sqlite3.Connection, path: Path) -> int:
    if path.stat().st_size < SHORTEST:
        raise DamageError("it is cut off")
    version = version_of(connection, path)
    if version:
        (verdict,) = connection.execute("PRAGMA integrity_check(1)").fetchone()
        if verdict != "ok":
            cause = sqlite3.DatabaseError(verdict.splitlines()[-1])  # SQLite's heading stands on a line above it
            raise DamageError(DATABASE_REASONS[sqlite3.SQLITE_CORRUPT]) from cause
    if version >= AUTHORED_SINCE:
        _verify_rows(connection)
    return version


def _verify_rows(connection: sqlite3.Connection) -> None:
    """sqlite3.DatabaseError where the last state or anything authored is not what was written, or belongs to nothing.

    SQLite proves how its pages hang together, not the bytes in them: those are proved by each row's checksum.
    """
    stray = connection.execute("PRAGMA foreign_key_check").fetchone()
    if stray is not None:
        raise DamageError(f"row {stray[1]} of {stray[0]} belongs to no {stray[2]}")
    connection.execute("SELECT epoch, reason, snapshot FROM journal_aside LIMIT 0")
    for epoch, snapshot, sealed, *_ in connection.execute("SELECT epoch, snapshot, sum, slot, written FROM journal"):
        if sealed is not None and row_checksum([epoch, snapshot]) != sealed:  # None: as the first schema left it
            raise DamageError("its last state is damaged")
    read_all(connection)
    for _ in read_contents(connection):
        pass
