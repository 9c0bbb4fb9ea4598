"""Notes beside a show file: what pages have switched on, and tokens; nobody else may read them."""

import stat
from pathlib import Path

import pytest

from omote.server.persistence.device_file import (
    DeviceFile,
    DeviceNotes,
    device_path,
    read_notes,
    write_notes,
)

NOTES = DeviceNotes(("vmc:39539",), ("livelink:10.0.0.5:11111=dog",), {"VTube Studio 127.0.0.1:8001": "abc"})


def test_notes_are_kept_for_their_owner_alone(tmp_path: Path) -> None:
    path = device_path(tmp_path / "tour.omote")
    assert path.name == "tour.omote.devices"
    assert read_notes(path) == DeviceNotes()
    write_notes(path, NOTES)
    assert read_notes(path) == NOTES
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


@pytest.mark.parametrize("text", [b"", b"{", b'{"listen": 3}', b"\xff"])
def test_what_is_no_notes_is_said(tmp_path: Path, text: bytes) -> None:
    path = tmp_path / "a.devices"
    path.write_bytes(text)
    with pytest.raises(ValueError, match="delete it"):
        read_notes(path)
    said: list[str] = []
    file = DeviceFile(path, said.append)
    file.load()
    assert file.notes == DeviceNotes()
    assert "delete it" in said[0]


def test_changes_are_written_and_tokens_forgotten(tmp_path: Path) -> None:
    path = tmp_path / "a.devices"
    file = DeviceFile(path)
    file.load()
    file.keep(listen=NOTES.listen)
    file.keep_token("one", "abc")
    file.keep_token("two", "def")
    file.keep_token("one", "")
    file.close()
    assert read_notes(path) == DeviceNotes(NOTES.listen, (), {"two": "def"})
    again = DeviceFile(path)
    again.load()
    assert (again.token("two"), again.token("one")) == ("def", "")


def test_where_it_cannot_be_written_it_holds_and_is_said(tmp_path: Path) -> None:
    said: list[str] = []
    file = DeviceFile(tmp_path / "nowhere" / "a.devices", said.append)
    file.keep(listen=("vmc",))
    file.close()
    assert file.notes.listen == ("vmc",)
    assert "is not kept" in said[0]
    with pytest.raises(OSError, match="cannot be written"):
        write_notes(tmp_path / "nowhere" / "a.devices", NOTES)


def test_without_a_show_file_nothing_is_kept() -> None:
    file = DeviceFile(None)
    file.load()
    file.keep_token("one", "abc")
    file.close()
    assert file.token("one") == "abc"
