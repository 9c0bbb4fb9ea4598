"""Pictures without a window: the stage's own look, the same bytes every time, and levels of quality that do not pop."""

from __future__ import annotations

import base64
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page, expect

from omote.stage_data.picture_finish import measure_luminance
from tests.browser.pictures import DECODE, picture
from tests.browser.waiting import draw_on_demand, wait_until
from tools.browser import SENTENCE, find_browser

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
SIZE = "320x240"
SMILING = {"faces": {"kaori": 0.5, "old": 0.5}, "expressions": {"smile": 1.0}}
# Each picture's distance from the first until the new level stands still, on black: what is clear has no colour.
SEEN = """async () => {
    const [canvas, seen] = [document.querySelector("canvas"), []];
    const look = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    let [first, still, ended] = [undefined, 0, undefined];
    const frame = () => {
        look.clearRect(0, 0, canvas.width, canvas.height);
        look.drawImage(canvas, 0, 0);
        const drawn = look.getImageData(0, 0, canvas.width, canvas.height).data.some((value) => value > 0);
        if (!drawn && seen.length === 0) return;
        if (!drawn) { // a picture that stands still is not drawn again: the display keeps it
            seen.push(seen.at(-1));
            still = seen.at(-1)[1] === "high" ? still + 1 : 0;
            return;
        }
        look.globalCompositeOperation = "destination-over"; // on black
        look.fillRect(0, 0, canvas.width, canvas.height);
        look.globalCompositeOperation = "source-over";
        const { data } = look.getImageData(0, 0, canvas.width, canvas.height);
        first ??= data;
        const distance = data.reduce((sum, value, at) => sum + Math.abs(value - first[at]), 0);
        const { level } = window.omoteStage.counters();
        still = level === "high" && distance === seen.at(-1)?.[0] ? still + 1 : 0;
        seen.push([distance, level]);
    };
    const request = window.requestAnimationFrame;
    // Looked at right after the stage has drawn: a frame later the display has taken the picture away.
    window.requestAnimationFrame = (draw) => request((now) => {
        draw(now);
        frame();
        if (still >= 8) ended();
    });
    const end = new Promise((done) => { ended = done; });
    while (seen.length === 0) await new Promise((next) => request(next)); // a still picture is seldom drawn
    void window.omoteStage.change("high");
    await end;
    window.requestAnimationFrame = request;
    return seen;
}"""


