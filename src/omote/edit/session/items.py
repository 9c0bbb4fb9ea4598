"""Lists, describes, deletes and restores items (authored faces and expressions), and lists their revisions."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from msgspec.structs import replace

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import clean_label, clean_tags
from omote.edit.protocol.validation import PLACE
from omote.edit.session.plan import Result
from omote.edit.store.authored_state import AuthoredState
from omote.edit.store.on_air_recipes import OnAir
from omote.model.recipes.recipe import KEY
from omote.show.validation import Refusal, validate_number
from omote.showfile.changes import Item
from omote.stage_data.playing_cast import Own


def own_things(state: AuthoredState) -> tuple[Own, ...]:
    """All saved items that are not deleted, in palette order."""
    things = []
    for item in sorted(state.items.values(), key=lambda item: (item.place, item.id)):
        head = state.head(item)
        if head is not None and not item.deleted:
            things.append(Own(item.kind, item.name, item.label, item.tags, item.place, head.content))
    return tuple(things)


def document(state: AuthoredState, item: Item, editors: Iterable[str]) -> wire.ItemDocument:
    """The document of an item for lists; editors: names of those who have it open.

    state: the authored work; item: of it.
    """
    head = state.head(item)
    content = "" if head is None else KEY + head.content
    tags = list(item.tags)
    names = list(editors)
    return wire.ItemDocument(
        item.id, item.kind, item.name, item.label, tags, item.place, item.head, content, item.deleted, names
    )


def list_items(state: AuthoredState, digest: str, editors: Callable[[int], Iterable[str]]) -> wire.Items:
    """All items in palette order; editors: names of those who have an item open.

    state: the authored work; digest: of the cast as it plays.
    """
    order = sorted(state.items.values(), key=lambda item: (item.place, item.id))
    return wire.Items(digest, [document(state, item, editors(item.id)) for item in order])


def history(state: AuthoredState, item: Item, request: int) -> Result:
    """The revisions of an item.

    state: the authored work; item: of it; request: the number to answer to.
    """
    revisions = [
        wire.RevisionDocument(r.number, r.parent, KEY + r.content, r.written, r.editor, r.note, r.aside)
        for r in state.revisions.get(item.id, {}).values()
    ]
    return Result(reply=wire.History(request, item.id, revisions))


def describe(item: Item, wanted: wire.Describe) -> Result:
    """Changes the label, tags and place of an item.

    item: as it is; wanted: the request.
    """
    label = clean_label(wanted.label)
    tags = clean_tags(wanted.tags)
    place = validate_number(wanted.place, PLACE)
    return _replace_item(item, replace(item, label=label, tags=tags, place=place), wanted.request)


def delete(item: Item, on_air: OnAir, request: int) -> Result:
    """Takes an item out of the cast; Refusal while it is on air or coming. What was made from it keeps its content.

    item: as it is; on_air: what shows now; request: the number to answer to.
    """
    return _replace_item(item, mark_deleted(item, on_air), request)


def mark_deleted(item: Item, on_air: OnAir) -> Item:
    """An item as it is out of the cast; Refusal while it is on air, coming or the home face.

    item: as it is; on_air: what shows now.
    """
    if item.name in on_air.homes:
        raise Refusal(
            f"{item.label!r} is the home face, which panic brings: choose another in a console's Set-up first."
        )
    if item.name in on_air.names:
        raise Refusal(f"{item.label!r} is on air or coming: call another first, then delete it.")
    return replace(item, deleted=True)


def restore(item: Item, request: int) -> Result:
    """Puts a deleted item back into the cast.

    item: as it is; request: the number to answer to.
    """
    return _replace_item(item, replace(item, deleted=False), request)


def _replace_item(before: Item, after: Item, request: int) -> Result:
    return Result(() if after == before else (after,), wire.Done(request))
