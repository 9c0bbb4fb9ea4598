"""A microphone over a real WebSocket: it plays, is told what is heard, and ends with its token."""

import asyncio
from collections.abc import AsyncIterator

import msgspec
import pytest
import pytest_asyncio
from aiohttp import WSMsgType, web
from aiohttp.test_utils import TestClient, TestServer

from omote.inputs.microphone.microphone_messages import LONGEST_MESSAGE, Begin, Rejected, Sound, ToMicrophone, Voice
from omote.server.access.access_guard import VISITOR
from omote.server.microphone.microphone_link import MicrophoneLink
from omote.show.access.people_list import ANYBODY
from tests.inputs.microphone.voices import pcm, vowel
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
Client = TestClient[web.Request, web.Application]
_DECODER = msgspec.msgpack.Decoder(ToMicrophone)


@pytest_asyncio.fixture
async def link(show_harness: ShowHarness) -> AsyncIterator[MicrophoneLink]:
    made = MicrophoneLink(lambda: show_harness.show.session, show_harness.clock)
    show_harness.show.sources.append(made)
    yield made
    await made.close()


@pytest_asyncio.fixture
async def sender(link: MicrophoneLink) -> AsyncIterator[Client]:
    async def respond(request: web.Request) -> web.StreamResponse:
        request[VISITOR] = ANYBODY
        return await link.respond(request)

    application = web.Application()
    application.router.add_get("/voice", respond)
    async with TestClient(TestServer(application)) as client:
        yield client


async def tick_until(harness: ShowHarness, link: MicrophoneLink, count: int) -> None:
    """Ticks until so many microphones are open."""
    while len(link.microphones) != count:
        harness.tick()
        await asyncio.sleep(0.001)


async def test_a_microphone_plays_and_is_told(show_harness: ShowHarness, link: MicrophoneLink, sender: Client) -> None:
    async with sender.ws_connect("/voice") as socket:
        await socket.send_bytes(msgspec.msgpack.encode(Begin("Anna")))
        await socket.send_bytes(msgspec.msgpack.encode(Sound(pcm(vowel(0.2)))))
        await tick_until(show_harness, link, 1)
        for _ in range(8):
            show_harness.tick()
        told = _DECODER.decode(await socket.receive_bytes())
        assert isinstance(told, Voice)
        assert [source.name for source in show_harness.show.session.sources.states({})] == ["Anna"]
        await socket.send_bytes(b"hello")
        while not isinstance(told, Rejected):
            show_harness.tick()
            told = _DECODER.decode(await socket.receive_bytes())
        assert "nothing that a microphone says" in told.reason
    await tick_until(show_harness, link, 0)


async def test_a_message_that_is_too_long_ends_the_link(sender: Client) -> None:
    async with sender.ws_connect("/voice") as socket:
        await socket.send_bytes(b"x" * (LONGEST_MESSAGE + 1))
        told = _DECODER.decode(await socket.receive_bytes())
        assert isinstance(told, Rejected)
        assert (await socket.receive()).type is WSMsgType.CLOSE


async def test_what_is_rejected_of_a_page_that_has_gone_stops_no_tick(
    show_harness: ShowHarness, link: MicrophoneLink, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(link.microphones, "play", lambda now: [("microphone 7", Rejected("its mouth comes to rest"))])
    link.hear(show_harness.clock())
