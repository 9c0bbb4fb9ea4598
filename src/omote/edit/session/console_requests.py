"""What consoles ask of the show file: to keep what is on air, to change own items, and their layouts."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from omote.edit.protocol.names import clean_label, free_label
from omote.edit.session import items, saving
from omote.edit.session.drafts import is_dirty
from omote.edit.session.edit_session import EditSession, Outcome
from omote.edit.session.plan import Authored, KeepOutcome, Result
from omote.edit.session.saving import Author
from omote.edit.store.on_air_recipes import OnAir, recipe_on_air
from omote.show.declaration import KeepRequest, ServerMessage
from omote.show.objects.documents import DocumentRequest, RenameDocument, SetDocument, read_document
from omote.show.objects.items import CopyItem, DeleteItem, ItemChanged, KeepFace, Kept, RenameItem, RestoreItem
from omote.show.objects.link import Refused
from omote.show.validation import Refusal
from omote.showfile.changes import Change, DocumentRemoval, Item, Kind, StoredDocument

AskedOfItem = RenameItem | DeleteItem | RestoreItem | CopyItem
CONSOLE = "the console"
"""The name under which the history shows what was saved on air."""


def answer_console(session: EditSession, request: KeepRequest, on_air: OnAir, wall: float) -> Outcome:
    """Carries out a console's request; `Outcome.kept` reports what became of it, under `WHO ID`.

    session: of the editors; request: with who asks; on_air: what shows of the character; wall: seconds since 1970.
    """
    message = request.message
    authored = session.authored
    ticket = f"{request.who} {getattr(message, 'id', '')}"
    if isinstance(message, RenameItem | DeleteItem | RestoreItem | CopyItem):
        return session.carry_out(
            lambda: _change_item(authored, message, on_air, Author(CONSOLE, "", wall), ticket), ticket
        )
    if isinstance(message, DocumentRequest):
        named = authored.state.documents.get(message.of.kind, {})
        return session.carry_out(lambda: Result(change_documents(named, message)), ticket)
    kind: Kind = "face" if isinstance(message, KeepFace) else "expression"
    return keep_on_air(session, kind, on_air, label=None, wall=wall, editor=CONSOLE, ticket=ticket)


def reply_to_console(call: str, kept: KeepOutcome) -> ServerMessage:
    """The message that tells a console what became of its request `call`.

    call: the id of the request; kept: what became of it.
    """
    if kept.trouble:
        return Refused(kept.trouble, call)
    return ItemChanged(call, kept.label, kept.before) if kept.before else Kept(call, kept.name, kept.label)


def keep_on_air(
    session: EditSession, kind: Kind, on_air: OnAir, *, label: str | None, wall: float, editor: str, ticket: str
) -> Outcome:
    """Stores what is on air as a new item, as it is now, whatever else waits before it; label: None for a generated
    one.

    session: of the editors; kind: of the item; on_air: what shows; wall: seconds since 1970; editor: the name in
    the history; ticket: who asked, and under which id.
    """
    authored = session.authored
    try:
        recipe = recipe_on_air(kind, on_air, authored.net, authored.sources)
        plan = saving.keep(authored, kind, label, recipe, Author(editor, "", wall), ticket)
    except Refusal as refusal:
        return Outcome(kept=(KeepOutcome(ticket, trouble=str(refusal)),))
    return session.carry_out(lambda: plan, ticket, queue=(0, ""))  # in order, so that labels are


def change_documents(named: Mapping[str, bytes], asked: DocumentRequest) -> tuple[Change, ...]:
    """The changes that a request makes to the documents of its kind; Refusal where it cannot be carried out.

    named: the documents of the kind that are there (JSON) by name; asked: what a console asks of them.
    """
    kind = asked.of.kind
    if isinstance(asked, SetDocument):
        return (StoredDocument(kind, _name_to_set(named, asked), _checked_body(asked)),)
    if asked.name not in named:
        raise Refusal(f"there is no {kind} {asked.name!r} any more: choose another from the list.")
    if not isinstance(asked, RenameDocument):
        return (DocumentRemoval(kind, asked.name),)
    name = clean_label(asked.to, f"the name of a {kind}")
    others = (other for other in named if other != asked.name)
    twin = next((other for other in others if other.casefold() == name.casefold()), None)
    if twin is not None:
        raise Refusal(f"there is a {kind} {twin!r} already: give another name, or delete that one first.")
    return DocumentRemoval(kind, asked.name), StoredDocument(kind, name, named[asked.name])


def _change_item(authored: Authored, asked: AskedOfItem, on_air: OnAir, author: Author, ticket: str) -> Result:
    """Renames, deletes, restores or copies an item; Refusal where that cannot be done."""
    item = authored.state.find(asked.name)
    if item is None or item.kind != asked.kind or item.deleted != isinstance(asked, RestoreItem):
        raise Refusal(f"there is no {_sort(asked)} {asked.kind} {asked.name!r} any more.")
    if isinstance(asked, CopyItem):
        copied = saving.duplicate(authored, item, free_label(item.label, authored.labels(item.kind)), author, -1)
        (copy,) = (change for change in copied.changes if isinstance(change, Item))
        return Result(copied.changes, kept=KeepOutcome(ticket, copy.id, copy.name, copy.label, copy.kind))
    match asked:
        case RenameItem():
            changed = replace(item, label=_label_apart(authored, item, asked.label))
        case DeleteItem():
            if asked.unedited and _is_edited(authored, item):
                raise Refusal(f"{item.label!r} has been edited since it was kept: delete it by its own tile.")
            changed = items.mark_deleted(item, on_air)
        case RestoreItem():
            changed = replace(item, deleted=False)
    return Result((changed,), kept=KeepOutcome(ticket, item.id, item.name, changed.label, item.kind, before=item.label))


def _sort(asked: AskedOfItem) -> str:
    return "deleted" if isinstance(asked, RestoreItem) else "own"


def _label_apart(authored: Authored, item: Item, wanted: str) -> str:
    """A new label of an item, cleaned; Refusal where another of its kind has it."""
    label = clean_label(wanted, "the name")
    twin = next(
        (other for other in authored.labels(item.kind, but=item.id) if other.casefold() == label.casefold()), None
    )
    if twin is not None:
        raise Refusal(f"there is {_article(item.kind)} {twin!r} already: give another name.")
    return label


def _article(kind: Kind) -> str:
    return "an expression" if kind == "expression" else f"a {kind}"


def _is_edited(authored: Authored, item: Item) -> bool:
    """Whether somebody has worked on an item, or it was never kept on air."""
    state = authored.state
    head = authored.state.head(item)
    worked_on = any(key[0] == item.id and is_dirty(state, key) for key in state.drafts)
    return head is None or (head.number, head.editor) != (1, CONSOLE) or worked_on


def _name_to_set(named: Mapping[str, bytes], asked: SetDocument) -> str:
    kind = asked.of.kind
    name = clean_label(asked.name, f"the name of a {kind}")
    if name not in named and len(named) >= asked.of.most:
        raise Refusal(f"there are {asked.of.most} {kind}s already: delete one, or use the name of one of them.")
    return name


def _checked_body(asked: SetDocument) -> bytes:
    body = asked.document.encode()
    try:
        read_document(asked.of, body)
    except ValueError as error:
        raise Refusal(f"the {asked.of.kind} {asked.name!r} is not kept, for {error}: send it again.") from error
    return body
