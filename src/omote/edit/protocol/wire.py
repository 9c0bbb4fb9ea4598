"""Encodes and decodes editors' messages (MessagePack) and recipes (JSON)."""

from __future__ import annotations

from typing import Union

import msgspec

from omote.edit.protocol.messages import (
    EDITING_LIMIT,
    EDITOR_MESSAGES,
    EditorMessage,
    FromEditor,
    HandlesAsset,
    TangentsAsset,
    ToEditor,
)
from omote.edit.protocol.orders import Baked
from omote.interchange.formats.error_reasons import explain_error
from omote.model.recipes.recipe import AnyRecipe
from omote.show.access.access_role import HIGHEST, AccessRole, explain_missing_role, role_allows
from omote.show.validation import Refusal
from omote.show.wire import message_in

_encoder = msgspec.msgpack.Encoder()
_from_editor: msgspec.msgpack.Decoder[FromEditor] = msgspec.msgpack.Decoder(Union[EDITOR_MESSAGES])  # noqa: UP007  (of a tuple)
_to_editor: msgspec.msgpack.Decoder[ToEditor] = msgspec.msgpack.Decoder(ToEditor)
_baked = msgspec.msgpack.Decoder(Baked)
_recipe: msgspec.json.Decoder[AnyRecipe] = msgspec.json.Decoder(AnyRecipe)
_json = msgspec.json.Encoder()


def encode(message: FromEditor | ToEditor | TangentsAsset | HandlesAsset | Baked) -> bytes:
    """Encodes a message, a document or an answer of the workshop."""
    return _encoder.encode(message)


def decode(data: bytes, role: AccessRole = HIGHEST) -> FromEditor:
    """Decodes an editor's message; Refusal where it cannot be read, or its sender may not send it.

    data: MessagePack; role: of the sender.
    """
    message = message_in(data, _from_editor, EDITING_LIMIT)
    needed = message.access if isinstance(message, EditorMessage) else EditorMessage.access  # `cancel`, of both links
    if not role_allows(role, needed):
        raise Refusal(explain_missing_role(role, needed))
    return message


class _Numbered(msgspec.Struct):
    """What is read of a message that was rejected."""

    request: int = -1


_numbered = msgspec.msgpack.Decoder(_Numbered)


def request_in(data: bytes) -> int:
    """The number of a request that was rejected, so that its page knows which; -1 where none can be read."""
    try:
        return message_in(data, _numbered, EDITING_LIMIT).request
    except Refusal:
        return -1


def decode_answer(data: bytes) -> ToEditor:
    """Decodes a server's message, for editors written in Python; msgspec.DecodeError for invalid bytes."""
    return _to_editor.decode(data)


def decode_baked(data: bytes) -> Baked:
    """Decodes an answer of the workshop; Refusal for invalid bytes."""
    try:
        return _baked.decode(data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError, OverflowError) as error:
        raise Refusal(f"the workshop's answer cannot be read ({_reason(error)}): try again.") from error


def write_recipe(recipe: AnyRecipe) -> bytes:
    """Encodes a recipe as the show file stores it (JSON); the same recipe gives the same bytes."""
    return _json.encode(recipe)


def read_recipe(data: bytes) -> AnyRecipe:
    """Decodes a recipe that `write_recipe` wrote; Refusal for anything else."""
    try:
        return _recipe.decode(data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise Refusal(f"the recipe that is kept cannot be read ({_reason(error)}): open another revision.") from error


def _reason(error: Exception) -> str:
    return explain_error(error)[:200]
