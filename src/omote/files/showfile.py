"""The show file: one SQLite file (`.omote`); its first table is the journal of the live state.

The journal is one row that is written over and over, so the file stays small. In WAL mode a commit survives the death
of the process at once, and the loss of power from the next `flush` on.
"""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

APPLICATION_ID = 0x4F4D4F54  # "OMOT"
SCHEMA_VERSION = 1
SCHEMA = """
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
ASIDE_LIMIT = 20
"""Snapshots kept that no server could start from; older ones go."""

HIGHEST_EPOCH = 2**53
"""Epochs are numbers in the browser too; beyond this they would not be told apart."""


class ShowFileError(RuntimeError):
    """The show file cannot be used, and why, in one sentence; the file is untouched."""


class CorruptShowFileError(ShowFileError):
    """The file is no readable show file."""


@dataclass(frozen=True)
class JournalEntry:
    """The last state of a show: under which epoch, at what monotonic time (s) it was written, the snapshot if any."""

    epoch: int
    written: float
    snapshot: bytes | None


class ShowFile:
    """An open show file; made by `open_show`."""

    def __init__(self, connection: sqlite3.Connection, path: Path) -> None:
        self._connection = connection
        self.path = path

    def journal(self) -> JournalEntry:
        """The last state; epoch 0 and no snapshot in a new file. sqlite3.Error where it cannot be read."""
        row = self._connection.execute("SELECT epoch, written, snapshot FROM journal").fetchone()
        entry = JournalEntry(*row) if row else JournalEntry(epoch=0, written=0.0, snapshot=None)
        if not 0 <= entry.epoch <= HIGHEST_EPOCH:
            raise sqlite3.DatabaseError(f"its epoch {entry.epoch} was written by no server")
        return entry

    def write_journal(self, entry: JournalEntry) -> None:
        """Replaces the last state; returns when it is committed."""
        with self._connection:
            self._connection.execute(
                "INSERT OR REPLACE INTO journal (slot, epoch, written, snapshot) VALUES (1, ?, ?, ?)",
                (entry.epoch, entry.written, entry.snapshot),
            )

    def set_aside(self, entry: JournalEntry, reason: str) -> None:
        """Keeps a snapshot that no server could start from, and leaves the journal without one."""
        with self._connection:
            if entry.snapshot is not None:
                values = (entry.epoch, reason, entry.snapshot)
                self._connection.execute("INSERT OR REPLACE INTO journal_aside VALUES (?, ?, ?)", values)
            self._connection.execute(
                "DELETE FROM journal_aside WHERE epoch NOT IN "
                "(SELECT epoch FROM journal_aside ORDER BY epoch DESC LIMIT ?)",
                (ASIDE_LIMIT,),
            )
            self._connection.execute("UPDATE journal SET snapshot = NULL")

    def again(self) -> ShowFile:
        """The same file opened a second time, for a thread that flushes while another writes."""
        return ShowFile(sqlite3.connect(self.path, timeout=1.0, check_same_thread=False), self.path)

    def flush(self) -> None:
        """Makes all that is committed survive a loss of power."""
        self._connection.execute("PRAGMA wal_checkpoint(PASSIVE)").fetchone()

    def close(self) -> None:
        """Closes the file; its write-ahead log is merged."""
        self._connection.close()


def open_show(path: Path) -> ShowFile:
    """The show file at `path`, made when there is none; ShowFileError when it cannot be used."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        connection = sqlite3.connect(path, timeout=1.0, check_same_thread=False)
    except (OSError, sqlite3.Error) as error:
        raise ShowFileError(f"{path} cannot be opened ({error}); name another file.") from error
    try:
        _check(connection, path)
        _prepare(connection)
    except sqlite3.OperationalError as error:
        connection.close()
        raise ShowFileError(f"{path} cannot be written ({error}); name another file or make it writable.") from error
    except sqlite3.DatabaseError as error:
        connection.close()
        raise CorruptShowFileError(f"{path} is no readable show file ({error}).") from error
    except ShowFileError:
        connection.close()
        raise
    return ShowFile(connection, path)


def move_aside(path: Path) -> Path:
    """Renames a corrupt show file, and its log, to the first free `<name>.corrupt-<n>`; gives the new path."""
    number = 1
    while (kept := path.with_name(f"{path.name}.corrupt-{number}")).exists():
        number += 1
    path.rename(kept)
    for suffix in ("-wal", "-shm"):
        log = path.with_name(path.name + suffix)
        if log.exists():
            log.rename(kept.with_name(kept.name + suffix))
    return kept


def default_path(environment: Mapping[str, str] = os.environ) -> Path:
    """Where a show without a file keeps its journal: the user's state directory."""
    state = environment.get("XDG_STATE_HOME") or environment.get("LOCALAPPDATA")
    folder = Path(state) if state else Path.home() / ".local" / "state"
    return folder / "omote" / "show.omote"


def _check(connection: sqlite3.Connection, path: Path) -> None:
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_schema").fetchone()
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if tables == 0 and application == 0 and version == 0:
        return
    if application != APPLICATION_ID:
        raise ShowFileError(f"{path} is a database, but not of Omote; name another file.")
    if version > SCHEMA_VERSION:
        raise ShowFileError(
            f"{path} was written by a newer Omote (schema {version}, this one reads up to {SCHEMA_VERSION}); "
            "update Omote."
        )
    (verdict,) = connection.execute("PRAGMA quick_check(1)").fetchone()
    if verdict != "ok":
        raise sqlite3.DatabaseError(verdict)


def _prepare(connection: sqlite3.Connection) -> None:
    connection.execute("PRAGMA journal_mode = WAL").fetchone()
    connection.execute("PRAGMA synchronous = NORMAL")
    connection.execute("PRAGMA foreign_keys = ON")
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    if version == 0:
        connection.executescript(
            f"BEGIN; PRAGMA application_id = {APPLICATION_ID}; PRAGMA user_version = {SCHEMA_VERSION}; {SCHEMA} COMMIT;"
        )
    try:
        connection.execute("SELECT slot, epoch, written, snapshot FROM journal").fetchone()
        connection.execute("SELECT epoch, reason, snapshot FROM journal_aside").fetchone()
    except sqlite3.OperationalError as error:
        if "no such" not in str(error):
            raise
        raise sqlite3.DatabaseError(str(error)) from error
