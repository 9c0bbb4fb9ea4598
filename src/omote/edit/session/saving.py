"""Saves drafts as revisions: a revision plays at once, or is kept aside when another editor saved meanwhile."""

from __future__ import annotations

from dataclasses import dataclass

from msgspec.structs import replace

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import clean_label, new_label, new_name
from omote.edit.protocol.orders import Baked
from omote.edit.protocol.wire import read_recipe, write_recipe
from omote.edit.session.drafts import is_dirty
from omote.edit.session.plan import Authored, KeepOutcome, Plan, Result
from omote.edit.store.authored_state import DraftKey
from omote.model.recipes.recipe import AnyRecipe
from omote.showfile.changes import Change, Draft, Edit, Item, Kind, Revision


@dataclass(frozen=True)
class Author:
    """Who saves and when: the name that people read, the editor's id, seconds since 1970."""

    name: str
    editor: str
    wall: float


def save(authored: Authored, item: Item, author: Author, request: int, note: str, *, on_air: bool) -> Plan | Result:
    """Saves a draft as the next revision; nothing where it holds no changes. on_air: whether the item is seen now.

    authored: what is there; item, author: whose draft of what; request: the number to answer to; note: for the
    history.
    """
    key = item.id, author.editor
    if not is_dirty(authored.state, key):
        return Result(reply=_nothing_new_reply(authored, item, key, request))
    order = authored.bake(read_recipe(authored.state.shown_edit(key).recipe))
    return Plan(order, lambda baked: _save_baked(authored, key, author, request, note, baked, on_air))


def create(authored: Authored, kind: Kind, label: str, recipe: AnyRecipe, editor: str) -> Plan:
    """Creates an unsaved item and the editor's draft of it.

    authored: what is there; kind, label: of the item; recipe: what the draft begins with; editor: whose.
    """
    label = clean_label(label)
    recipe = authored.resolve_and_check(recipe)

    def finish(baked: Baked) -> Result:
        item = _new_item(authored, kind, label)
        changes = (
            *authored.changes_to_keep(baked.recipe),
            item,
            Draft(item.id, editor, base=0, cursor=0),
            Edit(item.id, editor, 0, write_recipe(baked.recipe), "new"),
        )
        return Result(changes, draft=(item.id, editor), opened=item.id, whole=True)

    return Plan(authored.bake(recipe, with_net=True), finish)


def keep(authored: Authored, kind: Kind, label: str | None, recipe: AnyRecipe, author: Author, ticket: str) -> Plan:
    """Creates and saves an item in one step, so that it plays; label: None for a generated one.

    authored: what is there; kind: of the item; recipe: what it is made by; author: for the history; ticket: the
    asker's.
    """
    label = None if label is None else clean_label(label)
    recipe = authored.resolve_and_check(recipe)

    def finish(baked: Baked) -> Result:
        taken = (item.label for item in authored.state.items.values())
        item = replace(_new_item(authored, kind, new_label("On air", taken) if label is None else label), head=1)
        data = write_recipe(baked.recipe)
        revision = Revision(item.id, 1, 0, data, baked.key, author.wall, author.name, "saved on air")
        return Result(
            (*_content_changes(authored, baked), item, revision),
            kept=KeepOutcome(ticket, item.id, item.name, item.label, kind),
        )

    return Plan(authored.bake(recipe), finish)


def duplicate(authored: Authored, item: Item, label: str, author: Author, request: int) -> Result:
    """Copies the playing revision of an item into a new item; Refusal before the first save.

    authored: what is there; item: what is copied; label: of the copy; author: for the history; request: the number
    to answer to.
    """
    head = authored.state.head(item)
    label = clean_label(label)
    if head is None:
        authored.sources.resolve(item.kind, item.name)  # refuses, and says why
        raise AssertionError
    copy = replace(_new_item(authored, item.kind, label), tags=item.tags, head=1)
    revision = replace(head, item=copy.id, number=1, parent=0, written=author.wall, editor=author.name, aside=False)
    reply = wire.Saved(
        request, copy.id, 1, 1, False, f"{label!r} is a copy of revision {head.number} of {item.label!r}."
    )
    return Result((copy, revision), reply)


def _save_baked(
    authored: Authored, key: DraftKey, author: Author, request: int, note: str, baked: Baked, on_air: bool
) -> Result:
    state = authored.state
    item = state.items[key[0]]
    draft = state.drafts[key]
    number = state.last_number(item.id) + 1
    aside = draft.base != item.head
    data = write_recipe(baked.recipe)
    revision = Revision(item.id, number, draft.base, data, baked.key, author.wall, author.name, note, aside)
    changes: list[Change] = [*_content_changes(authored, baked), revision]
    head = item.head if aside else number
    if not aside:
        changes.append(replace(item, head=number))
    changes.append(replace(draft, base=head))
    sentence = _aside_sentence(authored, item, number) if aside else _plays_sentence(item, number, on_air)
    return Result(tuple(changes), wire.Saved(request, item.id, number, head, aside, sentence), draft=key)


def _plays_sentence(item: Item, number: int, on_air: bool) -> str:
    place = "it is on air, so every stage has changed" if on_air else "consoles have it under Own"
    return f"Revision {number} of {item.label!r} plays from now on: {place}."


def _aside_sentence(authored: Authored, item: Item, number: int) -> str:
    theirs = authored.state.revisions[item.id][item.head]
    return (
        f"{theirs.editor} saved {item.label!r} meanwhile: their revision {item.head} plays, yours is kept beside it as "
        f"revision {number}. To let yours play, save again; to look at both, open the history."
    )


def _nothing_new_reply(authored: Authored, item: Item, key: DraftKey, request: int) -> wire.Saved:
    base = authored.state.drafts[key].base
    sentence = f"Nothing has changed since revision {base}."
    if base != item.head:
        sentence += f" What plays is revision {item.head} of {authored.state.revisions[item.id][item.head].editor}."
    return wire.Saved(request, item.id, base, item.head, False, sentence)


def _content_changes(authored: Authored, baked: Baked) -> tuple[Change, ...]:
    return (*authored.changes_to_keep(baked.recipe), *authored.store.changes_to_keep(baked.key))


def _new_item(authored: Authored, kind: Kind, label: str) -> Item:
    state = authored.state
    return Item(state.new_item(), kind, new_name(label, kind, authored.names()), label, place=state.new_place())
