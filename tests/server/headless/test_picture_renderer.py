"""A picture grid rendered by a browser: the pages served on loopback, the page, and errors when it does not open."""

import base64
from dataclasses import replace
from pathlib import Path

import aiohttp
import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.formats.png import png_bytes, read_png
from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.server.headless.chromium import open_chromium
from omote.server.headless.devtools import BrowserError
from omote.server.headless.picture_renderer import (
    Renderer,
    draw_grid,
    open_picture_page,
    query,
    render,
    serve_pages,
)
from omote.server.http.cast_documents import CastDocuments
from omote.stage_data.picture_grid import PictureGrid
from omote.stage_data.picture_setting import Setting
from tests.server.false_browser import ANSWERS, false_browser
from tests.server.synthetic_server import MASK, PAGES, meshes

SHEET = PictureGrid([[{"faces": {"generic": 1.0}}]])


def test_a_setting_is_the_address_of_a_stage() -> None:
    assert query(Setting()) == "?quality=high"
    assert query(Setting(background="#00b140", quality="low")) == "?quality=low&background=%2300b140"
    assert query(Setting(transparent=True)) == "?quality=high&transparent=1"
    assert query(Setting(hair=False)) == "?quality=high&hair=0"
    assert query(Setting(background="#00b140", mask="oval")) == "?quality=high&transparent=1"


def documents(cast: Cast) -> CastDocuments:
    return CastDocuments(cast, meshes(cast), MASK)


@pytest.mark.asyncio
async def test_pages_are_served_on_loopback_until_the_end(cast: Cast) -> None:
    async with aiohttp.ClientSession() as http:
        async with serve_pages(documents(cast), PAGES) as address:
            assert address.startswith("http://127.0.0.1:")
            async with http.get(f"{address}/stage") as answer:
                assert answer.status == 200
            async with http.get(f"{address}/manifest") as answer:
                assert answer.status == 200
        with pytest.raises(aiohttp.ClientError):
            await http.get(f"{address}/stage")


@pytest.mark.asyncio
async def test_a_picture_page_returns_what_the_page_draws(tmp_path: Path) -> None:
    async with open_chromium(false_browser(tmp_path)) as tools:
        page = await open_picture_page(tools, "http://127.0.0.1:1", Setting(100, 200))
        assert (await page.draw(SHEET)).data == b"picture"
        assert await page.draw(SHEET, SHEET.poses[0][0]) == (b"picture", None)
        (tmp_path / "a.png").write_bytes(b"picture")
        assert await page.compose(SHEET, [[tmp_path / "a.png"]]) == b"picture"
        await page.close()


@pytest.mark.asyncio
async def test_a_page_that_does_not_open_says_why(tmp_path: Path) -> None:
    refusing = ANSWERS.replace(
        '{"result": {"value": True}}',
        '{"result": {}, "exceptionDetails": {"exception": {"value": "light=moon is no light."}}}',
    )
    async with open_chromium(false_browser(tmp_path, refusing)) as tools:
        with pytest.raises(BrowserError, match=r"^light=moon is no light\.$"):
            await open_picture_page(tools, "http://127.0.0.1:1", Setting())


@pytest.mark.asyncio
async def test_a_page_that_never_opens_is_not_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.headless.picture_renderer.OPENING", 0.01)
    silent = ANSWERS.replace('return {"result": {"value": True}}', "sys.stdin.read(); os.read(3, 1)")
    async with open_chromium(false_browser(tmp_path, silent)) as tools:
        with pytest.raises(BrowserError, match="did not open within"):
            await open_picture_page(tools, "http://127.0.0.1:1", Setting())


def test_one_call_draws_a_grid(cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path)))
    monkeypatch.setattr("omote.server.headless.picture_renderer.built_in_documents", lambda: documents(cast))
    monkeypatch.setattr("omote.server.headless.picture_renderer.read_pages", lambda: PAGES)
    assert draw_grid(SHEET, Setting()) == b"picture"


PICTURE = np.arange(48, dtype=np.uint8).reshape(3, 4, 4)


@pytest.fixture
def drawing(cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Cast:
    """The synthetic cast, and a browser that says it drew a small picture."""
    answer = base64.b64encode(png_bytes(PICTURE)).decode()
    monkeypatch.setenv("OMOTE_BROWSER", str(false_browser(tmp_path, ANSWERS.replace("cGljdHVyZQ==", answer))))
    for name, made in (("load_cast", cast), ("load_meshes", meshes(cast)), ("load_mask", MASK), ("read_pages", PAGES)):
        monkeypatch.setattr(f"omote.server.headless.picture_renderer.{name}", lambda made=made: made)
    return cast


def test_a_frame_becomes_an_array_and_a_file(drawing: Cast, tmp_path: Path) -> None:
    frame = Performer(drawing).advance(0.0)
    np.testing.assert_array_equal(render(drawing, frame), PICTURE)
    np.testing.assert_array_equal(render(drawing, frame, path=str(tmp_path / "a.png")), PICTURE)
    np.testing.assert_array_equal(read_png((tmp_path / "a.png").read_bytes()), PICTURE)


def test_a_renderer_draws_frame_after_frame_in_one_browser_until_it_is_closed(
    drawing: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frame = Performer(drawing).advance(0.0)
    with Renderer(drawing) as renderer:
        monkeypatch.setenv("OMOTE_BROWSER", "/no second browser")
        np.testing.assert_array_equal(renderer(frame), PICTURE)
        with pytest.raises(ValueError, match="no face 'nobody' in this cast"):
            renderer(replace(frame, faces={"nobody": 1.0}))
        with pytest.raises(ValueError, match=r"'a\.jpg' is no name of a PNG"):
            renderer(frame, path="a.jpg")
        np.testing.assert_array_equal(renderer(frame, path=tmp_path / "a.png"), PICTURE)
    np.testing.assert_array_equal(read_png((tmp_path / "a.png").read_bytes()), PICTURE)
    renderer.close()
    with pytest.raises(RuntimeError, match="closed; open another one"):
        renderer(frame)


@pytest.mark.asyncio
async def test_it_draws_where_an_event_loop_runs_already(drawing: Cast) -> None:
    """As in a notebook."""
    assert render(drawing, Performer(drawing).advance(0.0)).shape == (3, 4, 4)


def test_what_cannot_be_drawn_is_refused_before_a_browser_starts(
    drawing: Cast, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OMOTE_BROWSER", "/no browser")
    frame = Performer(drawing).advance(0.0)
    with pytest.raises(ValueError, match="no face 'nobody' in this cast"):
        render(drawing, replace(frame, faces={"nobody": 1.0}))
    with pytest.raises(ValueError, match=r"'a\.jpg' is no name of a PNG"):
        render(drawing, frame, path="a.jpg")
    with pytest.raises(ValueError, match="1x1 pixels cannot be drawn"):
        render(drawing, frame, size=(1, 1))
    with pytest.raises(ValueError, match=r"size is \(64,\); give width and height"):
        render(drawing, frame, size=(64,))  # type: ignore[arg-type]
    monkeypatch.setattr("omote.server.headless.picture_renderer.load_cast", load_cast)
    with pytest.raises(ValueError, match=r"cannot be drawn; give one on the head of omote\.load_cast"):
        render(drawing, frame)
    with pytest.raises(FileNotFoundError, match="OMOTE_BROWSER"):
        draw_grid(SHEET, Setting())
