"""A connection to VTube Studio: what is too much is dropped, and a place that changes is followed."""

import asyncio

import pytest

from omote.inputs.trackers.vtube_studio.api_session import ApiSession
from omote.server.devices.vtube_studio import api_link
from omote.server.devices.vtube_studio.api_link import MOST_UNSENT, ApiLink
from tests.server.devices.vtube_studio.false_vtube_studio import open_false_vtube_studio

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"


async def test_a_flood_of_messages_takes_no_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    link = ApiLink(lambda: (HOST, 9), lambda send, place: ApiSession(send))
    for _ in range(1000):
        link.send(b"{}")
    assert len(link._unsent) == MOST_UNSENT
    await link.close()


async def test_a_place_that_changes_is_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(api_link, "RETRY_SECONDS", 0.001)
    places = [(HOST, 9)]
    link = ApiLink(lambda: places[0], lambda send, place: ApiSession(send))
    while not link.fault:
        await asyncio.sleep(0.001)
    async with open_false_vtube_studio() as (studio, server):
        assert server.port is not None
        places[0] = (HOST, server.port)
        while link.session is None:
            await asyncio.sleep(0.001)
        while not link.waiting:
            await asyncio.sleep(0.001)
        assert (link.place, link.fault) == ((HOST, server.port), "")
        assert studio.heard == ["AuthenticationTokenRequest"]
        await link.close()
