"""Connections that say nothing, or half of something, take no place from a show; whole requests are answered."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

import aiohttp
import pytest
from aiohttp import web

from omote.server.http.connection_limit import LONGEST_HEAD, ConnectionLimit

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"
Limit = Callable[[Callable[[], asyncio.Protocol]], ConnectionLimit]


@asynccontextmanager
async def serving(limit: Limit) -> AsyncIterator[int]:
    """A server that echoes bodies and links, behind a limit; its port."""

    async def respond(request: web.Request) -> web.StreamResponse:
        if request.path == "/link":
            link = web.WebSocketResponse()
            await link.prepare(request)
            async for message in link:
                await link.send_str(message.data)
            return link
        return web.Response(body=await request.read())

    application = web.Application()
    application.router.add_route("*", "/{path:.*}", respond)
    runner = web.AppRunner(application, shutdown_timeout=1.0)
    await runner.setup()
    assert runner.server is not None
    listener = await asyncio.get_running_loop().create_server(limit(runner.server), HOST, 0)
    try:
        yield listener.sockets[0].getsockname()[1]
    finally:
        listener.close()
        await runner.cleanup()


async def test_requests_and_links_are_answered_however_their_first_bytes_come() -> None:
    async with serving(ConnectionLimit) as port, aiohttp.ClientSession(f"http://{HOST}:{port}") as http:
        body = b"x" * 3 * LONGEST_HEAD
        for _ in range(2):  # by one connection
            async with http.post("/", data=body) as answer:
                assert await answer.read() == body
        async with http.ws_connect("/link") as link:
            await link.send_str("hello")
            assert await link.receive_str() == "hello"
        reader, writer = await asyncio.open_connection(HOST, port)
        for byte in b"GET / HTTP/1.1\r\nHost: x\r\n\r\n":
            writer.write(bytes([byte]))
            await writer.drain()
            await asyncio.sleep(0)
        assert (await reader.readline()).startswith(b"HTTP/1.1 200")
        writer.close()


async def ends(reader: asyncio.StreamReader) -> bool:
    """Waits until a connection has ended without a word."""
    try:
        return await reader.read(1) == b""
    except ConnectionError:
        return True


@pytest.mark.parametrize("sent", [b"", b"GET / HTTP/1.1\r\nHost: x\r\n"])
async def test_what_sends_no_whole_head_is_ended(sent: bytes) -> None:
    async with serving(lambda serve: ConnectionLimit(serve, seconds=0.05)) as port:
        reader, writer = await asyncio.open_connection(HOST, port)
        writer.write(sent)
        assert await ends(reader)
        writer.close()


async def test_an_address_has_so_many_connections_and_more_once_some_have_ended() -> None:
    async with serving(lambda serve: ConnectionLimit(serve, most=4)) as port:
        idle = [await asyncio.open_connection(HOST, port) for _ in range(4)]
        refused, writer = await asyncio.open_connection(HOST, port)
        assert await ends(refused)
        for _, each in [*idle, (refused, writer)]:
            each.close()
            await each.wait_closed()
        answered = False
        while not answered:  # the server sees their ends soon
            async with aiohttp.ClientSession() as http:
                try:
                    async with http.get(f"http://{HOST}:{port}/") as answer:
                        answered = answer.status == 200
                except aiohttp.ClientError:
                    await asyncio.sleep(0.01)
