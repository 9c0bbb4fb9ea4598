"""What the tests of the server share: a show behind a real socket, on a clock of the test."""

from collections.abc import AsyncIterator
from dataclasses import dataclass, field

import aiohttp
import pytest_asyncio
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer

from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.server.app import ShowServer
from omote.server.library import Library
from omote.server.security import own_names
from omote.show import messages as wire
from omote.show.session import ShowSession
from omote.show.wire import decode_answer, encode
from tests.server.synthetic_server import MASK, PAGES, meshes


@dataclass
class Clock:
    """A clock that moves when told."""

    now: float = 0.0

    def __call__(self) -> float:
        return self.now


@dataclass
class House:
    """A show server, a client of its web pages, and the clock both live by."""

    show: ShowServer
    client: "TestClient[web.Request, web.Application]"
    clock: Clock = field(default_factory=Clock)

    async def link(self, role: wire.Role = "console") -> aiohttp.ClientWebSocketResponse:
        """A link that has said hello and was welcomed."""
        socket = await self.client.ws_connect(wire.LINK_PATH)
        await socket.send_bytes(encode(wire.Hello(role, wire.PROTOCOL_VERSION)))
        assert isinstance(await answer(socket), wire.Welcome)
        return socket

    def tick(self) -> None:
        """The next sixtieth of a second."""
        self.clock.now += 1.0 / wire.STATE_RATE
        self.show.tick()


async def answer(socket: aiohttp.ClientWebSocketResponse) -> wire.FromServer:
    """The next message of the server."""
    return decode_answer(await socket.receive_bytes(timeout=10.0))


async def state(socket: aiohttp.ClientWebSocketResponse) -> wire.State:
    """The next message of the server, which is a state."""
    message = await answer(socket)
    assert isinstance(message, wire.State)
    return message


async def obeyed(socket: aiohttp.ClientWebSocketResponse, *messages: wire.FromClient) -> None:
    """Sends messages and waits until the server has heard them all."""
    for message in (*messages, wire.Ping(1.0)):
        await socket.send_bytes(encode(message))
    assert isinstance(await answer(socket), wire.Pong)


@pytest_asyncio.fixture
async def house(cast: Cast) -> AsyncIterator[House]:
    """The synthetic cast behind a real socket; ticks come from the test."""
    clock = Clock()
    session = ShowSession(cast, Performer(cast), epoch=7)
    library = Library(cast, meshes(cast), MASK)
    show = ShowServer(session, library, PAGES, clock=clock)
    async with TestClient(TestServer(show.application(own_names()))) as client:
        yield House(show, client, clock)
    library.close()
