"""Picture files: refused before anything is drawn where they could not be written, and written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Literal

Kind = Literal["image/png", "image/jpeg"]

KINDS: dict[str, Kind] = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg"}


def picture_kind(path: Path) -> Kind:
    """The media type that a file's name asks for; ValueError for a name that asks for none."""
    kind = KINDS.get(path.suffix.lower())
    if kind is None:
        raise ValueError(f"{path.name!r} is no name of a picture; end it with {' or '.join(KINDS)}")
    return kind


def check_writable(path: Path) -> None:
    """OSError with a sentence where a file cannot be written at this place."""
    if path.is_dir():
        raise IsADirectoryError(f"{path} is a folder; give the name of a file in it")
    folder = path.absolute().parent
    if not folder.is_dir():
        raise FileNotFoundError(f"there is no folder {folder}; make it, or write somewhere else")
    if not os.access(folder, os.W_OK):
        raise PermissionError(f"nothing can be written into {folder}; choose another folder")


def write_picture(path: Path, data: bytes) -> None:
    """Writes a file in one step: a reader sees the old one, or none, until all of the new one is there."""
    check_writable(path)
    folder = path.absolute().parent
    handle, draft = tempfile.mkstemp(prefix=f".{path.name}.", dir=folder)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        Path(draft).chmod(0o666 & ~_mask())
        Path(draft).replace(path)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise


def _mask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
