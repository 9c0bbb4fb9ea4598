"""Own faces and expressions of the cast, as consoles keep and change them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from omote.perform.limits import check_known
from omote.show.declaration import CallId, CharacterName, FileRequest, Name, Outgoing, ServerMessage, Session

ItemKind = Literal["face", "expression"]


class KeepOnAir(FileRequest, frozen=True):
    """Keeps something that a character has on air as a new own item. An `id` executes once; answered with `kept`."""

    access = "edit"

    character: CharacterName
    id: CallId

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps the request; ValueError where nobody is called so. session: the show; who: the client; now: seconds,
        monotonic."""
        check_known(self.character, session.scene, "character")
        return super().act(session, who, now)


class KeepFace(KeepOnAir, frozen=True):
    """Keeps the mix of faces on air as a new own face. An `id` executes once; answered with `kept`."""


class KeepExpression(KeepOnAir, frozen=True):
    """Keeps expressions, channels and gaze on air as a new own expression. An `id` executes once; answered with
    `kept`."""


class OwnItemRequest(FileRequest, frozen=True):
    """Changes an own face or expression, by its kind and its name. An `id` executes once."""

    access = "edit"

    id: CallId
    kind: ItemKind
    name: Name


class RenameItem(OwnItemRequest, frozen=True):
    """Gives an own face or expression another label, which no other of its kind has. An `id` executes once; answered,
    as the two below, with `item_changed`."""

    label: Name


class DeleteItem(OwnItemRequest, frozen=True):
    """Takes an own face or expression out of the cast; rejected while it is on air or the home face. `unedited`:
    rejected too once somebody has worked on what a console kept."""

    unedited: bool = False


class RestoreItem(OwnItemRequest, frozen=True):
    """Puts a deleted face or expression back into the cast."""


class CopyItem(OwnItemRequest, frozen=True):
    """Copies an own face or expression to a new one under a label of its own. An `id` executes once; answered with
    `kept`."""


class Kept(ServerMessage, frozen=True):
    """Answers keep_face, keep_expression and copy_item: the new name in the cast, and its label."""

    id: str
    name: str
    label: str


class ItemChanged(ServerMessage, frozen=True):
    """Answers rename_item, delete_item and restore_item: the label of the item now, and before."""

    id: str
    label: str
    before: str
