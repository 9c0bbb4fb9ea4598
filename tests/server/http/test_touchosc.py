"""The layout for TouchOSC over HTTP."""

import asyncio
import zlib

import pytest
from aiohttp.hdrs import CONTENT_DISPOSITION

from omote.server.http.touchosc import TOUCHOSC_PATH
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio


async def read_layout(harness: ShowHarness) -> bytes:
    """The file, as a tablet downloads it."""
    async with harness.client.get(TOUCHOSC_PATH) as response:
        assert response.status == 200
        assert response.headers[CONTENT_DISPOSITION] == 'attachment; filename="omote.tosc"'
        return await response.read()


async def test_the_layout_plays_the_characters_that_there_are(show_harness: ShowHarness) -> None:
    first, *others = await asyncio.gather(*(read_layout(show_harness) for _ in range(8)))
    assert zlib.decompress(first).count(b"/omote/one/gaze]") == 1
    assert {*others, await read_layout(show_harness)} == {first}, "it is built once: its ids are random"
    show_harness.show.session.scene.add("two")
    assert b"/omote/two/gaze]" in zlib.decompress(await read_layout(show_harness))
