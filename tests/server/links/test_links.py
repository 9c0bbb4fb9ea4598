"""Whoever is slow slows nobody."""

import asyncio
import socket
from collections.abc import Coroutine, Generator

import aiohttp
import pytest

from omote.server.links.links import (
    ANSWER_LIMIT,
    HEARD_BURST,
    STALL_LIMIT,
    UNSENT_LIMIT,
    Link,
    Links,
    LinkSocket,
    finish_now,
)
from omote.show.access.people_list import ANYBODY
from omote.show.messages import LINK_PATH
from omote.show.objects.faders import SetChannel
from omote.show.rate_limit import TokenBucket
from omote.show.wire import encode
from tests.server.conftest import ShowHarness, send_and_wait, state

HANDSHAKE = (
    f"GET {LINK_PATH} HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"
)


class Transport:
    """A transport with as many unsent bytes as a test says."""

    def __init__(self) -> None:
        self.unsent = 0
        self.aborted = False
        self.closing = False

    def get_write_buffer_size(self) -> int:
        return self.unsent

    def is_closing(self) -> bool:
        return self.closing

    def get_extra_info(self, name: str) -> None:
        assert name == "socket"

    def abort(self) -> None:
        self.aborted = True


class Socket:
    """A websocket that keeps what it was given."""

    def __init__(self) -> None:
        self.sent: list[bytes] = []
        self.closed = False
        self.broken = False

    async def send_bytes(self, data: bytes) -> None:
        if self.broken:
            raise ConnectionResetError
        self.sent.append(data)


def opened(links: Links) -> tuple[Socket, Transport]:
    """A link of fakes."""
    ws = Socket()
    transport = Transport()
    links.open(ws, transport)  # type: ignore[arg-type]
    return ws, transport


def test_a_socket_whose_browser_went_before_it_was_let_in_closes_without_a_word() -> None:
    async def close() -> bool:
        return await LinkSocket(heartbeat=1.0).close()

    assert asyncio.run(close()) is False


def test_who_is_behind_gets_the_newest_state_and_nothing_in_between() -> None:
    links = Links()
    (fast, _) = opened(links)
    (slow, transport) = opened(links)
    for number in range(10):
        transport.unsent = UNSENT_LIMIT + 1 if 2 <= number < 8 else 0
        links.broadcast(bytes([number]), now=number / 60)
    assert [data[0] for data in fast.sent] == list(range(10))
    assert [data[0] for data in slow.sent] == [0, 1, 8, 9]
    assert [link.skipped for link in links] == [0, 6]


def test_a_link_that_has_one_large_state_unsent_is_not_behind() -> None:
    links = Links()
    state = bytes(4 * UNSENT_LIMIT)
    _, transport = opened(links)
    for unsent, skipped in ((len(state), 0), (len(state) + 1, 1)):
        transport.unsent = unsent
        links.broadcast(state, now=0.0)
        assert [link.skipped for link in links] == [skipped]


def test_who_is_behind_for_too_long_is_cut() -> None:
    links = Links()
    (_, healthy), (_, stalled) = opened(links), opened(links)
    stalled.unsent = UNSENT_LIMIT + 1
    links.broadcast(b"", now=100.0)
    links.broadcast(b"", now=100.0 + STALL_LIMIT)
    assert len(links) == 2
    links.broadcast(b"", now=100.1 + STALL_LIMIT)
    assert len(links) == 1
    assert (healthy.aborted, stalled.aborted) == (False, True)


def test_who_catches_up_in_time_is_not_cut() -> None:
    links = Links()
    _, transport = opened(links)
    for now in range(100):
        transport.unsent = UNSENT_LIMIT + 1 if now % 9 else 0
        links.broadcast(b"", now=float(now))
    assert not transport.aborted


def test_a_broken_or_closing_link_disturbs_nobody() -> None:
    links = Links()
    (broken, _), (_, closing), (good, _) = opened(links), opened(links), opened(links)
    broken.broken = closing.closing = True
    links.broadcast(b"state", now=0.0)
    assert good.sent == [b"state"]


