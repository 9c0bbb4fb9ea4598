"""The state of all authored work in memory; it changes only by the changes that the show file commits."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec.structs import replace

from omote.showfile.changes import (
    Change,
    Content,
    ContentRemoval,
    DocumentRemoval,
    Documents,
    Draft,
    Edit,
    Item,
    Revision,
    Stored,
    StoredDocument,
)

DraftKey = tuple[int, str]
"""An item and an editor."""


class AuthoredState:
    """Items, their revisions, drafts and the drafts' edits; `apply` mirrors what the show file does."""

    def __init__(self, stored: Stored) -> None:
        self.items = {item.id: item for item in stored.items}
        self.revisions: dict[int, dict[int, Revision]] = {}
        for revision in sorted(stored.revisions, key=lambda revision: (revision.item, revision.number)):
            self.revisions.setdefault(revision.item, {})[revision.number] = revision
        self.edits = _complete_steps(stored.edits)
        self.drafts = {
            key: replace(draft, cursor=min(draft.cursor, len(self.edits[key]) - 1))
            for draft in stored.drafts
            if (key := (draft.item, draft.editor)) in self.edits
        }
        self.documents: Documents = {kind: dict(named) for kind, named in stored.documents.items()}

    def apply(self, changes: Iterable[Change]) -> None:
        """Applies changes, in order."""
        for change in changes:
            self._apply(change)

    def stored(self) -> Stored:
        """All rows, sorted by their keys."""
        return Stored(
            items=tuple(self.items[number] for number in sorted(self.items)),
            revisions=tuple(r for item in sorted(self.revisions) for _, r in sorted(self.revisions[item].items())),
            drafts=tuple(self.drafts[key] for key in sorted(self.drafts)),
            edits=tuple(edit for key in sorted(self.edits) for edit in self.edits[key]),
            documents=self.documents,
        )

    def head(self, item: Item) -> Revision | None:
        """The revision that plays, None before the first save."""
        return self.revisions.get(item.id, {}).get(item.head)

    def last_number(self, item: int) -> int:
        """The highest number of a revision of the item, 0 for none."""
        return max(self.revisions.get(item, {0: None}))

    def shown_edit(self, key: DraftKey) -> Edit:
        """The step of a draft that its cursor is at."""
        return self.edits[key][self.drafts[key].cursor]

    def new_item(self) -> int:
        """An unused id: items are never removed."""
        return max(self.items, default=0) + 1

    def new_place(self) -> float:
        """A place behind all items."""
        return max((item.place for item in self.items.values()), default=0.0) + 1.0

    def find(self, name: str) -> Item | None:
        """The item of this name, deleted or not."""
        return next((item for item in self.items.values() if item.name == name), None)

    def _apply(self, change: Change) -> None:
        match change:
            case Item():
                self.items[change.id] = change
            case Revision():
                if change.number in self.revisions.setdefault(change.item, {}):
                    raise ValueError(f"revision {change.number} is there already; expected a new number")
                self.revisions[change.item][change.number] = change
            case Draft():
                self.drafts[change.item, change.editor] = change
            case Edit():
                steps = self.edits.setdefault((change.item, change.editor), [])
                steps[change.number :] = [change]
            case Content() | ContentRemoval():
                pass  # bytes are in the content store
            case _:
                self._apply_to_documents(change)

    def _apply_to_documents(self, change: StoredDocument | DocumentRemoval) -> None:
        named = self.documents.setdefault(change.kind, {})
        named.pop(change.name, None)
        if isinstance(change, StoredDocument):
            named[change.name] = change.body
        elif not named:
            del self.documents[change.kind]


def _complete_steps(edits: Iterable[Edit]) -> dict[DraftKey, list[Edit]]:
    """The steps of each draft from 0 up to where, in a damaged file, the first is missing."""
    by_draft: dict[DraftKey, list[Edit]] = {}
    for edit in sorted(edits, key=lambda edit: edit.number):
        steps = by_draft.get((edit.item, edit.editor), [])
        if edit.number == len(steps):
            by_draft.setdefault((edit.item, edit.editor), steps).append(edit)
    return by_draft
