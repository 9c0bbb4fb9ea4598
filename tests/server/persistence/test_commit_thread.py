"""What is told to be committed is on the disk, in order, whatever the disk does meanwhile."""

import sqlite3
import threading
from collections.abc import Callable
from pathlib import Path
from queue import SimpleQueue

import pytest

from benchmarks.saving import Reference, check, kill_writer
from omote.server.persistence.backup_thread import BackupThread
from omote.server.persistence.commit_thread import CommitOutcome, CommitThread
from omote.showfile.changes import Change, StoredDocument
from omote.showfile.database_errors import WrongRowError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

COMMITTED = CommitOutcome("committed")


class Disk:
    """A show file on a disk that waits or fails when told."""

    path = Path("show.omote")

    def __init__(self) -> None:
        self.written: list[str] = []
        self.broken: Exception | None = None
        self.free = threading.Event()
        self.reached = threading.Event()
        self.free.set()

    def apply(self, changes: tuple[StoredDocument, ...]) -> None:
        self.reached.set()
        self.free.wait()
        if self.broken is not None:
            raise self.broken
        self.written += [change.name for change in changes]

    def close(self) -> None:
        self.written.append("closed")


def layout(name: object) -> list[Change]:
    """A change that is told apart by its name."""
    return [StoredDocument("layout", str(name), b"{}")]


class Author:
    """A scribe on a disk, and what it told and said."""

    def __init__(self, disk: Disk | ShowFile, **options: object) -> None:
        self.fates: SimpleQueue[tuple[object, CommitOutcome]] = SimpleQueue()
        self.said: list[str] = []
        self.scribe = CommitThread(disk, self.said.append, **options)  # type: ignore[arg-type]

    def commit(self, name: object) -> None:
        self.scribe.commit(layout(name), self.told(name))

    def told(self, name: object) -> Callable[[CommitOutcome], None]:
        return lambda fate: self.fates.put((name, fate))

    def next(self) -> tuple[object, CommitOutcome]:
        return self.fates.get(timeout=60.0)


def test_what_is_told_to_be_committed_is_there_for_others(tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    author = Author(show.again())
    for number in range(20):
        author.commit(number)
        assert author.next() == (number, COMMITTED)
        assert str(number) in show.stored().documents.get("layout", {})
    author.scribe.close()
    show.close()
    assert author.said == []


def test_nobody_waits_for_a_stuck_disk_and_the_order_is_kept() -> None:
    disk = Disk()
    disk.free.clear()
    author = Author(disk)
    for number in range(50):
        author.commit(number)  # returns although the disk does not
    assert author.fates.empty()
    disk.free.set()
    author.scribe.close()
    assert disk.written == [*map(str, range(50)), "closed"]
    assert [author.next() for _ in range(50)] == [(number, COMMITTED) for number in range(50)]


def test_a_failing_disk_is_told_once_and_tried_again_in_order() -> None:
    disk = Disk()
    disk.broken = sqlite3.OperationalError("database or disk is full")
    disk.broken.sqlite_errorcode = sqlite3.SQLITE_FULL
    author = Author(disk, retry_seconds=1e-3)
    author.commit("a")
    author.commit("b")
    name, fate = author.next()
    assert (name, fate.state) == ("a", "waiting")
    assert "show.omote cannot be written (the disk is full): your work is kept in memory" in fate.sentence
    for _ in range(3):
        disk.reached.clear()
        assert disk.reached.wait(60.0)
    disk.broken = None
    assert [author.next(), author.next()] == [("a", COMMITTED), ("b", COMMITTED)]
    author.scribe.close()
    assert disk.written == ["a", "b", "closed"]
    assert author.said == [fate.sentence]


def test_a_disk_that_fails_to_the_end_loses_nothing_without_a_word() -> None:
    disk = Disk()
    disk.broken = sqlite3.OperationalError("disk I/O error")
    author = Author(disk, retry_seconds=60.0)
    author.commit("a")
    author.commit("b")
    assert author.next()[1].state == "waiting"
    author.scribe.close()
    fates = {"a": [author.next()[1].state], "b": [author.next()[1].state, author.next()[1].state]}
    assert fates == {"a": ["refused"], "b": ["waiting", "refused"]}
    assert disk.written == ["closed"]


@pytest.mark.parametrize("error", [WrongRowError("no"), ValueError("no"), OverflowError("no")])
def test_what_can_never_be_made_is_refused_and_stops_nothing(error: Exception) -> None:
    disk = Disk()
    disk.broken = error
    author = Author(disk)
    author.commit("a")
    name, fate = author.next()
    assert (name, fate.state) == ("a", "refused")
    assert "show.omote cannot keep this (no)" in fate.sentence
    disk.broken = None
    author.commit("b")
    assert author.next() == ("b", COMMITTED)
    author.scribe.close()


def test_after_the_end_changes_are_refused() -> None:
    author = Author(Disk())
    author.scribe.close()
    author.commit("late")
    assert author.next()[1].state == "refused"


def test_whoever_no_longer_listens_stops_nothing() -> None:
    def ended(fate: CommitOutcome) -> None:
        raise RuntimeError("Event loop is closed")

    def broken(fate: CommitOutcome) -> None:
        raise BrokenPipeError("nobody")

    disk = Disk()
    author = Author(disk)
    author.scribe.commit(layout("a"), ended)
    author.scribe.commit(layout("b"), broken)
    author.commit("c")
    assert author.next() == ("c", COMMITTED)
    author.scribe.close()
    assert disk.written == ["a", "b", "c", "closed"]
    assert author.said[-1] == "what became of a change (committed) could not be told (BrokenPipeError)."


def test_nothing_is_committed_to_a_file_that_a_backup_found_damaged(tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    show.apply(layout("early"))
    said: list[str] = []
    backup = BackupThread(show.again(), said.append, first_seconds=3600.0)
    author = Author(show.again(), backup=backup)
    author.commit("a")
    assert author.next() == ("a", COMMITTED)
    show._connection.execute("UPDATE document SET body = x'00' WHERE name = 'early'")
    show._connection.commit()
    backup.close()
    author.commit("b")
    name, fate = author.next()
    assert (name, fate.state) == ("b", "refused")
    assert fate.sentence.endswith(
        "a.omote is damaged: its document layout, early is damaged. This is not kept: start the show again, and "
        "repeat it."
    )
    author.scribe.close()
    show.close()
    assert len(said) == 1


def test_the_journal_and_the_scribe_share_the_file(tmp_path: Path) -> None:
    """Both write as fast as they can, and a third flushes: nothing of either is lost."""
    show = open_show(tmp_path / "a.omote")
    author = Author(show.again())
    flusher = show.again()
    for number in range(150):
        author.commit(number)
        show.write_journal(JournalEntry(number + 1, 0.0, bytes(2000)))
        flusher.flush()
    assert [author.next() for _ in range(150)] == [(number, COMMITTED) for number in range(150)]
    author.scribe.close()
    flusher.close()
    show.close()
    again = open_show(tmp_path / "a.omote")
    assert again.journal().epoch == 150
    assert len(again.stored().documents.get("layout", {})) == 150
    again.close()
    assert author.said == []


def test_a_killed_writer_loses_nothing_that_it_was_told(tmp_path: Path) -> None:
    """A few of the kills of `benchmarks/saving.py`: all acknowledged is there, and no half of a list of changes."""
    reference = Reference()
    for acknowledgements in (1, 4, 17):
        kill = kill_writer(tmp_path / "a.omote", acknowledgements, 0.0, reference.made)
        assert check(tmp_path / "a.omote", kill, reference) == ""
