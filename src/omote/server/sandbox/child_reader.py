"""Parses untrusted GLB and OBJ files in a sandboxed child process with limits on CPU, memory and descriptors.

The child sends back plain arrays, which are validated again here.
"""

from __future__ import annotations

import contextlib
import os
import resource
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats import glb_reader, obj_reader
from omote.interchange.formats.glb_reader import Piece

SECONDS, MEMORY, FILES = 60, 2 * 2**30, 16
"""Limits of the child: CPU seconds, bytes of memory beyond what it starts with, open files."""

READERS: Mapping[str, Callable[[bytes], tuple[Piece, ...]]] = {
    ".glb": glb_reader.read_glb,
    ".obj": obj_reader.read_obj_pieces,
}
"""Parsers by file name suffix."""


class _Plain(msgspec.Struct, frozen=True, array_like=True):
    name: str
    points: bytes
    rows: bytes | None
    moves: dict[str, bytes]


class _Answer(msgspec.Struct, frozen=True, array_like=True):
    pieces: list[_Plain] = []
    refused: str = ""


def read_in_sandbox(path: Path, /) -> tuple[Piece, ...]:
    """Parses a GLB or OBJ file into its pieces; ValueError for an invalid file, OSError where it cannot be read."""
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path.name!r} is no file with a head; expected {', '.join(READERS)} or .json")
    if path.stat().st_size > glb_reader.LARGEST:
        raise ValueError(f"{path.name} has {path.stat().st_size} bytes; expected {glb_reader.LARGEST} at most")
    data = path.read_bytes()
    answer = _run_in_child(lambda: _Answer([_plain(piece) for piece in reader(data)]))
    if answer.refused:
        raise ValueError(f"{path.name}: {answer.refused}")
    return tuple(_piece(plain) for plain in answer.pieces)


def _run_in_child(work: Callable[[], _Answer]) -> _Answer:
    """Runs `work` in a child process; returns its answer, or a rejection where the file exhausted or killed it."""
    come, go = os.pipe()
    child = os.fork()
    if child == 0:
        status = 1
        with contextlib.suppress(BaseException):
            os.close(come)
            _limit_resources()
            with os.fdopen(go, "wb") as pipe:
                pipe.write(msgspec.msgpack.encode(_try_work(work)))
            status = 0
        os._exit(status)
    os.close(go)
    with os.fdopen(come, "rb") as pipe:
        data = pipe.read()
    _, status = os.waitpid(child, 0)
    if status:
        return _Answer(refused="reading it needs more time or memory than any face; export a smaller one")
    return msgspec.msgpack.decode(data, type=_Answer)


def _try_work(work: Callable[[], _Answer]) -> _Answer:
    try:
        return work()
    except ValueError as error:
        return _Answer(refused=str(error))


def _limit_resources() -> None:
    """Limits this process: CPU time, memory, file writes, descriptors; no core dumps."""
    pages = int(Path("/proc/self/statm").read_text().split()[0]) if Path("/proc/self/statm").exists() else 0
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_NOFILE, (FILES, FILES))
    if pages:
        most = pages * resource.getpagesize() + MEMORY
        resource.setrlimit(resource.RLIMIT_AS, (most, most))


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
