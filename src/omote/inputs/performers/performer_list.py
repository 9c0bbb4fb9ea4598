"""The performers of a show file: how their faces are read, by name; every change can be undone."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import msgspec

from omote.inputs.trackers.tracker_frame import LONGEST_SUBJECT, trim_subject
from omote.perform.limits import check_known
from omote.show.objects.documents import read_document
from omote.show.objects.performers import StoredPerformer

MOST_PERFORMERS = 64
MOST_UNDOS = 20
LONGEST_DOCUMENT = 2**20
Keep = Callable[[Mapping[str, bytes], list[str]], None]
"""Stores documents by name, and forgets the names that are gone."""


class PerformerList:
    """Performers by name. stored: their documents; keep: stores what has changed."""

    def __init__(self, stored: Mapping[str, bytes], keep: Keep) -> None:
        self._documents = dict(stored)
        self._keep = keep
        self._undo: list[tuple[str, dict[str, bytes]]] = []

    @property
    def names(self) -> list[str]:
        """All performers, sorted."""
        return sorted(self._documents, key=str.casefold)

    @property
    def documents(self) -> Mapping[str, bytes]:
        """What is stored of each, by name."""
        return self._documents

    @property
    def undo_label(self) -> str:
        """What an undo takes back, in words; "" for nothing."""
        return self._undo[-1][0] if self._undo else ""

    def find(self, name: str) -> StoredPerformer | None:
        """How a performer's face is read; None for one that is unknown, ValueError for what cannot be read."""
        document = self._documents.get(name)
        if document is None:
            return None
        try:
            return read_document(StoredPerformer, document)
        except ValueError as error:
            raise ValueError(
                f"what is stored of {name} cannot be read ({error}); make the guided minute again"
            ) from error

    def store(self, name: str, calibration: bytes, *, guided: bool) -> None:
        """Stores how a performer's face is read (JSON); ValueError where there is no room for it.

        name: the performer's; calibration: its document; guided: whether it is of the guided minute.
        """
        document = StoredPerformer(msgspec.Raw(calibration), guided).encode()
        if len(document) > LONGEST_DOCUMENT:
            raise ValueError(f"a calibration of {len(document)} bytes is too long; at most {LONGEST_DOCUMENT} are kept")
        if name not in self._documents and len(self._documents) >= MOST_PERFORMERS:
            raise ValueError(f"the show knows {MOST_PERFORMERS} performers already; delete one")
        self._change(f"the calibration of {name}", {**self._documents, name: document})

    def rename(self, name: str, other: str) -> None:
        """Gives a performer the name `other`; ValueError for one that is unknown, or where somebody has that name."""
        check_known(name, self._documents, "performer")
        if other in self._documents:
            raise ValueError(f"{other} is a performer already; choose another name, or delete that one")
        renamed = {other if key == name else key: document for key, document in self._documents.items()}
        self._change(f"the new name of {name}", renamed)

    def delete(self, name: str) -> None:
        """Forgets a performer; ValueError for one that is unknown."""
        check_known(name, self._documents, "performer")
        self._change(f"the deletion of {name}", {k: document for k, document in self._documents.items() if k != name})

    def undo(self) -> None:
        """Takes the last change back; ValueError where there is none."""
        if not self._undo:
            raise ValueError("there is nothing to undo")
        _, before = self._undo.pop()
        self._store(before)

    def _change(self, label: str, documents: dict[str, bytes]) -> None:
        self._undo = [*self._undo, (label, self._documents)][-MOST_UNDOS:]
        self._store(documents)

    def _store(self, documents: dict[str, bytes]) -> None:
        gone = [name for name in self._documents if name not in documents]
        changed = {name: document for name, document in documents.items() if self._documents.get(name) != document}
        self._documents = documents
        self._keep(changed, gone)


def check_performer_name(typed: str) -> str:
    """A performer's name as it is shown and stored; ValueError for one without a letter."""
    name = trim_subject(typed)
    if not name:
        raise ValueError(f"a performer is called {typed[:20]!r}; give a name of 1 to {LONGEST_SUBJECT} letters")
    return name
