"""Opens a show file that no show plays, for a command."""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from omote.server.persistence.lock import ShowLockedError, lock_show, release_lock
from omote.server.persistence.memory_copy import find_copy, remove_copy
from omote.showfile.backup import back_up
from omote.showfile.identification import locate_show
from omote.showfile.inspection import what_opens
from omote.showfile.recovery import is_lost
from omote.showfile.show_file import CorruptShowFileError, ShowFile, ShowFileError, open_show

BY_PAGES = (
    "While it runs, files are taken in by its console and its editor, and a list of cues by its server (POST "
    "/cue_lists/main)."
)


@contextmanager
def open_offline_show(path: Path, *, new: bool = False, instead: str = BY_PAGES) -> Iterator[ShowFile]:
    """The show file, ours alone until the end; new: made where there is none, and backed up at the end.

    FileNotFoundError where there is none, ShowLockedError where a show plays it, ShowFileError where it cannot be used.

    path: of the show file; links are followed; instead: what can be done while a show plays it, in a sentence.
    """
    path = locate_show(path)
    if not new and not path.exists():
        raise FileNotFoundError(f"there is no show file {path}; `omote show {path}` makes one")
    if is_lost(path):  # a new one in its place would push its backups out
        raise ShowFileError(
            f"{path} is not there or empty, but its good copies are: open it with `omote show {path}`, which brings "
            "them back, then repeat this."
        )
    lock = _lock_idle(path, instead)
    if (copy := find_copy(path)) is not None:
        remove_copy(copy)  # left by a show whose processes were all killed
    try:
        file = _open_whole(path)
        try:
            yield file
            if new:
                with suppress(sqlite3.Error, OSError, ShowFileError):  # the work is done; a show makes the next one
                    back_up(file)
        finally:
            file.close()
    finally:
        release_lock(path, lock)


def _lock_idle(path: Path, instead: str) -> int:
    try:
        return lock_show(path)
    except ShowLockedError as error:
        raise ShowLockedError(f"{error} End that show first. {instead}") from error


def _open_whole(path: Path) -> ShowFile:
    try:
        return open_show(path)
    except CorruptShowFileError as error:
        raise CorruptShowFileError(f"{error} {what_opens(path)}") from error


def wall_clock() -> float:
    """Seconds since 1970, shown in histories."""
    return time.time_ns() / 1e9
