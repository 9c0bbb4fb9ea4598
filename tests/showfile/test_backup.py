"""Backups are whole and verified, the newest of three, and a damaged file never takes the place of one."""

import os
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from omote.showfile.backup import back_up, backup_paths, put_in_place
from omote.showfile.changes import Content, StoredDocument, content_key
from omote.showfile.identification import MAGIC, ForeignFileError
from omote.showfile.integrity import open_read_only, verify_integrity
from omote.showfile.schema import CorruptShowFileError
from omote.showfile.show_file import FilePlace, JournalEntry, ShowFile, open_show

DATA = bytes(20_000)


def filled(path: Path) -> ShowFile:
    """An open show file whose last changes are in its log only."""
    show = open_show(path)
    show.apply([Content(content_key(DATA), DATA), StoredDocument("layout", "console", b"{}")])
    show.write_journal(JournalEntry(7, 1.0, b"state"))
    return show


def test_a_backup_holds_all_that_is_committed_in_one_file(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    back_up(show)
    alone = tmp_path / "elsewhere.omote"
    alone.write_bytes(backup_paths(show.path)[0].read_bytes())
    verify_integrity(alone)
    copy = open_show(alone)
    assert (copy.stored(), copy.contents(), copy.journal()) == (show.stored(), show.contents(), show.journal())
    copy.close()
    show.close()
    assert {file.name for file in tmp_path.iterdir()} == {"a.omote", "a.omote.good", "a.omote.lock", "elsewhere.omote"}


def test_the_backup_that_another_process_is_making_is_left_alone(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    unfinished = tmp_path / "a.omote.good-new"
    with hands_on(show.path, unfinished) as other:
        assert not back_up(show)
        assert unfinished.read_bytes() == MAGIC + b"theirs"
        other.kill()
    assert back_up(show)  # what a killed one left is in nobody's way
    assert not unfinished.exists()
    verify_integrity(backup_paths(show.path)[0])
    show.close()


@contextmanager
def hands_on(path: Path, unfinished: Path) -> Iterator[subprocess.Popen[bytes]]:
    """Another process that is making a backup."""
    program = f"""
from pathlib import Path
from omote.showfile.backup import _alone
with _alone(Path({str(path)!r})) as alone:
    assert alone
    Path({str(unfinished)!r}).write_bytes({MAGIC!r} + b"theirs")
    print(flush=True)
    input()
"""
    with subprocess.Popen([sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"\n"
        yield other


@pytest.mark.parametrize("links", [True, False])
def test_the_newest_three_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, links: bool) -> None:
    if not links:
        forbid_links(monkeypatch)
    show = filled(tmp_path / "a.omote")
    made: list[set[str]] = []
    for number in range(5):
        show.apply([StoredDocument("layout", f"page {number}", b"{}")])
        back_up(show)
        made.insert(0, set(show.stored().documents.get("layout", {})))
        assert [layouts_in(path) for path in backup_paths(show.path) if path.exists()] == made[:3]
    show.close()


@pytest.mark.parametrize(("links", "renames"), [(True, 1), (True, 2), (False, 1), (False, 2), (False, 3)])
def test_a_rotation_cut_off_leaves_whole_backups_and_the_next_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, links: bool, renames: int
) -> None:
    if not links:
        forbid_links(monkeypatch)
    show = filled(tmp_path / "a.omote")
    for number in range(4):
        show.apply([StoredDocument("layout", f"page {number}", b"{}")])
        if number < 3:
            back_up(show)
    before = layouts_in(backup_paths(show.path)[0])
    cut_after(monkeypatch, renames)
    with pytest.raises(KeyboardInterrupt):
        back_up(show)
    monkeypatch.undo()
    assert backup_paths(show.path)[0].exists() or not links
    left = [layouts_in(path) for path in backup_paths(show.path) if path.exists()]
    assert left[0] >= before
    assert left == sorted(left, key=len, reverse=True)
    back_up(show)
    assert layouts_in(backup_paths(show.path)[0]) == set(show.stored().documents.get("layout", {}))
    show.close()


def forbid_links(monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk on which no file has two names."""

    def refuse(*_: object) -> None:
        raise PermissionError("Operation not permitted")

    monkeypatch.setattr(os, "link", refuse)


def layouts_in(path: Path) -> set[str]:
    """The names of the layouts in a whole backup, which stays as it is."""
    verify_integrity(path)
    with closing(open_read_only(path)) as connection:
        return {name for (name,) in connection.execute("SELECT name FROM document")}


def cut_after(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    """Lets so many renames pass, then the power goes."""
    left = [count]
    real = os.replace

    def replace(*paths: str) -> None:
        real(*paths)
        left[0] -= 1
        if left[0] == 0:
            raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", replace)


@pytest.mark.parametrize(
    "statement", ["UPDATE content SET data = x'00'", "UPDATE document SET body = x'00'", "DROP TABLE document"]
)
def test_a_damaged_file_leaves_the_copy_of_before(tmp_path: Path, statement: str) -> None:
    show = filled(tmp_path / "a.omote")
    back_up(show)
    before = backup_paths(show.path)[0].read_bytes()
    with sqlite3.connect(show.path) as other:
        other.execute(statement)
    other.close()
    with pytest.raises(CorruptShowFileError, match=r"a\.omote is damaged: its (content|document|tables)"):
        back_up(show)
    assert backup_paths(show.path)[0].read_bytes() == before
    assert not show.path.with_name("a.omote.good-new").exists()
    show.close()


def test_a_file_without_its_first_page_is_damaged_and_leaves_the_backup_of_before(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    back_up(show)
    before = backup_paths(show.path)[0].read_bytes()
    show.close()
    again = ShowFile(sqlite3.connect(show.path), FilePlace(show.path))
    show.path.write_bytes(bytes(4096) + show.path.read_bytes()[4096:])
    with pytest.raises(CorruptShowFileError, match=r"a\.omote is damaged: its beginning is lost or overwritten\."):
        back_up(again)
    assert backup_paths(show.path)[0].read_bytes() == before
    again.close()


def test_a_disk_that_fails_while_it_copies_damages_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    full_disk = sqlite3.OperationalError("database or disk is full")
    full_disk.sqlite_errorcode = sqlite3.SQLITE_FULL

    def full(*_: object) -> None:
        raise full_disk

    show = filled(tmp_path / "a.omote")
    monkeypatch.setattr(show, "copy_into", full)
    with pytest.raises(sqlite3.OperationalError, match="disk is full"):
        back_up(show)
    show.close()


def test_what_a_killed_writer_left_of_a_copy_does_not_touch_the_next(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    for suffix in ("", "-journal", "-wal", "-shm"):
        (tmp_path / f"a.omote.good-new{suffix}").write_bytes(MAGIC + b"left" * 10)
    back_up(show)
    verify_integrity(backup_paths(show.path)[0])
    assert {file.name for file in tmp_path.iterdir() if "good" in file.name} == {"a.omote.good"}
    show.close()


def test_a_folder_that_takes_no_copy_says_so_and_keeps_the_one_of_before(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    back_up(show)
    before = backup_paths(show.path)[0].read_bytes()
    (tmp_path / "a.omote.good-new").mkdir()
    with pytest.raises(ForeignFileError, match="good-new is a folder, where a good copy of"):
        back_up(show)
    (tmp_path / "a.omote.good-new").rmdir()
    assert backup_paths(show.path)[0].read_bytes() == before
    show.close()


def test_a_file_is_put_in_place_of_another(tmp_path: Path) -> None:
    (tmp_path / "draft").write_bytes(b"new")
    (tmp_path / "file").write_bytes(b"old")
    put_in_place(tmp_path / "draft", tmp_path / "file")
    assert (tmp_path / "file").read_bytes() == b"new"
    assert not (tmp_path / "draft").exists()
