"""Wherever a show file is cut off or written over, it opens whole or exactly as its newest whole backup.

A show file, closed and as a killed server leaves it, is cut off at every length, or loses a page, and is opened as
`omote show` does, twice: what it holds must be exactly what so many lists of changes make, all that the file had or
all that its newest whole backup had; the corrupt file must be kept as it is, the second start be silent. The same with
the newest backup cut off as well: then the one before it opens. Where only the log is cut off nothing that was merged
may be lost. Pages of 512 bytes, so that every length can be tried; with SQLite's usual 4096 every 97th and those about
every page's end. `--stride N`: fewer.
"""

from __future__ import annotations

import argparse
import shutil
import sqlite3
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.saving import STEPS, Reference, changes, count_lists
from omote.server.persistence.restore import open_newest
from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import Stored
from omote.showfile.inspection import verdicts
from omote.showfile.show_file import JournalEntry, open_show

NAME = "show.omote"
OLDER = STEPS
COPIED = 2 * STEPS
FLUSHED = 4 * STEPS - 3
MADE = 4 * STEPS
"""Lists of changes when the backups were made, when the log was merged for the last time, in all."""
VERTICES = 50
State = tuple[Stored, dict[str, bytes]]
Damaged = tuple[str, dict[str, bytes]]
"""What was done to files, and the files by name."""


@dataclass(frozen=True)
class CutFiles:
    """Files by name, as a killed server leaves them and closed, and what each number of lists makes."""

    killed: dict[str, bytes]
    closed: dict[str, bytes]
    states: list[State]


def populate(folder: Path, page: int) -> CutFiles:
    """A show file with that many bytes in a page."""
    connection = sqlite3.connect(folder / NAME)
    connection.execute(f"PRAGMA page_size = {page}")
    connection.execute("PRAGMA journal_mode = WAL")
    connection.close()
    show = open_show(folder / NAME)
    reference = Reference()
    states: list[State] = [(reference.show.stored(), {})]
    for number in range(1, MADE + 1):
        show.apply(changes(number, VERTICES))
        reference.make(number, VERTICES)
        states.append((reference.show.stored(), reference.show.contents()))
        if number in (OLDER, COPIED):
            back_up(show)
        if number == FLUSHED:
            show.flush()
    show.write_journal(JournalEntry(1234, 5.0, b"state"))
    killed = {file.name: file.read_bytes() for file in folder.iterdir() if not file.name.endswith("-shm")}
    show.close()
    return CutFiles(killed, {file.name: file.read_bytes() for file in folder.iterdir()}, states)


def reopen(folder: Path, files: dict[str, bytes], states: list[State], whole: int, backup: int) -> str:
    """How these files open: "whole" with at least so many lists, "restored" with as many as a backup has, or what is
    wrong."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for name, data in files.items():
        (folder / name).write_bytes(data)
    said: list[str] = []
    found: list[State] = []
    for _ in range(2):
        show = open_newest(folder / NAME, said.append)
        found.append((show.stored(), show.contents()))
        there = count_lists(show)
        show.close()
    if found[0] != found[1] or len(said) > 1:
        return "the second start differs from the first"
    if found[0] != states[there] or there not in ([backup] if said else range(whole, MADE + 1)):
        return f"it holds {there} lists or something else: {said}"
    if not said:
        return "whole"
    if (folder / f"{NAME}.corrupt-1").read_bytes() != files[NAME]:
        return "the corrupt file was changed"
    wrong = [sentence for right, sentence in verdicts(folder / NAME) if not right]
    return wrong[0] if wrong else "restored"


def lengths_of(data: bytes, page: int, stride: int) -> list[int]:
    """Every so many bytes, and the whole."""
    ends = {length + more for length in range(0, len(data), page) for more in (-1, 0, 1)} if stride > 1 else set()
    return sorted(length for length in {*range(0, len(data), stride), *ends, len(data)} if 0 <= length <= len(data))


def cut(files: dict[str, bytes], names: tuple[str, ...], lengths: Iterable[int]) -> Iterator[Damaged]:
    """These of the files cut off at each length."""
    for length in lengths:
        yield f"cut to {length} bytes", files | {name: files[name][:length] for name in names}


def written_over(files: dict[str, bytes], page: int) -> Iterator[Damaged]:
    """The show file with each page in turn lost: as zeros, and as anything."""
    data = files[NAME]
    for start in range(0, len(data), page):
        for block in (bytes(page), b"\xa5" * page):
            yield f"page at byte {start} lost", files | {NAME: data[:start] + block + data[start + page :]}


def tried(folder: Path, kind: str, damaged: Iterable[Damaged], states: list[State], whole: int, backup: int) -> bool:
    """Opens damaged files, prints how they opened; whether the claim holds."""
    found = Counter[str]()
    for what, files in damaged:
        try:
            how = reopen(folder, files, states, whole, backup)
        except Exception as error:  # whatever it is, it is what this looks for
            how = f"{type(error).__name__}: {error}"
        if how not in ("whole", "restored"):
            print(f"  {kind}, {what}: {how}")
        found[how if how in ("whole", "restored") else "wrong"] += 1
    print(f"  {kind:28} {found.total():6} times: {found['whole']} opened whole, ", end="")
    print(f"{found['restored']} as the backup of {backup} lists, {found['wrong']} wrong")
    return not found["wrong"]


def holds(folder: Path, made: CutFiles, page: int, stride: int) -> bool:
    """Damages one populated file in every way; whether the claim holds."""
    newest = backup_paths(Path(NAME))[0].name
    log = f"{NAME}-wal"
    lengths = lengths_of(made.closed[NAME], page, stride)
    both = cut(made.closed, (NAME, newest), [length for length in lengths if length < len(made.closed[newest])])
    logs = cut(made.killed, (log,), lengths_of(made.killed[log], page, stride))
    ways = [
        ("closed file cut", cut(made.closed, (NAME,), lengths), MADE, COPIED),
        ("closed file, a page lost", written_over(made.closed, page), MADE, COPIED),
        ("killed file cut", cut(made.killed, (NAME,), lengths), MADE, COPIED),
        ("closed file and backup cut", both, MADE, OLDER),
        ("log cut", logs, FLUSHED, COPIED),
    ]
    good = [tried(folder, kind, damaged, made.states, *lists) for kind, damaged, *lists in ways]
    return all(good)


def main() -> int:
    """Cuts, prints; exit status 1 when anything was lost that must not be."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--stride", type=int, default=1)
    stride = parser.parse_args().stride
    good = True
    memory = Path("/dev/shm")  # no disk is asked to sync so many files
    for page, every in ((512, stride), (4096, 97 * stride)):
        with tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None) as folder:
            (Path(folder) / "made").mkdir()
            made = populate(Path(folder) / "made", page)
            print(f"a show file of {MADE} lists of changes in pages of {page} bytes, backups of {COPIED} and {OLDER}")
            good = holds(Path(folder) / "cut", made, page, every) and good
    print("holds" if good else "DOES NOT HOLD")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
