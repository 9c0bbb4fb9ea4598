"""Opens the show file of a server that takes over, without waiting for a disk that does not answer."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass
from pathlib import Path

from omote.server.persistence.lock import probe_disk
from omote.server.persistence.memory_copy import bring_newest, find_copy, open_copy
from omote.server.persistence.restore import Report, open_journal
from omote.server.process.process_messages import Order
from omote.showfile.show_file import ShowFile

DISK_SECONDS = 0.3
"""Seconds in which a disk must answer at all before the copy in memory is played."""


@dataclass(frozen=True)
class OpenedShow:
    """The show file of a server; `file` is None where nothing can be kept.

    back: done once the disk answers again, where `file` is the copy in memory; else None. away: why nothing can be
    committed then, as a whole sentence.
    """

    file: ShowFile | None
    back: Future[ShowFile | None] | None = None
    away: str = ""

    @property
    def on_disk(self) -> ShowFile | None:
        """The file itself; None where there is none, or its disk is away."""
        return self.file if self.back is None else None


def open_in_time(show: Path, order: Order, report: Report, *, seconds: float = DISK_SECONDS) -> OpenedShow:
    """Opens a show file; a server that takes the place of another one plays the copy in memory where the disk does not
    answer. A disk that answers is waited for, however long the file takes.

    show: its path; order: of the supervisor; report: tells the operator; seconds: in which the disk must answer.
    """
    copy = find_copy(show)
    if order.failover is None or copy is None:
        return OpenedShow(open_journal(show, report))

    def open_newest_state() -> ShowFile | None:
        file = open_journal(show, report)
        if file is not None:
            bring_newest(file, copy)
        return file

    opening = _begin(open_newest_state)
    answering = _begin(lambda: probe_disk(show))
    wait([opening, answering], timeout=seconds, return_when=FIRST_COMPLETED)
    if not opening.done() and not answering.done() and (kept := open_copy(copy, show)) is not None:
        report(
            f"the disk of {show} does not answer: the show goes on from memory, and takes no edits and files until the "
            "disk is back."
        )
        return OpenedShow(kept, opening, f"the disk of {show} does not answer: repeat this when it is back.")
    return OpenedShow(opening.result())


def _begin(work: Callable[[], ShowFile | None]) -> Future[ShowFile | None]:
    """Begins something in a thread that nobody waits for at the end."""
    future: Future[ShowFile | None] = Future()

    def run() -> None:
        try:
            future.set_result(work())
        except BaseException as error:
            future.set_exception(error)

    threading.Thread(target=run, name="disk", daemon=True).start()
    return future