def omote(*words: str) -> subprocess.CompletedProcess[str]:
    """What the command says, with the browser of these tests."""
    browser = find_browser()
    if browser is None:
        pytest.fail(SENTENCE)
    command = [sys.executable, "-c", "from omote.cli import main; main()", *words]
    environment = {**os.environ, "OMOTE_BROWSER": str(browser), "OPENBLAS_NUM_THREADS": "1"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def from_python(path: Path, **pose: str) -> NDArray[np.uint8]:
    """The same picture by `omote.render`, in a program of its own, with the browser of these tests."""
    program = (
        "import numpy, omote; cast = omote.load_cast(); "
        f"picture = omote.render(cast, omote.parse_pose(cast, **{pose!r}), size=(320, 240), path={str(path)!r}); "
        f"numpy.save({str(path) + '.npy'!r}, picture)"
    )
    environment = {**os.environ, "OMOTE_BROWSER": str(find_browser()), "OPENBLAS_NUM_THREADS": "1"}
    subprocess.run([sys.executable, "-c", program], env=environment, check=True)
    array: NDArray[np.uint8] = np.load(f"{path}.npy")
    return array


def decoded(page: Page, path: Path) -> NDArray[np.int16]:
    """A picture file as an array (height, width, 4)."""
    width, height, text = page.evaluate(DECODE, base64.b64encode(path.read_bytes()).decode())
    return np.frombuffer(base64.b64decode(text), np.uint8).reshape(height, width, 4).astype(np.int16)


def opened(open_page: OpenPage, query: str = "", *, live: bool = False) -> Page:
    """A stage that draws; one that is not `live` draws what it is to hold from then on."""
    page = open_page(f"/stage{query}", width=320, height=240)
    wait_until(page, "window.omoteStage?.counters().drawn")
    if not live:
        draw_on_demand(page)
    return page


def test_a_picture_is_the_stage_and_the_same_every_time(open_page: OpenPage, tmp_path: Path) -> None:
    words = ("--face", "kaori=0.5", "--face", "old", "--expression", "smile", "--size", SIZE)
    paths = [tmp_path / "one.png", tmp_path / "two.png"]
    done = omote("render", *words, "-o", str(paths[0]))
    assert done.returncode == 0, done.stderr
    assert done.stderr.splitlines()[-1] == f"omote: {paths[0]}: 1 picture."
    again = from_python(paths[1], face="kaori=0.5+old", expression="smile")
    assert paths[0].read_bytes() == paths[1].read_bytes()
    assert np.array_equal(again, decoded(open_page("/"), paths[0]))
    stage = opened(open_page, "?quality=high")
    stage.evaluate("pose => window.omoteStage.hold(pose)", SMILING)
    assert np.abs(decoded(stage, paths[0]) - picture(stage)).max() <= 2
    assert sorted(tmp_path.glob("*.png")) == paths


def test_the_first_picture_of_a_page_is_drawn_as_all_others(open_page: OpenPage) -> None:
    page = open_page("/stage?quality=high&light=theatre", width=240, height=270)
    wait_until(page, "window.omoteStage?.counters().drawn > 0")
    sheet = {
        "poses": [[{"faces": {"old": 1}, "expressions": {"smile": 1}}]],
        **{"rows": [], "columns": [], "captions": [], "part": [0, 0, 1, 1], "paper": None, "kind": "image/png"},
    }
    first, second = (page.evaluate("(sheet) => window.omoteStage.sheet(sheet)", sheet) for _ in range(2))
    assert first == second, "nothing of a picture comes from the one before"


def test_a_grid_holds_the_pictures(open_page: OpenPage, tmp_path: Path) -> None:
    words = ("--size", SIZE, "--quality", "low")
    two = ("--faces", "old,kaori", "--no-labels")  # the hair of the second comes while the first is drawn
    assert omote("grid", *two, *words, "-o", str(tmp_path / "grid.png")).returncode == 0
    assert omote("render", "--face", "old", *words, "-o", str(tmp_path / "one.png")).returncode == 0
    page = open_page("/")
    sheet, one = (decoded(page, tmp_path / name) for name in ("grid.png", "one.png"))
    assert sheet.shape in {(481, 320, 4), (240, 641, 4)}
    assert np.array_equal(sheet[:240, :320], one)
    assert not np.array_equal(sheet[-240:, -320:], one)


def test_stimuli_are_bald_masked_and_matched_as_their_table_says(open_page: OpenPage, tmp_path: Path) -> None:
    (tmp_path / "design.csv").write_text(
        "name,face,size,quality,turn,transparent,hair,mask,luminance,contrast\n"
        "haired,kaori,160x180,low,,yes,yes,,,\nbald,kaori,160x180,low,,yes,no,,,\n"
        "one,kaori,160x180,low,,yes,no,oval,0.25,0.35\nother,man,160x180,low,25,yes,no,oval,0.25,0.35\n"
    )
    done = omote("stimuli", str(tmp_path / "design.csv"), "-o", str(tmp_path / "out"))
    assert done.returncode == 0, done.stderr
    page = open_page("/")
    names = ("haired", "bald", "one", "other")
    haired, bald, *masked = (decoded(page, tmp_path / "out" / f"{name}.png").astype(np.uint8) for name in names)
    assert (bald[..., 3] > 0).sum() < 0.9 * (haired[..., 3] > 0).sum()
    for picture_of_one in masked:
        assert measure_luminance(picture_of_one) == pytest.approx((0.25, 0.35), abs=1 / 255)
    oval = masked[0][..., 3] > 0
    assert not (oval & (bald[..., 3] == 0)).any(), "the oval lies on the face"
    assert oval.sum() < 0.8 * (bald[..., 3] > 0).sum()
    assert np.abs(oval.astype(int) - oval[:, ::-1]).mean() < 0.02, "and in the middle"


def test_a_picture_from_its_sidecar_and_from_two_browsers_is_the_same_and_open_around_the_head(
    open_page: OpenPage, tmp_path: Path
) -> None:
    words = ("--morph", "generic:dog:3", "--turns", "0,30", "--size", "160x120", "--quality", "low", "--transparent")
    assert omote("grid", *words, "-o", str(tmp_path / "a.png"), "--jobs", "2").returncode == 0
    done = omote("redraw", str(tmp_path / "a.png.json"))
    assert done.stderr.splitlines()[-1] == f"omote: {tmp_path / 'a.png'}: drawn again, the same to the last byte."
    cell = tmp_path / "a.pictures" / "neutral-30-generic-dog-001.png"
    assert omote("redraw", f"{cell}.json", "-o", str(tmp_path / "c.png")).returncode == 0
    assert cell.read_bytes() == (tmp_path / "c.png").read_bytes()
    page = open_page("/")
    sheet = decoded(page, tmp_path / "a.png")
    one = decoded(page, cell)
    assert (one[:4, [0, 1, -2, -1], 3] == 0).all()
    assert (one[40:80, 65:95, 3] == 255).all()
    assert any(np.array_equal(sheet[at : at + 120, -321:-161], one) for at in range(sheet.shape[0] - 119))


def test_what_is_refused_is_one_sentence_and_no_file(tmp_path: Path) -> None:
    done = omote("render", "--background", "red", "-o", str(tmp_path / "a.png"))
    assert (done.returncode, done.stderr.count("\n")) == (1, 1)
    assert "the background 'red' is no colour" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_another_level_fades_in(open_page: OpenPage) -> None:
    page = opened(open_page, "?quality=lowest&transparent", live=True)
    page.evaluate("pose => window.omoteStage.hold(pose)", SMILING)
    seen = page.evaluate(SEEN)
    distances = np.array([each[0] for each in seen], float)
    levels = [each[1] for each in seen]
    assert (levels[0], levels[-1]) == ("lowest", "high")
    way = distances / distances[-1]
    assert way[levels.index("high")] < 0.2, "it popped"
    assert np.diff(way).max() < 0.5
    assert ((way > 0.05) & (way < 0.95)).sum() >= 2


def test_the_operator_sees_the_level(open_page: OpenPage) -> None:
    # A level that a software renderer draws in time to say so, and not the one it would choose itself.
    opened(open_page, "?quality=low", live=True)
    level = open_page("/console", pictures=False).locator("omote-status .level")
    expect(level).to_contain_text("low")
    expect(level).not_to_contain_text("lowest")
