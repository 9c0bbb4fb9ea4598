"""A good copy beside each show file, `NAME.omote.good`: whole, proved, and replaced only by one that is both."""

from __future__ import annotations

import contextlib
import fcntl
import os
from collections.abc import Iterator
from pathlib import Path

from omote.showfile.integrity import prove
from omote.showfile.show_file import ShowFile


def good_path(path: Path, /) -> Path:
    """Where the good copy of a show file lies."""
    return path.with_name(path.name + ".good")


def keep_good_copy(show: ShowFile, /) -> bool:
    """Makes the good copy of a show file as it is now; others may write it meanwhile.

    False: another process is making it, as where a server ends late; try again. CorruptShowFileError where the file is
    damaged, sqlite3.Error and OSError where the disk fails: the copy of before stays.
    """
    draft = show.path.with_name(show.path.name + ".good-new")
    with _alone(show.path) as alone:
        if alone:
            try:
                remove(draft)
                show.copy_into(draft)
                prove(draft)
                put_in_place(draft, good_path(show.path))
            finally:
                remove(draft)
        return alone


@contextlib.contextmanager
def _alone(path: Path) -> Iterator[bool]:
    """Whether no other process makes the good copy; a record lock, which goes with its process, on the file whose flock
    says which show plays: the two know nothing of each other."""
    descriptor = os.open(path.with_name(path.name + ".lock"), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    try:
        try:
            fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            yield False
        else:
            yield True
    finally:
        os.close(descriptor)


def remove(path: Path, /) -> None:
    """Removes an unfinished file with its logs: SQLite would take those of a killed writer for the next one's."""
    for suffix in ("", "-wal", "-shm", "-journal"):
        path.with_name(path.name + suffix).unlink(missing_ok=True)


def put_in_place(draft: Path, path: Path, /) -> None:
    """Renames a file so that, whenever the power goes, one of the two is there whole."""
    _sync(draft)
    draft.replace(path)
    _sync(path.absolute().parent)


def _sync(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
