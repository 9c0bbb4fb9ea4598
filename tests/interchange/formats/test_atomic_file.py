"""Files written whole or not at all."""

import errno
import os
from pathlib import Path

import pytest

from omote.interchange.formats.atomic_file import check_writable, require_free, write_whole

PNG = b"\x89PNG\r\n\x1a\n"


def test_a_file_replaces_the_one_before_and_leaves_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    write_whole(path, PNG + b"old")
    write_whole(path, PNG + b"new")
    assert path.read_bytes() == PNG + b"new"
    assert list(tmp_path.iterdir()) == [path]


def test_when_writing_fails_the_old_file_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.png"
    write_whole(path, PNG + b"old")

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match=r"a\.png cannot be written: the disk is full; what was there stays as it is"):
        write_whole(path, PNG + b"new")
    assert path.read_bytes() == PNG + b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_places_where_nothing_can_be_written_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(IsADirectoryError, match="is a folder"):
        check_writable(tmp_path)
    with pytest.raises(FileNotFoundError, match=f"there is no folder {tmp_path}/deeper"):
        check_writable(tmp_path / "deeper" / "a.png")
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(PermissionError, match="nothing can be written into"):
        check_writable(tmp_path / "a.png")


def test_others_may_read_it_as_any_new_file(tmp_path: Path) -> None:
    usual = tmp_path / "usual"
    usual.touch()
    write_whole(tmp_path / "a.png", b"x")
    assert (tmp_path / "a.png").stat().st_mode == usual.stat().st_mode


@pytest.mark.parametrize("name", ["a.png", "a.PNG", "a.jpg", "a.glb", "package.json", "notes.txt", "notes"])
def test_another_kind_of_file_is_not_written_over(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(b'{"name": "theirs"}')
    with pytest.raises(FileExistsError, match=f"{name} is there already and is no .*; it stays as it is"):
        check_writable(path)
    with pytest.raises(FileExistsError):
        write_whole(path, PNG if path.suffix else b'{"omote": "expression"}')
    assert path.read_bytes() == b'{"name": "theirs"}'


@pytest.mark.parametrize(
    ("name", "old"),
    [
        ("a.png", PNG + b"old"),
        ("a.jpeg", b"\xff\xd8\xff\xe0"),
        ("a.glb", b"glTF\2"),
        ("smile.json", b'{\n"omote": "expression"'),
        ("a.png", b""),
    ],
)
def test_its_own_kind_and_an_empty_file_are_written_over(tmp_path: Path, name: str, old: bytes) -> None:
    (tmp_path / name).write_bytes(old)
    check_writable(tmp_path / name)
    write_whole(tmp_path / name, b"whatever")
    assert (tmp_path / name).read_bytes() == b"whatever"


def test_what_begins_as_the_new_content_is_of_its_kind(tmp_path: Path) -> None:
    for number in range(2):
        write_whole(tmp_path / "figure.json", b'{"picture": "a.png", "number": %d}' % number)
    assert b'"number": 1' in (tmp_path / "figure.json").read_bytes()


def test_only_who_says_so_replaces_a_file(tmp_path: Path) -> None:
    path = tmp_path / "smirk.json"
    require_free(path, force=False)
    path.write_bytes(b"{}")
    require_free(path, force=True)
    with pytest.raises(FileExistsError, match=r"smirk.json is there already .* or --force to replace it"):
        require_free(path, force=False)


def test_a_device_is_not_replaced(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.png")
    for path in (tmp_path / "pipe.png", Path(os.devnull)):
        with pytest.raises(FileExistsError, match="is no file but a device"):
            write_whole(path, PNG)
    assert [entry.name for entry in tmp_path.iterdir()] == ["pipe.png"]


def test_a_link_is_followed_not_replaced(tmp_path: Path) -> None:
    (tmp_path / "deep").mkdir()
    (tmp_path / "a.png").symlink_to(tmp_path / "deep" / "real.png")
    write_whole(tmp_path / "a.png", PNG)
    assert (tmp_path / "a.png").is_symlink()
    assert (tmp_path / "deep" / "real.png").read_bytes() == PNG
    (tmp_path / "loop.png").symlink_to(tmp_path / "loop.png")
    with pytest.raises(OSError, match=r"loop\.png"):
        write_whole(tmp_path / "loop.png", PNG)
