"""A copy of the show in memory is whole, newest, private and gone with its show."""

import os
from pathlib import Path

import pytest

from omote.server.persistence.file_gate import FileGate
from omote.server.persistence.memory_copy import MemoryCopy, find_copy, open_copy, read_state, remove_copy
from omote.showfile.changes import StoredDocument
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

NOTE = StoredDocument("note", "evening", b"{}")


@pytest.fixture
def show(tmp_path: Path) -> ShowFile:
    """A show file with a document and a state."""
    file = open_show(tmp_path / "a.omote")
    file.apply([NOTE])
    file.write_journal(JournalEntry(3, 10.0, b"older"))
    return file


def copied(tmp_path: Path) -> Path:
    """Where the copy is."""
    memory = tmp_path / "memory"
    memory.mkdir(exist_ok=True)
    copy = find_copy(tmp_path / "a.omote", memory)
    assert copy is not None
    return copy


def wait_until(holds: object) -> None:
    """Waits for a state."""
    while not holds():  # type: ignore[operator]
        pass


def test_a_copy_has_the_file_and_the_newest_state_and_the_identity_of_its_show(show: ShowFile, tmp_path: Path) -> None:
    copy = copied(tmp_path)
    keeping = MemoryCopy(copy, show.again(), pytest.fail)
    for number in range(100):
        keeping.offer(JournalEntry(4, float(number), b"newest %d" % number))
    keeping.close()
    opened = open_copy(copy, tmp_path / "a.omote")
    assert opened is not None
    assert opened.journal() == JournalEntry(4, 99.0, b"newest 99")
    assert opened.stored() == show.stored()
    assert opened.identity() == show.identity()
    opened.close()
    show.close()


def test_what_is_committed_later_is_copied_and_a_newer_journal_of_the_file_stays(
    show: ShowFile, tmp_path: Path
) -> None:
    copy = copied(tmp_path)
    keeping = MemoryCopy(copy, show.again(), pytest.fail)
    keeping.offer(JournalEntry(2, 99.0, b"of an earlier server"))
    wait_until(copy.exists)
    show.apply([StoredDocument("note", "matinee", b"{}")])
    keeping.note_commit()

    def has_both() -> bool:
        opened = open_copy(copy, tmp_path / "a.omote")
        assert opened is not None
        try:
            assert opened.journal().snapshot == b"older"
            return opened.stored() == show.stored()
        finally:
            opened.close()

    wait_until(has_both)
    keeping.close()
    show.close()


def test_states_are_kept_while_the_file_waits_for_its_disk(show: ShowFile, tmp_path: Path) -> None:
    copy = copied(tmp_path)
    gate = FileGate()
    with gate.alone():
        keeping = MemoryCopy(copy, show.again(), pytest.fail, gate)
        keeping.offer(JournalEntry(5, 1.0, b"on air"))
        wait_until(lambda: read_state(copy) == JournalEntry(5, 1.0, b"on air"))
    wait_until(copy.exists)
    keeping.close()
    show.close()


def test_a_copy_is_its_owners_alone_and_gone_when_its_show_ends(show: ShowFile, tmp_path: Path) -> None:
    copy = copied(tmp_path)
    show.path.chmod(0o600)
    keeping = MemoryCopy(copy, show.again(), pytest.fail)
    keeping.offer(JournalEntry(5, 1.0, b"on air"))
    wait_until(lambda: copy.exists() and read_state(copy))
    assert {path.stat().st_mode & 0o077 for path in (copy.parent, *copy.parent.iterdir())} == {0}
    keeping.remove()
    keeping.close()
    assert list(copy.parent.iterdir()) == []
    show.close()


def test_a_folder_that_others_may_read_is_not_used(tmp_path: Path) -> None:
    copy = copied(tmp_path)
    copy.parent.chmod(0o755)
    assert find_copy(tmp_path / "a.omote", tmp_path / "memory") is None
    copy.parent.rmdir()
    copy.parent.symlink_to(tmp_path)
    assert find_copy(tmp_path / "a.omote", tmp_path / "memory") is None
    assert find_copy(tmp_path / "a.omote", tmp_path / "nowhere") is None


def test_a_copy_that_cannot_be_used_is_none(tmp_path: Path) -> None:
    copy = copied(tmp_path)
    assert open_copy(copy, tmp_path / "a.omote") is None
    copy.write_bytes(os.urandom(4096))
    assert open_copy(copy, tmp_path / "a.omote") is None
    remove_copy(copy)


def test_memory_that_is_full_is_said_once(show: ShowFile, tmp_path: Path) -> None:
    copy = copied(tmp_path)
    copy.parent.rmdir()  # nothing can be made there
    said = list[str]()
    keeping = MemoryCopy(copy, show.again(), said.append)
    keeping.offer(JournalEntry(5, 1.0, b"on air"))
    wait_until(lambda: said)
    keeping.close()
    assert len(said) == 1
    assert "cannot be copied into memory" in said[0]
    show.close()
