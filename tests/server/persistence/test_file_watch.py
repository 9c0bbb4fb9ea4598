"""A show file that is moved during the show is made anew and said; nothing that was acknowledged is lost."""

import fcntl
import os
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from queue import SimpleQueue

import pytest

from omote.server.persistence.backup_thread import BackupThread
from omote.server.persistence.commit_thread import CommitOutcome, CommitThread
from omote.server.persistence.file_gate import FileGate
from omote.server.persistence.file_watch import FileWatch
from omote.server.persistence.journal import JournalWriter
from omote.server.persistence.lock import ShowLockedError, take_lock
from omote.server.process.notice_board import LONGEST_NOTICE
from omote.showfile.backup import backup_paths
from omote.showfile.changes import StoredDocument
from omote.showfile.show_file import JournalEntry, open_show

OFTEN = 1e-3


def until(true: Callable[[], bool]) -> None:
    """Waits for a state."""
    for _ in range(60_000):
        if true():
            return
        threading.Event().wait(OFTEN)
    raise AssertionError("this never came")


@dataclass
class Playing:
    """A show file with all threads of a show process."""

    path: Path
    watch_seconds: float = OFTEN
    said: list[str] = field(default_factory=list)
    moved: list[Path] = field(default_factory=list)
    outcomes: SimpleQueue[CommitOutcome] = field(default_factory=SimpleQueue)

    def __post_init__(self) -> None:
        file = open_show(self.path)
        gate = FileGate()
        self.backup = BackupThread(file.again(), self.said.append, gate, first_seconds=OFTEN, backup_seconds=OFTEN)
        self.committer = CommitThread(file.again(), self.said.append, self.backup, gate)
        self.journal = JournalWriter(file, self.said.append, gate, flush_seconds=OFTEN)
        self.watch = FileWatch(file, gate, self.said.append, self.moved.append, watch_seconds=self.watch_seconds)

    def commit(self, name: str) -> None:
        """Commits a layout, and waits until that is acknowledged."""
        self.committer.commit([StoredDocument("layout", name, b"{}")], self.outcomes.put)
        assert self.outcomes.get(timeout=60.0) == CommitOutcome("committed")

    def close(self) -> None:
        """As a show process ends."""
        for thread in (self.watch, self.committer, self.journal, self.backup):
            thread.close()


@pytest.fixture
def playing(tmp_path: Path) -> Iterator[Playing]:
    """A show file that plays."""
    show = Playing(tmp_path / "a.omote")
    yield show
    show.close()


def layouts(path: Path) -> set[str]:
    """What a file holds for whoever opens it."""
    show = open_show(path)
    found = set(show.stored().documents.get("layout", {}))
    show.close()
    return found


def replace_by_text(path: Path) -> None:
    """Puts somebody else's file in the place of a show file, at one stroke."""
    text = path.with_name("notes.txt")
    text.write_text("milk and eggs")
    text.replace(path)


def test_nothing_that_is_acknowledged_is_lost_however_often_it_is_moved(playing: Playing) -> None:
    committed = set[str]()
    for move in range(6):
        for number in range(20):
            name = f"{move} {number}"
            playing.commit(name)
            playing.journal.offer(JournalEntry(len(committed) + 1, 0.0, b"state"))
            committed.add(name)
            if number == 10:
                playing.path.rename(playing.path.with_name(f"moved-{move}.omote"))
        until(lambda: len(playing.moved) == move + 1)  # noqa: B023  (called at once)
    playing.close()
    assert layouts(playing.path) == committed
    assert playing.moved == [playing.path] * 6
    show = open_show(playing.path)
    assert show.journal().epoch == 120
    show.close()
    assert len(playing.said) == 6
    assert (
        "a.omote was moved, renamed, deleted or replaced during the show. It was made anew there at "
        in (playing.said[0])
    )


def test_a_file_that_takes_its_place_stays_and_the_crew_is_told_which_to_open(playing: Playing) -> None:
    playing.commit("early")
    replace_by_text(playing.path)
    beside = playing.path.with_name("a-2.omote")
    until(lambda: playing.moved[-1:] == [beside])
    playing.commit("late")
    with pytest.raises(ShowLockedError):
        os.close(take_lock(beside))
    playing.close()
    assert layouts(beside) == {"early", "late"}
    assert playing.path.read_text() == "milk and eggs"
    (said,) = [sentence for sentence in playing.said if "another file took the place of" in sentence]
    assert "a-2.omote beside it, which has everything: open that one next time." in said


def test_a_file_that_cannot_be_made_anew_is_said_once_and_again_when_it_is_back(tmp_path: Path) -> None:
    backup_paths(tmp_path / "a.omote")[0].mkdir()  # takes the place of the copy that is to be made first
    playing = Playing(tmp_path / "a.omote")
    playing.commit("early")
    moved = playing.path.rename(playing.path.with_name("moved.omote"))
    until(lambda: any("cannot be made anew" in said for said in playing.said))
    playing.commit("late")
    moved.rename(playing.path)
    until(lambda: any("is in its place again" in said for said in playing.said))
    assert sum("cannot be made anew" in said for said in playing.said) == 1
    assert playing.moved == []
    backup_paths(playing.path)[0].rmdir()
    playing.close()
    assert layouts(playing.path) == {"early", "late"}


def test_a_file_that_is_moved_at_the_very_end_is_there_for_the_next_start(tmp_path: Path) -> None:
    playing = Playing(tmp_path / "a.omote", watch_seconds=3600.0)
    playing.commit("late")
    playing.path.unlink()
    playing.close()
    assert layouts(playing.path) == {"late"}


def test_sentences_fit_on_a_notice_with_a_long_path(tmp_path: Path) -> None:
    playing = Playing(tmp_path / ("a" * 60) / "a.omote")
    replace_by_text(playing.path)
    until(lambda: bool(playing.moved))
    playing.path.with_name("a-2.omote").unlink()
    until(lambda: len(playing.moved) == 2)
    playing.close()
    assert max(map(len, playing.said)) <= LONGEST_NOTICE


def test_a_lock_that_the_supervisor_holds_is_left_to_it(tmp_path: Path) -> None:
    held = take_lock(tmp_path / "a.omote")
    playing = Playing(tmp_path / "a.omote")
    os.close(held)
    with (tmp_path / "a.omote.lock").open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    playing.close()
