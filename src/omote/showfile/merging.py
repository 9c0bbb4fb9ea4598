"""What newer rows of a show file add to an older, whole copy of it; pure."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

import msgspec

from omote.showfile.changes import (
    Change,
    Draft,
    DropDraft,
    Edit,
    Item,
    PutContent,
    PutDraft,
    PutEdit,
    PutItem,
    PutLayout,
    PutRevision,
    Revision,
    Stored,
)


def changes_since(
    good: Stored, keys: Collection[str], found: Stored, contents: Mapping[str, bytes], /
) -> list[Change]:  # fmt: skip
    """The changes that bring a whole copy as near to newer rows as these are whole.

    good, keys: the copy's rows and the keys of its contents; found, contents: true rows of a later state, not all of
    them. A revision counts with its item and content, a head with its revision (else the newest that is there), a draft
    with its steps up to the shown one.
    """
    items = {item.id: item for item in (*good.items, *found.items)}
    known = {(revision.item, revision.number) for revision in good.revisions}
    revisions = [
        revision
        for revision in found.revisions
        if (revision.item, revision.number) not in known
        and revision.item in items
        and (revision.content in keys or revision.content in contents)
    ]
    whole = (*good.revisions, *revisions)
    same = set(good.items)
    return [
        *(PutContent(key, data) for key, data in contents.items() if key not in keys),
        *(PutItem(item) for item in (_set_head(item, whole) for item in found.items) if item not in same),
        *map(PutRevision, revisions),
        *(change for draft in found.drafts if draft.item in items for change in _draft(draft, good, found)),
        *(PutLayout(name, data) for name, data in found.layouts.items() if good.layouts.get(name) != data),
    ]


def _set_head(item: Item, revisions: Collection[Revision]) -> Item:
    mine = [revision for revision in revisions if revision.item == item.id]
    if item.head == 0 or any(revision.number == item.head for revision in mine):
        return item
    return msgspec.structs.replace(
        item, head=max((revision.number for revision in mine if not revision.aside), default=0)
    )


def _draft(draft: Draft, good: Stored, found: Stored) -> Iterator[Change]:
    edits = _steps(draft, found)
    if edits == _steps(draft, good) and draft in good.drafts:
        return
    if draft.cursor >= len(edits):  # steps are missing: the copy's draft is whole
        if not edits or any((old.item, old.editor) == (draft.item, draft.editor) for old in good.drafts):
            return
        draft = msgspec.structs.replace(draft, cursor=len(edits) - 1)
    yield DropDraft(draft.item, draft.editor)
    yield PutDraft(draft)
    yield from map(PutEdit, edits)


def _steps(draft: Draft, stored: Stored) -> list[Edit]:
    """The steps of a draft from the first on, as far as none is missing."""
    mine = {edit.number: edit for edit in stored.edits if (edit.item, edit.editor) == (draft.item, draft.editor)}
    steps: list[Edit] = []
    while len(steps) in mine:
        steps.append(mine[len(steps)])
    return steps
