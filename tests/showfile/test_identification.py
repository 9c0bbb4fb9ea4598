"""What a file is, by its own bytes: only what was a show, or is nothing yet, is ever taken for one."""

import os
import socket
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.showfile.changes import StoredDocument
from omote.showfile.identification import (
    ForeignFileError,
    Identity,
    identify,
    is_own_log,
    locate_show,
    reject_foreign,
    require_show,
)
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import ShowFile, open_show


def filled(path: Path) -> ShowFile:
    """An open show file whose tables are in its log only."""
    show = open_show(path)
    show.apply([StoredDocument("layout", "console", b"{}" * 500)])
    return show


@pytest.fixture
def closed(tmp_path: Path) -> Path:
    """A closed show file."""
    show = filled(tmp_path / "a.omote")
    show.close()
    return show.path


def test_a_show_is_one_while_it_plays_after_a_kill_and_closed(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    assert show.path.read_bytes()[68:72] == bytes(4)  # its id is in the log only
    assert identify(show.path) == Identity("show")
    show.close()
    assert identify(show.path) == Identity("show")


def test_a_start_that_was_cut_off_left_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    assert identify(path) == Identity("missing")
    path.touch()
    assert identify(path) == Identity("empty")
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA journal_mode = WAL").fetchone()
    assert path.stat().st_size > 0
    assert identify(path) == Identity("empty")
    open_show(path).close()
    assert identify(path) == Identity("show")


def test_a_first_start_whose_log_lost_pages_with_the_power_left_nothing(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    log = bytearray(show.place.log_path.read_bytes())
    for frame in range(32, len(log), 24 + 4096):  # https://sqlite.org/fileformat2.html#walformat
        if log[frame : frame + 4] == b"\0\0\0\1":
            log[frame + 24 : frame + 24 + 4096] = bytes(4096)
    left = tmp_path / "left.omote"
    left.write_bytes(show.path.read_bytes())
    left.with_name("left.omote-wal").write_bytes(log)
    show.close()
    assert identify(left) == Identity("empty")
    open_show(left).close()
    assert identify(left) == Identity("show")


@pytest.mark.parametrize("length", [1, 8, 16, 60, 71])
def test_a_header_that_is_cut_off_tells_nothing(closed: Path, length: int) -> None:
    closed.write_bytes(closed.read_bytes()[:length])
    assert identify(closed) == Identity("remains")


@pytest.mark.parametrize("byte", [b"\x00", b"\xa5", b"\xff"])
def test_a_show_without_its_first_page_may_have_been_one(closed: Path, byte: bytes) -> None:
    closed.write_bytes(byte * 4096 + closed.read_bytes()[4096:])
    assert identify(closed) == Identity("remains")


def test_a_show_without_its_first_page_but_with_its_log_is_one(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    (tmp_path / "b.omote-wal").write_bytes((tmp_path / "a.omote-wal").read_bytes())
    show.close()
    (tmp_path / "b.omote").write_bytes(bytes(4096))
    assert identify(tmp_path / "b.omote") == Identity("show")


def test_whatever_comes_after_its_header_a_show_is_one(closed: Path) -> None:
    closed.write_bytes(closed.read_bytes()[:100] + b"\xa5" * 5000)
    assert identify(closed) == Identity("show")


@given(text=st.text(st.characters(exclude_categories=["Cc", "Cs"]), min_size=1))
def test_a_text_is_nobody_s_show(tmp_path_factory: pytest.TempPathFactory, text: str) -> None:
    path = tmp_path_factory.getbasetemp() / "text.omote"
    path.write_text(text, encoding="utf-8")
    expected = (
        Identity("remains")
        if b"SQLite format 3\0".startswith(text.encode()[:16])
        else Identity("foreign", "a text file")
    )
    assert identify(path) == expected


@given(data=st.binary(min_size=16))
def test_bytes_at_random_are_nobody_s_show(tmp_path_factory: pytest.TempPathFactory, data: bytes) -> None:
    path = tmp_path_factory.getbasetemp() / "noise.omote"
    path.write_bytes(data)
    assert (identify(path).kind == "foreign") == (any(data[:16]) and not data.startswith(b"SQLite format 3\0"))


def test_the_source_of_our_tables_is_a_text(tmp_path: Path) -> None:
    path = tmp_path / "schema.omote"
    path.write_text(Path(__file__).read_text() + "CREATE TABLE journal_aside (\n" * 9000)
    assert identify(path) == Identity("foreign", "a text file")


@pytest.mark.parametrize("setting", ["", "PRAGMA application_id = 7", "PRAGMA journal_mode = WAL"])
def test_a_database_of_another_program_is_told_without_opening_it(tmp_path: Path, setting: str) -> None:
    path = tmp_path / "places.omote"
    with closing(sqlite3.connect(path)) as connection:
        connection.execute(setting)
        connection.execute("CREATE TABLE theirs (x)")
        connection.commit()
        before = sorted(file.name for file in tmp_path.iterdir())
        assert identify(path) == Identity("foreign", "a database of another program")
        assert sorted(file.name for file in tmp_path.iterdir()) == before


def test_what_is_no_file_is_told(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind(str(tmp_path / "s"))
        nouns = {name: identify(tmp_path / name).noun for name in ("pipe", "s", ".")}
    assert nouns == {"pipe": "a pipe", "s": "a socket", ".": "a folder"}
    assert identify(Path(os.devnull)) == Identity("foreign", "a device")


def test_what_is_somebody_else_s_is_rejected_by_name_and_untouched(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("milk\n")
    with pytest.raises(ForeignFileError, match=r"notes\.txt is a text file, not a show; it stays as it is\."):
        reject_foreign(path)
    assert [file.read_text() for file in tmp_path.iterdir()] == ["milk\n"]


def test_an_empty_file_becomes_a_show_only_where_its_name_says_so(tmp_path: Path) -> None:
    for name in ("a.omote", "A.OMOTE"):
        (tmp_path / name).touch()
        require_show(tmp_path / name)
    (tmp_path / "__init__.py").touch()
    with pytest.raises(ForeignFileError, match=r"__init__\.py is an empty file whose name does not end in \.omote"):
        require_show(tmp_path / "__init__.py")


def test_what_cannot_be_read_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError(13, "Permission denied", "a.omote")

    (tmp_path / "a.omote").write_bytes(b"x")
    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(ShowFileError, match=r"a\.omote cannot be read \(you are not allowed to\): name another file"):
        identify(tmp_path / "a.omote")


def test_a_log_alone_is_ours_where_it_or_its_name_says_so(tmp_path: Path) -> None:
    show = filled(tmp_path / "a.omote")
    log = (tmp_path / "a.omote-wal").read_bytes()
    show.close()
    (tmp_path / "b-wal").write_bytes(log)
    assert is_own_log(tmp_path / "b")
    for name, ours in (("c", False), ("c.omote", True)):
        (tmp_path / f"{name}-wal").write_bytes(log[:32])  # it has no page yet
        assert is_own_log(tmp_path / name) is ours
    (tmp_path / "d.omote-wal").write_bytes(b"my diary")
    assert not is_own_log(tmp_path / "d.omote")


def test_links_are_followed(tmp_path: Path) -> None:
    (tmp_path / "link.omote").symlink_to(tmp_path / "real.omote")
    assert locate_show(tmp_path / "link.omote") == (tmp_path / "real.omote").resolve()
