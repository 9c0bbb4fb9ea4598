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
    first, same = await asyncio.gather(read_layout(show_harness), read_layout(show_harness))
    assert zlib.decompress(first).count(b"/omote/one/gaze]") == zlib.decompress(same).count(b"/omote/one/gaze]") == 1
    assert await read_layout(show_harness) in (first, same)
    show_harness.show.session.scene.add("two")
    assert b"/omote/two/gaze]" in zlib.decompress(await read_layout(show_harness))
