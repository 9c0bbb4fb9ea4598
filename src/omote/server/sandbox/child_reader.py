"""Files of strangers are read in a process of their own, bounded in what it uses; it brings back plain arrays."""

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

from omote.interchange.formats import glb_reader as glbread
from omote.interchange.formats import obj_reader as objfile
from omote.interchange.formats.glb_reader import Piece

SECONDS, MEMORY, FILES = 60, 2 * 2**30, 16
"""What a reader may use: seconds of a processor, bytes beyond what it begins with, open files."""

READERS: Mapping[str, Callable[[bytes], tuple[Piece, ...]]] = {
    ".glb": glbread.read_glb,
    ".obj": lambda data: (Piece("skin", objfile.read_obj(data)),),
}
"""Who reads what, by the end of a file's name."""


class _Plain(msgspec.Struct, frozen=True, array_like=True):
    name: str
    points: bytes
    rows: bytes | None
    moves: dict[str, bytes]


class _Answer(msgspec.Struct, frozen=True, array_like=True):
    pieces: list[_Plain] = []
    refused: str = ""


def read_in_sandbox(path: Path, /) -> tuple[Piece, ...]:
    """The pieces in a GLB or OBJ file; ValueError, in a sentence, for what is none, OSError where it cannot be read."""
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ValueError(f"{path.name!r} is no file with a head; expected {', '.join(READERS)} or .json")
    if path.stat().st_size > glbread.LARGEST:
        raise ValueError(f"{path.name} has {path.stat().st_size} bytes; expected {glbread.LARGEST} at most")
    data = path.read_bytes()
    answer = _run_in_child(lambda: _Answer([_plain(piece) for piece in reader(data)]))
    if answer.refused:
        raise ValueError(f"{path.name}: {answer.refused}")
    return tuple(_piece(plain) for plain in answer.pieces)


def _run_in_child(work: Callable[[], _Answer]) -> _Answer:
    """What a child answers; a refusal where it died of what it read."""
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
    """No more memory than so much, no files, no dumps; whatever lasts too long is ended."""
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
