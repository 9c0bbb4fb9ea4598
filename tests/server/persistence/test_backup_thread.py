"""Backups are made beside the show, however busy it is, and a file that is damaged is said."""

import sqlite3
import threading
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from omote.server.persistence.backup_thread import BACKUP_SECONDS, FIRST_SECONDS, BackupThread
from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import StoredDocument
from omote.showfile.integrity import open_read_only, verify_integrity
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

OFTEN = 1e-3


@pytest.fixture
def said() -> list[str]:
    """What the operator reads."""
    return []


def commit(show: ShowFile, name: object) -> None:
    """A change that is told apart by its name."""
    show.apply([StoredDocument("layout", str(name), b"{}")])


def layouts_in(path: Path) -> set[str]:
    """The layouts in a backup; none where it is not there (yet)."""
    if not path.exists():
        return set()
    verify_integrity(path)
    with closing(open_read_only(path)) as connection:
        return {name for (name,) in connection.execute("SELECT name FROM document")}


def until(true: Callable[[], bool]) -> None:
    """Waits for a state."""
    for _ in range(30_000):
        if true():
            return
        threading.Event().wait(OFTEN)
    raise AssertionError("this never came")


def counted(monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The files that backups were made of, from now on."""
    made: list[Path] = []

    def counting(show: ShowFile) -> bool:
        made.append(show.path)
        return back_up(show)

    monkeypatch.setattr("omote.server.persistence.backup_thread.back_up", counting)
    return made


def test_the_loss_is_at_most_a_minute() -> None:
    assert FIRST_SECONDS < BACKUP_SECONDS < 60.0 - 10.0


def test_backups_are_made_although_nobody_ever_pauses(tmp_path: Path, said: list[str]) -> None:
    show = open_show(tmp_path / "a.omote")
    thread = BackupThread(show.again(), said.append, first_seconds=OFTEN, backup_seconds=OFTEN)
    newest = backup_paths(show.path)[0]
    seen = set[int]()
    for number in range(30_000):
        commit(show, number)
        seen.add(len(layouts_in(newest)))
        if len(seen) > 5:
            break
    assert len(seen) > 5
    thread.close()
    assert layouts_in(newest) == set(show.stored().documents.get("layout", {}))
    show.close()
    assert said == []


def test_a_state_that_the_journal_keeps_is_backed_up_too(tmp_path: Path, said: list[str]) -> None:
    show = open_show(tmp_path / "a.omote")
    thread = BackupThread(show.again(), said.append, first_seconds=OFTEN, backup_seconds=OFTEN)
    newest = backup_paths(show.path)[0]
    until(newest.exists)
    show.write_journal(JournalEntry(77, 1.0, b"state"))

    def epoch() -> int:
        with closing(open_read_only(newest)) as connection:
            row = connection.execute("SELECT epoch FROM journal").fetchone()
            return int(row[0]) if row else 0

    until(lambda: epoch() == 77)
    thread.close()
    show.close()


def test_where_nothing_is_committed_nothing_is_copied_again(
    tmp_path: Path, said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    made = counted(monkeypatch)
    show = open_show(tmp_path / "a.omote")
    asked: list[tuple[int, int]] = []
    own = show.again()
    version = own.data_version

    def counting() -> tuple[int, int]:
        asked.append(version())
        return asked[-1]

    monkeypatch.setattr(own, "data_version", counting)
    thread = BackupThread(own, said.append, first_seconds=OFTEN, backup_seconds=OFTEN)
    until(lambda: len(asked) > 5)
    assert len(made) == 1
    commit(show, "new")
    until(lambda: len(made) == 2)
    asked.clear()
    until(lambda: len(asked) > 5)
    thread.close()
    show.close()
    assert len(made) == 2


def test_the_last_backup_is_made_at_the_end(tmp_path: Path, said: list[str]) -> None:
    show = open_show(tmp_path / "a.omote")
    thread = BackupThread(show.again(), said.append, first_seconds=3600.0)
    commit(show, "late")
    thread.close()
    show.close()
    assert layouts_in(backup_paths(show.path)[0]) == {"late"}
    assert said == []


def test_a_damaged_file_is_said_once_and_its_backup_stays(tmp_path: Path, said: list[str]) -> None:
    show = open_show(tmp_path / "a.omote")
    commit(show, "early")
    thread = BackupThread(show.again(), said.append, first_seconds=OFTEN, backup_seconds=OFTEN)
    newest = backup_paths(show.path)[0]
    until(newest.exists)
    assert thread.damage == ""
    with closing(sqlite3.connect(show.path)) as other:
        other.execute("UPDATE document SET body = x'00'")
        other.commit()
    until(lambda: bool(said))
    for number in range(3):
        commit(show, number)
    assert thread.damage.endswith("a.omote is damaged: its document layout, early is damaged.")
    with closing(sqlite3.connect(show.path)) as other:
        other.execute("DELETE FROM document WHERE name = 'early'")
        other.commit()
    until(lambda: not thread.damage)
    thread.close()
    show.close()
    assert layouts_in(newest) == {"0", "1", "2"}
    assert said == [
        f"{show.path} is damaged: its document layout, early is damaged. "
        "The show goes on, but edits are not kept: start it again to open its good copy."
    ]


def test_a_disk_that_takes_no_backup_is_said_once(
    tmp_path: Path, said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    tries: list[ShowFile] = []

    def full(show: ShowFile) -> bool:
        tries.append(show)
        raise OSError("No space left on device")

    monkeypatch.setattr("omote.server.persistence.backup_thread.back_up", full)
    show = open_show(tmp_path / "a.omote")
    thread = BackupThread(show.again(), said.append, first_seconds=OFTEN, backup_seconds=OFTEN)
    until(lambda: len(tries) > 2)
    thread.close()
    show.close()
    assert said == [f"no good copy of {show.path} could be made: No space left on device. The ones of before stay."]
    assert thread.damage == ""


def test_a_backup_that_another_process_makes_is_made_again_without_a_word(
    tmp_path: Path, said: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    tries: list[ShowFile] = []

    def taken_twice(show: ShowFile) -> bool:
        tries.append(show)
        return len(tries) > 2

    monkeypatch.setattr("omote.server.persistence.backup_thread.back_up", taken_twice)
    show = open_show(tmp_path / "a.omote")
    thread = BackupThread(show.again(), said.append, first_seconds=OFTEN, backup_seconds=OFTEN)
    until(lambda: len(tries) > 2)
    thread.close()
    show.close()
    assert (len(tries), said) == (3, [])
