"""The show file: one SQLite file (`.omote`) with the journal of the live state and all authored work.

The journal is one row that is overwritten, so the file stays small. In WAL mode every commit survives the death of the
process; authored work survives a loss of power at once, the journal from the next `sync_log` or `flush` on.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import shutil
import sqlite3
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from omote.showfile.authored_rows import apply_changes, read_all, read_contents, row_checksum
from omote.showfile.changes import Change, Stored
from omote.showfile.database_errors import LOCKLESS, DamageError, explain_database_error, is_lockless
from omote.showfile.identification import require_show
from omote.showfile.integrity import verify_integrity
from omote.showfile.schema import CorruptShowFileError, ShowFileError, migrate

__all__ = ["CorruptShowFileError", "JournalEntry", "ShowFile", "ShowFileError", "default_path", "open_show"]

ASIDE_LIMIT = 20
"""Snapshots kept that no server could start from; older ones are deleted."""

_sync = getattr(os, "fdatasync", os.fsync)

HIGHEST_EPOCH = 2**53
"""Epochs are numbers in the browser too; beyond this they would not be told apart."""


FileId = tuple[int, int]
"""Device and number of a file on it: a file keeps them when it is renamed, another one in its place has others."""


@dataclass(eq=False)
class FilePlace:
    """Where an open show file lies, and which files of the disk it and its log are (None: not known).

    moves: how often it was made anew; opened: all connections to it; home: where a copy belongs, links followed, None
    for what is none.
    """

    path: Path
    file: FileId | None = None
    log: FileId | None = None
    moves: int = 0
    opened: list[ShowFile] = field(default_factory=list)
    home: Path | None = None

    @property
    def log_path(self) -> Path:
        """Where its write-ahead log belongs."""
        return self.path.with_name(self.path.name + "-wal")

    def remember(self) -> None:
        """Remembers what lies there now as what is open."""
        self.file = identify_file(self.path)
        self.log = identify_file(self.log_path)

    def is_kept(self) -> bool:
        """Whether what is open lies there still; OSError where the disk does not say."""
        self.log = self.log or identify_file(self.log_path)  # made by the first commit, and there until the end
        return (identify_file(self.path), identify_file(self.log_path)) == (self.file, self.log)


def identify_file(path: Path, /) -> FileId | None:
    """Which file of the disk lies at a path, None where there is none; OSError where the disk does not say."""
    try:
        status = path.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    return status.st_dev, status.st_ino


@dataclass(frozen=True)
class JournalEntry:
    """The last state of a show: under which epoch, at what monotonic time (s) it was written, the snapshot if any."""

    epoch: int
    written: float
    snapshot: bytes | None


class ShowFile:
    """An open show file; made by `open_show`. place: shared by all that `again` opens."""

    def __init__(self, connection: sqlite3.Connection, place: FilePlace) -> None:
        self._connection = connection
        self._flushed: tuple[int, int] | None = None
        self.place = place
        place.opened.append(self)

    @property
    def path(self) -> Path:
        """Where it lies."""
        return self.place.path

    def stored(self) -> Stored:
        """All authored work but the contents' bytes; sqlite3.Error where it cannot be read."""
        return read_all(self._connection)

    def contents(self) -> dict[str, bytes]:
        """Every content's bytes (`showfile.contents`) by key; sqlite3.Error where they cannot be read."""
        return dict(read_contents(self._connection))

    def apply(self, changes: Iterable[Change]) -> None:
        """Commits authored changes, all or none; they survive a loss of power when it returns.

        sqlite3.OperationalError: not now; any other sqlite3.Error, ValueError or OverflowError: never.
        """
        self._connection.execute("PRAGMA synchronous = FULL")
        try:
            apply_changes(self._connection, changes)
        finally:
            with contextlib.suppress(sqlite3.Error):
                self._connection.execute("PRAGMA synchronous = NORMAL")

    def erase(self, removals: Iterable[tuple[str, Sequence[str | int]]]) -> None:
        """Makes statements that remove rows, all or none, and writes the file anew: nothing of them is left in it.

        No other connection may be open. sqlite3.Error where that cannot be: what is not removed is there.
        """
        for setting in ("secure_delete = ON", "temp_store = MEMORY", "synchronous = FULL"):
            self._connection.execute(f"PRAGMA {setting}").fetchone()
        with self._connection:
            self._connection.execute("BEGIN IMMEDIATE")
            guards = self._connection.execute("SELECT name, sql FROM sqlite_schema WHERE type = 'trigger'").fetchall()
            for name, _ in guards:  # they keep revisions from being removed
                self._connection.execute(f'DROP TRIGGER "{name}"')
            for statement, values in removals:
                self._connection.execute(statement, values)
            for _, guard in guards:
                self._connection.execute(guard)
        self._connection.execute("VACUUM")
        self.merge_log()

    def identity(self) -> str:
        """Which show this is, hexadecimal: another one has another, a copy of the file elsewhere too.

        sqlite3.Error where it cannot be read.
        """
        (own,) = self._connection.execute("SELECT id FROM identity").fetchone() or ("",)
        where = os.fsencode(self.place.home or os.path.realpath(self.path))
        return hashlib.blake2b(f"{own} ".encode() + where, digest_size=8).hexdigest()

    def journal(self) -> JournalEntry:
        """The last state; epoch 0 and no snapshot in a new file. sqlite3.Error where it cannot be read."""
        row = self._connection.execute("SELECT epoch, written, snapshot FROM journal").fetchone()
        entry = JournalEntry(*row) if row else JournalEntry(epoch=0, written=0.0, snapshot=None)
        if not isinstance(entry.epoch, int) or not 0 <= entry.epoch <= HIGHEST_EPOCH:
            raise DamageError(f"its epoch {entry.epoch} was written by no server")
        return entry

    def write_journal(self, entry: JournalEntry) -> None:
        """Replaces the last state; returns when it is committed."""
        with self._connection:
            self._connection.execute(
                "INSERT OR REPLACE INTO journal (slot, epoch, written, snapshot, sum) VALUES (1, ?, ?, ?, ?)",
                (entry.epoch, entry.written, entry.snapshot, row_checksum([entry.epoch, entry.snapshot])),
            )

    def set_aside(self, entry: JournalEntry, reason: str) -> None:
        """Keeps a snapshot that no server could start from, and leaves the journal without one.

        entry: the last state; reason: why, for people.
        """
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
        """Opens the same file a second time, for another thread; sqlite3.OperationalError where it is not there."""
        if not self.place.is_kept():
            raise sqlite3.OperationalError("the file is not in its place")
        return ShowFile(_configured(_connect(self.path)), self.place)

    def follow(self, path: Path) -> None:
        """Goes on with another file of the same contents, and so do all that `again` opened; none may be in use.

        sqlite3.Error where that cannot be opened: all go on with the old one.
        """
        place = self.place
        connections = list[sqlite3.Connection]()
        try:
            for _ in place.opened:
                connections.append(_configured(_connect(path)))
        except sqlite3.Error:
            for connection in connections:
                connection.close()
            raise
        place.path = path
        place.moves = place.moves + 1
        place.remember()
        for file, connection in zip(place.opened, connections, strict=True):
            file._connection.close()
            file._connection = connection
            file._flushed = None

    def merge_log(self) -> None:
        """Writes all commits of the log into the file itself, as far as no other program reads it."""
        self._connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()

    def sync_log(self) -> None:
        """Waits until what was committed so far is on the disk, and survives a loss of power; from any thread.

        It lies in the log then; nothing is merged. Nothing where the log was moved away. OSError where the disk fails.
        """
        with contextlib.suppress(FileNotFoundError):
            sync_to_disk(self.place.log_path, _sync)  # SQLite has no lock on it, which closing it would drop

    def flush(self) -> None:
        """Flushes to the disk, so that all commits survive a loss of power, and merges the log.

        Only where another connection has committed since the last time: a checkpoint that has nothing to do, while a
        commit begins the log anew, can lose that commit (SQLite before 3.51.3, "the WAL-reset bug").
        """
        if self.data_version() == self._flushed:
            return
        self._connection.execute("PRAGMA wal_checkpoint(PASSIVE)").fetchone()
        self._flushed = self.data_version()

    def data_version(self) -> tuple[int, int]:
        """Numbers that are others after another connection has committed (SQLite's `data_version`)."""
        (version,) = self._connection.execute("PRAGMA data_version").fetchone()
        return self.place.moves, int(version)

    def copy_into(self, path: Path) -> None:
        """Copies the file as it is now, log and all, into a new file without a log; others may write meanwhile."""
        make_private(path)
        copy = sqlite3.connect(path)
        try:
            copy.execute("PRAGMA synchronous = OFF")  # whoever puts it in place syncs it whole
            self._connection.backup(copy)
            copy.execute("PRAGMA journal_mode = DELETE").fetchone()
        finally:
            copy.close()
        with contextlib.suppress(FileNotFoundError):  # it was moved away; the copy stays private
            shutil.copymode(self.place.path, path)

    def close(self) -> None:
        """Closes the file; its write-ahead log is merged."""
        self._connection.close()
        if self in self.place.opened:
            self.place.opened.remove(self)


