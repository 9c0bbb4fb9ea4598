"""Backups of a show file, `NAME.omote.good` and two older ones, made by SQLite while others write.

Each is verified before it takes the newest one's place, and whenever the power goes one of them is there whole.
"""

from __future__ import annotations

import contextlib
import errno
import fcntl
import os
import sqlite3
from collections.abc import Iterator
from pathlib import Path

from omote.showfile.database_errors import explain_database_error
from omote.showfile.identification import ForeignFileError, identify
from omote.showfile.integrity import is_damage, verify_integrity
from omote.showfile.schema import CorruptShowFileError
from omote.showfile.show_file import ShowFile, sync_to_disk

BACKUP_SUFFIXES = (".good", ".good-1", ".good-2")
"""What the names of backups end with, the newest first."""


def backup_paths(path: Path, /) -> tuple[Path, ...]:
    """Where the backups of a show file lie, the newest first."""
    return tuple(path.with_name(path.name + suffix) for suffix in BACKUP_SUFFIXES)


def back_up(show: ShowFile, /) -> bool:
    """Makes a backup of a show file as it is now; others may write it meanwhile.

    False: another process is making one, as where a server ends late; try again. CorruptShowFileError where the file is
    damaged, ForeignFileError where somebody else's file is in a backup's place, sqlite3.Error and OSError where the
    disk fails: the backups of before stay.
    """
    draft = show.path.with_name(show.path.name + ".good-new")
    with _alone(show.path) as alone:
        if alone:
            for file in (draft, *backup_paths(show.path)):
                refuse_foreign(file, show.path)
            try:
                remove(draft)
                copy_verified(show, draft)
                _rotate(draft, show.path)
            finally:
                remove(draft)
        return alone


def copy_verified(show: ShowFile, draft: Path, /) -> None:
    """Copies a show file as it is now and proves the copy; CorruptShowFileError where the file is damaged.

    show: the open file; draft: where the copy is made.
    """
    try:
        show.copy_into(draft)
        verify_integrity(draft)
    except CorruptShowFileError as error:
        raise CorruptShowFileError(str(error).replace(str(draft), str(show.path))) from error
    except sqlite3.DatabaseError as error:
        if is_damage(error):
            raise CorruptShowFileError(f"{show.path} is damaged: {explain_database_error(error)}.") from error
        raise


def refuse_foreign(path: Path, show: Path, /) -> None:
    """Rejects, by ForeignFileError, somebody else's file in the place of a copy of ours.

    path: where the copy belongs; show: the file that it is of.
    """
    identity = identify(path)
    if identity.kind == "foreign":
        raise ForeignFileError(
            f"{path} is {identity.noun}, where a good copy of {show.name} belongs; it stays as it is: move it away."
        )


def _rotate(draft: Path, path: Path) -> None:
    """Puts a backup in the newest one's place, that in the next one's, and so on; the oldest goes."""
    newest, older, oldest = backup_paths(path)
    if older.exists():
        older.replace(oldest)
    if newest.exists():
        try:
            older.hardlink_to(newest)  # there is a newest backup at every moment
        except OSError:  # the disk knows no links
            newest.replace(older)
    put_in_place(draft, newest)


@contextlib.contextmanager
def _alone(path: Path) -> Iterator[bool]:
    """Whether no other process makes a backup; a record lock, which goes with its process, on the file whose flock
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
    """Renames a file so that, whenever the power goes, one of the two is there whole.

    draft: the file, whole; path: its name from now on.
    """
    sync_to_disk(draft)
    draft.replace(path)
    sync_to_disk(path.absolute().parent)


def put_in_free_place(draft: Path, path: Path, /) -> None:
    """Renames a file to where none lies; FileExistsError where one has come, which stays.

    draft: the file, whole; path: its name from now on.
    """
    sync_to_disk(draft)
    try:
        path.hardlink_to(draft)
    except FileExistsError:
        raise
    except OSError:  # the disk knows no links
        if path.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(path)) from None
        draft.replace(path)
    sync_to_disk(path.absolute().parent)
