"""One server to a show file."""

import errno
import fcntl
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from omote.server.persistence.lock import ShowLockedError, lock_show, release_lock
from omote.showfile.schema import ShowFileError


def test_a_second_server_is_refused_and_the_next_is_not(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    first = lock_show(path)
    with pytest.raises(ShowLockedError, match=r"another Omote plays .*a\.omote already"):
        lock_show(path)
    os.close(first)
    os.close(lock_show(path))


def test_a_mistyped_folder_is_not_made(tmp_path: Path) -> None:
    with pytest.raises(ShowFileError, match=r"its folder .*new is not there; make it first"):
        lock_show(tmp_path / "new" / "a.omote")
    assert list(tmp_path.iterdir()) == []


def test_a_lock_without_a_show_file_leaves_nothing_and_locks_nobody_out(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    release_lock(path, lock_show(path))
    assert list(tmp_path.iterdir()) == []
    lock = lock_show(path)
    path.touch()
    release_lock(path, lock)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["a.omote", "a.omote.lock"]
    os.close(lock_show(path))


def test_a_lock_that_its_holder_removed_meanwhile_is_taken_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Who opened the file just before it was removed would else hold a lock that nobody sees."""
    path = tmp_path / "a.omote"
    real = os.open
    removed = list[int]()

    def open_late(*words: Any) -> int:
        descriptor = real(*words)
        if not removed:
            removed.append(descriptor)
            Path(words[0]).unlink()
        return descriptor

    monkeypatch.setattr(os, "open", open_late)
    lock = lock_show(path)
    assert os.path.samestat(os.fstat(lock), path.with_name("a.omote.lock").stat())
    os.close(lock)


def test_two_shows_do_not_disturb_each_other(tmp_path: Path) -> None:
    descriptors = [lock_show(tmp_path / name) for name in ("a.omote", "b.omote")]
    for descriptor in descriptors:
        os.close(descriptor)


def test_who_inherits_the_lock_holds_it(tmp_path: Path) -> None:
    lock = lock_show(tmp_path / "a.omote")
    heir = subprocess.Popen(
        [sys.executable, "-c", "input()"], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL, pass_fds=(lock,)
    )
    os.close(lock)  # the supervisor is gone, its server is not
    with pytest.raises(ShowLockedError):
        lock_show(tmp_path / "a.omote")
    heir.kill()
    heir.communicate()
    os.close(lock_show(tmp_path / "a.omote"))


def test_what_is_no_file_is_refused_untouched(tmp_path: Path) -> None:
    with pytest.raises(ShowFileError, match=r"is a folder, not a show; it stays as it is\. .*show\.omote"):
        lock_show(tmp_path)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(ShowFileError, match=r"pipe is a pipe, not a show; it stays as it is"):
        lock_show(tmp_path / "pipe")
    assert [entry.name for entry in tmp_path.iterdir()] == ["pipe"]
    assert not tmp_path.with_name(tmp_path.name + ".lock").exists()


def test_a_place_where_no_file_can_be_is_refused_in_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for path in (tmp_path / "file" / "a.omote", tmp_path / ("x" * 300)):
        with pytest.raises(
            ShowFileError, match=rf"{path.name} cannot be (made: .* is no folder|read \(.*\): name another file)"
        ):
            lock_show(path)


@pytest.mark.parametrize(
    ("call", "number"), [("flock", errno.EOPNOTSUPP), ("flock", errno.ENOLCK), ("lockf", errno.ENOLCK)]
)
def test_a_folder_without_locks_is_said_to_be_one_and_nothing_is_left_in_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: str, number: int
) -> None:
    def refuse(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(fcntl, call, refuse)
    with pytest.raises(
        ShowFileError, match=r"cannot be played: its folder cannot hold a show: it has no locks"
    ) as told:
        lock_show(tmp_path / "a.omote")
    assert "on a disk of this machine" in str(told.value)
    assert list(tmp_path.iterdir()) == []