def open_show(path: Path) -> ShowFile:
    """Opens the show file at `path`, or makes it; ShowFileError when it cannot be used."""
    require_show(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        version = verify_integrity(path)
        if not path.exists():
            make_private(path)
        connection = _connect(path)
    except (OSError, sqlite3.Error) as error:
        raise ShowFileError(f"{path} cannot be opened ({explain_database_error(error)}); name another file.") from error
    try:
        _configure(connection)
        migrate(connection, version)
    except sqlite3.OperationalError as error:
        connection.close()
        if is_lockless(error):
            raise ShowFileError(f"{path} cannot be played: {LOCKLESS}.") from error
        raise ShowFileError(
            f"{path} cannot be written ({explain_database_error(error)}): mend that, or name another file."
        ) from error
    except sqlite3.DatabaseError as error:
        connection.close()
        raise CorruptShowFileError(f"{path} is damaged: {explain_database_error(error)}.") from error
    place = FilePlace(path)
    place.remember()
    return ShowFile(connection, place)


def write_new_show(path: Path, changes: Iterable[Change], /) -> None:
    """Makes a show file that holds what changes add, whole or not at all; ShowFileError, OSError or sqlite3.Error where
    it cannot be. It survives a loss of power when this returns.

    path: where nothing lies yet; changes: to an empty show.
    """
    with tempfile.TemporaryDirectory(dir=path.parent) as folder:
        made = Path(folder) / path.name
        show = open_show(made)
        try:
            show.apply(changes)
            show.merge_log()  # to close it merges too, but says nothing where the disk is full
        finally:
            show.close()
        made.rename(path)
    sync_to_disk(path.absolute().parent)


def default_path(environment: Mapping[str, str] = os.environ) -> Path:
    """The path of the show file where none is named: in the user's state directory."""
    state = environment.get("XDG_STATE_HOME") or environment.get("LOCALAPPDATA")
    folder = Path(state) if state else Path.home() / ".local" / "state"
    return folder / "omote" / "show.omote"


def make_private(path: Path) -> None:
    """Makes an empty file that its owner alone may read: faces are those of people. Nothing where there is one. OSError
    where it cannot be made.

    What is there is not even opened: to close it would drop all locks that SQLite has of it in this process.
    """
    with contextlib.suppress(FileExistsError):
        os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600))


def sync_to_disk(path: Path, sync: Callable[[int], None] | None = None) -> None:
    """Waits until a file, or the names in a folder, survive a loss of power; OSError where the disk fails.

    path: of the file, or of the folder; sync: what waits, given the open file; None for `os.fsync`.
    """
    descriptor = os.open(path, os.O_RDONLY)
    try:
        (sync or os.fsync)(descriptor)
    finally:
        os.close(descriptor)


def _connect(path: Path) -> sqlite3.Connection:
    return sqlite3.connect(path, timeout=1.0, check_same_thread=False)


def _configured(connection: sqlite3.Connection) -> sqlite3.Connection:
    try:
        _configure(connection)
    except sqlite3.Error:
        connection.close()
        raise
    return connection


def _configure(connection: sqlite3.Connection) -> None:
    connection.execute("PRAGMA journal_mode = WAL").fetchone()
    connection.execute("PRAGMA foreign_keys = ON")
    connection.execute("PRAGMA synchronous = NORMAL")
    connection.execute("SELECT 1 FROM sqlite_schema").fetchone()  # opens the log, by its name: later it may be gone
