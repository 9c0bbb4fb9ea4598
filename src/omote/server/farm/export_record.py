"""What was exported into a folder, a record for each face: whether its files are whole, current, and still ours.

A record is written before the files that it is of, and names the contents that each may have meanwhile. So whatever
ends a run, the next one tells what it wrote, or was writing, from what somebody else put there.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Literal

import msgspec

from omote.interchange.formats.atomic_file import write_whole
from omote.interchange.formats.error_reasons import explain_error

RECORDS = ".omote-export"
LOCK = "lock"
"""The folder of records in the folder of an export, and what is locked in it while one runs."""
FOREIGN = (
    "is there already and is not as Omote wrote it; it stays as it is: give another folder, or --force to replace it"
)
ExportState = Literal["missing", "former", "current", "foreign"]
"""Of a face's files: not there (not all), of another export of ours, as they are to be, or not as Omote wrote them."""


class Record(msgspec.Struct, frozen=True):
    """An export of a face: its key, and for each file the digests of contents that are ours, the wanted one first."""

    omote: Literal["export"]
    key: str
    files: dict[str, list[str]]


def read_record(folder: Path, name: str) -> Record | None:
    """The record of a name, None where there is none or it is damaged. folder: of the export; name: of the record."""
    try:
        return msgspec.json.decode(_path(folder, name).read_bytes(), type=Record)
    except (OSError, msgspec.DecodeError):
        return None


def find_state(folder: Path, name: str, key: str, main: str) -> ExportState:
    """The state of the files of a name; main: the file or folder that it would have without a record.

    folder: of the export; name: of the record; key: of what the files are to be made of.
    """
    record = read_record(folder, name)
    if find_foreign(folder, name, main):
        return "foreign"
    digests = {path: _digest(folder / path) for path in record.files} if record else {}
    if record is None or not all(digests.values()):
        return "missing"
    whole = all(digest == record.files[path][0] for path, digest in digests.items())
    return "current" if whole and record.key == key else "former"


def find_foreign(folder: Path, name: str, main: str) -> str:
    """The first file of a name that is not as Omote wrote it, as a path from the folder; "" where there is none.

    folder: of the export; name: of the record; main: as of `find_state`.
    """
    record = read_record(folder, name)
    if record is None:
        return main if (folder / main).exists() else ""
    digests = ((path, _digest(folder / path)) for path in record.files)
    return next((path for path, digest in digests if digest and digest not in record.files[path]), "")


def store_export(folder: Path, name: str, key: str, files: Mapping[str, bytes], *, force: bool = False) -> None:
    """Writes files under a record; FileExistsError where one is there that Omote did not write, OSError as
    `write_whole`.

    folder: of the export; name: of the record; key: of what the files are made of; files: their bytes by path; force:
    overwrites what is there.
    """
    old = read_record(folder, name)
    recorded = {} if old is None else old.files
    accepted = {}
    for path, data in files.items():
        there = _digest(folder / path)
        if there and there not in recorded.get(path, []) and not force:
            raise FileExistsError(f"{folder / path} {FOREIGN}")
        accepted[path] = list(dict.fromkeys(filter(None, [hash_content(data), there])))
    write_whole(_path(folder, name), msgspec.json.encode(Record("export", key, accepted)))
    for path, data in reversed(list(files.items())):  # what is named comes last, when all that it names is there
        _make_folder((folder / path).parent)
        write_whole(folder / path, data)


@contextmanager
def open_folder(folder: Path) -> Iterator[None]:
    """Makes a folder for an export that no other one writes into meanwhile; OSError with a sentence where it cannot be.

    What a run was writing when it was killed is removed.
    """
    _make_folder(folder / RECORDS)
    if not os.access(folder, os.W_OK):
        raise PermissionError(f"nothing can be written into {folder}; choose another folder")
    descriptor = os.open(folder / RECORDS / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise BlockingIOError(f"another omote export writes into {folder}; wait for it, or stop it") from error
        _clear_drafts(folder)
        yield
    finally:
        os.close(descriptor)


def hash_content(data: bytes) -> str:
    """The digest of a file's content."""
    return hashlib.blake2b(data, digest_size=16).hexdigest()


def _clear_drafts(folder: Path) -> None:
    """Removes what `write_whole` had begun to write beside recorded files, and beside their records."""
    for record in (folder / RECORDS).glob("*.json"):
        former = read_record(folder, record.name.removesuffix(".json"))
        for path in [record, *((folder / file) for file in (former.files if former else ()))]:
            for draft in path.parent.glob(f".{path.name[:100]}.????????"):
                draft.unlink(missing_ok=True)


def _path(folder: Path, name: str) -> Path:
    return folder / RECORDS / f"{name}.json"


def _digest(path: Path) -> str:
    """The digest of a file, "" where there is none."""
    with suppress(FileNotFoundError, NotADirectoryError), path.open("rb") as file:
        return hashlib.file_digest(file, lambda: hashlib.blake2b(digest_size=16)).hexdigest()
    return ""


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OSError(f"the folder {folder} cannot be made: {explain_error(error)}; name another one") from error
