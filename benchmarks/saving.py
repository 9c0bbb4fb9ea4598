"""What is acknowledged is kept: `kill -9` while authored work is saved, and then a bad disk.

A process edits and saves through the scribe as a server does, beside a journal that is written and flushed all the
while and backups that are made again and again, and says on a pipe what was told to be committed. It is killed at a
random moment. Then the file must be right in every part (`omote file check`), hold all that was acknowledged, and
exactly what so many lists of changes make, no half of one; so must each backup. Then a copy of the file is damaged at
a random place: it must open, as `omote show` does, whole or as its newest backup, and what that lacks must not be older
than the time between two backups and the quarter of a minute that `omote show` allows for making one. The next process
goes on with the same file. `--kills N`.
"""

from __future__ import annotations

import argparse
import os
import shutil
import signal
import sqlite3
import struct
import sys
import tempfile
import threading
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np

from omote.model.recipes.recipe import Recipe
from omote.model.space.expression import Expression
from omote.server.persistence.backup_thread import BACKUP_SECONDS, BackupThread
from omote.server.persistence.commit_thread import CommitOutcome, CommitThread
from omote.server.persistence.journal import JournalWriter
from omote.server.persistence.restore import open_newest
from omote.showfile.changes import Change, Content, Draft, Edit, Item, Revision, StoredDocument, content_key
from omote.showfile.contents import pack_expression
from omote.showfile.inspection import verdicts
from omote.showfile.schema import migrate
from omote.showfile.show_file import FilePlace, JournalEntry, ShowFile, open_show

ITEMS = 7
STEPS = 4
"""Items that are edited in turn, and lists of changes that make one save of one."""
IN_FLIGHT = 3
"""Lists that wait for the scribe at once."""
BACKUP_EVERY = 0.02
MOST_SECONDS = BACKUP_EVERY + 60.0 - BACKUP_SECONDS
"""Between two backups here, and how old what a bad disk costs may be: as `omote show` promises a minute."""
VERTICES = 300
COUNT = "count"
TOLD = struct.Struct("<id")
"""A list's number and the monotonic time (s) at which it was acknowledged."""


def changes(number: int, vertices: int = VERTICES) -> list[Change]:
    """The list of changes of this number, from 1: two edits, an undo, a save, of one item after the other."""
    step = (number - 1) % STEPS
    item = (number - 1) // STEPS % ITEMS + 1
    save = (number - 1) // (STEPS * ITEMS) + 1
    recipe = msgspec.json.encode(Recipe((1, 2), ((0.0, 0.001 * number, 1.0), (0.0, 0.0, 1.0))))
    counted = StoredDocument(COUNT, COUNT, str(number).encode())
    if step < STEPS - 2:
        draft = Draft(item, "ada", save - 1, step)
        edit = Edit(item, "ada", step, recipe, f"edit {number}")
        return [_item(item, save - 1), draft, edit, counted]
    if step == STEPS - 2:
        return [Draft(item, "ada", save - 1, 0), counted]
    data = content(number, vertices)
    revision = Revision(item, save, save - 1, recipe, content_key(data), float(number), "ada")
    kept = Content(revision.content, data)
    return [_item(item, save), revision, kept, counted]


def content(number: int, vertices: int) -> bytes:
    """An expression of so many vertices that is told apart by its number."""
    field = np.random.default_rng(number).normal(size=(2, vertices))
    return pack_expression(Expression(field[0], field[1], np.exp(field[0]), np.zeros((0, 3))))


def _item(number: int, head: int) -> Item:
    return Item(number, "expression", f"own-{number}", f"Own {number}", head=head)


def count_lists(show: ShowFile) -> int:
    """How many lists of changes a file holds."""
    return int(show.stored().documents.get(COUNT, {}).get(COUNT, b"0"))


def say(sentence: str) -> None:
    """What an operator would read; nothing is expected."""
    sys.stderr.write(f"{sentence}\n")


