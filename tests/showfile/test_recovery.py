"""A corrupt or lost show file is kept, and its newest whole backup takes its place."""

import os
import sqlite3
from pathlib import Path

import pytest

from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import Content, Stored, StoredDocument, content_key
from omote.showfile.recovery import Recovery, is_lost, move_aside, recover_show
from omote.showfile.schema import SCHEMA_VERSION, CorruptShowFileError, ShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show
from tests.showfile.authored_work import item, revision

Held = tuple[Stored, dict[str, bytes], JournalEntry]


def save(show: ShowFile, number: int) -> Held:
    """Commits an item, its save and a state; gives all that the file then holds."""
    data = bytes([number]) * 9000
    key = content_key(data)
    show.apply(
        [
            Content(key, data),
            item(number, head=1),
            revision(number, 1, content=key, recipe=b"{}" * 500),
            StoredDocument("layout", f"page {number}", b"{}"),
        ]
    )
    show.write_journal(JournalEntry(number, 5.0, b"state"))
    return show.stored(), show.contents(), show.journal()


@pytest.fixture
def backups(tmp_path: Path) -> list[Held]:
    """What three backups of a closed show file hold, the newest first; the file holds more than any."""
    show = open_show(tmp_path / "a.omote")
    found: list[Held] = []
    for number in range(1, 4):
        found.insert(0, save(show, number))
        back_up(show)
    save(show, 4)
    show.close()
    return found


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """Where the show file lies."""
    return tmp_path / "a.omote"


def held(path: Path) -> Held:
    """All that a show file holds."""
    show = open_show(path)
    everything = (show.stored(), show.contents(), show.journal())
    show.close()
    return everything


def damage(path: Path, start: int = 0) -> bytes:
    """Writes over the first page from a byte on; gives what the file then is."""
    whole = path.read_bytes()
    damaged = whole[:start] + bytes(4096 - start) + whole[4096:]
    path.write_bytes(damaged)
    return damaged


def kept_of(path: Path) -> Path:
    """Where a corrupt file is kept."""
    return path.with_name(path.name + ".corrupt-1")


@pytest.mark.parametrize("broken", [0, 1, 2])
def test_the_newest_whole_backup_takes_the_place_of_a_corrupt_file(
    path: Path, backups: list[Held], broken: int
) -> None:  # fmt: skip
    damaged = damage(path)
    kept = {backup: damage(backup) for backup in backup_paths(path)[:broken]}
    made = backup_paths(path)[broken].stat().st_mtime
    recovery = recover_show(path)
    assert recovery == Recovery(path.with_name("a.omote.corrupt-1"), made)
    assert path.with_name("a.omote.corrupt-1").read_bytes() == damaged
    assert {backup: kept_of(backup).read_bytes() for backup in kept} == kept
    assert not any(backup.exists() for backup in kept)
    assert held(path) == backups[broken]


def test_a_backup_of_before_there_were_three_is_honoured(path: Path, backups: list[Held]) -> None:
    for older in backup_paths(path)[1:]:
        older.unlink()
    damage(path)
    recover_show(path)
    assert held(path) == backups[0]
    show = open_show(path)
    back_up(show)
    show.close()
    assert [backup.exists() for backup in backup_paths(path)] == [True, True, False]


@pytest.mark.parametrize("left", [None, b"", bytes(5000)])
def test_without_a_whole_backup_nothing_is_left_but_what_is_kept(
    path: Path, backups: list[Held], left: bytes | None
) -> None:  # fmt: skip
    assert backups
    for backup in backup_paths(path):
        backup.unlink()
    if left is not None:
        backup_paths(path)[1].write_bytes(left)
    damaged = damage(path, start=100)  # its header still says that it is a show
    recovery = recover_show(path)
    assert recovery.copied is None
    assert recovery.kept is not None
    assert recovery.kept.read_bytes() == damaged
    assert not path.exists()
    if left is not None:
        assert kept_of(backup_paths(path)[1]).read_bytes() == left
    assert held(path) == (Stored(), {}, JournalEntry(0, 0.0, None))


