"""Takes in what a file of other people brought, but what is there already, and what somebody made of a scan."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import get_args

import msgspec
from msgspec.structs import replace

from omote.edit.protocol.names import free_label, new_name
from omote.edit.protocol.wire import read_recipe, write_recipe
from omote.edit.session.plan import Authored, Result
from omote.show.validation import Refusal
from omote.showfile.changes import BroughtItem, Change, Item, Kind, PutItem, PutRevision


class TakenIn(msgspec.Struct, frozen=True):
    """What became of an item that a file brought: the one that it is in the show; known: that was there already."""

    kind: Kind
    name: str
    label: str
    known: bool = False


Adding = Callable[[Authored], tuple[Result, list[TakenIn]]]
"""The changes that add items, and what becomes of each; Refusal where they cannot be added."""


def take_in(authored: Authored, brought: Sequence[BroughtItem]) -> tuple[Result, list[TakenIn]]:
    """The changes that add brought items, which play at once, and what becomes of each; one whose content plays as an
    item of its kind is not added again."""
    same = [_find_same(authored, each) for each in brought]
    result = _add(authored, [each for each, known in zip(brought, same, strict=True) if known is None])
    added = iter([change.item for change in result.changes if isinstance(change, PutItem)])
    return result, [_describe(next(added) if known is None else known, known is not None) for known in same]


def take_made(
    authored: Authored, brought: Sequence[BroughtItem], replaced: int | None = None
) -> tuple[Result, list[TakenIn]]:
    """The changes that add items that somebody made and named, and what becomes of each: what plays already under
    another name is another item. replaced: the item whose next revision the first becomes, with its name and label;
    Refusal where there is none of its kind."""
    if replaced is not None:
        return _replace(authored, brought[0], replaced)
    result = _add(authored, brought)
    return result, [_describe(change.item, False) for change in result.changes if isinstance(change, PutItem)]


def _describe(item: Item, known: bool) -> TakenIn:
    return TakenIn(item.kind, item.name, item.label, known)


def _find_same(authored: Authored, brought: BroughtItem) -> Item | None:
    """The item that plays the content of a brought one; None where there is none."""
    items, wanted = authored.state.items.values(), (brought.item.kind, brought.revision.content)
    heads = ((item, authored.state.head(item)) for item in items if not item.deleted)
    return next((item for item, head in heads if head is not None and (item.kind, head.content) == wanted), None)


def _add(authored: Authored, brought: Sequence[BroughtItem]) -> Result:
    """Adds items of another show file as new items, each under a name and a label of its own."""
    state, store, taken = authored.state, authored.store, authored.names()
    labels = {kind: authored.labels(kind) for kind in get_args(Kind)}
    changes: list[Change] = []
    for step, each in enumerate(brought):
        name, key = new_name(each.item.label, each.item.kind, taken), each.revision.content
        label = free_label(each.item.label, labels[each.item.kind])
        taken.add(name)
        labels[each.item.kind].append(label)
        number, place = state.new_item() + step, state.new_place() + step
        item = replace(each.item, id=number, name=name, label=label, place=place, head=1)
        store.remember_contents({key: each.content})
        store.remember_recipe(write_recipe(read_recipe(each.revision.recipe)), key)
        revision = replace(each.revision, item=item.id, number=1, parent=0)
        changes += [*store.changes_to_keep(key), PutItem(item), PutRevision(revision)]
    return Result(tuple(changes))


def _replace(authored: Authored, brought: BroughtItem, number: int) -> tuple[Result, list[TakenIn]]:
    """Makes what was brought the revision of an item that plays."""
    state, store, item = authored.state, authored.store, authored.state.items.get(number)
    if item is None or item.deleted or item.kind != brought.item.kind:
        raise Refusal(f"there is no {brought.item.kind} {number} to replace: choose one from the list.")
    key = brought.revision.content
    store.remember_contents({key: brought.content})
    store.remember_recipe(write_recipe(read_recipe(brought.revision.recipe)), key)
    following = replace(item, head=state.last_number(number) + 1)
    revision = replace(brought.revision, item=number, number=following.head, parent=item.head)
    return Result((*store.changes_to_keep(key), PutItem(following), PutRevision(revision))), [_describe(item, False)]
