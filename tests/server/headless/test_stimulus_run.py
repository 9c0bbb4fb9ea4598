"""The stimuli of a table: drawn into a folder once, gone on with, and listed."""

import base64
import csv
import hashlib
import shutil
from pathlib import Path

import msgspec
import numpy as np
import pytest

from omote.interchange.formats.png import png_bytes
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.motion_curve import make_curve
from omote.server.headless.clip_pictures import ClipPictures
from omote.server.headless.picture_run import PictureStudio
from omote.server.headless.stimulus_run import DRAWN, draw_planned, draw_stimuli, finish_stimuli, plan_stimuli
from omote.show.objects.clips import stored_clip
from omote.showfile.changes import Stored
from omote.showfile.inspection import Inspection
from omote.stage_data.picture_request import RenderRequest
from omote.stage_data.picture_sidecar import read_sidecar, sidecar_path
from tests.server.false_browser import ANSWERS, false_browser
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


RAMP = stored_clip(Clip([Lane(make_curve([0.0, 1.0], {"jawOpen": [0.0, 1.0]}, {}))])).encode()
PICTURE = png_bytes(np.full((64, 64, 4), 90, np.uint8))
"""What the browser draws: ffmpeg wants pictures."""
DRAWS_PICTURES = ANSWERS.replace("cGljdHVyZQ==", base64.b64encode(PICTURE).decode())
MOVES = "name,clip,face,from,to,fps,size,format\na,ramp,generic,0.2,0.6,5,64x64,\n"


SHOW = Inspection(8, 0, Stored(documents={"clip": {"ramp": RAMP}}), {})


@pytest.fixture
def drawing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A browser that gives pictures."""
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path, DRAWS_PICTURES)))


def run(table: str, folder: Path) -> dict[int, str]:
    studio = PictureStudio(SHOW)
    planned = plan_stimuli(studio, table.encode(), folder)
    planned.refuse_foreign()
    return finish_stimuli(studio, planned, draw_planned(studio, planned, lambda _: None), TOLD.append)


TOLD: list[str] = []


@pytest.mark.usefixtures("drawing")
def test_a_motion_clip_is_drawn_with_a_sidecar_of_its_frames(tmp_path: Path) -> None:
    assert run(MOVES, tmp_path / "out") == {}
    sidecar = msgspec.json.decode((tmp_path / "out" / "a" / "frames.json").read_bytes(), type=ClipPictures)
    assert sidecar.frames == {"0001.png": 0.0, "0002.png": 0.2}
    assert sidecar.pictures == dict.fromkeys(sidecar.frames, hashlib.sha256(PICTURE).hexdigest())
    assert (sidecar.clip, sidecar.motion, sidecar.rate) == ("ramp", hashlib.sha256(RAMP).hexdigest(), 5.0)
    assert sidecar.row == {
        "name": "a", "clip": "ramp", "face": "generic", "from": "0.2", "to": "0.6", "fps": "5", "size": "64x64",
    }  # fmt: skip
    drawn = [read_sidecar(sidecar_path(tmp_path / "out" / "a" / name)) for name in sidecar.frames]
    assert [each.pictures["poses"][0][0]["channels"] for each in drawn] == [
        pytest.approx({"jawOpen": at}) for at in (0.2, 0.4)
    ]
    again = drawn[1].request
    assert isinstance(again, RenderRequest)
    assert (again.clip, round(again.at, 9)) == ("ramp", 0.4), "omote redraw draws it again"


@pytest.mark.usefixtures("drawing")
@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="ffmpeg is not installed")
def test_a_film_is_made_once_and_nothing_of_others_is_replaced(tmp_path: Path) -> None:
    table = MOVES.replace("64x64,", "64x64,mov")
    out = tmp_path / "out"
    assert run(table, out) == {}
    film = out / "a.mov"
    sidecar = msgspec.json.decode((out / "a" / "frames.json").read_bytes(), type=ClipPictures)
    assert sidecar.film == hashlib.sha256(film.read_bytes()).hexdigest()
    made = film.stat().st_mtime_ns
    assert run(table, out) == {}
    assert film.stat().st_mtime_ns == made
    film.unlink()
    assert run(table, out) == {}
    assert TOLD == ["a.mov, film 1 of 1.", "a.mov, film 1 of 1."]
    film.write_bytes(b"somebody's own")
    with pytest.raises(FileExistsError, match=r"a\.mov is there already and is not as Omote made it"):
        run(table, out)


REFUSES = DRAWS_PICTURES.replace(
    'if method == "Runtime.evaluate" and "heet("',
    """if method == "Runtime.evaluate" and '"smile":' in parameters["expression"]:
        return {"exceptionDetails": {"exception": {"value": "too many triangles"}}}
    if method == "Runtime.evaluate" and "heet(\"""",
)


def test_a_row_that_cannot_be_drawn_costs_that_row_and_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path, REFUSES)))
    table = "name,expression,clip,size,seconds,fps\nb,smile,,64x64,0.4,5\na,,,64x64,,\nc,,ramp,64x64,,2\n"
    assert run(table, tmp_path / "out") == {2: "row 2, b: too many triangles"}
    rows = list(csv.DictReader((tmp_path / "out" / DRAWN).read_text().splitlines()))
    assert [row["file"] for row in rows] == ["a.png", "c/0001.png", "c/0002.png"]
    (tmp_path / "design.csv").write_text("name,expression\nb,smile\na,\n")
    with pytest.raises(RuntimeError, match=r"^row 2, b: too many triangles; all other rows are drawn$"):
        draw_stimuli(tmp_path / "design.csv", tmp_path / "again")


def test_a_table_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"^there is no table .*nope\.csv; name one that is there$"):
        draw_stimuli(tmp_path / "nope.csv", tmp_path / "out")