def write_for_ever(path: Path, pipe: int) -> None:
    """Edits and saves until somebody kills it; the number and time of every commit told of go into the pipe."""
    show = open_newest(path, say)
    backup = BackupThread(show.again(), say, first_seconds=BACKUP_EVERY, backup_seconds=BACKUP_EVERY)
    scribe = CommitThread(show.again(), say, backup)
    journal = JournalWriter(show.again(), say, flush_seconds=0.002)
    free = threading.Semaphore(IN_FLIGHT)
    number = count_lists(show)

    def told(number: int, outcome: CommitOutcome) -> None:
        if outcome.state != "committed":
            say(f"list {number}: {outcome}")
            return
        try:
            os.write(pipe, TOLD.pack(number, time.monotonic()))
        except OSError:
            os._exit(1)  # who should have killed us is gone
        free.release()

    while True:
        number += 1
        free.acquire()
        journal.offer(JournalEntry(number, float(number), bytes(2000)))
        scribe.commit(changes(number), lambda fate, number=number: told(number, fate))  # type: ignore[misc]


@dataclass(frozen=True)
class Kill:
    """acknowledged: the last list told to be committed; times: when each was (s); half: whether the log ends within a
    transaction; copying: whether a backup was being made."""

    acknowledged: int
    times: dict[int, float]
    half: bool
    copying: bool


