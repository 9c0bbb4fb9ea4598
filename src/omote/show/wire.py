"""Encodes and decodes messages (MessagePack)."""

from __future__ import annotations

from typing import TypeVar, Union

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.error_reasons import explain_error
from omote.show.declaration import SPEECH_LIMIT, ClientMessage, RequestId, ServerMessage
from omote.show.messages import CLIENT_MESSAGES, SERVER_MESSAGES
from omote.show.validation import Refusal

Said = TypeVar("Said")

_encoder = msgspec.msgpack.Encoder()
_from_client: msgspec.msgpack.Decoder[ClientMessage] = msgspec.msgpack.Decoder(Union[CLIENT_MESSAGES])  # noqa: UP007  (of a tuple)
_from_server: msgspec.msgpack.Decoder[ServerMessage] = msgspec.msgpack.Decoder(Union[SERVER_MESSAGES])  # noqa: UP007


def encode(message: msgspec.Struct) -> bytes:
    """Encodes a message or a document."""
    return _encoder.encode(message)


def decode(data: bytes) -> ClientMessage:
    """Decodes a client's message; Refusal for invalid bytes, and for more than its kind may have."""
    message = message_in(data, _from_client, SPEECH_LIMIT)
    _check_size(data, message.longest)
    return message


def _check_size(data: bytes, limit: int) -> None:
    if len(data) > limit:
        raise Refusal(f"the message has {len(data)} bytes, but at most {limit} are read.")


def message_in(data: bytes, decoder: msgspec.msgpack.Decoder[Said], limit: int) -> Said:
    """Decodes `data`; Refusal for more bytes than `limit`, and for invalid bytes. decoder: of the messages that are
    understood."""
    _check_size(data, limit)
    try:
        return decoder.decode(data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError, OverflowError) as error:
        raise Refusal(
            f"the message cannot be read: {explain_error(error)[:200]}. "
            "Mend the program that sent it; a page: reload it."
        ) from error


class _Identified(msgspec.Struct):
    """What is read of a message that was rejected."""

    id: RequestId = ""


_identified = msgspec.msgpack.Decoder(_Identified)


def id_in(data: bytes) -> str:
    """The id of a message that was rejected, so that its page knows which; "" where none can be read."""
    try:
        return message_in(data, _identified, SPEECH_LIMIT).id
    except Refusal:
        return ""


def decode_answer(data: bytes) -> ServerMessage:
    """Decodes a server's message, for clients written in Python; msgspec.DecodeError for invalid bytes."""
    return _from_server.decode(data)


def le_bytes(array: NDArray[np.generic], dtype: str) -> bytes:
    """The bytes of an array as the given little-endian dtype."""
    return np.ascontiguousarray(array, dtype=dtype).tobytes()
