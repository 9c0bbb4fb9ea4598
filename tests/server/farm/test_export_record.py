"""Records of exports: what is whole, former or foreign is told at any instant, also after a kill -9 anywhere."""

import os
import signal
from collections.abc import Callable
from pathlib import Path

import pytest

from omote.interchange.formats.atomic_file import write_whole
from omote.server.farm import export_record
from omote.server.farm.export_record import RECORDS, find_foreign, find_state, open_folder, store_export
from tests.server.farm.runs import contents

NAME = "aunt.glb"
MAIN = "aunt.glb"
OLD = {MAIN: b"glTF old", "aunt.skin.png": b"\x89PNG\r\n\x1a\n old"}
NEW = {MAIN: b"glTF new", "aunt.skin.png": b"\x89PNG\r\n\x1a\n new", "aunt.eye.png": b"\x89PNG\r\n\x1a\n eye"}


def test_a_face_is_missing_then_current_then_former(tmp_path: Path) -> None:
    with open_folder(tmp_path):
        assert find_state(tmp_path, NAME, "old", MAIN) == "missing"
        store_export(tmp_path, NAME, "old", OLD)
        assert find_state(tmp_path, NAME, "old", MAIN) == "current"
        assert find_state(tmp_path, NAME, "new", MAIN) == "former"
        store_export(tmp_path, NAME, "new", NEW)
        assert find_state(tmp_path, NAME, "new", MAIN) == "current"
    assert contents(tmp_path) == NEW


def test_what_somebody_changed_or_put_there_stays(tmp_path: Path) -> None:
    with open_folder(tmp_path):
        (tmp_path / MAIN).write_bytes(b"glTF theirs")
        assert find_state(tmp_path, NAME, "new", MAIN) == "foreign"
        with pytest.raises(FileExistsError, match=r"aunt\.glb is there already and is not as Omote wrote it"):
            store_export(tmp_path, NAME, "new", NEW)
        assert contents(tmp_path) == {MAIN: b"glTF theirs"}
        store_export(tmp_path, NAME, "new", NEW, force=True)
        (tmp_path / "aunt.skin.png").write_bytes(b"\x89PNG\r\n\x1a\n painted over")
        assert find_state(tmp_path, NAME, "new", MAIN) == "foreign"
        assert find_foreign(tmp_path, NAME, MAIN) == "aunt.skin.png"


def test_a_file_that_is_gone_or_a_record_that_is_damaged_is_seen(tmp_path: Path) -> None:
    with open_folder(tmp_path):
        store_export(tmp_path, NAME, "new", NEW)
        (tmp_path / "aunt.eye.png").unlink()
        assert find_state(tmp_path, NAME, "new", MAIN) == "missing"
        (tmp_path / RECORDS / f"{NAME}.json").write_bytes(b"{")
        assert find_state(tmp_path, NAME, "new", MAIN) == "foreign"


def test_two_runs_do_not_write_into_one_folder(tmp_path: Path) -> None:
    with (
        open_folder(tmp_path),
        pytest.raises(BlockingIOError, match="another omote export writes into"),
        open_folder(tmp_path),
    ):
        pass
    with open_folder(tmp_path):
        pass


def test_a_folder_that_cannot_be_made_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with (
        pytest.raises(OSError, match=r"file/.* cannot be made: .*; name another one"),
        open_folder(tmp_path / "file" / "folder"),
    ):
        pass


def die_at(step: int) -> Callable[[Path, bytes], None]:
    """`write_whole`, killed at its step: before a draft, with half a draft written, or when the file is written."""
    steps = iter(range(step + 1))

    def tick() -> None:
        if next(steps) == step:
            os.kill(os.getpid(), signal.SIGKILL)

    def write(path: Path, data: bytes) -> None:
        tick()
        (path.parent / f".{path.name}.abcd1234").write_bytes(data[:9])
        tick()
        (path.parent / f".{path.name}.abcd1234").unlink()
        write_whole(path, data)
        tick()

    return write


@pytest.mark.parametrize("step", range(3 * (len(NEW) + 1)))
def test_a_kill_at_any_step_leaves_whole_files_that_are_ours(tmp_path: Path, step: int) -> None:
    with open_folder(tmp_path):
        store_export(tmp_path, NAME, "old", OLD)
    pid = os.fork()
    if pid == 0:
        setattr(export_record, "write_whole", die_at(step))  # noqa: B010 - in this child alone
        with open_folder(tmp_path):
            store_export(tmp_path, NAME, "new", NEW)
        os._exit(0)
    assert os.WTERMSIG(os.waitpid(pid, 0)[1]) == signal.SIGKILL
    found = {name: data for name, data in contents(tmp_path).items() if not name.startswith(".")}
    assert all(data in (OLD.get(name), NEW[name]) for name, data in found.items())
    with open_folder(tmp_path):
        state = find_state(tmp_path, NAME, "new", MAIN)
        assert (state == "current") == (found == NEW)
        assert state != "foreign"
        store_export(tmp_path, NAME, "new", NEW)
    assert contents(tmp_path) == NEW
    assert [path.name for path in (tmp_path / RECORDS).glob(".*")] == []
