"""Writes the journal (the show's newest state) in a thread: a slow or broken disk never delays a tick."""

from __future__ import annotations

import sqlite3
import threading
import time
from collections.abc import Callable
from functools import partial

from omote.server.persistence.file_gate import FileGate
from omote.server.process.notice_board import CrewReport
from omote.showfile.database_errors import explain_database_error
from omote.showfile.show_file import JournalEntry, ShowFile

SYNC_SECONDS = 0.1
"""Seconds between two syncs of the log, after which the journal survives a loss of power."""
FLUSH_SECONDS = 1.0
"""Seconds between two times that the log is merged into the file, so that it stays short."""
STALL_SECONDS = 3.0
"""After which a disk that has not taken a write counts as stalled, and the crew is told."""


class JournalWriter:
    """Writes the newest state in a thread; older states that it could not write in time are dropped.

    A second thread syncs the log: that takes a disk tens of milliseconds, and a state must not wait for it. A third one
    merges the log, which takes tenths of a second, for which no sync waits. gate: passed for each use of the file;
    solved: told when the file is written again, and of what that solves. sqlite3.Error where the file cannot be opened
    a second time.
    """

    def __init__(
        self,
        show: ShowFile,
        report: Callable[[str], None],
        gate: FileGate | None = None,
        *,
        solved: CrewReport | None = None,
        sync_seconds: float = SYNC_SECONDS,
        flush_seconds: float = FLUSH_SECONDS,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._show = show
        self._report = report
        self._solved = solved
        self._gate = gate or FileGate()
        with self._gate:  # now: once the threads run, the file may be moved away at any time
            self._flushed = show.again()
        self._newest: JournalEntry | None = None
        self._closing = False
        self._waiting = threading.Condition()
        self._failure = ""
        self._failing: set[int] = set()
        self._stalled = False
        self._clock = clock
        self._under_way: dict[int, float] = {}
        self._flush_seconds = flush_seconds
        self._unsynced = threading.Event()
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._run, name="journal", daemon=True)
        self._flusher = threading.Thread(target=self._flush, name="journal-flush", daemon=True)
        syncing = threading.Thread(target=self._sync, args=(sync_seconds,), name="journal-sync", daemon=True)
        for thread in (self._thread, self._flusher, syncing):
            thread.start()

    def offer(self, entry: JournalEntry) -> None:
        """Queues the newest state, and tells the operator when the disk stalls; returns at once."""
        with self._waiting:
            self._newest = entry
            self._waiting.notify()
        began = list(self._under_way.values())
        stalled = bool(began) and self._clock() - min(began) > STALL_SECONDS
        if stalled and not self._stalled:
            self._report(
                f"the disk of {self._show.path} does not answer: the show goes on, and what changes waits in memory."
            )
        elif self._stalled and not began:
            self._report(f"the disk of {self._show.path} answers again.")
        self._stalled = stalled or (self._stalled and bool(began))

    def close(self) -> None:
        """Writes what is left and closes the file; waits two seconds at most."""
        with self._waiting:
            self._closing = True
            self._waiting.notify()
        self._thread.join(timeout=2.0)
        self._flusher.join(timeout=2.0)

    def _run(self) -> None:
        while True:
            with self._waiting:
                self._waiting.wait_for(lambda: self._newest is not None or self._closing)
                entry = self._newest
                self._newest = None
            if entry is None:
                break
            self._try_write(partial(self._show.write_journal, entry))
            self._unsynced.set()
        self._done.set()
        with self._gate:
            self._show.close()

    def _sync(self, seconds: float) -> None:
        while not self._done.wait(seconds):
            if self._unsynced.is_set():
                self._unsynced.clear()
                self._try_write(self._show.sync_log)

    def _flush(self) -> None:
        while not self._done.wait(self._flush_seconds):
            self._try_write(self._flushed.flush)
        with self._gate:
            self._flushed.close()

    def _try_write(self, work: Callable[[], None]) -> None:
        """Writes, and tells the operator when no thread could and when all can again."""
        me = threading.get_ident()
        self._under_way[me] = self._clock()
        try:
            with self._gate:
                work()
        except (sqlite3.Error, OSError) as error:
            self._failing.add(me)
            if not self._failure:
                self._failure = (
                    f"{self._show.path} cannot be written ({explain_database_error(error)}): the show goes on, but if "
                    "its process ends, what has changed since is not restored. Mend that soon."
                )
                self._report(self._failure)
        else:
            self._note_success(me)
        finally:
            del self._under_way[me]

    def _note_success(self, thread: int) -> None:
        self._failing.discard(thread)
        if self._failing or not self._failure:
            return
        failure = self._failure
        self._failure = ""
        if self._solved is not None:
            self._solved(f"{self._show.path} is written again: what has changed is kept.", failure)
