"""Encodes and decodes PNG pictures of 8 bits a channel as arrays: for the bake and for exported textures."""

from __future__ import annotations

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]

SIGNATURE = b"\x89PNG\r\n\x1a\n"
_COLOURS = {3: 2, 4: 6}
_UP = 2  # the filter of every line: less the line above


def png_bytes(picture: Picture, /) -> bytes:
    """A PNG of a picture (rows, columns, 3 or 4); alpha is not multiplied into the colours."""
    rows, columns, channels = picture.shape
    below = picture.astype(np.int16)
    lines = np.concatenate([below[:1], np.diff(below, axis=0)]).astype(np.uint8).reshape(rows, -1)
    filtered = np.concatenate([np.full((rows, 1), _UP, np.uint8), lines], axis=1)
    head = struct.pack(">IIBBBBB", columns, rows, 8, _COLOURS[channels], 0, 0, 0)
    body = zlib.compress(filtered.tobytes(), 6)
    return SIGNATURE + _chunk(b"IHDR", head) + _chunk(b"IDAT", body) + _chunk(b"IEND", b"")


def read_png(data: bytes, /) -> Picture:
    """The picture (rows, columns, 3 or 4) in a PNG as `png_bytes` and the bake write it; ValueError for any other."""
    try:
        parts = _parts(data)
        columns, rows, depth, colour, *rest = struct.unpack(">IIBBBBB", parts[b"IHDR"])
        channels = {kind: count for count, kind in _COLOURS.items()}[colour]
        lines = np.frombuffer(zlib.decompress(parts[b"IDAT"]), np.uint8).reshape(rows, 1 + channels * columns)
    except (struct.error, KeyError, ValueError, zlib.error) as error:
        raise ValueError("a picture is no PNG of 8 bits and 3 or 4 channels") from error
    if depth != 8 or any(rest) or (lines[:, 0] != _UP).any():
        raise ValueError("a picture is a PNG of another kind; expected the one that `make bake` writes")
    return np.cumsum(lines[:, 1:], axis=0, dtype=np.uint64).astype(np.uint8).reshape(rows, columns, channels)


def _parts(data: bytes) -> dict[bytes, bytes]:
    if not data.startswith(SIGNATURE):
        raise ValueError("it does not begin as one")
    parts, at = dict[bytes, bytes](), len(SIGNATURE)
    while at < len(data):
        length, name = struct.unpack_from(">I4s", data, at)
        parts[name] = parts.get(name, b"") + data[at + 8 : at + 8 + length]
        at += 12 + length
    return parts


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