def test_a_backup_of_a_newer_omote_is_not_taken_and_nothing_is_touched(path: Path, backups: list[Held]) -> None:
    assert backups
    damage(backup_paths(path)[0])
    with sqlite3.connect(backup_paths(path)[1]) as connection:
        connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION + 1}")
    connection.close()
    damage(path)
    before = {file.name: file.read_bytes() for file in path.parent.iterdir()}
    with pytest.raises(ShowFileError, match="newer Omote"):
        recover_show(path)
    assert {file.name: file.read_bytes() for file in path.parent.iterdir()} == before


@pytest.mark.parametrize("content", [None, b""])
def test_a_lost_file_comes_back_from_its_newest_backup(
    path: Path, backups: list[Held], content: bytes | None
) -> None:  # fmt: skip
    assert not is_lost(path)
    path.unlink()
    if content is not None:
        path.write_bytes(content)
    assert is_lost(path)
    assert (recover_show(path).kept is None) == (content is None)
    assert held(path) == backups[0]
    assert not is_lost(path)


def test_an_older_backup_alone_is_enough_to_know_that_a_file_is_lost(path: Path, backups: list[Held]) -> None:
    path.unlink()
    for backup in backup_paths(path)[:2]:
        backup.unlink()
    assert is_lost(path)
    recover_show(path)
    assert held(path) == backups[2]


def test_a_new_file_is_not_lost(path: Path) -> None:
    log = path.with_name("a.omote-wal")
    assert not is_lost(path)
    log.write_bytes(b"log")
    assert is_lost(path)  # SQLite would remove a log without its file
    path.write_bytes(b"")
    assert is_lost(path)
    log.unlink()
    assert not is_lost(path)


def test_a_disk_that_takes_no_copy_leaves_all_as_it_was(
    path: Path, backups: list[Held], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        path.with_name("a.omote.recovered").write_bytes(b"half")
        raise OSError("No space left on device")

    assert backups
    damage(path)
    before = {file.name: file.read_bytes() for file in path.parent.iterdir()}
    monkeypatch.setattr("omote.showfile.recovery.shutil.copyfile", full)
    with pytest.raises(OSError, match="No space left"):
        recover_show(path)
    assert {file.name: file.read_bytes() for file in path.parent.iterdir()} == before


@pytest.mark.parametrize("renames", range(1, 5))
def test_a_recovery_cut_off_between_two_renames_is_finished_by_the_next(
    path: Path, backups: list[Held], monkeypatch: pytest.MonkeyPatch, renames: int
) -> None:
    broken = damage(backup_paths(path)[0])
    damaged = damage(path)
    log = b"log" * 100
    path.with_name("a.omote-wal").write_bytes(log)
    cut_after(monkeypatch, renames)
    with pytest.raises(KeyboardInterrupt):
        recover_show(path)
    monkeypatch.undo()
    if is_lost(path) or is_corrupt(path):
        recover_show(path)
    assert held(path) == backups[1]
    kept = [file.read_bytes() for file in path.parent.glob("*.corrupt-*") if not file.name.endswith("-shm")]
    assert sorted(kept) == sorted([broken, damaged, log])
    assert not path.with_name("a.omote.recovered").exists()


def is_corrupt(path: Path) -> bool:
    """Whether the file cannot be opened, which leaves it as it is."""
    try:
        open_show(path).close()
    except CorruptShowFileError:
        return True
    return False


def cut_after(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    """Lets so many renames pass, then the power goes."""
    left = [count]

    def counted(name: str) -> None:
        real = getattr(os, name)

        def renamed(*paths: object, **options: object) -> None:
            left[0] -= 1
            real(*paths, **options)
            if left[0] == 0:
                raise KeyboardInterrupt

        monkeypatch.setattr(os, name, renamed)

    counted("rename")
    counted("replace")


def test_moving_aside_never_writes_over_what_was_kept(path: Path, tmp_path: Path) -> None:
    assert move_aside(path) is None
    (tmp_path / "a.omote-wal").write_bytes(b"first log")
    assert move_aside(path) is None
    path.write_bytes(b"file")
    (tmp_path / "a.omote-wal").write_bytes(b"second log")
    assert move_aside(path) == tmp_path / "a.omote.corrupt-2"
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == {
        "a.omote.corrupt-1-wal": b"first log",
        "a.omote.corrupt-2": b"file",
        "a.omote.corrupt-2-wal": b"second log",
    }
