"""What is acknowledged is kept: `kill -9` while authored work is saved.

A process edits and saves through the scribe as a server does, beside a journal that is written and flushed all the
while and good copies that are made again and again, and says on a pipe what was told to be committed. It is killed at a
random moment. Then the file must be right in every part (`omote file check`), hold all that was acknowledged, and
exactly what so many lists of changes make, no half of one. The next process goes on with the same file. `--kills N`.
"""

from __future__ import annotations

import argparse
import os
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
from omote.server.persistence.commit_thread import CommitOutcome, CommitThread
from omote.server.persistence.journal import JournalWriter
from omote.server.persistence.restore import open_newest
from omote.showfile.backup import good_path
from omote.showfile.changes import (
    Change,
    Draft,
    DropDraft,
    Edit,
    Item,
    PutContent,
    PutDraft,
    PutEdit,
    PutItem,
    PutLayout,
    PutRevision,
    Revision,
)
from omote.showfile.contents import content_key, pack_expression
from omote.showfile.inspection import verdicts
from omote.showfile.integrity import prove
from omote.showfile.schema import migrate
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

ITEMS, STEPS = 7, 4
"""Items that are edited in turn, and lists of changes that make one save of one."""
IN_FLIGHT = 3
"""Lists that wait for the scribe at once; every so often none, and a good copy is made."""
VERTICES = 300
COUNT = "count"


def changes(number: int, vertices: int = VERTICES) -> list[Change]:
    """The list of changes of this number, from 1: two edits, an undo, a save, of one item after the other."""
    step, item = (number - 1) % STEPS, (number - 1) // STEPS % ITEMS + 1
    save = (number - 1) // (STEPS * ITEMS) + 1
    recipe = msgspec.json.encode(Recipe((1, 2), ((0.0, 0.001 * number, 1.0), (0.0, 0.0, 1.0))))
    counted = PutLayout(COUNT, str(number).encode())
    if step < STEPS - 2:
        draft = Draft(item, "ada", save - 1, step)
        edit = Edit(item, "ada", step, recipe, f"edit {number}")
        return [PutItem(_item(item, save - 1)), PutDraft(draft), PutEdit(edit), counted]
    if step == STEPS - 2:
        return [PutDraft(Draft(item, "ada", save - 1, 0)), counted]
    data = content(number, vertices)
    revision = Revision(item, save, save - 1, recipe, content_key(data), float(number), "ada")
    kept = PutContent(revision.content, data)
    return [PutItem(_item(item, save)), PutRevision(revision), kept, DropDraft(item, "ada"), counted]


def content(number: int, vertices: int) -> bytes:
    """An expression of so many vertices that is told apart by its number."""
    field = np.random.default_rng(number).normal(size=(2, vertices))
    return pack_expression(Expression(field[0], field[1], np.exp(field[0]), np.zeros((0, 3))))


def _item(number: int, head: int) -> Item:
    return Item(number, "expression", f"own-{number}", f"Own {number}", head=head)


def count_lists(show: ShowFile) -> int:
    """How many lists of changes a file holds."""
    return int(show.stored().layouts.get(COUNT, b"0"))


def say(sentence: str) -> None:
    """What an operator would read; nothing is expected."""
    sys.stderr.write(f"{sentence}\n")


# --- the process that is killed ---------------------------------------------------------------------------------------


def write_for_ever(path: Path, pipe: int) -> None:
    """Edits and saves until somebody kills it; the number of every list told to be committed goes into the pipe."""
    show = open_newest(path, say)
    scribe = CommitThread(show.again(), say, quiet_seconds=0.0)
    journal = JournalWriter(show.again(), say, flush_seconds=0.002)
    free = threading.Semaphore(IN_FLIGHT)
    number = count_lists(show)

    def told(number: int, fate: CommitOutcome) -> None:
        if fate.state != "committed":
            say(f"list {number}: {fate}")
            return
        try:
            os.write(pipe, struct.pack("<i", number))
        except OSError:
            os._exit(1)  # who should have killed us is gone
        free.release()

    while True:
        number += 1
        free.acquire()
        journal.offer(JournalEntry(number, float(number), bytes(2000)))
        scribe.commit(changes(number), lambda fate, number=number: told(number, fate))  # type: ignore[misc]
        if number % 16 == 0:
            for _ in range(IN_FLIGHT):
                free.acquire()
            free.release(IN_FLIGHT)


@dataclass(frozen=True)
class Kill:
    """acknowledged: the last list told to be committed; half: whether the log ends within a transaction; copying:
    whether a good copy was being made."""

    acknowledged: int
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
        told = pipe.read(4 * acknowledgements)
        if wait:
            time.sleep(wait)
        os.kill(child, signal.SIGKILL)
        told += pipe.read()
    os.waitpid(child, 0)
    numbers = [number for (number,) in struct.iter_unpack("<i", told[: len(told) // 4 * 4])]
    if numbers != [*range(before + 1, before + 1 + len(numbers))] or len(numbers) < acknowledgements:
        raise AssertionError(f"after {before} lists {numbers} were acknowledged")
    return Kill(before + len(numbers), ends_half(path), path.with_name(path.name + ".good-new").exists())


def ends_half(path: Path) -> bool:
    """Whether the log ends with pages of a transaction that was never committed (SQLite's file format, 4.1)."""
    log = path.with_name(path.name + "-wal")
    data = log.read_bytes() if log.exists() else b""
    if len(data) < 32:
        return False
    size, salts, half = struct.unpack(">I", data[8:12])[0] + 24, data[16:24], False
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
        self.show = ShowFile(connection, Path(":memory:"))
        self.made = 0

    def make(self, count: int, vertices: int = VERTICES) -> None:
        """Goes on until so many are made."""
        for number in range(self.made + 1, count + 1):
            self.show.apply(changes(number, vertices))
        self.made = count


def check(path: Path, kill: Kill, reference: Reference) -> str:
    """What of the claim does not hold after a kill; "" when all does."""
    wrong = [sentence for right, sentence in verdicts(path) if not right]
    if wrong:
        return "; ".join(wrong)
    if good_path(path).exists():
        prove(good_path(path))
    show = open_show(path)
    try:
        there = count_lists(show)
        if not kill.acknowledged <= there <= kill.acknowledged + IN_FLIGHT:
            return f"{kill.acknowledged} were acknowledged, {there} are there"
        reference.make(there)
        if show.stored() != reference.show.stored() or show.contents() != reference.show.contents():
            return f"it holds something else than {there} lists make"
        return ""
    finally:
        show.close()


def kills(path: Path, count: int, *, seed: int = 5) -> bool:
    """Kills so many writers of one file, prints what was found; whether the claim holds."""
    random, reference, found = np.random.default_rng(seed), Reference(), Counter[str]()
    for number in range(count):
        wait = float(random.choice([0.0, random.uniform(0.0, 0.02)]))
        kill = kill_writer(path, int(random.integers(1, 25)), wait, reference.made)
        wrong = check(path, kill, reference)
        if wrong:
            print(f"  kill {number + 1}: {wrong}")
        found["wrong"] += bool(wrong)
        found["half"] += kill.half
        found["copying"] += kill.copying
        found["unheard"] += reference.made > kill.acknowledged
    size = path.stat().st_size / 1e6
    print(f"{count} x kill -9 while {reference.made} lists of changes were committed, file {size:.1f} MB")
    print(f"  within the writing of a commit {found['half']}, between commit and word {found['unheard']}", end="")
    print(f", while a good copy was made {found['copying']}")
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
