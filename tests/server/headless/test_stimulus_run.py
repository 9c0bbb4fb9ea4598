"""The stimuli of a table: drawn into a folder once, gone on with, and listed."""

import csv
from pathlib import Path

import pytest

from omote.model.cast import Cast
from omote.server.headless.picture_run import PictureStudio
from omote.server.headless.stimulus_run import DRAWN, draw_planned, draw_stimuli, plan_stimuli
from omote.stage_data.picture_sidecar import read_sidecar, sidecar_path
from tests.server.false_browser import false_browser
from tests.server.synthetic_server import MASK, PAGES, meshes

TABLE = "name,expression,size,seconds,fps,block\na,smile,64x64,,,x\nb,,32x32,,,y\nc,smile,64x64,0.2,5,y\n"


@pytest.fixture(autouse=True)
def browser(cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The synthetic cast, and a browser that only speaks."""
    for name, made in (("load_cast", cast), ("load_meshes", meshes(cast)), ("load_mask", MASK), ("read_pages", PAGES)):
        monkeypatch.setattr(f"omote.server.headless.picture_run.{name}", lambda made=made: made)
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path)))


def test_a_table_is_drawn_once_gone_on_with_and_listed(tmp_path: Path) -> None:
    design = tmp_path / "design.csv"
    design.write_text(TABLE)
    out = tmp_path / "out"
    pictures = draw_stimuli(design, out)
    assert [path.relative_to(out).as_posix() for path in pictures] == ["a.png", "b.png", "c/0001.png", "c/0002.png"]
    rows = list(csv.DictReader((out / DRAWN).read_text().splitlines()))
    assert [(row["name"], row["file"], row["second"], row["block"]) for row in rows] == [
        ("a", "a.png", "", "x"),
        ("b", "b.png", "", "y"),
        ("c", "c/0001.png", "0", "y"),
        ("c", "c/0002.png", "0.2", "y"),
    ]
    assert [row["sha256"] for row in rows] == [read_sidecar(sidecar_path(path)).picture for path in pictures]
    assert {(row["cut_black"], row["cut_white"]) for row in rows} == {("", "")}
    assert plan_stimuli(PictureStudio(), TABLE.encode(), out).waiting == 0
    pictures[1].unlink()
    (out / "c" / "0001.png").unlink()
    told: list[tuple[int, int]] = []
    studio = PictureStudio()
    again = plan_stimuli(studio, TABLE.encode(), out)
    draw_planned(studio, again, lambda progress: told.append((progress.number, progress.total)))
    assert told == [(3, 4), (4, 4)]
    assert all(path.exists() for path in pictures)
    with pytest.raises(ValueError, match="give the design another name"):
        draw_stimuli(out / DRAWN, out)
    pictures[0].write_bytes(b"retouched")
    with pytest.raises(FileExistsError, match="is not as Omote drew it"):
        draw_stimuli(design, out)


def test_a_table_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"^there is no table .*nope\.csv; name one that is there$"):
        draw_stimuli(tmp_path / "nope.csv", tmp_path / "out")
