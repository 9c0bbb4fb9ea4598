"""Encodes and decodes PNG pictures of 8 bits a channel as arrays: the bake's, exported textures and rendered ones."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Collection

import numpy as np
from numba import njit
from numpy.typing import NDArray

Picture = NDArray[np.uint8]

SIGNATURE = b"\x89PNG\r\n\x1a\n"
_COLOURS = {3: 2, 4: 6}
_UP, _PAETH = 2, 4  # filters of a line: less the line above; less the nearest of three neighbours


def png_bytes(picture: Picture, /) -> bytes:
    """A PNG of a picture (rows, columns, 3 or 4); alpha is not multiplied into the colours."""
    rows, columns, channels = picture.shape
    below = picture.astype(np.int16)
    lines = np.concatenate([below[:1], np.diff(below, axis=0)]).astype(np.uint8).reshape(rows, -1)
    filtered = np.concatenate([np.full((rows, 1), _UP, np.uint8), lines], axis=1)
    head = struct.pack(">IIBBBBB", columns, rows, 8, _COLOURS[channels], 0, 0, 0)
    body = zlib.compress(filtered.tobytes(), 6)
    return SIGNATURE + _chunk(b"IHDR", head) + _chunk(b"IDAT", body) + _chunk(b"IEND", b"")


def read_png(data: bytes, /, sides: Collection[int] | None = None) -> Picture:
    """The picture (rows, columns, 3 or 4) in a PNG of 8 bits a channel, not interlaced; ValueError for any other.

    sides: how many rows and columns there may be; nothing is unpacked of other pictures, nor beyond what the head says.
    """
    try:
        parts = _parts(data)
        columns, rows, depth, colour, *rest = struct.unpack(">IIBBBBB", parts[b"IHDR"])
        channels = {kind: count for count, kind in _COLOURS.items()}[colour]
        if sides is not None and not (rows in sides and columns in sides):
            raise ValueError(f"it has {rows} rows of {columns}")
        lines = _lines(parts[b"IDAT"], rows, 1 + channels * columns)
    except (struct.error, KeyError, ValueError, OverflowError, zlib.error) as error:
        raise ValueError("a picture is no PNG of 8 bits and 3 or 4 channels") from error
    if depth != 8 or any(rest) or (lines[:, 0] > _PAETH).any():
        raise ValueError("a picture is a PNG of another kind; expected 8 bits a channel, not interlaced")
    if (lines[:, 0] == _UP).all():  # as `png_bytes` writes it
        return np.cumsum(lines[:, 1:], axis=0, dtype=np.uint64).astype(np.uint8).reshape(rows, columns, channels)
    return _unfilter(lines, channels).reshape(rows, columns, channels)


@njit(cache=True)
def _unfilter(lines: Picture, channels: int) -> Picture:
    """Undoes the filters of lines (PNG specification, section 9): none, sub, up, average, Paeth."""
    rows, width = lines.shape[0], lines.shape[1] - 1
    found = np.zeros((rows + 1, width + channels), np.uint8)  # a line above, a pixel to the left: all zero
    for row in range(rows):
        kind = lines[row, 0]
        for column in range(width):
            left = np.int32(found[row + 1, column])
            above = np.int32(found[row, column + channels])
            corner = np.int32(found[row, column])
            guess = np.int32(0)
            if kind == 1:
                guess = left
            elif kind == _UP:
                guess = above
            elif kind == 3:
                guess = (left + above) // 2
            elif kind == _PAETH:
                away_left, away_above = abs(above - corner), abs(left - corner)
                away_corner = abs(left + above - 2 * corner)
                if away_left <= away_above and away_left <= away_corner:
                    guess = left
                else:
                    guess = above if away_above <= away_corner else corner
            found[row + 1, column + channels] = (np.int32(lines[row, column + 1]) + guess) & 255
    return found[1:, channels:].copy()


def _lines(packed: bytes, rows: int, width: int) -> Picture:
    plain = zlib.decompressobj().decompress(packed, rows * width + 1)
    return np.frombuffer(plain, np.uint8).reshape(rows, width)


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
