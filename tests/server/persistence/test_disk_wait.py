"""A server that takes over waits for a disk that is slow, and not for one that does not answer."""

import threading
from pathlib import Path

import pytest

from omote.server.persistence import disk_wait
from omote.server.persistence.disk_wait import open_in_time
from omote.server.persistence.memory_copy import MemoryCopy, find_copy
from omote.server.process.process_messages import Failover, Order
from omote.showfile.show_file import JournalEntry, open_show

FIRST = Order(1, neutral=False)
NEXT = Order(2, neutral=False, failover=Failover(1, 0.0, hung=False))


@pytest.fixture
def path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A show file whose copy in memory has a newer state."""
    memory = tmp_path / "memory"
    memory.mkdir()
    monkeypatch.setattr(disk_wait, "find_copy", lambda show: find_copy(show, memory))
    path = tmp_path / "a.omote"
    file = open_show(path)
    file.write_journal(JournalEntry(1, 1.0, b"on disk"))
    copy = find_copy(path, memory)
    assert copy is not None
    keeping = MemoryCopy(copy, file.again(), pytest.fail)
    keeping.offer(JournalEntry(1, 2.0, b"in memory"))
    while not copy.exists():
        pass
    keeping.close()
    file.close()
    return path


def stall(monkeypatch: pytest.MonkeyPatch, *names: str) -> threading.Event:
    """Lets these of the disk's works wait until the event."""
    answers = threading.Event()

    def wait_before(name: str) -> None:
        work = getattr(disk_wait, name)
        monkeypatch.setattr(disk_wait, name, lambda *arguments: answers.wait() and work(*arguments))

    for name in names:
        wait_before(name)
    return answers


def test_a_disk_that_answers_is_played_with_the_newest_state(path: Path) -> None:
    opened = open_in_time(path, NEXT, pytest.fail)
    assert opened.file is not None
    assert opened.on_disk is opened.file
    assert opened.file.path == path
    assert opened.file.journal() == JournalEntry(1, 2.0, b"in memory")
    opened.file.close()


def test_a_disk_that_does_not_answer_is_not_waited_for(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    answers = stall(monkeypatch, "open_journal", "probe_disk")
    said = list[str]()
    opened = open_in_time(path, NEXT, said.append, seconds=0.0)
    assert "does not answer: the show goes on from memory" in said[0]
    assert "does not answer: repeat this" in opened.away
    assert opened.file is not None
    assert opened.on_disk is None
    assert opened.file.journal() == JournalEntry(1, 2.0, b"in memory")
    answers.set()
    assert opened.back is not None
    back = opened.back.result(60.0)
    assert back is not None
    assert back.path == path
    back.close()
    opened.file.close()


def test_a_file_that_takes_long_on_a_disk_that_answers_is_waited_for(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answers = stall(monkeypatch, "open_journal")
    threading.Timer(0.2, answers.set).start()
    opened = open_in_time(path, NEXT, pytest.fail, seconds=60.0)
    assert opened.on_disk is not None
    opened.on_disk.close()


def test_the_first_server_of_a_show_waits_for_its_disk_and_takes_nothing_from_memory(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answers = stall(monkeypatch, "open_journal", "probe_disk")
    threading.Timer(0.2, answers.set).start()
    opened = open_in_time(path, FIRST, pytest.fail, seconds=0.0)
    assert opened.on_disk is not None
    assert opened.on_disk.journal() == JournalEntry(1, 1.0, b"on disk")
    opened.on_disk.close()
