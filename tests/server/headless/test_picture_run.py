"""Many pictures into files: written one by one, in several browsers, and not again."""

import itertools
import os
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest

from omote.interchange.formats.png import png_bytes, read_png
from omote.model.cast import Cast
from omote.server.headless.devtools import BrowserError
from omote.server.headless.picture_run import (
    PictureProgress,
    PictureStudio,
    digest_of_pages,
    draw_run,
    pictures_folder,
)
from omote.server.http.static_pages import Page
from omote.stage_data.morph_distance import measure_difference, measure_distance
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_request import GridRequest, RenderRequest
from omote.stage_data.picture_setting import Setting
from omote.stage_data.picture_sidecar import is_drawn, sidecar_path
from tests.server.false_browser import ANSWERS, false_browser
from tests.server.synthetic_server import MASK, PAGES, meshes

BROKEN = """
import pathlib
DRAWN = pathlib.Path(sys.argv[0] + ".drawn")
def answer(method, parameters):
    if method == "Runtime.evaluate" and "heet(" in parameters["expression"]:
        drawn = int(DRAWN.read_text()) if DRAWN.exists() else 0
        DRAWN.write_text(str(drawn + 1))
        if drawn == 2:
            os._exit(1)
        return {"result": {"value": "cGljdHVyZQ=="}}
    if method == "Runtime.evaluate":
        return {"result": {"value": True}}
    return {"targetId": "t", "sessionId": "s"}
"""


@pytest.fixture
def studio(cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> PictureStudio:
    """The synthetic cast, and a browser that only speaks."""
    for name, made in (("load_cast", cast), ("load_meshes", meshes(cast)), ("load_mask", MASK), ("read_pages", PAGES)):
        monkeypatch.setattr(f"omote.server.headless.picture_run.{name}", lambda made=made: made)
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path)))
    return PictureStudio()


@pytest.mark.parametrize("jobs", [1, 2, 9])
def test_every_picture_is_written_with_its_sidecar(studio: PictureStudio, tmp_path: Path, jobs: int) -> None:
    path = tmp_path / "grid.png"
    told = list[PictureProgress]()
    grid = GridRequest(faces=",".join(studio.cast.faces), expressions="neutral,smile")
    run = studio.plan(grid, path)
    draw_run(studio, run, told.append, jobs=jobs)
    assert [progress.number for progress in told] == [1, 2, 3, 4, 5, 6]
    assert all(is_drawn(file.path, file.sidecar) for file in run.pictures)
    assert run.table is not None
    assert is_drawn(path, run.table.sidecar)
    assert len(list(pictures_folder(path).iterdir())) == 12
    assert studio.plan(grid, path).complete
    assert not studio.plan(grid, path, fresh=True).complete


def test_a_run_goes_on_where_the_browser_ended(
    studio: PictureStudio, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "grid.png"
    grid = GridRequest(faces=",".join(studio.cast.faces), expressions="neutral,smile")
    broken = false_browser(tmp_path, BROKEN).rename(tmp_path / "broken")
    monkeypatch.setenv("OMOTE_BROWSER", str(broken))
    with pytest.raises(BrowserError, match="browser"):
        draw_run(studio, studio.plan(grid, path), lambda _: None)
    left = studio.plan(grid, path)
    assert (len(left.waiting), path.exists()) == (4, False)
    told: list[PictureProgress] = []
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path)))
    draw_run(PictureStudio(), left, told.append)
    assert [progress.number for progress in told] == [3, 4, 5, 6]
    assert studio.plan(grid, path).complete


