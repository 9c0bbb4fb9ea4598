"""The good copy is whole and proved, and a bad file never takes its place."""

import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from omote.showfile.backup import good_path, keep_good_copy, put_in_place
from omote.showfile.changes import PutContent, PutLayout
from omote.showfile.contents import content_key
from omote.showfile.integrity import prove
from omote.showfile.schema import CorruptShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

DATA = bytes(20_000)


def filled(path: Path) -> ShowFile:
    """An open show file whose last changes are in its log only."""
    show = open_show(path)
    show.apply([PutContent(content_key(DATA), DATA), PutLayout("console", b"{}")])
    show.write_journal(JournalEntry(7, 1.0, b"state"))
    return show


def test_the_copy_holds_all_that_is_committed_in_one_file(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    keep_good_copy(show)
    alone = tmp_path / "elsewhere.omote"
    alone.write_bytes(good_path(show.path).read_bytes())
    prove(alone)
    copy = open_show(alone)
    assert (copy.stored(), copy.contents(), copy.journal()) == (show.stored(), show.contents(), show.journal())
    copy.close()
    show.close()
    assert {file.name for file in tmp_path.iterdir()} == {"a.omote", "a.omote.good", "a.omote.lock", "elsewhere.omote"}


def test_the_copy_that_another_process_is_making_is_left_alone(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    unfinished = tmp_path / "a.omote.good-new"
    with hands_on(show.path, unfinished) as other:
        assert not keep_good_copy(show)
        assert unfinished.read_bytes() == b"theirs"
        other.kill()
    assert keep_good_copy(show)  # what a killed one left is in nobody's way
    assert not unfinished.exists()
    prove(good_path(show.path))
    show.close()


@contextmanager
def hands_on(path: Path, unfinished: Path) -> Iterator[subprocess.Popen[bytes]]:
    """Another process that is making the good copy."""
    program = f"""
from pathlib import Path
from omote.showfile.backup import _alone
with _alone(Path({str(path)!r})) as alone:
    assert alone
    Path({str(unfinished)!r}).write_bytes(b"theirs")
    print(flush=True)
    input()
"""
    with subprocess.Popen([sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"\n"
        yield other


def test_a_newer_copy_takes_the_place_of_the_older(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    for name in ("first", "second"):
        show.apply([PutLayout(name, b"{}")])
        keep_good_copy(show)
    show.close()
    copy = open_show(good_path(show.path))
    assert set(copy.stored().layouts) == {"console", "first", "second"}
    copy.close()


@pytest.mark.parametrize(
    "statement", ["UPDATE content SET data = x'00'", "UPDATE layout SET document = x'00'", "DROP TABLE layout"]
)
def test_a_damaged_file_leaves_the_copy_of_before(tmp_path: Path, statement: str) -> None:
    show = filled(tmp_path / "a.omote")
    keep_good_copy(show)
    before = good_path(show.path).read_bytes()
    with sqlite3.connect(show.path) as other:
        other.execute(statement)
    other.close()
    with pytest.raises(CorruptShowFileError):
        keep_good_copy(show)
    assert good_path(show.path).read_bytes() == before
    assert not show.path.with_name("a.omote.good-new").exists()
    show.close()


def test_what_a_killed_writer_left_of_a_copy_does_not_touch_the_next(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    for suffix in ("", "-journal", "-wal", "-shm"):
        (tmp_path / f"a.omote.good-new{suffix}").write_bytes(b"left" * 1000)
    keep_good_copy(show)
    prove(good_path(show.path))
    assert {file.name for file in tmp_path.iterdir() if "good" in file.name} == {"a.omote.good"}
    show.close()


def test_a_folder_that_takes_no_copy_says_so_and_keeps_the_one_of_before(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    keep_good_copy(show)
    before = good_path(show.path).read_bytes()
    (tmp_path / "a.omote.good-new").mkdir()
    with pytest.raises(OSError, match="good-new"):
        keep_good_copy(show)
    (tmp_path / "a.omote.good-new").rmdir()
    assert good_path(show.path).read_bytes() == before
    show.close()


def test_a_file_is_put_in_place_of_another(tmp_path: Path) -> None:
    (tmp_path / "draft").write_bytes(b"new")
    (tmp_path / "file").write_bytes(b"old")
    put_in_place(tmp_path / "draft", tmp_path / "file")
    assert (tmp_path / "file").read_bytes() == b"new"
    assert not (tmp_path / "draft").exists()
