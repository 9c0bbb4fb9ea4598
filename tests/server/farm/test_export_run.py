"""Runs of exports: in any number of processes the same files; interrupted anywhere, the next run makes what is left."""

import os
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from omote.interchange.formats.atomic_file import write_whole
from omote.server.farm import export_record
from omote.server.farm.export_run import ExportRun, bake_in_processes, run_export
from tests import synthetic
from tests.server.farm.runs import contents, ignore, make_run, pool_here

FACES = list(synthetic.FACES)
ROOT = Path(__file__).parents[3]


def test_any_number_of_processes_writes_the_same_files(tmp_path: Path) -> None:
    for jobs in (0, 1, 3):
        pool = bake_in_processes(jobs) if jobs else pool_here
        done = run_export(make_run(tmp_path / str(jobs), kind=".glb"), pool, ignore)
        assert (sorted(done.exported), done.current, done.failed) == (sorted(FACES), [], {})
    first = contents(tmp_path / "0")
    assert first.keys() == {f"{face}.glb" for face in FACES}
    assert contents(tmp_path / "1") == first == contents(tmp_path / "3")


def test_what_is_whole_and_current_is_not_made_again(tmp_path: Path) -> None:
    told = list[tuple[int, int, str, str]]()
    run_export(make_run(tmp_path), pool_here, lambda *step: told.append(step))
    assert told == [(number, len(FACES), face, "") for number, face in enumerate(FACES, 1)]
    (tmp_path / f"{FACES[1]}.npz").unlink()
    again = run_export(make_run(tmp_path), pool_here, ignore)
    assert (again.exported, set(again.current)) == ([FACES[1]], set(FACES) - {FACES[1]})
    assert run_export(make_run(tmp_path), pool_here, ignore).exported == []
    other = run_export(make_run(tmp_path, expressions=["smile", "jawOpen"]), pool_here, ignore)
    assert other.exported == FACES
    keys = [replace(make_run(tmp_path), body=body).keys[FACES[0]] for body in ("", "own", "heavy")]
    assert len(set(keys)) == len(keys)  # a head, and figures on other bodies, are made anew


def test_what_fails_is_named_and_the_others_are_made(tmp_path: Path) -> None:
    (tmp_path / f"{FACES[0]}.npz").write_bytes(b"PK\x03\x04 theirs")
    done = run_export(make_run(tmp_path), pool_here, ignore)
    assert done.exported == FACES[1:]
    assert f"{FACES[0]}.npz is there already and is not as Omote wrote it" in done.failed[FACES[0]]
    forced = run_export(make_run(tmp_path, force=True), pool_here, ignore)
    assert forced.exported == FACES[:1]


def test_a_full_disk_ends_the_run_with_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, data: bytes) -> None:
        if path.name == f"{FACES[1]}.npz":
            raise OSError(f"{path} cannot be written: the disk is full; what was there stays as it is")
        write_whole(path, data)

    monkeypatch.setattr(export_record, "write_whole", full)
    with pytest.raises(OSError, match=rf"{FACES[1]}: .*the disk is full; .*the same command goes on from there"):
        run_export(make_run(tmp_path), pool_here, ignore)
    monkeypatch.undo()
    done = run_export(make_run(tmp_path), pool_here, ignore)
    assert (done.exported, done.current) == (FACES[1:], FACES[:1])


def test_nothing_can_be_written_into_a_folder_of_somebody_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)  # who runs tests as root may write everywhere
    with pytest.raises(PermissionError, match=r"nothing can be written into .*; choose another folder"):
        run_export(make_run(tmp_path), pool_here, ignore)


INTERRUPTED = """
import sys
from pathlib import Path
from omote.server.farm.export_run import bake_in_processes, run_export
from tests.server.farm.runs import make_run
run_export(make_run(Path(sys.argv[1]), kind=".glb"), bake_in_processes(2), lambda *step: print(step[0], flush=True))
"""


@pytest.mark.usefixtures("children_hear_ctrl_c")
@pytest.mark.parametrize("ending", [signal.SIGKILL, signal.SIGINT])
def test_a_run_that_is_ended_in_the_middle_goes_on(tmp_path: Path, ending: signal.Signals) -> None:
    first = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, str(tmp_path / "a")],
        cwd=ROOT, env={**os.environ, "PYTHONPATH": f"{ROOT / 'src'}{os.pathsep}{ROOT}"},
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
    )  # fmt: skip
    assert first.stdout is not None
    with first.stdout as said:
        assert said.readline() == "1\n"
        first.send_signal(ending)
        assert first.wait() != 0
        said.read()  # ends with the last worker
    run: ExportRun = make_run(tmp_path / "a", kind=".glb")
    before = contents(tmp_path / "a")
    done = run_export(run, bake_in_processes(2), ignore)
    assert done.current
    assert {*done.exported, *done.current} == set(FACES)
    run_export(make_run(tmp_path / "b", kind=".glb"), pool_here, ignore)
    whole = contents(tmp_path / "b")
    assert contents(tmp_path / "a") == whole
    assert all(before[f"{face}.glb"] == whole[f"{face}.glb"] for face in done.current)
