"""The authored work of a show file, open: the session that knows it, and whoever keeps what it changes."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from omote.edit.session.edit_session import EditSession
from omote.server.persistence.commit_thread import Fate
from omote.server.workers.order_worker import Bench
from omote.showfile.changes import Change
from omote.showfile.show_file import ShowFile


class Keeper(Protocol):
    """Whoever keeps changes (`scribe.Scribe`)."""

    def commit(self, changes: Sequence[Change], told: Callable[[Fate], None]) -> None:
        """Keeps changes together; tells, from a thread of its own, what became of them."""

    def close(self) -> None:
        """Keeps what is left."""


@dataclass(frozen=True)
class Desk:
    """What editors work at; layouts: pages' documents (JSON) by name."""

    session: EditSession
    keeper: Keeper
    layouts: dict[str, bytes]


def open_desk(show: ShowFile, keeper: Keeper, bench: Bench, report: Callable[[str], None]) -> Desk | None:
    """The desk of a show file; None, and the operator is told, when its authored work cannot be read."""
    try:
        stored, contents = show.stored(), show.contents()
    except sqlite3.Error as error:
        report(f"the authored work in {show.path} cannot be read ({error}); the show goes on without it.")
        return None
    session = EditSession(bench.cast, stored, contents, net=bench.net, welcome=bench.welcome)
    return Desk(session, keeper, dict(stored.layouts))
