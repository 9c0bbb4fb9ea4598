"""Writes files atomically, and checks before any work that a file can be written and nothing of others is lost."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

from omote.interchange.formats.error_reasons import explain_error

SIGNATURES: Mapping[str, tuple[str, tuple[bytes, ...]]] = {
    ".png": ("PNG picture", (b"\x89PNG\r\n\x1a\n",)),
    ".jpg": ("JPEG picture", (b"\xff\xd8\xff",)),
    ".jpeg": ("JPEG picture", (b"\xff\xd8\xff",)),
    ".glb": ("GLB file", (b"glTF",)),
    ".vrm": ("VRM file", (b"glTF",)),
    ".usdc": ("USD file", (b"PXR-USDC",)),
    ".usda": ("USD file", (b"#usda ",)),
    ".usdz": ("USDZ file", (b"PK\x03\x04",)),
    ".obj": ("OBJ file", (b"#", b"mtllib ", b"o ", b"g ", b"v ")),
    ".mtl": ("MTL file", (b"#", b"newmtl ")),
    ".npz": ("NPZ file", (b"PK\x03\x04",)),
    ".csv": ("table that Omote wrote", (b"expression,facs,mesh,",)),
}
"""What files of a name's ending begin with: a new one takes the place of its own kind only."""
OWN_MARK = b'"omote"'
MOST_READ = 200
ALIKE = 16
"""What stands in the first bytes of a document of ours; bytes in which two contents of a kind are alike."""


def check_writable(path: Path, begin: bytes = b"") -> None:
    """Raises OSError with a message where a file cannot be written at this path, or another kind of file is there.

    begin: how the new content begins, where it is known: what begins as it does is of its kind.
    """
    if path.is_dir():
        raise IsADirectoryError(f"{path} is a folder; give the name of a file in it")
    folder = require_parent(path)
    if path.exists():
        _refuse_other_kind(path, begin)
    if not os.access(folder, os.W_OK):
        raise PermissionError(f"nothing can be written into {folder}; choose another folder")


def require_parent(path: Path) -> Path:
    """Returns the folder that a path really lies in; FileNotFoundError with a message where there is none."""
    folder = locate(path).parent
    if not folder.is_dir():
        raise FileNotFoundError(f"there is no folder {folder}; make it, or write somewhere else")
    return folder


def require_free(path: Path, *, force: bool) -> None:
    """Raises FileExistsError with a message where a file is at this path that nobody said may be replaced.

    path: of the file; force: whether somebody said so.
    """
    if path.is_file() and not force:
        raise FileExistsError(
            f"{path} is there already and stays as it is; give another name, or --force to replace it"
        )


def write_whole(path: Path, data: bytes) -> None:
    """Writes a file atomically (temporary file, then rename): readers see the old file or the whole new one.

    Where the path is a link, the file that it leads to is written. Errors as `check_writable`.

    path: of the file; data: all of it.
    """
    check_writable(path, data[:ALIKE])
    path = locate(path)
    draft = ""
    try:
        handle, draft = tempfile.mkstemp(prefix=f".{path.name[:100]}.", dir=path.parent)
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        Path(draft).chmod(0o666 & ~_mask())
        Path(draft).replace(path)
    except OSError as error:
        raise OSError(f"{path} cannot be written: {explain_error(error)}; what was there stays as it is") from error
    finally:
        if draft:
            Path(draft).unlink(missing_ok=True)


def locate(path: Path) -> Path:
    """Where a file really lies: links are followed, not replaced."""
    try:
        return path.resolve()
    except (OSError, RuntimeError) as error:
        raise FileNotFoundError(f"the links of {path} lead in a circle; write somewhere else") from error


def _refuse_other_kind(path: Path, begin: bytes) -> None:
    """FileExistsError for a device, and for a file that is not of the kind that its new content is."""
    if not path.is_file():
        raise FileExistsError(f"{path} is no file but a device; give the name of a file")
    with path.open("rb") as file:
        head = file.read(MOST_READ)
    noun, marks = SIGNATURES.get(path.suffix.lower(), ("document that Omote wrote", ()))
    same = head.startswith((*marks, begin) if begin else marks) or (not marks and OWN_MARK in head)
    if head and not same:
        raise FileExistsError(f"{path} is there already and is no {noun}; it stays as it is: delete or rename it first")


def _mask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
