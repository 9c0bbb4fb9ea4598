"""Every way in which a show is saved, run before a disk that records or fails (`faulty_disk.c`).

A program beside the tests: it reads tasks as lines of JSON, runs each in a fork, and answers with a line.
"""

from __future__ import annotations

import ctypes
import json
import os
import sqlite3
import sys
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from omote.server.persistence.restore import open_newest
from omote.showfile import backup, recovery
from omote.showfile.backup import back_up
from omote.showfile.changes import Change, Content, StoredDocument, content_key
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show, sync_to_disk, write_new_show

NAME = "show.omote"
FIRST = 3
"""Saves that a prepared show has before a save path begins."""
EXPECTED = (sqlite3.Error, OSError, ShowFileError)
"""How a save may fail: what the server reports to people, and tries again."""


def save_data(number: int) -> bytes:
    """Some pages of bytes that are those of one save."""
    return number.to_bytes(4, "big") * 1500


def changes(number: int) -> list[Change]:
    """What the save of this number, from 1, commits: some pages of bytes and the name that tells them."""
    data = save_data(number)
    return [Content(content_key(data), data), StoredDocument("layout", "count", b"%d" % number)]


def acknowledge(what: str, number: int) -> None:
    """Notes in the record of the disk that this was told to be kept."""
    descriptor = os.open(os.environ["DISK_RECORD"], os.O_WRONLY | os.O_APPEND | os.O_CREAT)
    os.write(descriptor, f"{what}\t{number}\t0\t0\t\t\n".encode())
    os.close(descriptor)


def save(show: ShowFile, number: int) -> None:
    """A save of an editor; the show goes on where it fails."""
    with suppress(*EXPECTED):
        show.apply(changes(number))
        acknowledge("saved", number)


def prepare(path: Path) -> None:
    """A show with saves and a backup of them."""
    show = open_show(path)
    for number in range(1, FIRST + 1):
        show.apply(changes(number))
    back_up(show)
    show.close()


