"""Messages to bytes and back."""

from __future__ import annotations

from typing import TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.show.messages import MESSAGE_LIMIT, FromClient, FromServer
from omote.show.validation import Refusal

Said = TypeVar("Said")

_encoder = msgspec.msgpack.Encoder()
_from_client: msgspec.msgpack.Decoder[FromClient] = msgspec.msgpack.Decoder(FromClient)
_from_server: msgspec.msgpack.Decoder[FromServer] = msgspec.msgpack.Decoder(FromServer)


def encode(message: msgspec.Struct) -> bytes:
    """The bytes of a message or a document."""
    return _encoder.encode(message)


def decode(data: bytes) -> FromClient:
    """The client's message in `data`; Refusal for bytes that are none."""
    return message_in(data, _from_client, MESSAGE_LIMIT)


def message_in(data: bytes, decoder: msgspec.msgpack.Decoder[Said], limit: int) -> Said:
    """What `decoder` reads in `data`; Refusal for more bytes than `limit`, and for bytes that are no message."""
    if len(data) > limit:
        raise Refusal(f"the message has {len(data)} bytes, but at most {limit} are read.")
    try:
        return decoder.decode(data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError, OverflowError) as error:
        raise Refusal(f"the message cannot be read: {str(error)[:200]}.") from error


def decode_answer(data: bytes) -> FromServer:
    """The server's message in `data`, for clients written in Python; msgspec.DecodeError for bytes that are none."""
    return _from_server.decode(data)


def le_bytes(array: NDArray[np.generic], dtype: str) -> bytes:
    """The bytes of an array for a document, as the little-endian dtype that it names."""
    return np.ascontiguousarray(array, dtype=dtype).tobytes()
