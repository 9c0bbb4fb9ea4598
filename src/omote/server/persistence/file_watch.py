"""Watches where the show file lies: one that is moved, renamed, deleted or replaced during the show is made anew."""

from __future__ import annotations

import contextlib
import sqlite3
import threading
import time
from collections.abc import Callable
from pathlib import Path

from omote.server.persistence.file_gate import FileGate
from omote.server.persistence.lock import ShowLockedError, take_lock
from omote.showfile.database_errors import explain_database_error
from omote.showfile.relocation import relocate_show
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import ShowFile

WATCH_SECONDS = 1.0
"""Seconds between two looks; what is done between a move and the next look is lost only if all ends before it."""


class FileWatch:
    """A thread that looks whether the show file is in its place, and makes it anew from the open one where it is not.

    gate: all who use the file pass it; moved: called with the path from which the show is to be opened from then on.
    """

    def __init__(
        self,
        show: ShowFile,
        gate: FileGate,
        report: Callable[[str], None],
        moved: Callable[[Path], None],
        *,
        watch_seconds: float = WATCH_SECONDS,
    ) -> None:
        self._show = show
        self._gate = gate
        self._report = report
        self._moved = moved
        self._said = ""
        self._watch_seconds = watch_seconds
        self._closing = threading.Event()
        hold_lock(show.path)  # made anew elsewhere by the process before
        self._thread = threading.Thread(target=self._run, name="file-watch", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Looks for the last time; waits five seconds at most."""
        self._closing.set()
        self._thread.join(timeout=5.0)

    def _run(self) -> None:
        while not self._closing.wait(self._watch_seconds):
            self._look()
        self._look()

    def _look(self) -> None:
        try:
            if not self._show.place.is_kept():
                self._relocate()
            elif self._said:
                self._report(f"{self._show.path} is in its place again.")
                self._said = ""
        except OSError:
            pass  # the disk does not say what lies there; whoever writes reports that it fails

    def _relocate(self) -> None:
        path = self._show.path
        try:
            with self._gate.alone():
                now = relocate_show(self._show)
        except (sqlite3.Error, OSError, ShowFileError) as error:
            return self._report_failure(f"{_lost(path)}, and cannot be made anew ({explain_database_error(error)})")
        self._said = ""
        hold_lock(now)
        self._moved(now)
        self._report(_sentence_of(path, now))
        return None

    def _report_failure(self, what: str) -> None:
        if not self._said:
            self._report(
                f"{what}: what is done now is written to the file as it was opened, wherever it lies, and lost when "
                "the show's process ends. Put the file back soon."
            )
        self._said = what


def hold_lock(path: Path) -> None:
    """Locks a show file until this process ends, where the supervisor's lock does not hold for it."""
    with contextlib.suppress(ShowLockedError, ShowFileError):
        take_lock(path)


def _lost(path: Path) -> str:
    return f"{path} was moved, renamed, deleted or replaced during the show"


def _sentence_of(path: Path, now: Path) -> str:
    if now != path:
        return (
            f"another file took the place of {path} during the show; it stays as it is. The show and all work go on in "
            f"{now.name} beside it, which has everything: open that one next time."
        )
    at = time.strftime("%H:%M:%S", time.localtime())
    return (
        f"{_lost(path)}. It was made anew there at {at} with everything in it, and the show and all work go on in it; "
        "a moved file keeps what was there until then."
    )
