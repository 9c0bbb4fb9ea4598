"""What every request asks for: the plan or the result of each message, and which of them wait for each other."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import checked_text
from omote.edit.session import drafts, items, saving
from omote.edit.session.plan import Authored, Plan, Result
from omote.edit.session.saving import Hand
from omote.edit.store.authored_state import DraftKey
from omote.edit.store.on_air_recipes import OnAir, expression_of, face_of, recipe_on_air
from omote.model.recipes.recipe import FaceRecipe, Recipe
from omote.show.messages import Message
from omote.show.validation import Refusal
from omote.showfile.changes import Item


@dataclass(frozen=True)
class Asked:
    """A request with all that its answer depends on."""

    authored: Authored
    message: Any
    hand: Hand
    on_air: OnAir

    @property
    def item(self) -> Item:
        """The item that it is about; Refusal where there is none, or it was deleted and that matters."""
        item = self.authored.ledger.items.get(self.message.item)
        if item is None:
            raise Refusal(f"there is no item {self.message.item}: choose one from the list.")
        if item.deleted and not isinstance(self.message, OF_DELETED_ITEMS):
            raise Refusal(f"{item.label!r} was deleted: restore it first.")
        return item

    @property
    def draft(self) -> DraftKey:
        """The asker's draft of the item; Refusal where there is none."""
        key = self.item.id, self.hand.editor
        if key not in self.authored.ledger.drafts:
            raise Refusal(f"{self.item.label!r} is not open here: open it first.")
        return key


def lane(message: Message, editor: str) -> DraftKey | None:
    """What a request waits in: its draft, or all new items of its editor; None: it waits for nothing."""
    if isinstance(message, wire.CreateExpression | wire.CreateFace):
        return 0, editor
    return (getattr(message, "item", 0), editor) if isinstance(message, OF_DRAFTS) else None


def answer(asked: Asked) -> Plan | Result:
    """The plan or the result of a request; Refusal where it cannot be obeyed."""
    return ANSWERS[type(asked.message)](asked)


def _create_expression(asked: Asked) -> Plan:
    authored, wanted = asked.authored, asked.message
    if wanted.on_air:
        recipe = recipe_on_air("expression", asked.on_air, authored.net, authored.sources)
    else:
        recipe = expression_of([*wanted.start.items()], authored.net, authored.sources)
    return saving.create(authored, "expression", wanted.label, recipe, asked.hand.editor)


def _create_face(asked: Asked) -> Plan:
    authored, wanted = asked.authored, asked.message
    recipe: Recipe | FaceRecipe = face_of(asked.on_air.faces if wanted.on_air else wanted.base, authored.sources)
    return saving.create(authored, "face", wanted.label, recipe, asked.hand.editor)


def _save(asked: Asked) -> Plan | Result:
    assert asked.draft
    note = checked_text(asked.message.note)
    on_air = asked.item.name in asked.on_air.names
    return saving.save(asked.authored, asked.item, asked.hand, asked.message.request, note, on_air=on_air)


def _duplicate(asked: Asked) -> Result:
    return saving.duplicate(asked.authored, asked.item, asked.message.label, asked.hand, asked.message.request)


def _close(asked: Asked) -> Result:
    return Result(reply=wire.Done(asked.message.request), closed=asked.item.id)


def _edit(asked: Asked) -> Plan:
    return drafts.edit(asked.authored, asked.draft, asked.message)


ANSWERS: Mapping[type[Message], Callable[[Asked], Plan | Result]] = {
    wire.CreateExpression: _create_expression,
    wire.CreateFace: _create_face,
    wire.OpenItem: lambda asked: drafts.open_item(asked.authored, asked.item, asked.hand.editor),
    wire.CloseItem: _close,
    **dict.fromkeys(drafts.EDITS, _edit),
    wire.Undo: lambda asked: drafts.step(asked.authored, asked.draft, -1),
    wire.Redo: lambda asked: drafts.step(asked.authored, asked.draft, 1),
    wire.Save: _save,
    wire.BringBack: lambda asked: drafts.bring_back(asked.authored, asked.draft, asked.message.revision),
    wire.Describe: lambda asked: items.describe(asked.item, asked.message),
    wire.Duplicate: _duplicate,
    wire.Delete: lambda asked: items.delete(asked.item, asked.on_air, asked.message.request),
    wire.Restore: lambda asked: items.restore(asked.item, asked.message.request),
    wire.AskHistory: lambda asked: items.history(asked.authored.ledger, asked.item, asked.message.request),
}
"""What each request leads to; greeting is the session's own."""

OF_DRAFTS: tuple[type[Message], ...] = (
    wire.OpenItem, wire.CloseItem, *drafts.EDITS, wire.Undo, wire.Redo, wire.Save, wire.BringBack
)  # fmt: skip
OF_DELETED_ITEMS: tuple[type[Message], ...] = (wire.CloseItem, wire.Delete, wire.Restore, wire.AskHistory)
