"""Backs up the show file beside the show, so that a bad disk costs a minute at most."""

from __future__ import annotations

import sqlite3
import threading
from collections.abc import Callable

from omote.server.persistence.file_gate import FileGate
from omote.showfile.backup import back_up
from omote.showfile.database_errors import explain_database_error
from omote.showfile.schema import CorruptShowFileError, ShowFileError
from omote.showfile.show_file import ShowFile

FIRST_SECONDS = 5.0
"""How long after the start the first backup is made: however often a server is replaced, most get as far."""
BACKUP_SECONDS = 45.0
"""How long after a backup the next is made, where anything has been committed; the rest of the minute is its making."""


class BackupThread:
    """A thread that keeps whole backups of a show file.

    show: the thread's own (`ShowFile.again`); it closes it. damage: why the file is not whole, "" while it is; what is
    committed to a damaged file is in no backup. gate: passed for each use of the file.
    """

    def __init__(
        self,
        show: ShowFile,
        report: Callable[[str], None],
        gate: FileGate | None = None,
        *,
        first_seconds: float = FIRST_SECONDS,
        backup_seconds: float = BACKUP_SECONDS,
    ) -> None:
        self._show = show
        self._report = report
        self._gate = gate or FileGate()
        self._first_seconds = first_seconds
        self._backup_seconds = backup_seconds
        self._closing = threading.Event()
        self._backed_up: tuple[int, int] | None = None
        self._said = self.damage = ""
        self._thread = threading.Thread(target=self._run, name="backup", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Makes the last backup and closes the file; waits five seconds at most."""
        self._closing.set()
        self._thread.join(timeout=5.0)

    def _run(self) -> None:
        wait = self._first_seconds
        while not self._closing.wait(wait):
            self._tried()
            wait = self._backup_seconds
        self._tried()
        with self._gate:
            self._show.close()

    def _tried(self) -> None:
        try:
            with self._gate:
                self._back_up_changes()
            self._said = self.damage = ""
        except CorruptShowFileError as error:
            self.damage = str(error)
            self._say(f"{error} The show goes on, but edits are not kept: start it again to open its good copy.")
        except (sqlite3.Error, OSError, ShowFileError) as error:
            reason = explain_database_error(error).rstrip(".")
            self._say(f"no good copy of {self._show.path} could be made: {reason}. The ones of before stay.")

    def _back_up_changes(self) -> None:
        version = self._show.data_version()
        if version != self._backed_up and back_up(self._show):
            self._backed_up = version

    def _say(self, sentence: str) -> None:
        if sentence != self._said:
            self._report(sentence)
        self._said = sentence
