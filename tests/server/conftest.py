"""What the tests of the server share: a show behind a real socket, on a clock of the test."""

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import aiohttp
import pytest_asyncio
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer

from omote.edit.protocol import messages as editing
from omote.edit.protocol import wire as edit_wire
from omote.model.cast import Cast
from omote.server.access.security import own_names
from omote.server.http.app import ShowServer
from omote.server.http.cast_documents import CastDocuments
from omote.server.persistence.restore import journal_entry, restore
from omote.server.process.process_messages import Order
from omote.server.supervision.show_process import open_reopenable_work
from omote.show.declaration import ClientMessage, Message, ServerMessage
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION, STATE_RATE
from omote.show.objects.faders import Hands
from omote.show.objects.hand.pads import PadList
from omote.show.objects.link import Bus, Hello, Ping, Pong, Role, Welcome
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.wire import decode_answer, encode
from omote.showfile.show_file import open_show
from tests.server.synthetic_server import MASK, PAGES, meshes


@dataclass
class Clock:
    """A clock that moves when told."""

    now: float = 0.0

    def __call__(self) -> float:
        return self.now


@dataclass
class ShowHarness:
    """A show server, a client of its web pages, and the clock both live by."""

    show: ShowServer
    client: "TestClient[web.Request, web.Application]"
    clock: Clock = field(default_factory=Clock)

    async def link(self, role: Role = "console", *, bus: Bus = "air") -> aiohttp.ClientWebSocketResponse:
        """A link that has said hello and was welcomed."""
        socket = await self.client.ws_connect(LINK_PATH)
        await socket.send_bytes(encode(Hello(role, PROTOCOL_VERSION, bus=bus)))
        assert isinstance(await answer(socket), Welcome)
        return socket

    def tick(self) -> None:
        """The next sixtieth of a second."""
        self.clock.now += 1.0 / STATE_RATE
        self.show.tick()


async def answer(socket: aiohttp.ClientWebSocketResponse) -> ServerMessage:
    """The next message of the server but the list of pads, which every show has and tells all consoles."""
    message = decode_answer(await socket.receive_bytes(timeout=60.0))
    return await answer(socket) if isinstance(message, PadList) else message


async def state(socket: aiohttp.ClientWebSocketResponse) -> State:
    """The next message of the server but of others' hands, which is a state."""
    message = await answer(socket)
    while isinstance(message, Hands):
        message = await answer(socket)
    assert isinstance(message, State)
    return message


async def send_and_wait(socket: aiohttp.ClientWebSocketResponse, *messages: ClientMessage) -> None:
    """Sends messages and waits until the server has heard them all."""
    for message in (*messages, Ping(1.0)):
        await socket.send_bytes(encode(message))
    assert isinstance(await answer(socket), Pong)


@dataclass
class Editor:
    """An editor's page without a screen: numbers its requests and reads their answers."""

    socket: aiohttp.ClientWebSocketResponse
    greeted: editing.Greeted | None = None
    request: int = 0
    heard: list[editing.ToEditor] = field(default_factory=list)

    async def greet(self, editor: str = "e1", name: str = "Ada") -> editing.Greeted:
        """The answer to greet."""
        await self.socket.send_bytes(encode(editing.Greet(editor, name, editing.EDITING_VERSION)))
        answered = await self.next(editing.Greeted)
        assert isinstance(answered, editing.Greeted)
        return answered

    async def ask(self, make: Callable[..., Message], *arguments: object) -> Any:
        """The answer to a request."""
        self.request += 1
        await self.socket.send_bytes(encode(make(self.request, *arguments)))
        return await self.next(object, request=self.request)

    async def next(self, kind: type, request: int | None = None) -> editing.ToEditor:
        """The next message of a kind, and to a request; those before it are kept in `heard`."""
        while True:
            message = edit_wire.decode_answer(await self.socket.receive_bytes(timeout=60.0))
            if isinstance(message, kind) and request in (None, getattr(message, "request", None)):
                return message
            self.heard.append(message)


@dataclass
class EditHarness(ShowHarness):
    """A house with a show file that editors may come to."""

    said: list[str] = field(default_factory=list)
    path: Path = Path()

    async def editor(self, editor: str = "e1", name: str = "Ada") -> Editor:
        """An editor who has greeted."""
        page = Editor(await self.client.ws_connect(editing.EDITING_PATH, max_msg_size=0))
        page.greeted = await page.greet(editor, name)
        return page


@asynccontextmanager
async def open_edit_harness(cast: Cast, path: Path | None) -> AsyncIterator[EditHarness]:
    """A show with or without a file, put together as `show_process.play` does; ticks come from the test."""
    clock = Clock()
    said = list[str]()
    file = None if path is None else open_show(path)
    documents = CastDocuments(cast, meshes(cast), MASK)
    authored_work, reopen = open_reopenable_work(file, documents, said.append)
    session = restore(documents.playing, file, Order(epoch=1, neutral=False), said.append)
    show = ShowServer(session, documents, PAGES, clock=clock)
    show.enable_editing(authored_work, reopen, said.append)
    async with TestClient(TestServer(show.application(own_names()))) as client:
        yield EditHarness(show, client, clock, said, path or Path())
        await show.close_all()
    documents.close()
    if authored_work:
        authored_work.committer.close()
    if file:
        file.write_journal(journal_entry(show.session))
        file.close()


@pytest_asyncio.fixture
async def edit_harness(cast: Cast, tmp_path: Path) -> AsyncIterator[EditHarness]:
    """A house that editors may come to."""
    async with open_edit_harness(cast, tmp_path / "show.omote") as opened:
        yield opened


@pytest_asyncio.fixture
async def show_harness(cast: Cast) -> AsyncIterator[ShowHarness]:
    """The synthetic cast behind a real socket; ticks come from the test."""
    clock = Clock()
    session = ShowSession(cast, epoch=7)
    documents = CastDocuments(cast, meshes(cast), MASK)
    show = ShowServer(session, documents, PAGES, clock=clock)
    async with TestClient(TestServer(show.application(own_names()))) as client:
        yield ShowHarness(show, client, clock)
    documents.close()
