"""`omote clip ...`: in from recordings, listed, and out for other programs."""

from __future__ import annotations

import csv
import json
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from omote.cli import app
from omote.clip_commands import telling
from omote.server.persistence.lock import lock_show
from tests.inputs.takes.test_live_link_take import HEADER, row
from tests.interchange.clips.humanoids import MIXAMO, bvh_of, moving


def run(*arguments: object) -> Result:
    return CliRunner().invoke(app, ["clip", *map(str, arguments)])


@pytest.fixture
def show(tmp_path: Path) -> Path:
    """A show file with the clip `line1`, of one second."""
    take = tmp_path / "line1.csv"
    rows = [row(f"00:00:00:{frame:02}.000", *[frame / 60] * 8) for frame in range(60)]
    take.write_text(HEADER + "".join(rows))
    done = run("import", tmp_path / "my.omote", take)
    assert done.exit_code == 0, done.output
    assert "has the clip line1, 0.98 s" in done.output
    return tmp_path / "my.omote"


def test_clips_are_listed(show: Path) -> None:
    (listed,) = json.loads(run("list", show, "--json").stdout)
    assert (listed["name"], listed["lanes"]) == ("line1", 1)
    assert listed["seconds"] == pytest.approx(59 / 60, abs=1e-3)
    told = CliRunner().invoke(app, ["file", "list", str(show), "--documents", "clip"])
    assert "line1" in told.stdout


@pytest.mark.parametrize("ending", [".csv", ".bvh", ".vrma"])
def test_a_clip_goes_out(show: Path, ending: str) -> None:
    output = show.with_name(f"out{ending}")
    done = run("export", show, "line1", "-o", output)
    assert done.exit_code == 0, done.output
    assert "holds line1, 60 frames" in done.output
    assert output.stat().st_size > 1000
    assert run("export", show, "line1", "-o", output).exit_code == 1  # it is there
    assert run("export", show, "line1", "-o", output, "--force").exit_code == 0
    if ending == ".csv":
        assert len([*csv.reader(output.read_text().splitlines())]) == 61


def test_what_cannot_be_done_is_said(show: Path, tmp_path: Path) -> None:
    for arguments, said in (
        (("export", show, "line2", "-o", tmp_path / "a.bvh"), "there is no clip 'line2' in this show"),
        (("export", show, "line1", "-o", tmp_path / "a.fbx"), "end it with .csv, .glb, .vrma, .bvh"),
        (("export", show, "line1", "-o", tmp_path / "a.csv", "--rate", "30"), "60 frames a second, not 30"),
        (("export", show, "line1", "-o", tmp_path / "a.glb", "--face", "nobody"), "there is no face 'nobody'"),
        (("render", show, "line1", "-o", tmp_path / "a.avi"), "end it with .mov or .webm, or name a folder"),
        (("render", show, "line1", "-o", tmp_path), "is not empty; name another, or empty it"),
        (("render", show, "line2", "-o", tmp_path / "frames"), "there is no clip 'line2' in this show"),
        (("import", show, tmp_path / "line1.csv"), "there is a clip 'line1' already"),
        (("import", show, tmp_path / "none.csv"), "none.csv cannot be used: it is not there"),
    ):
        done = run(*arguments)
        assert done.exit_code == 1, arguments
        assert said in done.output, done.output


@pytest.mark.parametrize("ending", [".bvh", ".vrma"])
def test_a_body_comes_in_goes_out_and_comes_in_again(tmp_path: Path, ending: str) -> None:
    show = tmp_path / "my.omote"
    walk = tmp_path / "walk.bvh"
    walk.write_bytes(bvh_of(moving(tuple(MIXAMO), frames=8), MIXAMO))
    assert run("import", show, walk).exit_code == 0
    output = tmp_path / f"again{ending}"
    done = run("export", show, "walk", "-o", output, "--rate", 30, "--face", "heavy")
    assert done.exit_code == 0, done.output
    done = run("import", show, output, "--from", "0.1", "--to", "0.2")
    assert done.exit_code == 0, done.output
    listed = {clip["name"]: clip for clip in json.loads(run("list", show, "--json").stdout)}
    assert listed["again"]["parts"] == listed["walk"]["parts"] == "body"
    assert listed["again"]["seconds"] == 0.1
    walk.write_text("HIERARCHY")
    done = run("import", show, walk, "--name", "none")
    assert done.exit_code == 1
    assert "the file has no MOTION" in done.output
    left_out = run("export", show, "walk", "-o", tmp_path / "walk.csv")
    assert "it moves the body too, which is not in this" in left_out.output


def test_several_clips_are_cut_out_of_one_take(show: Path) -> None:
    for name, begin, end in (("a", "0", "0.5"), ("b", "0:00.5", "0.75")):
        done = run("import", show, show.with_name("line1.csv"), "--name", name, "--from", begin, "--to", end)
        assert done.exit_code == 0, done.output
    listed = json.loads(run("list", show, "--json").stdout)
    assert {clip["name"]: clip["seconds"] for clip in listed} == {"a": 0.5, "b": 0.25, "line1": 0.983}


def test_into_a_show_that_runs_nothing_is_imported(show: Path) -> None:
    lock = lock_show(show)
    done = run("import", show, show.with_name("line1.csv"), "--name", "line2")
    os.close(lock)
    assert done.exit_code == 1
    assert "End that show first. While it runs, play the recording into it" in done.output


def test_how_far_pictures_are_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    def stop_at(done: int) -> None:
        with telling(goes_on=True) as tell:
            tell(0, 30)
            tell(done, 30)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        stop_at(9)
    with telling(goes_on=True) as tell:
        tell(9, 30)
        tell(10, 30)
    assert capsys.readouterr().err.splitlines() == [
        "omote: 9 of 30 frames were drawn; the same command goes on.",
        "omote: 9 of 30 frames were drawn before, and stay.",
    ]
