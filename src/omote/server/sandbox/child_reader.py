"""Parses untrusted GLB and OBJ files in a sandboxed child process with limits on CPU, memory and descriptors.

The child sends back plain arrays, which are validated again here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats import glb_reader, obj_reader
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.scans.gltf.vrm_expressions import read_vrm_expressions
from omote.server.sandbox.child_task import Limits, run_limited

LIMITS = Limits(seconds=60, memory=2 * 2**30)
_TOO_MUCH = "reading it needs more time or memory than any face; export a smaller one"

_read_avatar = partial(glb_reader.read_glb, naming=read_vrm_expressions)

READERS: Mapping[str, Callable[[bytes], tuple[Piece, ...]]] = {
    ".glb": _read_avatar,
    ".vrm": _read_avatar,
    ".obj": obj_reader.read_obj_pieces,
}
"""Parsers by file name suffix."""


class _Plain(msgspec.Struct, frozen=True, array_like=True):
    name: str
    points: bytes
    rows: bytes | None
    moves: dict[str, bytes]


def read_in_sandbox(path: Path, /) -> tuple[Piece, ...]:
    """Parses a GLB or OBJ file into its pieces; ValueError for an invalid file, OSError where it cannot be read."""
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path.name!r} is no file with a head; expected {', '.join(READERS)} or .json")
    if path.stat().st_size > glb_reader.LARGEST:
        raise ValueError(f"{path.name} has {path.stat().st_size} bytes; expected {glb_reader.LARGEST} at most")
    data = path.read_bytes()
    try:
        answer = run_limited(
            lambda _: msgspec.msgpack.encode([_plain(piece) for piece in reader(data)]), LIMITS, exhausted=_TOO_MUCH
        )
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error
    return tuple(_piece(plain) for plain in msgspec.msgpack.decode(answer, type=list[_Plain]))


def _plain(piece: Piece) -> _Plain:
    rows = None if piece.rows is None else piece.rows.tobytes()
    return _Plain(piece.name, piece.points.tobytes(), rows, {name: m.tobytes() for name, m in piece.moves.items()})


def _piece(plain: _Plain) -> Piece:
    points = _array(plain.points)
    moves = {name: _array(data) for name, data in plain.moves.items()}
    rows = None if plain.rows is None else np.frombuffer(plain.rows, np.int64)
    if any(len(each) != len(points) for each in (*moves.values(), points if rows is None else rows)):
        raise ValueError("a reader brought back arrays that do not belong together")
    return Piece(plain.name, points, rows, moves)


def _array(data: bytes) -> NDArray[Any]:
    return np.frombuffer(data, np.float64).reshape(-1, 3)