def test_a_picture_without_its_sidecar_is_drawn_again(studio: PictureStudio, tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    request = RenderRequest(face=(next(iter(studio.cast.faces)),))
    draw_run(studio, studio.plan(request, path), lambda _: None)
    assert studio.plan(request, path).complete
    sidecar_path(path).unlink()
    assert not studio.plan(request, path).complete


def test_what_draws_in_another_way_has_another_digest() -> None:
    other = {**PAGES, "/static/a.js": Page(b"1", "text/javascript", immutable=True)}
    assert digest_of_pages(PAGES) != digest_of_pages(other)
    assert digest_of_pages(PAGES) == digest_of_pages(
        {**PAGES, "/console": Page(b"another", "text/html", immutable=False)}
    )


def test_no_more_browsers_start_than_there_are_pictures(studio: PictureStudio, tmp_path: Path) -> None:
    started = tmp_path / "started"
    note = f"open({str(started)!r}, 'a').write('.')\n"
    false_browser(tmp_path, note + ANSWERS)
    request = RenderRequest(face=(next(iter(studio.cast.faces)),))
    draw_run(studio, studio.plan(request, tmp_path / "a.png"), lambda _: None, jobs=os.cpu_count() or 2)
    assert started.read_text() == "."


def test_a_morph_by_millimetres_has_steps_that_are_so_far_apart(studio: PictureStudio, tmp_path: Path) -> None:
    one, other = list(studio.cast.faces)[1:3]
    space = studio.cast.base.space
    shapes = {name: studio.cast.base.faces[name].positions.astype(np.float64) for name in (one, other)}
    away = measure_distance(space, shapes[one], shapes[other])
    run = studio.plan(GridRequest(morph=f"{one}:{other}:{away / 7:.6f}mm"), tmp_path / "a.png")
    poses = [file.sheet.poses[0][0]["faces"] for file in run.pictures]
    skins = [np.sum([share * shapes[name] for name, share in pose.items()], axis=0) for pose in poses]
    steps = [measure_distance(space, before, after) for before, after in itertools.pairwise(skins)]
    assert steps == pytest.approx([away / 7] * 7, rel=1e-4)
    with pytest.raises(ValueError, match=r"mm apart, so steps of 1000 mm are 0; give a distance"):
        studio.plan(GridRequest(morph=f"{one}:{other}:1000mm"), tmp_path / "a.png")


class GreyBrowser:
    """Draws grey that grows with the cube of the last face's share, and counts how often."""

    drawn: ClassVar[list[float]] = []
    last = ""

    def __init__(self, setting: Setting, playing: object = None) -> None:
        assert (setting.width, setting.height) == (240, 270)
        assert playing is None

    def draw(self, sheet: PictureGrid) -> bytes:
        """A picture of one pixel."""
        share = sheet.poses[0][0]["faces"].get(self.last, 0.0)
        self.drawn.append(share)
        return png_bytes(np.full((1, 1, 3), 40 + round(200 * share**3), np.uint8))

    def close(self) -> None:
        """Nothing is open."""


@pytest.mark.parametrize("steps", ["6lab", "12dE"])
def test_a_morph_that_is_even_in_cielab_is_spelled_out_by_what_its_pictures_show(
    studio: PictureStudio, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, steps: str
) -> None:
    monkeypatch.setattr("omote.server.headless.picture_run.PictureBrowser", GreyBrowser)
    GreyBrowser.drawn.clear()
    one, other = list(studio.cast.faces)[1:3]
    GreyBrowser.last = other
    run = studio.plan(GridRequest(morph=f"{one}:{other}:{steps}", expressions="neutral,smile"), tmp_path / "a.png")
    assert len(GreyBrowser.drawn) == len(set(GreyBrowser.drawn)), "no step is drawn twice"
    shares = np.array([file.sheet.poses[0][0]["faces"].get(other, 0.0) for file in run.pictures]).reshape(2, -1)
    assert (shares[0] == shares[1]).all(), "all rows have the same faces"
    light = [png_bytes(np.full((1, 1, 3), 40 + round(200 * share**3), np.uint8)) for share in shares[0]]
    apart = [measure_difference(read_png(before), read_png(after)) for before, after in itertools.pairwise(light)]
    assert max(apart) < 1.1 * min(apart)
    assert np.diff(shares[0])[0] > 3 * np.diff(shares[0])[-1], "they are uneven in millimetres"
    assert run.table is not None
    again = studio.plan(run.table.sidecar.request, tmp_path / "a.png")
    assert [file.sidecar for file in again.files] == [file.sidecar for file in run.files], "drawn again as it was"
    assert len(GreyBrowser.drawn) == len(set(GreyBrowser.drawn)), "nor measured again"
