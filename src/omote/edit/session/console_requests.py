"""What consoles ask of the show file: to keep what is on air, to change own items, and their layouts."""

from __future__ import annotations

from collections.abc import Mapping

import msgspec
from msgspec.structs import replace

from omote.edit.protocol.names import clean_label, free_label
from omote.edit.session import items, saving
from omote.edit.session.drafts import is_dirty
from omote.edit.session.edit_session import EditSession, Outcome
from omote.edit.session.plan import Authored, KeepOutcome, Result
from omote.edit.session.saving import Author
from omote.edit.store.on_air_recipes import OnAir, recipe_on_air
from omote.interchange.formats.error_reasons import explain_error
from omote.show import messages as wire
from omote.show.outgoing import KeepRequest
from omote.show.validation import Refusal
from omote.showfile.changes import Change, DropLayout, Item, Kind, PutItem, PutLayout

AskedOfItem = wire.RenameItem | wire.DeleteItem | wire.RestoreItem | wire.CopyItem
CONSOLE = "the console"
"""The name under which the history shows what was saved on air."""
MOST_LAYOUTS = 64


def answer_console(session: EditSession, request: KeepRequest, on_air: OnAir, wall: float) -> Outcome:
    """Carries out a console's request; `Outcome.kept` reports what became of it, under `WHO ID`."""
    message, authored = request.message, session.authored
    ticket = f"{request.who} {getattr(message, 'id', '')}"
    if isinstance(message, wire.RenameItem | wire.DeleteItem | wire.RestoreItem | wire.CopyItem):
        return session.carry_out(
            lambda: _change_item(authored, message, on_air, Author(CONSOLE, "", wall), ticket), ticket
        )
    if isinstance(message, wire.SetLayout | wire.RenameLayout | wire.DropLayout):
        return session.carry_out(lambda: Result(change_layouts(authored.state.layouts, message)), ticket)
    kind: Kind = "face" if isinstance(message, wire.KeepFace) else "expression"
    return keep_on_air(session, kind, on_air, label=None, wall=wall, editor=CONSOLE, ticket=ticket)


def reply_to_console(call: str, kept: KeepOutcome) -> wire.FromServer:
    """The message that tells a console what became of its request `call`."""
    if kept.trouble:
        return wire.Refused(kept.trouble, call)
    return wire.ItemChanged(call, kept.label, kept.before) if kept.before else wire.Kept(call, kept.name, kept.label)


def keep_on_air(
    session: EditSession, kind: Kind, on_air: OnAir, *, label: str | None, wall: float, editor: str, ticket: str
) -> Outcome:
    """Stores what is on air as a new item, as it is now, whatever else waits before it; label: None for a generated
    one."""
    authored = session.authored
    try:
        recipe = recipe_on_air(kind, on_air, authored.net, authored.sources)
        plan = saving.keep(authored, kind, label, recipe, Author(editor, "", wall), ticket)
    except Refusal as refusal:
        return Outcome(kept=(KeepOutcome(ticket, trouble=str(refusal)),))
    return session.carry_out(lambda: plan, ticket, queue=(0, ""))  # in order, so that labels are


def change_layouts(
    layouts: Mapping[str, bytes], asked: wire.SetLayout | wire.RenameLayout | wire.DropLayout
) -> tuple[Change, ...]:
    """The changes that a request makes to the layouts, by name; Refusal where it cannot be carried out."""
    if isinstance(asked, wire.SetLayout):
        return (PutLayout(_new_name(layouts, asked.name), _document(asked)),)
    if asked.name not in layouts:
        raise Refusal(f"there is no layout {asked.name!r} any more: choose another from the list.")
    if isinstance(asked, wire.DropLayout):
        return (DropLayout(asked.name),)
    name = clean_label(asked.to, "the name of a layout")
    others = (each for each in layouts if each != asked.name)
    twin = next((each for each in others if each.casefold() == name.casefold()), None)
    if twin is not None:
        raise Refusal(f"there is a layout {twin!r} already: give another name, or delete that one first.")
    return DropLayout(asked.name), PutLayout(name, layouts[asked.name])


def _change_item(authored: Authored, asked: AskedOfItem, on_air: OnAir, author: Author, ticket: str) -> Result:
    """Renames, deletes, restores or copies an item; Refusal where that cannot be done."""
    item = authored.state.find(asked.name)
    if item is None or item.kind != asked.kind or item.deleted != isinstance(asked, wire.RestoreItem):
        raise Refusal(f"there is no {_sort(asked)} {asked.kind} {asked.name!r} any more.")
    if isinstance(asked, wire.CopyItem):
        copied = saving.duplicate(authored, item, free_label(item.label, authored.labels(item.kind)), author, -1)
        (copy,) = (change.item for change in copied.changes if isinstance(change, PutItem))
        return Result(copied.changes, kept=KeepOutcome(ticket, copy.id, copy.name, copy.label, copy.kind))
    match asked:
        case wire.RenameItem():
            changed = replace(item, label=_label_apart(authored, item, asked.label))
        case wire.DeleteItem():
            if asked.unedited and _is_edited(authored, item):
                raise Refusal(f"{item.label!r} has been edited since it was kept: delete it by its own tile.")
            changed = items.mark_deleted(item, on_air)
        case wire.RestoreItem():
            changed = replace(item, deleted=False)
    return Result(
        (PutItem(changed),), kept=KeepOutcome(ticket, item.id, item.name, changed.label, item.kind, before=item.label)
    )


def _sort(asked: AskedOfItem) -> str:
    return "deleted" if isinstance(asked, wire.RestoreItem) else "own"


def _label_apart(authored: Authored, item: Item, wanted: str) -> str:
    """A new label of an item, cleaned; Refusal where another of its kind has it."""
    label = clean_label(wanted, "the name")
    twin = next((each for each in authored.labels(item.kind, but=item.id) if each.casefold() == label.casefold()), None)
    if twin is not None:
        raise Refusal(f"there is {_article(item.kind)} {twin!r} already: give another name.")
    return label


def _article(kind: Kind) -> str:
    return "a face" if kind == "face" else "an expression"


def _is_edited(authored: Authored, item: Item) -> bool:
    """Whether somebody has worked on an item, or it was never kept on air."""
    state, head = authored.state, authored.state.head(item)
    worked_on = any(key[0] == item.id and is_dirty(state, key) for key in state.drafts)
    return head is None or (head.number, head.editor) != (1, CONSOLE) or worked_on


def _new_name(layouts: Mapping[str, bytes], name: str) -> str:
    name = clean_label(name, "the name of a layout")
    if name not in layouts and len(layouts) >= MOST_LAYOUTS:
        raise Refusal(f"there are {MOST_LAYOUTS} layouts already: delete one, or use the name of one of them.")
    return name


def _document(asked: wire.SetLayout) -> bytes:
    document = asked.document.encode()
    try:
        msgspec.json.decode(document)
    except (msgspec.DecodeError, RecursionError) as error:
        raise Refusal(f"the layout {asked.name!r} is no JSON ({explain_error(error)}): send it again.") from error
    return document
