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
from omote.showfile.changes import BroughtItem, Change, Item, Kind


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
    item of its kind is not added again.

    authored: what is there; brought: the items of the file.
    """
    same = [_find_same(authored, item) for item in brought]
    result = _add(authored, [item for item, twin in zip(brought, same, strict=True) if twin is None])
    added = iter([change for change in result.changes if isinstance(change, Item)])
    return result, [_describe(next(added) if twin is None else twin, twin is not None) for twin in same]


def take_made(
    authored: Authored, brought: Sequence[BroughtItem], replaced: int | None = None
) -> tuple[Result, list[TakenIn]]:
    """The changes that add items that somebody made and named, and what becomes of each: what plays already under
    another name is another item. replaced: the item whose next revision the first becomes, with its name and label;
    Refusal where there is none of its kind.

    authored: what is there; brought: the items, named.
    """
    if replaced is not None:
        return _replace(authored, brought[0], replaced)
    result = _add(authored, brought)
    return result, [_describe(change, False) for change in result.changes if isinstance(change, Item)]


def _describe(item: Item, known: bool) -> TakenIn:
    return TakenIn(item.kind, item.name, item.label, known)


def _find_same(authored: Authored, brought: BroughtItem) -> Item | None:
    """The item that plays the content of a brought one; None where there is none."""
    items = authored.state.items.values()
    wanted = (brought.item.kind, brought.revision.content)
    heads = ((item, authored.state.head(item)) for item in items if not item.deleted)
    return next((item for item, head in heads if head is not None and (item.kind, head.content) == wanted), None)


def _add(authored: Authored, brought: Sequence[BroughtItem]) -> Result:
    """Adds items of another show file as new items, each under a name and a label of its own."""
    state = authored.state
    store = authored.store
    taken = authored.names()
    labels = {kind: authored.labels(kind) for kind in get_args(Kind)}
    changes: list[Change] = []
    for step, arrival in enumerate(brought):
        name = new_name(arrival.item.label, arrival.item.kind, taken)
        key = arrival.revision.content
        label = free_label(arrival.item.label, labels[arrival.item.kind])
        taken.add(name)
        labels[arrival.item.kind].append(label)
        number = state.new_item() + step
        place = state.new_place() + step
        item = replace(arrival.item, id=number, name=name, label=label, place=place, head=1)
        store.remember_contents({key: arrival.content})
        store.remember_recipe(write_recipe(read_recipe(arrival.revision.recipe)), key)
        revision = replace(arrival.revision, item=item.id, number=1, parent=0)
        changes += [*store.changes_to_keep(key), item, revision]
    return Result(tuple(changes))


def _replace(authored: Authored, brought: BroughtItem, number: int) -> tuple[Result, list[TakenIn]]:
    """Makes what was brought the revision of an item that plays."""
    state = authored.state
    store = authored.store
    item = authored.state.items.get(number)
    if item is None or item.deleted or item.kind != brought.item.kind:
        raise Refusal(f"there is no {brought.item.kind} {number} to replace: choose one from the list.")
    key = brought.revision.content
    store.remember_contents({key: brought.content})
    store.remember_recipe(write_recipe(read_recipe(brought.revision.recipe)), key)
    following = replace(item, head=state.last_number(number) + 1)
    revision = replace(brought.revision, item=number, number=following.head, parent=item.head)
    return Result((*store.changes_to_keep(key), following, revision)), [_describe(item, False)]
