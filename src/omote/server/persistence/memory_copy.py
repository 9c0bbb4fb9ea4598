"""A copy of the show file in memory: a server that takes over while the disk does not answer plays from it.

Linux keeps what lies in `/dev/shm` in memory; elsewhere there is no copy. The file is copied after commits of authored
work, the newest state is written beside it with each entry of the journal. What is edited while the disk is away is
refused: the copy is never written back.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import sqlite3
import stat
import threading
from collections.abc import Callable
from pathlib import Path

import msgspec

from omote.server.persistence.file_gate import FileGate
from omote.showfile.database_errors import explain_database_error
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

MEMORY = Path("/dev/shm")
COPY_SECONDS = 1.0
"""Seconds at least between two copies of the file, while somebody edits."""
BESIDE = ("-wal", "-shm")


def find_copy(show: Path, memory: Path = MEMORY) -> Path | None:
    """Where the copy of a show file is; None where this system has no files in memory that we alone may read.

    show: the path of the file, links followed; memory: a folder whose files are in memory.
    """
    folder = memory / f"omote-{os.getuid()}"
    with contextlib.suppress(OSError):
        if memory.is_dir():
            folder.mkdir(mode=0o700, exist_ok=True)
            status = folder.lstat()
            if stat.S_ISDIR(status.st_mode) and status.st_uid == os.getuid() and status.st_mode & 0o077 == 0:
                return folder / f"{hashlib.blake2b(os.fsencode(show), digest_size=16).hexdigest()}.omote"
    return None


def remove_copy(copy: Path) -> None:
    """Removes a copy and its state."""
    for path in (copy, _state_path(copy), *_drafts(copy), *(copy.with_name(copy.name + name) for name in BESIDE)):
        path.unlink(missing_ok=True)


def read_state(copy: Path) -> JournalEntry | None:
    """The newest state beside a copy; None where there is none."""
    try:
        return msgspec.msgpack.decode(_state_path(copy).read_bytes(), type=JournalEntry)
    except (OSError, msgspec.DecodeError):
        return None


def open_copy(copy: Path, show: Path) -> ShowFile | None:
    """Opens a copy, with the newest state in its journal; None where there is none that can be used.

    show: where the file itself belongs, links followed.
    """
    if not copy.exists():
        return None
    try:
        file = open_show(copy)
        file.place.home = show
        bring_newest(file, copy)
    except (OSError, sqlite3.Error, ShowFileError):
        return None
    return file


def bring_newest(file: ShowFile, copy: Path) -> None:
    """Puts the state beside a copy into a file's journal where it is newer than what is there. sqlite3.Error."""
    state = read_state(copy)
    if state is None:
        return
    last = file.journal()
    if (state.epoch, state.written) > (last.epoch, last.written):
        file.write_journal(state)


class MemoryCopy:
    """Keeps the copy of an open show file, in threads.

    copy: where (`find_copy`); show: the threads' own (`ShowFile.again`), which they close, None while a server plays
    from the copy: then the state alone is written. gate: passed for each use of the file.
    """

    def __init__(
        self, copy: Path, show: ShowFile | None, report: Callable[[str], None], gate: FileGate | None = None
    ) -> None:
        self._copy = copy
        self._show = show
        self._report = report
        self._gate = gate or FileGate()
        self._newest: JournalEntry | None = None
        self._changed = threading.Condition()
        self._committed = threading.Event()
        self._closing = self._removed = self._said = False
        self._threads = [threading.Thread(target=self._write_states, name="memory-state", daemon=True)]
        if show is not None:
            self._committed.set()
            self._threads.append(threading.Thread(target=self._copy_commits, name="memory-copy", daemon=True))
        for thread in self._threads:
            thread.start()

    def offer(self, entry: JournalEntry) -> None:
        """Queues the newest state; returns at once."""
        with self._changed:
            self._newest = entry
            self._changed.notify_all()

    def note_commit(self) -> None:
        """Notes that authored work was committed: the file is copied again."""
        self._committed.set()

    def close(self) -> None:
        """Ends the threads; waits two seconds at most."""
        with self._changed:
            self._closing = True
            self._changed.notify_all()
        self._committed.set()
        for thread in self._threads:
            thread.join(timeout=2.0)
        if self._removed:
            remove_copy(self._copy)

    def remove(self) -> None:
        """Removes the copy when it is closed: the show ends, and nobody takes over."""
        self._removed = True

    def _write_states(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._newest is not None or self._closing)
                entry = self._newest
                self._newest = None
            if entry is None:
                return
            draft = _drafts(self._copy)[0]
            try:
                _write(draft, msgspec.msgpack.encode(entry))
                draft.replace(_state_path(self._copy))
            except OSError as error:
                self._say(error)

    def _copy_commits(self) -> None:
        assert self._show is not None
        while self._committed.wait() and not self._closing:
            self._committed.clear()
            try:
                with self._gate:
                    self._copy_file(self._show)
            except (OSError, sqlite3.Error) as error:
                self._say(error)
            with self._changed:
                self._changed.wait_for(lambda: self._closing, timeout=COPY_SECONDS)
        with self._gate:
            self._show.close()

    def _copy_file(self, show: ShowFile) -> None:
        draft = _drafts(self._copy)[1]
        draft.unlink(missing_ok=True)
        show.copy_into(draft)
        for name in BESIDE:  # of a server that played from the copy
            self._copy.with_name(self._copy.name + name).unlink(missing_ok=True)
        draft.replace(self._copy)

    def _say(self, error: BaseException) -> None:
        if not self._said:
            self._report(
                f"the show cannot be copied into memory ({explain_database_error(error)}): it goes on, but if its disk "
                "stops answering and its process ends too, it waits for the disk."
            )
        self._said = True


def _state_path(copy: Path) -> Path:
    return copy.with_suffix(".state")


def _drafts(copy: Path) -> tuple[Path, Path]:
    """Where the next state and the next copy are made."""
    return copy.with_suffix(".state-draft"), copy.with_suffix(".draft")


def _write(path: Path, data: bytes) -> None:
    with os.fdopen(os.open(path, os.O_CREAT | os.O_WRONLY | os.O_TRUNC, 0o600), "wb") as file:
        file.write(data)
