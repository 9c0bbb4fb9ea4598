"""Says in plain words what an error of the database means: SQLite's internal texts are for whoever repairs a file."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Iterator, Mapping

from omote.interchange.formats.error_reasons import explain_error

DATABASE_REASONS: Mapping[int, str] = {
    sqlite3.SQLITE_FULL: "the disk is full",
    sqlite3.SQLITE_READONLY: "it is write-protected",
    sqlite3.SQLITE_BUSY: "another program has it open, or its disk does not answer",
    sqlite3.SQLITE_LOCKED: "another program has it open, or its disk does not answer",
    sqlite3.SQLITE_CANTOPEN: "you are not allowed to, or its folder is not there",
    sqlite3.SQLITE_PERM: "you are not allowed to",
    sqlite3.SQLITE_AUTH: "you are not allowed to",
    sqlite3.SQLITE_IOERR: "the disk fails",
    sqlite3.SQLITE_NOMEM: "there is not enough memory",
    sqlite3.SQLITE_TOOBIG: "a part of it is too large",
    sqlite3.SQLITE_CORRUPT: "parts of it are lost or overwritten",
    sqlite3.SQLITE_NOTADB: "its beginning is lost or overwritten",
    sqlite3.SQLITE_CONSTRAINT: "it does not go together with what is there",
    sqlite3.SQLITE_ERROR: "its tables are not those of a show",
}
"""What SQLite's primary result codes (https://sqlite.org/rescode.html) say of a show file."""
LOCKLESS = (
    "its folder cannot hold a show: it has no locks or no memory that programs share, as on network drives and in "
    "synced folders; keep the show on a disk of this machine"
)
"""Why no show can be played in a folder: SQLite and Omote need both."""
LOCKLESS_CODES = frozenset(
    (
        sqlite3.SQLITE_IOERR_LOCK,
        sqlite3.SQLITE_IOERR_RDLOCK,
        sqlite3.SQLITE_IOERR_SHMLOCK,
        sqlite3.SQLITE_IOERR_SHMMAP,
        sqlite3.SQLITE_PROTOCOL,
    )
)
_OTHER = "the database fails"
_PRIMARY = 0xFF


class DamageError(sqlite3.DatabaseError):
    """What is wrong with the rows of a show file, in words that people can read."""


class WrongRowError(sqlite3.IntegrityError):
    """Why a change cannot be made to the rows that are there, in words that people can read."""


def explain_database_error(error: BaseException, /) -> str:
    """What an error means, as a clause without a full stop; `explain_error` for all but SQLite's."""
    if not isinstance(error, sqlite3.Error) or isinstance(error, DamageError | WrongRowError):
        return explain_error(error)
    if isinstance(error, sqlite3.ProgrammingError):
        return "it is closed already"
    code = getattr(error, "sqlite_errorcode", None)  # Python's own, about text that is none, have no code
    if is_lockless(error):
        return LOCKLESS
    return "what it holds cannot be read" if code is None else DATABASE_REASONS.get(code & _PRIMARY, _OTHER)


def is_lockless(error: BaseException, /) -> bool:
    """Whether a folder lacks what programs need to share a file in it."""
    return getattr(error, "sqlite_errorcode", None) in LOCKLESS_CODES


def describe_error(error: BaseException, /) -> str:
    """The whole sentence of an error for a terminal: a system error names its file, SQLite's the show file."""
    if isinstance(error, OSError) and error.errno is not None and error.filename is not None:
        return f"{os.fsdecode(error.filename)} cannot be used: {explain_error(error)}."
    if isinstance(error, sqlite3.Error):
        return f"the show file cannot be used: {explain_database_error(error)}."
    return explain_error(error)


def technical_texts(error: BaseException, /) -> Iterator[str]:
    """The internal texts behind an error, for whoever repairs the file: those of its causes."""
    cause = error.__cause__
    while cause is not None:
        yield str(cause)
        cause = cause.__cause__
