"""Locks a show file, so that only one server plays it."""

from __future__ import annotations

import fcntl
import os
from contextlib import suppress
from pathlib import Path

from omote.interchange.formats.error_reasons import explain_error
from omote.showfile.backup import BACKUP_SUFFIXES
from omote.showfile.database_errors import LOCKLESS
from omote.showfile.identification import require_folder
from omote.showfile.recovery import reject_unproven
from omote.showfile.schema import ShowFileError

LONGEST_ADDRESS = 400
"""Bytes."""
ASKED_BYTE = 1 << 30
"""Of the lock file, far behind what is written and locked there."""


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
    require_folder(path)
    return take_lock(path)


def take_lock(path: Path) -> int:
    """The lock alone, in a folder that is made anew where it is gone.

    What lies at the path is not looked at, for that would free SQLite's own locks of an open file.
    """
    descriptor = _open_lock(path)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        _require_record_locks(descriptor)
    except BlockingIOError as error:
        os.close(descriptor)
        raise ShowLockedError(f"another Omote plays {path} already: stop that one, or name another file.") from error
    except OSError as error:
        release_lock(path, descriptor)
        raise ShowFileError(f"{path} cannot be played: {LOCKLESS}.") from error
    if _is_at(_lock_path(path), descriptor):
        return descriptor
    os.close(descriptor)  # who held it removed it meanwhile (`release_lock`)
    return take_lock(path)


def release_lock(path: Path, lock: int) -> None:
    """Ends a lock; where there is no show file after all, nothing stays beside it either.

    path: of the show file; lock: the descriptor that holds it.
    """
    try:
        if not path.exists() and _is_at(_lock_path(path), lock):
            _lock_path(path).unlink()
    finally:
        os.close(lock)


def note_address(lock: int, address: str) -> None:
    """Writes where a show listens (a URL) into its lock file, for other commands on this machine.

    lock: the descriptor that holds the lock; address: a URL.
    """
    os.ftruncate(lock, 0)
    os.pwrite(lock, address.encode()[:LONGEST_ADDRESS], 0)


def probe_disk(path: Path) -> None:
    """Returns once the disk of a show file has taken something: a byte of its lock file, as it is there.

    path: of the show file.
    """
    with suppress(OSError):  # an answer too
        descriptor = os.open(_lock_path(path), os.O_RDWR)
        try:
            os.pwrite(descriptor, os.pread(descriptor, 1, 0), 0)
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def read_address(path: Path) -> str:
    """Where the show of a file listens, or did when it was played last; "" where that is not known."""
    try:
        with _lock_path(path).open("rb") as file:
            return file.read(LONGEST_ADDRESS).decode()
    except (OSError, UnicodeDecodeError):
        return ""


def _lock_path(path: Path) -> Path:
    return path.with_name(path.name + ".lock")


def _require_record_locks(descriptor: int) -> None:
    """OSError where a folder has no record locks, without which SQLite takes a file for one that is in use."""
    with suppress(BlockingIOError):  # another process asks the same
        fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, ASKED_BYTE)
        fcntl.lockf(descriptor, fcntl.LOCK_UN, 1, ASKED_BYTE)


def _open_lock(path: Path) -> int:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        return os.open(_lock_path(path), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError as error:
        raise ShowFileError(f"{path} cannot be opened ({explain_error(error)}): name another file.") from error


def _is_at(path: Path, descriptor: int) -> bool:
    """Whether an open file is the one at a path."""
    try:
        return os.path.samestat(path.stat(), os.fstat(descriptor))
    except FileNotFoundError:
        return False