def prepare_damaged(path: Path) -> None:
    """A show that is damaged in the middle, beside a whole backup."""
    prepare(path)
    with path.open("r+b") as file:
        file.seek(path.stat().st_size // 2)
        file.write(b"damage" * 500)


def begin(path: Path) -> None:
    """A new show."""
    show = open_show(path)
    for number in (1, 2):
        save(show, number)
    show.close()


def edit(path: Path) -> None:
    """Saves into a show that is there, and its end."""
    show = open_show(path)
    for number in range(FIRST + 1, FIRST + 5):
        save(show, number)
    show.close()


def play(path: Path) -> None:
    """The journal beside the saves, its log synced and merged."""
    show = open_show(path)
    journal = show.again()
    for number in range(FIRST + 1, FIRST + 4):
        with suppress(*EXPECTED):
            journal.write_journal(JournalEntry(number, float(number), b"state" * 200))
            show.sync_log()
            acknowledge("played", number)
        save(show, number)
        with suppress(*EXPECTED):
            journal.flush()
    journal.close()
    show.close()


def back_up_often(path: Path) -> None:
    """Backups between saves, each rotated."""
    show = open_show(path)
    for number in range(FIRST + 1, FIRST + 3):
        save(show, number)
        with suppress(*EXPECTED):
            back_up(show)
    show.close()


def back_up_damage(path: Path) -> None:
    """A backup of a show that a bad disk damages while it is open."""
    show = open_show(path)
    pages = path.stat().st_size // 4096
    with path.open("r+b") as file:
        file.seek((pages - 2) * 4096)
        file.write(b"damage" * 1300)
    with suppress(*EXPECTED):
        back_up(show.again())


def recover(path: Path) -> None:
    """The backup takes the place of a damaged show."""
    show = open_newest(path, lambda sentence: None)
    save(show, FIRST + 1)
    show.close()


def bring_out(path: Path) -> None:
    """A file made whole, as an export of a show is."""
    write_new_show(path, changes(1))
    acknowledge("saved", 1)


PATHS: Mapping[str, tuple[Callable[[Path], None] | None, Callable[[Path], None]]] = {
    "begin": (None, begin),
    "edit": (prepare, edit),
    "play": (prepare, play),
    "back up": (prepare, back_up_often),
    "back up a damaged file": (prepare, back_up_damage),
    "recover": (prepare_damaged, recover),
    "export": (None, bring_out),
}
"""What lies in the folder before, and what is done, by name."""


def _apply_unsynced(show: ShowFile, given: list[Change]) -> None:
    from omote.showfile.authored_rows import apply_changes

    apply_changes(show._connection, given)


def _apply_later(apply: Callable[[ShowFile, list[Change]], None]) -> Callable[[ShowFile, list[Change]], None]:
    waiting: list[list[Change]] = []

    def later(show: ShowFile, given: list[Change]) -> None:
        for earlier in waiting:
            apply(show, earlier)
        waiting[:] = [given]

    return later


def _apply_in_silence(apply: Callable[[ShowFile, list[Change]], None]) -> Callable[[ShowFile, list[Change]], None]:
    def silent(show: ShowFile, given: list[Change]) -> None:
        with suppress(sqlite3.Error):
            apply(show, given)

    return silent


def _sync_after_rename(draft: Path, path: Path) -> None:
    draft.replace(path)
    sync_to_disk(path)
    sync_to_disk(path.parent)


def _write_over(draft: Path, path: Path) -> None:
    path.write_bytes(draft.read_bytes())


def _delete(path: Path) -> Path:
    path.unlink(missing_ok=True)
    return path


def _apply_one_by_one(apply: Callable[[ShowFile, list[Change]], None]) -> Callable[[ShowFile, list[Change]], None]:
    def split(show: ShowFile, given: list[Change]) -> None:
        for change in given:
            apply(show, [change])

    return split


BUGS: Mapping[str, tuple[object, str, Callable[[Any], Any]]] = {
    "saves are not synced": (ShowFile, "apply", lambda apply: _apply_unsynced),
    "a save is acknowledged before it is written": (ShowFile, "apply", _apply_later),
    "a save that fails is acknowledged": (ShowFile, "apply", _apply_in_silence),
    "a save is more than one commit": (ShowFile, "apply", _apply_one_by_one),
    "the journal's log is not synced": (ShowFile, "sync_log", lambda sync: lambda show: None),
    "a backup is not synced": (backup, "sync_to_disk", lambda sync: lambda path: None),
    "a backup is synced after it is renamed": (backup, "put_in_place", lambda put: _sync_after_rename),
    "a backup is written over the one before": (backup, "put_in_place", lambda put: _write_over),
    "backups are rotated before the new one is verified": (backup, "verify_integrity", lambda verify: lambda path: 1),
    "a corrupt file is deleted": (recovery, "move_aside", lambda move: _delete),
}
"""Bugs that can be planted: whose name, which, and what takes its place."""


def run(task: Mapping[str, Any]) -> dict[str, Any]:
    """Runs a task in this process; gives how an error reads that no save path may raise, and the calls counted."""
    os.environ["DISK_FOLDER"] = task["folder"]
    os.environ["DISK_RECORD"] = task["record"]
    if task["bug"]:
        owner, name, plant = BUGS[task["bug"]]
        setattr(owner, name, plant(getattr(owner, name)))
    disk = ctypes.CDLL(os.environ["LD_PRELOAD"])
    disk.count_calls.restype = ctypes.c_long
    disk.fail_call(*(ctypes.c_long(number) for number in task["failing"]), task["error"])
    said = ""
    try:
        PATHS[task["path"]][1](Path(task["folder"]) / NAME)
    except EXPECTED:
        pass
    except Exception as error:
        said = f"{type(error).__name__}: {error}"
    return {"said": said, "calls": disk.count_calls()}


def main() -> None:
    """Answers tasks until there are none."""
    for line in sys.stdin:
        reading, writing = os.pipe()
        child = os.fork()
        if child == 0:
            os.write(writing, json.dumps(run(json.loads(line))).encode())
            os._exit(0)
        os.close(writing)
        with os.fdopen(reading) as answers:
            answer = answers.read()
        _, status = os.waitpid(child, 0)
        sys.stdout.write((answer or json.dumps({"said": f"ended with {status}", "calls": 0})) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
