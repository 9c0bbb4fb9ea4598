"""Show files that no show plays."""

import os
from pathlib import Path

import pytest

from omote.server.persistence import offline_show
from omote.server.persistence.lock import ShowLockedError, lock_show
from omote.server.persistence.offline_show import open_offline_show, wall_clock
from omote.showfile.backup import backup_paths
from omote.showfile.changes import StoredDocument
from omote.showfile.show_file import ShowFile, open_show


def test_what_is_written_stays_and_the_file_is_free_again(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    with open_offline_show(path, new=True) as file:
        file.apply([StoredDocument("layout", "console", b"{}")])
    with open_offline_show(path) as file:
        assert file.stored().documents.get("layout", {}) == {"console": b"{}"}
    os.close(lock_show(path))


def test_what_is_written_is_backed_up_and_what_is_only_read_is_not(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    with open_offline_show(path, new=True) as file:
        file.apply([StoredDocument("layout", "console", b"{}")])
        written = file.stored()
    with open_offline_show(path):
        pass
    newest, *older = backup_paths(path)
    backup = open_show(newest)
    assert backup.stored() == written
    backup.close()
    assert not any(each.exists() for each in older)


def test_a_disk_that_takes_no_backup_keeps_what_was_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: ShowFile) -> bool:
        raise OSError("No space left on device")

    monkeypatch.setattr("omote.server.persistence.offline_show.back_up", full)
    path = tmp_path / "a.omote"
    with open_offline_show(path, new=True) as file:
        file.apply([StoredDocument("layout", "console", b"{}")])
    with open_offline_show(path) as file:
        assert file.stored().documents.get("layout", {}) == {"console": b"{}"}


def test_a_file_that_is_not_there_is_not_made(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="there is no show file"), open_offline_show(tmp_path / "a.omote"):
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_a_show_plays_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    lock = lock_show(path)
    with (
        pytest.raises(
            ShowLockedError,
            match=r"another Omote plays .* by its console and its editor, and a list of cues by its server",
        ),
        open_offline_show(path, new=True),
    ):
        pass
    os.close(lock)


def test_the_wall_clock_counts_from_1970() -> None:
    assert wall_clock() > 1.7e9


def test_what_a_killed_show_left_in_memory_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    copy = tmp_path / "copy.omote"
    copy.write_bytes(b"faces of people")
    monkeypatch.setattr(offline_show, "find_copy", lambda _: copy)
    with open_offline_show(tmp_path / "a.omote", new=True):
        assert not copy.exists()
