"""Parses the vertices of untrusted Wavefront OBJ files, in their order; one file is one shape of a mesh."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.file_content import describe_content
from omote.interchange.formats.glb_reader import Piece

LARGEST = 128 * 2**20
"""Bytes of a file at most."""
MOST_VERTICES = 1_000_000
SKIN = "skin"
_NUMBERS = 6  # x, y, z, and what some programs write after them: a weight, or a colour


def read_obj(data: bytes, /) -> NDArray[np.float64]:
    """Parses the vertices (n, 3) of an OBJ file; ValueError where it has none or one is invalid."""
    if len(data) > LARGEST:
        raise ValueError(f"the file has {len(data)} bytes; expected {LARGEST} at most")
    lines = [line for line in data.splitlines() if line.lstrip()[:2] in (b"v ", b"v\t")]
    if not lines:
        raise ValueError(f"the file is no OBJ with vertices, but {describe_content(data)}; export the head as .obj")
    if not 1 <= len(lines) <= MOST_VERTICES:
        raise ValueError(f"the file has {len(lines)} vertices; expected an OBJ file of 1 to {MOST_VERTICES}")
    points = np.array([_point(line) for line in lines])
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        raise ValueError(f"vertex {bad[0] + 1} is {points[bad[0]]}; expected finite numbers: export the file anew")
    return points


def read_obj_pieces(data: bytes, /) -> tuple[Piece, ...]:
    """The head in an OBJ file: the mesh of each object where one is named SKIN, as an export names them; else all
    vertices as one mesh, the skin. Errors as `read_obj`."""
    points = read_obj(data)
    words = [line.split(maxsplit=1) for line in data.splitlines() if line.lstrip()[:2] in (b"v ", b"v\t", b"o ")]
    starts: dict[str, int] = {}
    seen = 0
    for word, rest in words:
        if word == b"v":
            seen += 1
        else:
            starts.setdefault(rest.strip().decode("utf-8", "replace"), seen)
    if SKIN not in starts:
        return (Piece(SKIN, points),)
    ends = [*list(starts.values())[1:], len(points)]
    parts = {name: points[first:end] for (name, first), end in zip(starts.items(), ends, strict=True)}
    return tuple(Piece(name, part) for name, part in parts.items() if len(part))


def _point(line: bytes) -> list[float]:
    words = line.split()[1:]
    try:
        numbers = [float(word) for word in words[:_NUMBERS]]
    except ValueError:
        numbers = []
    if len(numbers) < 3:
        raise ValueError(f"the line {line[:80].decode('ascii', 'replace')!r} is no vertex; expected v x y z")
    return numbers[:3]
