"""The authored work of a show file, open: the session that knows it, and whoever keeps what it changes."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from omote.edit.session.edit_session import EditSession
from omote.server.persistence.commit_thread import CommitOutcome
from omote.server.workers.order_worker import OrderWorker
from omote.showfile.changes import Change
from omote.showfile.show_file import ShowFile


class Committer(Protocol):
    """Whoever keeps changes (`scribe.Scribe`)."""

    def commit(self, changes: Sequence[Change], told: Callable[[CommitOutcome], None]) -> None:
        """Keeps changes together; tells, from a thread of its own, what became of them."""

    def close(self) -> None:
        """Keeps what is left."""


@dataclass(frozen=True)
class AuthoredWork:
    """What editors work at; layouts: pages' documents (JSON) by name."""

    session: EditSession
    committer: Committer
    layouts: dict[str, bytes]


def open_authored_work(
    show: ShowFile, committer: Committer, worker: OrderWorker, report: Callable[[str], None]
) -> AuthoredWork | None:
    """The desk of a show file; None, and the operator is told, when its authored work cannot be read."""
    try:
        stored, contents = show.stored(), show.contents()
    except sqlite3.Error as error:
        report(f"the authored work in {show.path} cannot be read ({error}); the show goes on without it.")
        return None
    session = EditSession(worker.cast, stored, contents, net=worker.net, welcome=worker.welcome)
    return AuthoredWork(session, committer, dict(stored.layouts))
