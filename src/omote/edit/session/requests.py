"""Dispatches requests: the plan or result of each message type, and the queue in which it waits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import clean_text
from omote.edit.session import drafts, items, saving
from omote.edit.session.plan import Authored, Plan, Result
from omote.edit.session.saving import Author
from omote.edit.store.authored_state import DraftKey
from omote.edit.store.on_air_recipes import OnAir, expression_recipe, face_recipe, recipe_on_air
from omote.model.recipes.recipe import AnyRecipe
from omote.show.declaration import Message
from omote.show.validation import Refusal
from omote.showfile.changes import Item


@dataclass(frozen=True)
class RequestContext:
    """A request with all data that its answer depends on."""

    authored: Authored
    message: Any
    author: Author
    on_air: OnAir

    @property
    def item(self) -> Item:
        """The item that the request is about; Refusal where there is none, or it is deleted and must not be."""
        item = self.authored.state.items.get(self.message.item)
        if item is None:
            raise Refusal(f"there is no item {self.message.item}: choose one from the list.")
        if item.deleted and not self.message.of_deleted:
            raise Refusal(f"{item.label!r} was deleted: restore it first.")
        return item

    @property
    def draft(self) -> DraftKey:
        """The asker's draft of the item; Refusal where there is none."""
        key = self.item.id, self.author.editor
        if key not in self.authored.state.drafts:
            raise Refusal(f"{self.item.label!r} is not open here: open it first.")
        return key


def queue_key(message: Message, editor: str) -> DraftKey | None:
    """The queue of a request: its draft, or all new items of its editor; None: it waits for nothing.

    message: the request; editor: who sends it.
    """
    if isinstance(message, wire.CreateExpression | wire.CreateFace | wire.CreatePose):
        return 0, editor
    return (message.item, editor) if isinstance(message, wire.DraftRequest) else None


def answer(context: RequestContext) -> Plan | Result:
    """The plan or the result of a request; Refusal where it cannot be carried out."""
    return ANSWERS[type(context.message)](context)


def _create_expression(context: RequestContext) -> Plan:
    authored = context.authored
    wanted = context.message
    if wanted.on_air:
        recipe = recipe_on_air("expression", context.on_air, authored.net, authored.sources)
    else:
        recipe = expression_recipe([*wanted.start.items()], authored.net, authored.sources)
    return saving.create(authored, "expression", wanted.label, recipe, context.author.editor)


def _create_face(context: RequestContext) -> Plan:
    authored = context.authored
    wanted = context.message
    recipe: AnyRecipe = face_recipe(context.on_air.faces if wanted.on_air else wanted.base, authored.sources)
    return saving.create(authored, "face", wanted.label, recipe, context.author.editor)


def _create_pose(context: RequestContext) -> Plan:
    authored = context.authored
    wanted = context.message
    return saving.create(
        authored, "pose", wanted.label, authored.sources.pose_recipe(wanted.start), context.author.editor
    )


def _save(context: RequestContext) -> Plan | Result:
    assert context.draft
    note = clean_text(context.message.note)
    on_air = context.item.name in context.on_air.names
    return saving.save(context.authored, context.item, context.author, context.message.request, note, on_air=on_air)


def _duplicate(context: RequestContext) -> Result:
    return saving.duplicate(
        context.authored, context.item, context.message.label, context.author, context.message.request
    )


def _close(context: RequestContext) -> Result:
    return Result(reply=wire.Done(context.message.request), closed=context.item.id)


def _edit(context: RequestContext) -> Plan:
    return drafts.edit(context.authored, context.draft, context.message)


ANSWERS: Mapping[type[Message], Callable[[RequestContext], Plan | Result]] = {
    wire.CreateExpression: _create_expression,
    wire.CreateFace: _create_face,
    wire.CreatePose: _create_pose,
    wire.OpenItem: lambda context: drafts.open_item(context.authored, context.item, context.author.editor),
    wire.CloseItem: _close,
    **dict.fromkeys(drafts.EDITS, _edit),
    wire.PreviewLayers: lambda context: drafts.preview_layers(context.authored, context.draft, context.message),
    wire.Undo: lambda context: drafts.step(context.authored, context.draft, -1),
    wire.Redo: lambda context: drafts.step(context.authored, context.draft, 1),
    wire.Save: _save,
    wire.BringBack: lambda context: drafts.bring_back(context.authored, context.draft, context.message.revision),
    wire.Describe: lambda context: items.describe(context.item, context.message),
    wire.Duplicate: _duplicate,
    wire.Delete: lambda context: items.delete(context.item, context.on_air, context.message.request),
    wire.Restore: lambda context: items.restore(context.item, context.message.request),
    wire.AskHistory: lambda context: items.history(context.authored.state, context.item, context.message.request),
}
"""The handler of each request; the session itself handles `greet`."""
