"""Before a show plays: its file and its port."""

import os
import socket
from pathlib import Path

import pytest

from omote.server.supervision.preparation import open_or_make, prepare_show
from omote.showfile.backup import back_up
from omote.showfile.show_file import ShowFileError, open_show
from tests.server.synthetic_server import PAGES


@pytest.fixture(autouse=True)
def pages(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pages that need no build."""
    monkeypatch.setattr("omote.server.supervision.preparation.read_pages", lambda: PAGES)


def test_a_file_that_is_brought_back_from_a_copy_is_no_new_show(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    told = list[str]()
    show = open_show(path)
    back_up(show)
    show.close()
    assert open_or_make(path, told.append) == f"the show of {path} goes on; it holds 0 own faces and expressions"
    assert told == []
    path.unlink()
    open_or_make(path, told.append)
    assert len(told) == 1
    assert "its good copy" in told[0]


@pytest.mark.parametrize("port_taken", [True, False])
def test_what_cannot_be_prepared_leaves_nothing_behind(tmp_path: Path, port_taken: bool) -> None:
    path = tmp_path / "a.omote"
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1] if port_taken else 0
        if not port_taken:
            path.with_name("a.omote-wal").write_bytes(b"of another program")
        before = sorted(tmp_path.iterdir())
        with pytest.raises((OSError, ShowFileError)):
            prepare_show(path, "127.0.0.1", port, tell=print, report=print)
        assert sorted(tmp_path.iterdir()) == before


def test_it_is_locked_it_listens_and_says_which_file(tmp_path: Path) -> None:
    told = list[str]()
    lock, listening = prepare_show(tmp_path / "a.omote", "127.0.0.1", 0, tell=told.append, report=print)
    with listening:
        assert listening.getsockname()[1] > 0
    assert told == [f"a new show begins in {tmp_path / 'a.omote'}"]
    os.close(lock)
