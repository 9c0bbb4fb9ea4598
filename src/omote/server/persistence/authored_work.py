"""The authored work of an open show file: the edit session, and the thread that commits its changes."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from omote.edit.session.edit_session import EditSession
from omote.server.persistence.commit_thread import CommitOutcome
from omote.server.workers.order_worker import OrderWorker
from omote.showfile.changes import Change, DocumentRemoval, StoredDocument
from omote.showfile.database_errors import explain_database_error
from omote.showfile.show_file import ShowFile


class Committer(Protocol):
    """Commits changes (`commit_thread.CommitThread`)."""

    def commit(self, changes: Sequence[Change], on_outcome: Callable[[CommitOutcome], None]) -> None:
        """Commits changes together; calls `on_outcome` with what became of them, from another thread."""

    def close(self) -> None:
        """Commits what is left."""


@dataclass(frozen=True)
class AuthoredWork:
    """The edit session and its committer."""

    session: EditSession
    committer: Committer

    def documents(self, kind: str) -> Mapping[str, bytes]:
        """The documents (JSON) of a kind (`show.objects`) by name."""
        return self.session.authored.state.documents.get(kind, {})

    def keep_documents(self, changes: Sequence[Change], report: Callable[[str], None]) -> None:
        """Commits documents together, with the contents that they need, beside the show.

        changes: what is put, and what goes; report: told on the terminal where that cannot be kept.
        """
        self.session.authored.state.apply(changes)
        documents = [change for change in changes if isinstance(change, StoredDocument | DocumentRemoval)]
        kinds = ", ".join(sorted({change.kind for change in documents}))

        def report_outcome(outcome: CommitOutcome) -> None:
            if outcome.state == "refused":
                report(f"a change of {kinds} documents is not kept: {outcome.sentence}")

        self.committer.commit(changes, report_outcome)


def open_authored_work(
    show: ShowFile, committer: Committer, worker: OrderWorker, report: Callable[[str], None]
) -> AuthoredWork | None:
    """Reads the authored work of a show file; None, with a report to the operator, when it cannot be read.

    show: the open file; committer: commits its changes; worker: bakes what editors make, with the built-in cast;
    report: tells the operator.
    """
    try:
        stored = show.stored()
        contents = show.contents()
        identity = show.identity()
    except sqlite3.Error as error:
        report(
            f"the own faces and expressions in {show.path} cannot be read ({explain_database_error(error)}); the show "
            "goes on without them."
        )
        return None
    session = EditSession(worker.cast, stored, contents, net=worker.net, welcome=worker.welcome)
    session.show = identity
    return AuthoredWork(session, committer)
