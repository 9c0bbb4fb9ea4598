"""Reads scans and pictures of strangers in a sandboxed child process; what comes back is validated again.

Besides the given file the child reads only files that lie beside it or in folders below: names in a file never lead
elsewhere, by `..`, by whole paths or by links.
"""

from __future__ import annotations

from pathlib import Path, PurePosixPath

import numpy as np
from numpy.typing import NDArray

from omote.interchange.scans.companions import Companions
from omote.interchange.scans.picture_reader import LARGEST_PICTURE, read_picture, write_plain
from omote.interchange.scans.scan_parts import LARGEST
from omote.interchange.scans.scan_reader import ScanFile, read_scan
from omote.server.sandbox.child_task import Limits, Tell, ignore_progress, run_limited

LIMITS = Limits(seconds=120, patience=1800.0, memory=6 * 2**30)
_TOO_LARGE = "decoding it needs more time or memory than any photograph"
_TOO_MUCH = "reading it needs more time or memory than any scan of a head; export one with fewer points"


def read_scan_in_sandbox(path: Path, /, *, follow: Tell = ignore_progress) -> ScanFile:
    """Reads a scan of any format that `scan_reader` knows.

    Parameters
    ----------
    path : Path
        Its file.
    follow : callable
        Told the progress.

    Returns
    -------
    ScanFile
        The scan, and sentences about what could not be used.

    Raises
    ------
    ValueError
        With the file's name and what to do, for any file that is no scan.
    OSError
        Where the file cannot be read.
    """
    data = _read_whole(path, LARGEST)

    def work(tell: Tell) -> ScanFile:
        tell(0.0, "reading")
        scan_file = read_scan(path.suffix, data, Companions(lambda name: find_beside(path, name)))
        tell(0.9, "handing it over")
        return scan_file

    try:
        return run_limited(work, ScanFile, LIMITS, exhausted=_TOO_MUCH, follow=follow)
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error


def read_picture_in_sandbox(path: Path, /) -> NDArray[np.uint8]:
    """Decodes a picture (height, width, 3), sRGB; ValueError with what to do for another file, OSError where it cannot
    be read."""
    data = _read_whole(path, LARGEST_PICTURE)
    try:
        return run_limited(
            lambda _: read_picture(data), NDArray[np.uint8], LIMITS,
            exhausted=_TOO_LARGE,
        )  # fmt: skip
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error


def read_photograph_in_sandbox(path: Path, longest: int, /) -> bytes:
    """A photograph as a JPEG that every browser shows, upright, its longer side no longer than `longest` pixels, with
    its pixels alone; errors as `read_picture_in_sandbox`.

    path: of the photograph; longest: pixels.
    """
    data = _read_whole(path, LARGEST_PICTURE)
    try:
        return run_limited(lambda _: write_plain(read_picture(data), longest), bytes, LIMITS, exhausted=_TOO_LARGE)
    except ValueError as error:
        raise ValueError(f"{path.name}: {error}") from error


def find_beside(path: Path, name: str, /) -> bytes | None:
    """The bytes of the file of this name beside a scan, or in a folder below it; None where there is none.

    Whole paths of another machine, and ones that lead elsewhere, are taken by their last part alone.

    path: of the scan; name: as the scan's file gives it.
    """
    folder = path.resolve().parent
    parts = PurePosixPath(name.replace("\\", "/")).parts
    inside = parts and not any(part == ".." or part == "/" or ":" in part for part in parts)
    for way in ([Path(*parts)] if inside else []) + [Path(part) for part in parts[-1:] if part not in ("..", "/")]:
        try:
            file = (folder / way).resolve()
            if file.is_relative_to(folder) and file.is_file() and file.stat().st_size <= LARGEST:
                return file.read_bytes()
        except (OSError, ValueError):  # no name of a file: too long, with a zero in it
            continue
    return None


def _read_whole(path: Path, largest: int) -> bytes:
    """The bytes of a file; ValueError where it is none, or too large."""
    if not path.exists():
        raise FileNotFoundError(f"there is no file {path}; name one that is there")
    if not path.is_file():
        raise ValueError(f"{path} is no file but {'a folder' if path.is_dir() else 'a device'}; name the files in it")
    size = path.stat().st_size
    if size > largest:
        raise ValueError(f"{path.name} has {size} bytes; expected {largest} at most: export it with fewer points")
    return path.read_bytes()
