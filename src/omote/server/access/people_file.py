"""Reads and writes the list of people beside a show file (`tour.omote.people`), which its owner alone may read."""

from __future__ import annotations

import fcntl
import os
import secrets
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec

from omote.interchange.formats.error_reasons import explain_error
from omote.server.persistence.private_file import write_private
from omote.show.access.access_role import ACCESS_ROLES, AccessRole
from omote.show.access.people_list import KEY_BYTES, People, Person

MOST_BYTES = 65536


def people_path(show: Path) -> Path:
    """Where the list of a show lies: beside its file, for a show that is mailed is to let in nobody."""
    return show.with_name(show.name + ".people")


def new_person(name: str, role: AccessRole, now: float, hours: float | None = None) -> Person:
    """A person with an id of its own. now: seconds since 1970.

    name: for people; role: what it may do; hours: for how long its token is valid, None for ever.
    """
    return Person(secrets.token_urlsafe(6), name.strip(), role, now, None if hours is None else now + 3600.0 * hours)


def new_people(now: float) -> People:
    """A list with a token for each role, which carries the role's name and may be shared."""
    return People(secrets.token_hex(KEY_BYTES), tuple(new_person(role, role, now) for role in ACCESS_ROLES))


def read_people(path: Path) -> People:
    """The list in a file; OSError or ValueError with a message that says what to do."""
    try:
        with path.open("rb") as file:
            return msgspec.json.decode(file.read(MOST_BYTES), type=People)
    except OSError as error:
        raise OSError(f"{path} cannot be read ({explain_error(error)}): make it readable, or delete it.") from error
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ValueError(
            f"{path} is no list of people ({explain_error(error)}): delete it, and all tokens are made anew."
        ) from error


def open_people(path: Path) -> People:
    """The list in a file, made where there is none; OSError or ValueError with a message that says what to do."""
    with _locked(path):
        if not path.exists():
            write_people(path, new_people(time.time()))  # noqa: TID251  (people read it as a date)
        return read_people(path)


def change_people(path: Path, change: Callable[[People], People]) -> People:
    """Changes the list in a file, one program after the other, and returns what it is then.

    path: of the file; change: gives the list that is wanted.
    """
    with _locked(path):
        changed = change(read_people(path))
        write_people(path, changed)
        return changed


def write_people(path: Path, people: People) -> None:
    """Writes a list atomically, readable by its owner alone; OSError with a message.

    path: of the file; people: the list.
    """
    try:
        write_private(path, msgspec.json.format(msgspec.json.encode(people), indent=2))
    except OSError as error:
        raise OSError(f"{path} cannot be written ({explain_error(error)}).") from error


@contextmanager
def _locked(path: Path) -> Iterator[None]:
    """A lock on the folder, so that no second file is needed; it ends with the process."""
    try:
        folder = os.open(path.parent, os.O_RDONLY | os.O_CLOEXEC)
    except OSError as error:
        raise OSError(f"{path.parent} cannot be opened ({explain_error(error)}).") from error
    try:
        fcntl.flock(folder, fcntl.LOCK_EX)
        yield
    finally:
        os.close(folder)
