"""Writes files atomically, and checks before any work that a file can be written."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path


def check_writable(path: Path) -> None:
    """Raises OSError with a message where a file cannot be written at this path."""
    if path.is_dir():
        raise IsADirectoryError(f"{path} is a folder; give the name of a file in it")
    folder = path.absolute().parent
    if not folder.is_dir():
        raise FileNotFoundError(f"there is no folder {folder}; make it, or write somewhere else")
    if not os.access(folder, os.W_OK):
        raise PermissionError(f"nothing can be written into {folder}; choose another folder")


def write_whole(path: Path, data: bytes) -> None:
    """Writes a file atomically (temporary file, then rename): readers see the old file or the whole new one."""
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
