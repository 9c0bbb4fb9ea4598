"""A picture grid rendered by a browser: the pages served on loopback, the page, and errors when it does not open."""

from pathlib import Path

import aiohttp
import pytest

from omote.model.cast import Cast
from omote.server.headless.chromium import open_chromium
from omote.server.headless.devtools import BrowserError
from omote.server.headless.picture_renderer import draw_grid, open_picture_page, query, serve_pages
from omote.server.http.cast_documents import CastDocuments
from omote.stage_data.picture_grid import PictureGrid, Setting
from tests.server.false_browser import ANSWERS, false_browser
from tests.server.synthetic_server import MASK, PAGES, meshes

SHEET = PictureGrid([[{"faces": {"generic": 1.0}}]])


def test_a_setting_is_the_address_of_a_stage() -> None:
    assert query(Setting()) == "?quality=high"
    assert query(Setting(background="#00b140", quality="low")) == "?quality=low&background=%2300b140"
    assert query(Setting(transparent=True)) == "?quality=high&transparent=1"


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
        assert await page.draw(SHEET) == b"picture"
        assert await page.draw(SHEET, SHEET.poses[0][0]) == b"picture"
        (tmp_path / "a.png").write_bytes(b"picture")
        assert await page.compose(SHEET, [[tmp_path / "a.png"]]) == b"picture"
        await page.close()


@pytest.mark.asyncio
async def test_a_page_that_does_not_open_says_why(tmp_path: Path) -> None:
    refusing = ANSWERS.replace(
        '{"result": {"value": True}}',
        '{"result": {}, "exceptionDetails": {"exception": {"value": "background=red is no colour."}}}',
    )
    async with open_chromium(false_browser(tmp_path, refusing)) as tools:
        with pytest.raises(BrowserError, match=r"^background=red is no colour\.$"):
            await open_picture_page(tools, "http://127.0.0.1:1", Setting(background="red"))


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
