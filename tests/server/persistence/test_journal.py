"""The journal is written beside the show, whatever the disk does."""

import sqlite3
import threading
from pathlib import Path

from omote.server.persistence.journal import STALL_SECONDS, SYNC_SECONDS, JournalWriter
from omote.showfile.show_file import JournalEntry, ShowFile, open_show


class Disk:
    """A show file on a disk that waits or fails when told."""

    def __init__(self) -> None:
        self.path = Path("show.omote")
        self.written: list[int] = []
        self.flushing = threading.Event()
        self.logged = threading.Event()
        self.synced_log: list[int] = []
        self.synced = threading.Event()
        self.synced.set()
        self.closed = threading.Event()
        self.reached = threading.Event()
        self.free = threading.Event()
        self.free.set()
        self.broken = False
        self.opened_by: threading.Thread | None = None

    def write_journal(self, entry: JournalEntry) -> None:
        self.reached.set()
        self.free.wait()
        if self.broken:
            error = sqlite3.OperationalError("disk I/O error")
            error.sqlite_errorcode = sqlite3.SQLITE_IOERR
            raise error
        self.written.append(entry.epoch)

    def sync_log(self) -> None:
        self.synced_log.append(len(self.written))
        self.logged.set()

    def again(self) -> "Flusher":
        self.opened_by = threading.current_thread()
        return Flusher(self)

    def close(self) -> None:
        self.closed.set()


class Flusher:
    """The same file, opened again to be flushed."""

    def __init__(self, disk: Disk) -> None:
        self.disk = disk

    def flush(self) -> None:
        self.disk.flushing.set()
        self.disk.synced.wait()

    def close(self) -> None:
        """Nothing is held."""


def entry(number: int) -> JournalEntry:
    """An entry that is told apart by its epoch."""
    return JournalEntry(number, 0.0, b"state")


def writer(disk: Disk, said: list[str]) -> JournalWriter:
    """A writer on that disk."""
    return JournalWriter(disk, said.append, solved=lambda *sentences: said.extend(sentences))  # type: ignore[arg-type]


def test_what_is_offered_last_is_in_the_file(tmp_path: Path) -> None:
    said: list[str] = []
    journal = JournalWriter(open_show(tmp_path / "a.omote"), said.append)
    for number in range(1, 200):
        journal.offer(entry(number))
    journal.close()
    again = open_show(tmp_path / "a.omote")
    assert again.journal() == entry(199)
    again.close()
    assert said == []


def test_a_stuck_disk_keeps_nobody_and_costs_only_what_is_old() -> None:
    disk = Disk()
    disk.free.clear()
    journal = writer(disk, [])
    journal.offer(entry(1))
    assert disk.reached.wait(60.0)
    for number in range(2, 1000):
        journal.offer(entry(number))  # returns although the disk does not
    disk.free.set()
    journal.close()
    assert disk.written == [1, 999]
    assert disk.closed.is_set()


def test_a_stalled_disk_is_told_for_what_it_is_once_and_when_it_answers_again() -> None:
    disk, said, now = Disk(), list[str](), [100.0]
    disk.free.clear()
    journal = JournalWriter(disk, said.append, clock=lambda: now[0])  # type: ignore[arg-type]
    journal.offer(entry(1))
    assert disk.reached.wait(60.0)
    journal.offer(entry(2))
    assert said == [], "a write may take its time"
    now[0] += 1.1 * STALL_SECONDS
    journal.offer(entry(3))
    journal.offer(entry(4))
    assert said == [
        "the disk of show.omote does not answer: the show goes on, and what changes waits in memory.",
    ]
    disk.free.set()
    while len(said) < 2:
        journal.offer(entry(5))
    assert said[1] == "the disk of show.omote answers again."
    journal.close()


def test_a_broken_disk_is_reported_once_and_tried_again() -> None:
    disk = Disk()
    said = list[str]()
    disk.broken = True
    journal = writer(disk, said)
    for number in range(3):
        disk.reached.clear()
        journal.offer(entry(number))
        assert disk.reached.wait(60.0)
    disk.reached.clear()
    disk.broken = False
    journal.offer(entry(3))
    journal.close()
    assert disk.written[-1] == 3
    assert len(said) == 3
    assert "show.omote cannot be written (the disk fails): the show goes on" in said[0]
    assert said[1].endswith("show.omote is written again: what has changed is kept.")
    assert said[2] == said[0], "which is solved"


def test_a_disk_that_syncs_for_ever_holds_up_no_state() -> None:
    disk = Disk()
    disk.synced.clear()
    journal = JournalWriter(disk, [].append, flush_seconds=1e-4)  # type: ignore[arg-type]
    assert disk.flushing.wait(60.0)
    for number in range(3):
        disk.reached.clear()
        journal.offer(entry(number))
        assert disk.reached.wait(60.0)
    disk.synced.set()
    journal.close()
    assert disk.written == [0, 1, 2]


def test_each_state_is_synced_at_once_also_while_the_log_is_merged() -> None:
    """What a loss of power costs: the time between two syncs, and what one takes."""
    assert SYNC_SECONDS <= 0.1
    disk = Disk()
    disk.synced.clear()
    journal = JournalWriter(disk, [].append, sync_seconds=1e-4, flush_seconds=1e-4)  # type: ignore[arg-type]
    assert disk.flushing.wait(60.0)
    for number in range(1, 4):
        disk.logged.clear()
        journal.offer(entry(number))
        while disk.synced_log[-1:] != [number]:
            assert disk.logged.wait(60.0)
    assert len(disk.synced_log) <= 2 * 3, "nothing is synced where nothing was written"
    disk.synced.set()
    journal.close()


def test_a_real_file_flushes(tmp_path: Path) -> None:
    show: ShowFile = open_show(tmp_path / "a.omote")
    show.write_journal(entry(4))
    other = show.again()
    other.flush()
    other.close()
    alone = sqlite3.connect(f"file:{tmp_path / 'a.omote'}?immutable=1", uri=True)  # reads past the log
    assert alone.execute("SELECT epoch FROM journal").fetchone() == (4,)
    alone.close()
    show.close()


def test_the_file_is_opened_a_second_time_before_any_thread_runs() -> None:
    """Later it may be moved away at any instant, and a thread that fails to open it would end without a word."""
    disk = Disk()
    journal = JournalWriter(disk, list[str]().append)  # type: ignore[arg-type]
    assert disk.opened_by is threading.current_thread()
    journal.close()
    assert disk.closed.is_set()
