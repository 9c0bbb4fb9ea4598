"""A show file that is moved, renamed, deleted or replaced while it is open is made anew from its open connections.

SQLite goes on with the file that it opened, wherever that lies now, or although no name leads to it any more: its
online backup reads it as before. Only the next start would not find it.
"""

from __future__ import annotations

import contextlib
import itertools
import sqlite3
from pathlib import Path

from omote.showfile.backup import (
    back_up,
    backup_paths,
    copy_verified,
    put_in_free_place,
    put_in_place,
    refuse_foreign,
    remove,
)
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import FilePlace, ShowFile, identify_file


def relocate_show(show: ShowFile, /) -> Path:
    """Makes an open show file anew with all that was committed, and goes on with it; gives where.

    At its path, unless somebody else's file or log lies there now: that stays, and the file is made beside it. Neither
    `show` nor what `again` opened may be in use. ShowFileError, OSError, sqlite3.Error: all go on with the old file.
    """
    place = show.place
    place.path.parent.mkdir(parents=True, exist_ok=True)
    with contextlib.suppress(sqlite3.Error):
        show.merge_log()  # so that the moved file is whole without it
    free = _is_free(place)
    path = place.path if free else find_free_path(place.path)
    if free and not back_up(show):  # the next start opens this, should we end half way
        raise ShowFileError(f"another process makes a copy of {path}; it is tried again.")
    draft = path.with_name(path.name + ".recovered")
    refuse_foreign(draft, path)
    try:
        remove(draft)
        copy_verified(show, draft)
        _put(draft, path, place)
    finally:
        remove(draft)
    show.follow(path)
    return path


def find_free_path(path: Path, /) -> Path:
    """The first of `NAME-2.omote`, `NAME-3.omote` ... where no show is or was."""
    names = (path.with_name(f"{path.stem}-{number}{path.suffix}") for number in itertools.count(2))
    return next(name for name in names if not any(file.exists() for file in (name, *_beside(name))))


def _beside(path: Path) -> tuple[Path, ...]:
    logs = [path.with_name(path.name + suffix) for suffix in ("-wal", "-shm", ".lock")]
    return (*logs, *backup_paths(path))


def _is_free(place: FilePlace) -> bool:
    """Whether nobody else's file lies where the show file and its log belong."""
    return identify_file(place.path) in (None, place.file) and identify_file(place.log_path) in (None, place.log)


def _put(draft: Path, path: Path, place: FilePlace) -> None:
    """Puts the new file in its place, without the old one's log, which SQLite would take for the new one's."""
    if path == place.path:
        for suffix in ("-wal", "-shm"):
            path.with_name(path.name + suffix).unlink(missing_ok=True)
        if identify_file(path) == place.file:
            return put_in_place(draft, path)
    return put_in_free_place(draft, path)
