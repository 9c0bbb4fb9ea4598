"""The state of all authored work in memory; it changes only by the changes that the show file commits."""

from __future__ import annotations

from collections.abc import Iterable
from functools import singledispatchmethod

from msgspec.structs import replace

from omote.showfile.changes import (
    Change,
    DropDraft,
    DropLayout,
    DropPerformer,
    Edit,
    Item,
    PutBindings,
    PutContent,
    PutDraft,
    PutEdit,
    PutItem,
    PutLayout,
    PutPerformer,
    PutRevision,
    Revision,
    Stored,
)

DraftKey = tuple[int, str]
"""An item and an editor."""


class AuthoredState:
    """Items, their revisions, drafts and the drafts' edits; `apply` mirrors what the show file does."""

    def __init__(self, stored: Stored) -> None:
        self.items = {item.id: item for item in stored.items}
        self.revisions: dict[int, dict[int, Revision]] = {}
        for revision in sorted(stored.revisions, key=lambda each: (each.item, each.number)):
            self.revisions.setdefault(revision.item, {})[revision.number] = revision
        self.edits = _complete_steps(stored.edits)
        self.drafts = {
            key: replace(draft, cursor=min(draft.cursor, len(self.edits[key]) - 1))
            for draft in stored.drafts
            if (key := (draft.item, draft.editor)) in self.edits
        }
        self.layouts = dict(stored.layouts)
        self.bindings = stored.bindings
        self.performers = dict(stored.performers)

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
            layouts=self.layouts,
            bindings=self.bindings,
            performers=self.performers,
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

    @singledispatchmethod
    def _apply(self, change: Change) -> None:
        raise TypeError(f"{type(change).__name__} is no change; expected one of omote.showfile.changes")

    @_apply.register
    def _(self, change: PutContent) -> None:
        pass  # bytes are in the content store

    @_apply.register
    def _(self, change: PutItem) -> None:
        self.items[change.item.id] = change.item

    @_apply.register
    def _(self, change: PutRevision) -> None:
        revisions = self.revisions.setdefault(change.revision.item, {})
        if change.revision.number in revisions:
            raise ValueError(f"revision {change.revision.number} is there already; expected a new number")
        revisions[change.revision.number] = change.revision

    @_apply.register
    def _(self, change: PutDraft) -> None:
        key = change.draft.item, change.draft.editor
        self.drafts[key] = change.draft
        self.edits.setdefault(key, [])

    @_apply.register
    def _(self, change: PutEdit) -> None:
        steps = self.edits.setdefault((change.edit.item, change.edit.editor), [])
        del steps[change.edit.number :]
        steps.append(change.edit)

    @_apply.register
    def _(self, change: DropDraft) -> None:
        self.drafts.pop((change.item, change.editor), None)
        self.edits.pop((change.item, change.editor), None)

    @_apply.register
    def _(self, change: PutLayout) -> None:
        self.layouts[change.name] = change.document

    @_apply.register
    def _(self, change: DropLayout) -> None:
        self.layouts.pop(change.name, None)

    @_apply.register
    def _(self, change: PutBindings) -> None:
        self.bindings = change.document

    @_apply.register
    def _(self, change: PutPerformer) -> None:
        self.performers[change.name] = change.document

    @_apply.register
    def _(self, change: DropPerformer) -> None:
        self.performers.pop(change.name, None)


def _complete_steps(edits: Iterable[Edit]) -> dict[DraftKey, list[Edit]]:
    """The steps of each draft from 0 up to where, in a damaged file, the first is missing."""
    found: dict[DraftKey, list[Edit]] = {}
    for edit in sorted(edits, key=lambda each: each.number):
        steps = found.get((edit.item, edit.editor), [])
        if edit.number == len(steps):
            found.setdefault((edit.item, edit.editor), steps).append(edit)
    return found
