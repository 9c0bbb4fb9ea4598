"""A device that speaks is heard between two ticks, by a datagram or by a note; what a tick has heard counts no more."""

import asyncio
import socket
from collections.abc import Iterator

import pytest

from omote.server.supervision.early_tick import EarlyTicks

LONG = 30.0
"""Seconds for which nobody waits: a device has spoken before."""
pytestmark = pytest.mark.asyncio


@pytest.fixture
def heard() -> Iterator[socket.socket]:
    with socket.socket(type=socket.SOCK_DGRAM) as datagrams:
        datagrams.bind(("127.0.0.1", 0))
        datagrams.setblocking(False)
        yield datagrams


def send(to: socket.socket) -> None:
    with socket.socket(type=socket.SOCK_DGRAM) as out:
        out.sendto(b"/omote", to.getsockname())


async def test_silence_is_waited_for_no_longer_than_asked(heard: socket.socket) -> None:
    early = EarlyTicks()
    early.watch(heard)
    assert not await early.spoke_within(0.0)


async def test_a_datagram_ends_the_wait(heard: socket.socket) -> None:
    early = EarlyTicks()
    early.watch(heard)
    waiting = asyncio.create_task(early.spoke_within(LONG))
    await asyncio.sleep(0)
    send(heard)
    assert await waiting


async def test_a_datagram_that_came_before_is_seen(heard: socket.socket) -> None:
    early = EarlyTicks()
    early.watch(heard)
    send(heard)
    assert await early.spoke_within(LONG)


async def test_what_was_noted_ends_the_wait_until_it_is_forgotten() -> None:
    early = EarlyTicks()
    early.note()
    assert await early.spoke_within(LONG)
    early.forget()
    assert not await early.spoke_within(0.0)


async def test_between_waits_a_socket_that_nobody_reads_wakes_nobody(heard: socket.socket) -> None:
    early = EarlyTicks()
    early.watch(heard)
    send(heard)
    assert await early.spoke_within(LONG)
    assert not asyncio.get_running_loop().remove_reader(heard), "the loop looks at it no more"


async def test_a_wait_that_is_cancelled_lets_go_of_its_sockets(heard: socket.socket) -> None:
    early = EarlyTicks()
    early.watch(heard)
    waiting = asyncio.create_task(early.spoke_within(LONG))
    await asyncio.sleep(0)
    waiting.cancel()
    with pytest.raises(asyncio.CancelledError):
        await waiting
    assert not asyncio.get_running_loop().remove_reader(heard)
