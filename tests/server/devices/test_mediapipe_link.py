"""Results of MediaPipe over a real WebSocket: on air, counted, and a flood is bounded."""

import asyncio
from collections.abc import AsyncIterator

import pytest
import pytest_asyncio
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer

from omote.server.access.access_guard import VISITOR
from omote.server.devices.mediapipe_link import MOST_WAITING, MediapipeLink
from omote.server.devices.rejection_log import RejectionLog
from omote.show.access.people_list import ANYBODY
from tests.inputs.trackers.test_mediapipe_frame import result
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio


@pytest.fixture
def said() -> list[str]:
    """What the terminal was told."""
    return []


@pytest_asyncio.fixture
async def link(show_harness: ShowHarness, said: list[str]) -> AsyncIterator[MediapipeLink]:
    made = MediapipeLink(lambda: show_harness.show.session, RejectionLog(said.append))
    made.on = True
    show_harness.show.sources.append(made)
    yield made
    await made.close()


@pytest_asyncio.fixture
async def sender(link: MediapipeLink) -> AsyncIterator[TestClient[web.Request, web.Application]]:
    async def respond(request: web.Request) -> web.StreamResponse:
        request[VISITOR] = ANYBODY
        return await link.respond(request)

    application = web.Application()
    application.router.add_get("/mediapipe", respond)
    async with TestClient(TestServer(application)) as client:
        yield client


async def tick_until_heard(harness: ShowHarness, link: MediapipeLink, count: int) -> None:
    """Ticks until so many results have been heard."""
    while link.trackers.heard < count:
        harness.tick()
        await asyncio.sleep(0.001)


async def test_results_play_as_text_and_as_bytes_and_damage_is_told(
    show_harness: ShowHarness, link: MediapipeLink, sender: TestClient[web.Request, web.Application], said: list[str]
) -> None:
    async with sender.ws_connect("/mediapipe") as socket:
        await socket.send_str(result().decode())
        await socket.send_bytes(result())
        await socket.send_str("hello")
        await tick_until_heard(show_harness, link, 3)
        assert (await socket.receive_bytes()).startswith(b"this is no result of MediaPipe")
    assert show_harness.show.session.tick(9.0).characters["one"].layers["tracker"].source == "MediaPipe 127.0.0.1"
    (counts,) = [probe() for probe in link.probes]
    assert (counts.heard, counts.rejected, counts.values) == (3, 1, {"jawOpen": 0.5})
    assert said[0].startswith("MediaPipe from 127.0.0.1: this is no result of MediaPipe")


async def test_what_comes_between_two_ticks_is_bounded(
    link: MediapipeLink, sender: TestClient[web.Request, web.Application]
) -> None:
    async with sender.ws_connect("/mediapipe") as socket:
        for _ in range(2 * MOST_WAITING):
            await socket.send_bytes(b"{}")
    while len(link._waiting) < MOST_WAITING:
        await asyncio.sleep(0.001)
    assert len(link._waiting) == MOST_WAITING
