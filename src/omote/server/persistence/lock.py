"""Locks a show file, so that only one server plays it."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path


class ShowLockedError(RuntimeError):
    """Another server plays this show file."""


def lock_show(path: Path) -> int:
    """Locks a show file; returns the descriptor that holds the lock, in children too. ShowLockedError when it is taken.

    The lock is on a file beside the show file, so that it stays where it is when a corrupt show file is moved aside. It
    ends with the last process that holds the descriptor, however that process ends. OSError with a message where no
    show file can be.
    """
    try:
        if path.exists() and not path.is_file():
            kind = "folder" if path.is_dir() else "device"
            raise OSError(f"{path} is a {kind}, not a show file: name a file, such as {path.parent / 'show.omote'}.")
        path.parent.mkdir(parents=True, exist_ok=True)
        descriptor = os.open(path.with_name(path.name + ".lock"), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError as error:
        if error.errno is None:
            raise
        raise OSError(f"{path} cannot be opened ({os.strerror(error.errno)}); name another file.") from error
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(descriptor)
        raise ShowLockedError(f"another Omote plays {path} already: stop that one, or name another file.") from error
    return descriptor
