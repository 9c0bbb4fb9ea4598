"""A page at one machine plays a show at another: both ways, and in words where that cannot be."""

import asyncio
import socket
from collections.abc import AsyncIterator

import msgspec
import pytest
import pytest_asyncio
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer

from omote.inputs.performers import camera_messages as wire
from omote.server.camera.show_relay import ShowRelay, ShowTarget
from omote.show.access.access_documents import REVOKED_CODE
from omote.show.wire import encode
from tests.inputs.performers.landmarks import packet

pytestmark = pytest.mark.asyncio


class FarShow:
    """A show that keeps what it hears. status: what it answers instead of a link; close_code: how it ends."""

    def __init__(self) -> None:
        self.heard: list[bytes] = []
        self.tokens: list[str] = []
        self.status = 101
        self.close_code = 0

    async def respond(self, request: web.Request) -> web.StreamResponse:
        self.tokens.append(request.headers.get("Authorization", ""))
        if self.status != 101:
            return web.Response(status=self.status)
        link = web.WebSocketResponse()
        await link.prepare(request)
        if self.close_code:
            await link.close(code=self.close_code)
            return link
        async for message in link:
            self.heard.append(message.data)
            await link.send_bytes(encode(wire.CameraRefused(f"heard {len(self.heard)}")))
        return link


@pytest_asyncio.fixture
async def far() -> AsyncIterator[tuple[FarShow, str]]:
    show = FarShow()
    application = web.Application()
    application.router.add_get(wire.CAMERA_PATH, show.respond)
    async with TestServer(application) as server:
        yield show, str(server.make_url("")).rstrip("/")


def near(target: ShowTarget) -> TestClient[web.Request, web.Application]:
    """The page's side."""
    application = web.Application()
    application.router.add_get(wire.CAMERA_PATH, ShowRelay(target).respond)
    return TestClient(TestServer(application))


async def refusal(target: ShowTarget) -> str:
    """What the page is told, before the link ends."""
    async with near(target) as client, client.ws_connect(wire.CAMERA_PATH) as page:
        refused = msgspec.msgpack.decode(await page.receive_bytes(timeout=60.0), type=wire.CameraRefused)
        await page.receive(timeout=60.0)
        assert page.closed
    return refused.reason


async def test_messages_pass_both_ways_with_the_token(far: tuple[FarShow, str]) -> None:
    show, address = far
    async with near(ShowTarget(address, "secret")) as client, client.ws_connect(wire.CAMERA_PATH) as page:
        for sent in (encode(wire.Perform(1, "Ada")), packet(1.0)):
            await page.send_bytes(sent)
            answered = msgspec.msgpack.decode(await page.receive_bytes(timeout=60.0), type=wire.ToCamera)
            assert answered == wire.CameraRefused(f"heard {len(show.heard)}")
            assert show.heard[-1] == sent
    assert show.tokens == ["Bearer secret"]
    await ShowRelay(ShowTarget(address)).reach()


@pytest.mark.parametrize(
    ("status", "said"),
    [(401, "--token"), (403, "role operate"), (404, "older Omote"), (429, "wait"), (500, "status 500")],
)
async def test_a_show_that_says_no_is_explained(far: tuple[FarShow, str], status: int, said: str) -> None:
    show, address = far
    show.status = status
    reason = await refusal(ShowTarget(address))
    assert said in reason
    assert address in reason
    with pytest.raises(ConnectionError, match=said):
        await ShowRelay(ShowTarget(address)).reach()


async def test_a_show_that_is_not_there_is_explained() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        address = f"http://127.0.0.1:{taken.getsockname()[1]}"
        reason = await refusal(ShowTarget(address))
        assert reason.endswith("nothing listens there: look at the address, and start the show with --host 0.0.0.0")


async def test_a_host_that_nobody_knows_is_explained(monkeypatch: pytest.MonkeyPatch) -> None:
    async def know_none(*_: object, **__: object) -> list[object]:
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    monkeypatch.setattr("aiohttp.resolver.ThreadedResolver.resolve", know_none)
    monkeypatch.setattr("aiohttp.resolver.AsyncResolver.resolve", know_none)
    reason = await refusal(ShowTarget("http://nohost.invalid:8090"))
    assert reason.endswith("no address of nohost.invalid is known: type the one that the show prints")


async def test_a_show_that_never_answers_is_explained(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omote.server.camera.show_relay.CONNECT_SECONDS", 0.05)
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        assert "firewalls" in await refusal(ShowTarget(f"http://127.0.0.1:{silent.getsockname()[1]}"))


async def test_a_token_that_ends_ends_the_page_s_link_the_same_way(far: tuple[FarShow, str]) -> None:
    show, address = far
    show.close_code = REVOKED_CODE
    async with near(ShowTarget(address)) as client, client.ws_connect(wire.CAMERA_PATH) as page:
        await page.receive(timeout=60.0)
        assert page.close_code == REVOKED_CODE


async def test_the_end_of_the_page_is_the_end_of_the_link(far: tuple[FarShow, str]) -> None:
    _, address = far
    async with near(ShowTarget(address)) as client:
        async with client.ws_connect(wire.CAMERA_PATH) as page:
            await page.send_bytes(packet(1.0))
            await page.receive_bytes(timeout=60.0)
        await asyncio.sleep(0)