def kill_writer(path: Path, acknowledgements: int, wait: float, before: int) -> Kill:
    """Has a process write, kills it so many seconds after so many acknowledgements; before: lists that are there."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(reading)
            write_for_ever(path, writing)
        finally:
            os._exit(1)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        told = pipe.read(TOLD.size * acknowledgements)
        if wait:
            time.sleep(wait)
        os.kill(child, signal.SIGKILL)
        told += pipe.read()
    os.waitpid(child, 0)
    times = dict(TOLD.iter_unpack(told[: len(told) // TOLD.size * TOLD.size]))
    if [*times] != [*range(before + 1, before + 1 + len(times))] or len(times) < acknowledgements:
        raise AssertionError(f"after {before} lists {[*times]} were acknowledged")
    copying = path.with_name(path.name + ".good-new").exists()
    return Kill(before + len(times), times, ends_half(path), copying)


def ends_half(path: Path) -> bool:
    """Whether the log ends with pages of a transaction that was never committed (SQLite's file format, 4.1)."""
    log = path.with_name(path.name + "-wal")
    data = log.read_bytes() if log.exists() else b""
    if len(data) < 32:
        return False
    size = struct.unpack(">I", data[8:12])[0] + 24
    salts = data[16:24]
    half = False
    for at in range(32, len(data) - 23, size):
        if data[at + 8 : at + 16] != salts:
            break
        half = data[at + 4 : at + 8] == bytes(4)
    return half


class Reference:
    """The same lists of changes, made in memory by nobody who is killed."""

    def __init__(self) -> None:
        connection = sqlite3.connect(":memory:", check_same_thread=False)
        connection.execute("PRAGMA foreign_keys = ON")
        migrate(connection, 0)
        self.show = ShowFile(connection, FilePlace(Path(":memory:")))
        self.made = 0

    def make(self, count: int, vertices: int = VERTICES) -> None:
        """Goes on until so many are made."""
        for number in range(self.made + 1, count + 1):
            self.show.apply(changes(number, vertices))
        self.made = count

    def equals(self, show: ShowFile, count: int) -> bool:
        """Whether a file holds exactly what so many lists make."""
        self.make(count)
        return show.stored() == self.show.stored() and show.contents() == self.show.contents()


def check(path: Path, kill: Kill, reference: Reference) -> str:
    """What of the claim does not hold after a kill; "" when all does."""
    wrong = [sentence for right, sentence in verdicts(path) if not right]
    if wrong:
        return "; ".join(wrong)
    show = open_show(path)
    try:
        there = count_lists(show)
        if not kill.acknowledged <= there <= kill.acknowledged + IN_FLIGHT:
            return f"{kill.acknowledged} were acknowledged, {there} are there"
        return "" if reference.equals(show, there) else f"it holds something else than {there} lists make"
    finally:
        show.close()


def damaged_copy(path: Path, folder: Path, random: np.random.Generator) -> str:
    """Copies a show file and all beside it into a new folder, cut off or written over there; says where."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for file in path.parent.glob(f"{path.name}*"):
        if not file.name.endswith("-shm"):
            shutil.copyfile(file, folder / file.name)
    data = path.read_bytes()
    at = int(random.integers(len(data)))
    rest = b"" if random.random() < 0.5 else random.bytes(4096) + data[at + 4096 :]
    (folder / path.name).write_bytes(data[:at] + rest)
    return f"{'written over' if rest else 'cut off'} from byte {at}"


class BadDisk:
    """Damages copies of the file; costs: seconds of writing from the first acknowledged list that is lost to the last,
    for each copy that was not whole."""

    def __init__(self, folder: Path, random: np.random.Generator) -> None:
        self.folder = folder
        self.random = random
        self.reference = Reference()
        self.acknowledged: dict[int, float] = {}
        self.costs: list[float] = []
        self.written = 0.0

    def strike(self, path: Path, kill: Kill, whole: int) -> str:
        """What of the claim does not hold for a damaged copy of a file that holds so many lists; "" when all does."""
        begun = min(kill.times.values()) - self.written
        self.acknowledged |= {number: time - begun for number, time in kill.times.items()}
        self.written = max(self.acknowledged.values())
        how = damaged_copy(path, self.folder, self.random)
        said = list[str]()
        show = open_newest(self.folder / path.name, said.append)
        try:
            there = count_lists(show)
            if not said:
                return "" if there == whole else f"{how}: opened as if nothing were wrong, with {there} lists"
            if not self.reference.equals(show, there):
                return f"{how}: opened with something else than {there} lists make"
            lost = [time for number, time in self.acknowledged.items() if number > there]
            self.costs.append(self.written - min(lost, default=self.written))
            return f"{how}: {self.costs[-1]:.1f} s are lost" if self.costs[-1] > MOST_SECONDS else ""
        finally:
            show.close()


def kills(path: Path, count: int, *, seed: int = 5) -> bool:
    """Kills so many writers of one file, prints what was found; whether the claim holds."""
    random = np.random.default_rng(seed)
    reference = Reference()
    found = Counter[str]()
    disk = BadDisk(path.parent / "bad disk", np.random.default_rng(seed + 1))
    for number in range(count):
        wait = float(random.choice([0.0, random.uniform(0.0, 0.02)]))
        kill = kill_writer(path, int(random.integers(1, 25)), wait, reference.made)
        wrong = check(path, kill, reference) or disk.strike(path, kill, reference.made)
        if wrong:
            print(f"  kill {number + 1}: {wrong}")
        found["wrong"] += bool(wrong)
        found["half"] += kill.half
        found["copying"] += kill.copying
        found["unheard"] += reference.made > kill.acknowledged
    size = path.stat().st_size / 1e6
    most = max(disk.costs, default=0.0)
    print(f"{count} x kill -9 while {reference.made} lists of changes were committed, file {size:.1f} MB")
    print(f"  within the writing of a commit {found['half']}, between commit and word {found['unheard']}", end="")
    print(f", while a backup was made {found['copying']}")
    print(f"  a bad disk after each: {len(disk.costs)} opened as a backup, at most {most:.2f} s old, the rest whole")
    print(f"  lost or torn {found['wrong']}")
    return not found["wrong"]


def main() -> int:
    """Kills, prints; exit status 1 when anything was lost or torn."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=600)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        good = kills(Path(folder) / "show.omote", options.kills)
    print("holds" if good else "DOES NOT HOLD")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
