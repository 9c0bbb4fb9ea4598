"""A reader for the PNG files that tools/baking writes: 8 bits, four channels, every line minus the one above."""

import struct
import zlib
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray


def chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """The chunks of a PNG by name, their check sums verified."""
    at = 8
    while at < len(data):
        (length,) = struct.unpack_from(">I", data, at)
        name = data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + length]
        assert struct.unpack_from(">I", data, at + 8 + length)[0] == zlib.crc32(name + body)
        yield name, body
        at += 12 + length


def read_png(data: bytes) -> NDArray[np.uint8]:
    """The picture (rows, columns, 4)."""
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    parts = dict(chunks(data))
    columns, rows, *kind = struct.unpack(">IIBBBBB", parts[b"IHDR"])
    assert kind == [8, 6, 0, 0, 0]
    lines = np.frombuffer(zlib.decompress(parts[b"IDAT"]), np.uint8).reshape(rows, 1 + 4 * columns)
    assert (lines[:, 0] == 2).all()
    return np.cumsum(lines[:, 1:], axis=0, dtype=np.uint64).astype(np.uint8).reshape(rows, columns, 4)
