"""Locks a show file, so that only one server plays it."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path

from omote.interchange.formats.error_reasons import explain_error
from omote.showfile.backup import BACKUP_SUFFIXES
from omote.showfile.recovery import reject_unproven
from omote.showfile.schema import ShowFileError


class ShowLockedError(RuntimeError):
    """Another server plays this show file."""


def lock_show(path: Path) -> int:
    """Locks a show file; returns the descriptor that holds the lock, in children too. ShowLockedError when it is taken.

    The lock is on a file beside the show file, so that it stays where it is when a corrupt show file is moved aside. It
    ends with the last process that holds the descriptor, however that process ends. ShowFileError where no show file
    can be; then nothing is made beside what is there.
    """
    if path.name.endswith(BACKUP_SUFFIXES):
        raise ShowFileError(f"{path} is the good copy of another show: copy it under a name of its own, and open that.")
    reject_unproven(path)
    return take_lock(path)


def take_lock(path: Path) -> int:
    """The lock alone: what lies there is not looked at, for that would free SQLite's own locks of an open file."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        descriptor = os.open(path.with_name(path.name + ".lock"), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError as error:
        raise ShowFileError(f"{path} cannot be opened ({explain_error(error)}): name another file.") from error
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(descriptor)
        raise ShowLockedError(f"another Omote plays {path} already: stop that one, or name another file.") from error
    return descriptor
