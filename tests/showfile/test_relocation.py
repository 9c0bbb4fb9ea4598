"""A show file that loses its place while it is open is made anew with everything, and nobody's file is touched."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import StoredDocument
from omote.showfile.recovery import is_lost
from omote.showfile.relocation import find_free_path, relocate_show
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

LAST = JournalEntry(7, 5.0, b"state")


def commit(show: ShowFile, *names: str) -> None:
    """Layouts that are told apart by their names, and a last state."""
    show.apply([StoredDocument("layout", name, b"{}") for name in names])
    show.write_journal(LAST)


def held(path: Path) -> tuple[set[str], JournalEntry]:
    """What a file holds for whoever opens it."""
    show = open_show(path)
    found = set(show.stored().documents.get("layout", {})), show.journal()
    show.close()
    return found


@pytest.fixture
def show(tmp_path: Path) -> ShowFile:
    """An open show file in a folder of its own, with a copy that is older than the file."""
    opened = open_show(tmp_path / "shows" / "a.omote")
    commit(opened, "early")
    back_up(opened)
    commit(opened, "late")
    return opened


def delete(path: Path) -> None:
    path.unlink()


def rename(path: Path) -> None:
    path.rename(path.with_name("b.omote"))


def rename_with_log(path: Path) -> None:
    for name in ("", "-wal", "-shm"):
        path.with_name(f"{path.name}{name}").rename(path.with_name(f"b.omote{name}"))


def move_folder(path: Path) -> None:
    path.parent.rename(path.parent.with_name("elsewhere"))


def delete_log(path: Path) -> None:
    path.with_name(f"{path.name}-wal").unlink()


LOSSES = (delete, rename, rename_with_log, move_folder, delete_log)


@pytest.mark.parametrize("lose", LOSSES)
def test_it_is_made_anew_where_it_was_with_all_that_was_committed(
    show: ShowFile, lose: Callable[[Path], None]
) -> None:  # fmt: skip
    path = show.path
    other = show.again()
    assert show.place.is_kept()
    lose(path)
    commit(other, "latest")  # still goes into the file that was opened
    assert not show.place.is_kept()
    assert relocate_show(show) == path
    assert show.place.is_kept()
    assert not is_lost(path)
    commit(show, "after")
    commit(other, "last")
    everything = {"early", "late", "latest", "after", "last"}
    assert (
        set(other.stored().documents.get("layout", {})) == set(show.stored().documents.get("layout", {})) == everything
    )
    shutil.copytree(path.parent, path.parent / "killed")  # as a process that is killed now leaves it
    assert held(path.parent / "killed" / path.name) == (everything, LAST)
    other.close()
    show.close()
    assert held(path) == (everything, LAST)


@pytest.mark.parametrize("lose", [rename, rename_with_log])
def test_a_moved_file_is_whole_as_it_was(show: ShowFile, lose: Callable[[Path], None]) -> None:
    path = show.path
    lose(path)
    commit(show, "latest")
    relocate_show(show)
    commit(show, "after")
    assert held(path.with_name("b.omote")) == ({"early", "late", "latest"}, LAST)
    show.close()


def test_whenever_it_is_cut_off_the_next_start_finds_everything(
    show: ShowFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    path = show.path
    path.unlink()
    commit(show, "latest")
    monkeypatch.setattr("omote.showfile.relocation.put_in_free_place", killed)
    with pytest.raises(KeyboardInterrupt):
        relocate_show(show)
    assert held(backup_paths(path)[0]) == ({"early", "late", "latest"}, LAST)
    assert not path.exists()
    assert not path.with_name("a.omote-wal").exists()
    show.close()


def replace_by_text(path: Path) -> bytes:
    path.unlink()
    path.write_text("milk and eggs")
    return path.read_bytes()


def replace_by_show(path: Path) -> bytes:
    other = open_show(path.with_name("other.omote"))
    commit(other, "of others")
    other.close()
    other.path.replace(path)
    return path.read_bytes()


def replace_log(path: Path) -> bytes:
    path.unlink()
    path.with_name(f"{path.name}-wal").unlink()
    path.with_name(f"{path.name}-wal").write_text("milk and eggs")
    return b""


@pytest.mark.parametrize("replace", [replace_by_text, replace_by_show, replace_log])
def test_somebody_else_s_file_in_its_place_stays_and_the_show_goes_on_beside(
    show: ShowFile, replace: Callable[[Path], bytes]
) -> None:
    path = show.path
    other = show.again()
    theirs = replace(path)
    assert not show.place.is_kept()
    beside = relocate_show(show)
    assert beside == path.with_name("a-2.omote") == show.path == other.path
    commit(other, "after")
    other.close()
    show.close()
    assert held(beside) == ({"early", "late", "after"}, LAST)
    assert (path.read_bytes() if path.exists() else b"") == theirs


def test_a_file_that_comes_at_the_last_moment_stays(show: ShowFile, monkeypatch: pytest.MonkeyPatch) -> None:
    path = show.path
    path.unlink()
    monkeypatch.setattr("omote.showfile.relocation.remove", lambda _: path.touch())
    with pytest.raises(FileExistsError):
        relocate_show(show)
    assert path.read_bytes() == b""
    assert set(show.stored().documents.get("layout", {})) == {"early", "late"}  # goes on in the old file
    monkeypatch.undo()
    assert relocate_show(show).name == "a-2.omote"
    show.close()


def test_connections_that_were_never_used_go_on_after_a_move_too(tmp_path: Path) -> None:
    show = open_show(tmp_path / "a.omote")
    commit(show, "early")
    for number in range(3):
        other = show.again()
        show.path.rename(tmp_path / f"moved-{number}.omote")
        commit(other, f"late {number}")
        relocate_show(other)
        show.path.unlink()
        relocate_show(other)
        other.close()
    assert set(show.stored().documents.get("layout", {})) == {"early", "late 0", "late 1", "late 2"}
    show.close()


def test_where_nothing_can_be_written_all_go_on_with_the_moved_file(show: ShowFile) -> None:
    path = show.path
    other = show.again()
    move_folder(path)
    path.parent.write_text("no folder")
    with pytest.raises(OSError, match="File exists"):
        relocate_show(show)
    commit(other, "latest")
    path.parent.unlink()
    path.parent.with_name("elsewhere").rename(path.parent)
    assert show.place.is_kept()
    other.close()
    show.close()
    assert held(path) == ({"early", "late", "latest"}, LAST)


def test_a_free_path_is_one_where_no_show_is_or_was(tmp_path: Path) -> None:
    (tmp_path / "a-2.omote").touch()
    (tmp_path / "a-3.omote.good").touch()
    (tmp_path / "a-4.omote-wal").touch()
    assert find_free_path(tmp_path / "a.omote") == tmp_path / "a-5.omote"
