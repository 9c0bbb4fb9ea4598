"""Writes authored work beside the show, in order: what is told to be committed is on the disk."""

from __future__ import annotations

import sqlite3
import threading
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from omote.server.persistence.backup_thread import BackupThread
from omote.server.persistence.file_gate import FileGate
from omote.showfile.changes import Change
from omote.showfile.database_errors import explain_database_error
from omote.showfile.show_file import ShowFile

RETRY_SECONDS = 1.0
"""Seconds between two tries to write to a disk that failed."""


@dataclass(frozen=True)
class CommitOutcome:
    """What became of a list of changes.

    "committed": on the disk, for good. "waiting": the disk failed; the changes are kept and tried again, in order, and
    another fate follows. "refused": they will never be made, none of them. sentence: why, where not committed.
    """

    state: Literal["committed", "waiting", "refused"]
    sentence: str = ""


OnOutcome = Callable[[CommitOutcome], None]


@dataclass(frozen=True)
class _Job:
    changes: tuple[Change, ...]
    on_outcome: OnOutcome


class RefusingCommitter:
    """Commits nothing while a show is played from memory; reason: why, as a whole sentence."""

    def __init__(self, reason: str) -> None:
        self._reason = reason

    def commit(self, changes: Sequence[Change], on_outcome: OnOutcome) -> None:  # noqa: ARG002  (as `Committer`)
        """Refuses changes. changes: any; on_outcome: called with that."""
        on_outcome(CommitOutcome("refused", self._reason))

    def close(self) -> None:
        """Does nothing: nothing was taken."""


class CommitThread:
    """A thread that commits lists of changes one after the other.

    show: the thread's own connection (`ShowFile.again`), which it closes. backup: of the same file; nothing is
    committed to a file that it found damaged. gate: passed for each use of the file. committed: called after each
    commit. Outcomes are told on this thread.
    """

    def __init__(
        self,
        show: ShowFile,
        report: Callable[[str], None],
        backup: BackupThread | None = None,
        gate: FileGate | None = None,
        *,
        committed: Callable[[], None] = lambda: None,
        retry_seconds: float = RETRY_SECONDS,
    ) -> None:
        self._show = show
        self._report = report
        self._backup = backup
        self._gate = gate or FileGate()
        self._committed = committed
        self._retry_seconds = retry_seconds
        self._queue: deque[_Job] = deque()
        self._waiting = threading.Condition()
        self._closing = self._failing = False
        self._thread = threading.Thread(target=self._run, name="commits", daemon=True)
        self._thread.start()

    def commit(self, changes: Sequence[Change], on_outcome: OnOutcome) -> None:
        """Hands over changes that belong together; returns at once.

        changes: in any order; on_outcome: called on this thread with what became of them, each time that is known.
        """
        with self._waiting:
            if not self._closing:
                self._queue.append(_Job(tuple(changes), on_outcome))
                self._waiting.notify()
                return
        on_outcome(CommitOutcome("refused", f"{self._show.path} is being closed; start the show again and repeat it."))

    def close(self) -> None:
        """Commits what is left and closes the file; waits five seconds at most."""
        with self._waiting:
            self._closing = True
            self._waiting.notify()
        self._thread.join(timeout=5.0)

    def _run(self) -> None:
        while True:
            with self._waiting:
                self._waiting.wait_for(lambda: self._queue or self._closing)
                if not self._queue:
                    break
                job = self._queue[0]
            self._carry_out(job)
            self._queue.popleft()
        with self._gate:
            self._show.close()

    def _carry_out(self, job: _Job) -> None:
        outcome = self._try_commit(job)
        if outcome.state == "waiting":
            self._tell(job, outcome)
        while outcome.state == "waiting":
            with self._waiting:
                last = self._waiting.wait_for(lambda: self._closing, timeout=self._retry_seconds)
            outcome = self._try_commit(job)
            if last and outcome.state == "waiting":
                outcome = CommitOutcome("refused", outcome.sentence)
        self._tell(job, outcome)

    def _try_commit(self, job: _Job) -> CommitOutcome:
        if self._backup and self._backup.damage:
            return CommitOutcome(
                "refused", f"{self._backup.damage} This is not kept: start the show again, and repeat it."
            )
        try:
            with self._gate:
                self._show.apply(job.changes)
        except sqlite3.OperationalError as error:
            sentence = (
                f"{self._show.path} cannot be written ({explain_database_error(error)}): your work is kept in memory "
                "and tried again."
            )
            if not self._failing:
                self._report(sentence)
            self._failing = True
            return CommitOutcome("waiting", sentence)
        except (sqlite3.Error, ValueError, TypeError, OverflowError) as error:
            reason = explain_database_error(error)
            return CommitOutcome("refused", f"{self._show.path} cannot keep this ({reason}): undo it, or do it again.")
        self._failing = False
        self._committed()
        return CommitOutcome("committed")

    def _tell(self, job: _Job, outcome: CommitOutcome) -> None:
        try:
            job.on_outcome(outcome)
        except RuntimeError:
            pass  # a loop that has ended hears nothing any more
        except Exception as error:  # whatever it is, later changes are still to be kept
            self._report(f"what became of a change ({outcome.state}) could not be told ({type(error).__name__}).")
