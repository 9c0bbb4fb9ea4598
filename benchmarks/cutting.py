"""Nothing that a good copy had is lost, wherever a show file is cut off: every length of it, every length of its log.

A show file, closed and as a killed server leaves it, is cut off and opened as `omote show` does, twice: what its good
copy had must be there, the corrupt file be kept as it is, the second start be silent. Where only the log is cut off,
what is there must be exactly what the first so many lists of changes make. Pages of 512 bytes, so that every length can
be tried; with SQLite's usual 4096 every 97th and those about every page's end. `--stride N`: fewer.
"""

from __future__ import annotations

import argparse
import shutil
import sqlite3
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from benchmarks.saving import STEPS, Reference, changes, count_lists
from omote.server.persistence.restore import open_newest
from omote.showfile.backup import keep_good_copy
from omote.showfile.changes import Stored
from omote.showfile.inspection import verdicts
from omote.showfile.show_file import JournalEntry, open_show

NAME = "show.omote"
COPIED, FLUSHED, MADE = 2 * STEPS, 4 * STEPS - 3, 4 * STEPS
"""Lists of changes when the good copy was made, when the log was merged for the last time, in all."""
VERTICES = 50
State = tuple[Stored, dict[str, bytes]]


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
    show, reference = open_show(folder / NAME), Reference()
    states: list[State] = [(reference.show.stored(), {})]
    for number in range(1, MADE + 1):
        show.apply(changes(number, VERTICES))
        reference.make(number, VERTICES)
        states.append((reference.show.stored(), reference.show.contents()))
        if number == COPIED:
            keep_good_copy(show)
        if number == FLUSHED:
            show.flush()
    show.write_journal(JournalEntry(1234, 5.0, b"state"))
    killed = {file.name: file.read_bytes() for file in folder.iterdir() if not file.name.endswith("-shm")}
    show.close()
    return CutFiles(killed, {file.name: file.read_bytes() for file in folder.iterdir()}, states)


def reopen(folder: Path, files: dict[str, bytes], states: list[State], *, log: bool) -> str:
    """How these files open: "whole", "rescued" or what is wrong; log: only the log was cut off."""
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
    if log or not said:
        return "whole" if not said and there >= FLUSHED * log and found[0] == states[there] else f"not list {there}"
    kept = folder / f"{NAME}.corrupt-1"
    if kept.read_bytes() != files[NAME]:
        return "the corrupt file was changed"
    if there < COPIED or not states[COPIED][1].items() <= found[0][1].items():
        return f"{there} lists are there; the good copy had {COPIED}"
    wrong = [sentence for right, sentence in verdicts(folder / NAME) if not right]
    return wrong[0] if wrong else "rescued"


def lengths_of(data: bytes, page: int, stride: int) -> list[int]:
    """Every so many bytes, and the whole."""
    ends = {length + more for length in range(0, len(data), page) for more in (-1, 0, 1)} if stride > 1 else set()
    return sorted(length for length in {*range(0, len(data), stride), *ends, len(data)} if 0 <= length <= len(data))


def cut(folder: Path, made: CutFiles, kind: str, lengths: Iterable[int]) -> bool:
    """Cuts one file at these lengths, prints how they opened; whether the claim holds."""
    files = made.closed if kind == "closed file" else made.killed
    name = f"{NAME}-wal" if kind == "log" else NAME
    found = Counter[str]()
    for length in lengths:
        try:
            how = reopen(folder, files | {name: files[name][:length]}, made.states, log=kind == "log")
        except Exception as error:  # whatever it is, it is what this looks for
            how = f"{type(error).__name__}: {error}"
        if how not in ("whole", "rescued"):
            print(f"  {kind} cut to {length} bytes: {how}")
        found[how if how in ("whole", "rescued") else "wrong"] += 1
    print(
        f"  {kind:12} cut at {found.total():6} of {len(files[name]) + 1} lengths: {found['whole']} opened whole, ",
        end="",
    )
    print(f"{found['rescued']} in their newest good state, {found['wrong']} wrong")
    return not found["wrong"]


def main() -> int:
    """Cuts, prints; exit status 1 when anything was lost."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--stride", type=int, default=1)
    stride, good = parser.parse_args().stride, True
    memory = Path("/dev/shm")  # no disk is asked to sync so many files
    for page, every in ((512, stride), (4096, 97 * stride)):
        with tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None) as folder:
            (Path(folder) / "made").mkdir()
            made = populate(Path(folder) / "made", page)
            print(f"a show file of {MADE} lists of changes in pages of {page} bytes, {COPIED} in its good copy")
            for kind in ("closed file", "killed file", "log"):
                data = made.killed[f"{NAME}-wal"] if kind == "log" else made.closed[NAME]
                good = cut(Path(folder) / "cut", made, kind, lengths_of(data, page, every)) and good
    print("holds" if good else "DOES NOT HOLD")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