def test_answers_to_one_who_does_not_read_are_dropped() -> None:
    links = Links()
    ws, transport = opened(links)
    links.answer("1", b"heard")
    transport.unsent = ANSWER_LIMIT + 1
    links.answer("1", b"too many")
    links.answer("nobody", b"gone")
    assert ws.sent == [b"heard"]


def test_names_are_never_used_twice() -> None:
    links = Links()
    names = set()
    for _ in range(5):
        opened(links)
        (link,) = links
        names.add(link.who)
        links.close(link)
        links.close(link)
    assert len(names) == 5


def test_a_send_that_would_wait_is_left_to_itself() -> None:
    closed = []

    class Waiting(Coroutine[object, None, None]):
        def send(self, value: None) -> object:
            return value

        def throw(self, *error: object) -> object:
            raise AssertionError(error)

        def close(self) -> None:
            closed.append(True)

        def __await__(self) -> Generator[object, None, None]:
            raise NotImplementedError

    finish_now(Waiting())
    assert closed == [True]


@pytest.mark.asyncio
async def test_a_browser_that_stops_reading_costs_nobody_a_state(show_harness: ShowHarness) -> None:
    healthy = await show_harness.link("stage")
    with socket.create_connection((show_harness.client.host, show_harness.client.port or 0)) as stalled:
        stalled.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        stalled.sendall(HANDSHAKE.encode())
        while len(show_harness.show.links) < 2:
            await send_and_wait(healthy)
        number = 0
        while len(show_harness.show.links) == 2:
            show_harness.tick()
            number += 1
            assert (await state(healthy)).number == number
        assert show_harness.clock.now > STALL_LIMIT
    for _ in range(60):
        show_harness.tick()
        number += 1
        assert (await state(healthy)).number == number


@pytest.mark.asyncio
async def test_a_flood_is_heard_in_order_and_in_time(show_harness: ShowHarness) -> None:
    flooding = await show_harness.link()
    calm = await show_harness.link()
    count = int(HEARD_BURST) + 200
    for number in range(count):
        await flooding.send_bytes(encode(SetChannel("one", "jawOpen", number / count)))
    await send_and_wait(calm, SetChannel("one", "smile", 1.0))
    while show_harness.show.session.commands < HEARD_BURST:
        await asyncio.sleep(0.0)
    assert (
        show_harness.show.session.commands <= HEARD_BURST + 1
    )  # the clock stands still, so no more than the burst was heard
    show_harness.clock.now += 10.0
    await send_and_wait(flooding)
    show_harness.tick()
    assert (await state(calm)).characters["one"].channels == {"jawOpen": (count - 1) / count, "smile": 1.0}


@pytest.mark.asyncio
async def test_all_are_told_when_the_server_goes(show_harness: ShowHarness) -> None:
    links = [await show_harness.link(), await show_harness.link("stage")]
    hanging = asyncio.create_task(show_harness.show.links.close_all())
    for link in links:
        message = await link.receive()
        while message.type is aiohttp.WSMsgType.BINARY:  # what it was welcomed with
            message = await link.receive()
        assert message.data == 1001  # going away
    await hanging


@pytest.mark.asyncio
async def test_what_many_links_send_at_one_time_is_heard_between_ticks() -> None:
    """Sixty links with a burst of sixty messages each held the ticks for .4 s: no message was waited for."""
    heard = list[str]()

    async def listen(who: str) -> None:
        link = Link(who, None, Transport(), ANYBODY, TokenBucket(60.0, 60.0))  # type: ignore[arg-type]
        for _ in range(60):
            await link.wait_turn(lambda: 0.0)
            heard.append(who)

    listening = [asyncio.create_task(listen(f"editor {number}")) for number in range(60)]
    while not heard:
        await asyncio.sleep(0.0)
    most = 0
    while len(heard) < 60 * 60:
        before = len(heard)
        await asyncio.sleep(0.0)  # as a tick waits for its turn
        most = max(most, len(heard) - before)
    assert most <= len(listening)
    await asyncio.gather(*listening)
