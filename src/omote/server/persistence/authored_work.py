"""The authored work of an open show file: the edit session, and the thread that commits its changes."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from omote.edit.session.edit_session import EditSession
from omote.server.persistence.commit_thread import CommitOutcome
from omote.server.workers.order_worker import OrderWorker
from omote.showfile.changes import Change, DropPerformer, PutBindings, PutPerformer
from omote.showfile.database_errors import explain_database_error
from omote.showfile.show_file import ShowFile


class Committer(Protocol):
    """Commits changes (`commit_thread.CommitThread`)."""

    def commit(self, changes: Sequence[Change], told: Callable[[CommitOutcome], None]) -> None:
        """Commits changes together; calls `told` with the outcome, from another thread."""

    def close(self) -> None:
        """Commits what is left."""


@dataclass(frozen=True)
class AuthoredWork:
    """The edit session and its committer."""

    session: EditSession
    committer: Committer

    @property
    def layouts(self) -> Mapping[str, bytes]:
        """The pages' layouts (JSON) by name."""
        return self.session.authored.state.layouts

    @property
    def bindings(self) -> bytes:
        """What controls of devices play (JSON); nothing where nothing has been bound yet."""
        return self.session.authored.state.bindings

    def keep_bindings(self, document: bytes, report: Callable[[str], None]) -> None:
        """Commits what controls of devices play; report: says on the terminal where it cannot be kept."""
        self._keep([PutBindings(document)], "a binding", report)

    @property
    def performers(self) -> Mapping[str, bytes]:
        """How the faces of performers are read (JSON), by their names."""
        return self.session.authored.state.performers

    def keep_performers(
        self, documents: Mapping[str, bytes], dropped: Iterable[str], report: Callable[[str], None]
    ) -> None:
        """Commits how the faces of performers are read, and who is known no more; report: as above."""
        changes: list[Change] = [*map(DropPerformer, dropped), *(PutPerformer(*each) for each in documents.items())]
        self._keep(changes, "a performer's calibration", report)

    def _keep(self, changes: Sequence[Change], what: str, report: Callable[[str], None]) -> None:
        self.session.authored.state.apply(changes)

        def report_outcome(outcome: CommitOutcome) -> None:
            if outcome.state == "refused":
                report(f"{what} is not kept: {outcome.sentence}")

        self.committer.commit(changes, report_outcome)


def open_authored_work(
    show: ShowFile, committer: Committer, worker: OrderWorker, report: Callable[[str], None]
) -> AuthoredWork | None:
    """Reads the authored work of a show file; None, with a report to the operator, when it cannot be read."""
    try:
        stored, contents, identity = show.stored(), show.contents(), show.identity()
    except sqlite3.Error as error:
        report(
            f"the own faces and expressions in {show.path} cannot be read ({explain_database_error(error)}); the show "
            "goes on without them."
        )
        return None
    session = EditSession(worker.cast, stored, contents, net=worker.net, welcome=worker.welcome)
    session.show = identity
    return AuthoredWork(session, committer)
