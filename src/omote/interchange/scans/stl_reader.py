"""Parses untrusted STL files, ascii and binary: triangles whose corners are joined where they are the same."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.interchange.formats.file_content import MARKS, describe_content, strip_mark
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.scan_parts import (
    LARGEST,
    MOST_TRIANGLES,
    find_doubles,
    make_scan,
    refuse_many,
)  # fmt: skip
from omote.interchange.scans.text_table import TextTable, parse_numbers
from omote.model.fitting.scan import Scan

HEAD = 84
"""Bytes before the first triangle of a binary file: anything, and how many triangles there are."""
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])


def read_stl(data: bytes, beside: Companions | None = None, /) -> Scan:
    """The scan in an STL file; ValueError for an invalid one.

    data: the file; beside: is told what is left out.
    """
    refuse_many(len(data), "bytes", LARGEST)
    if data.startswith(MARKS):
        data = strip_mark(data)
    corners = _read_binary(data) if is_binary_stl(data) else _read_text(data)
    first, inverse = find_doubles(corners)
    return make_scan(corners[first], inverse.reshape(-1, 3), beside=beside)


def is_binary_stl(data: bytes, /) -> bool:
    """Whether bytes are as long as their head says, or begin as no text does."""
    count = int.from_bytes(data[HEAD - 4 : HEAD], "little")
    exact = len(data) == HEAD + count * _TRIANGLE.itemsize
    return len(data) >= HEAD and (exact or data.lstrip()[:5].lower() != b"solid")


def _read_binary(data: bytes) -> Values:
    count = int.from_bytes(data[HEAD - 4 : HEAD], "little")
    refuse_many(count, "triangles", MOST_TRIANGLES)
    if HEAD + count * _TRIANGLE.itemsize > len(data) or not count:
        raise ValueError(
            f"the file is no STL of {count} triangles, but {describe_content(data)} of {len(data)} bytes; "
            f"expected {HEAD + count * _TRIANGLE.itemsize}: copy or export it anew"
        )
    triangles = np.frombuffer(data, _TRIANGLE, count, HEAD)
    return triangles["corners"].reshape(-1, 3).astype(np.float64)


def _read_text(data: bytes) -> Values:
    if data.lstrip()[:5].lower() != b"solid":
        raise ValueError(f"the file is no STL, but {describe_content(data)}; export the scan as .stl, .ply or .obj")
    table = TextTable(data.lower())
    lines = np.flatnonzero((table.initials == np.frombuffer(b"ver", np.uint8)).all(axis=1))
    refuse_many(len(lines) // 3, "triangles", MOST_TRIANGLES)
    numbers = parse_numbers(table.join(lines, skip=len("vertex")), "a vertex of the STL")
    if not len(lines) or len(lines) % 3 or len(numbers) != 3 * len(lines):
        raise ValueError(
            f"the STL has {len(lines)} corners with {len(numbers)} numbers; expected three corners of three numbers "
            "for each triangle: it is cut off or written wrong, export it anew"
        )
    return numbers.reshape(-1, 3)
