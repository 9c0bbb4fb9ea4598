"""Trackers over real sockets on the loopback network: on air, in health, and a phone that is asked."""

import asyncio
import socket
from collections.abc import AsyncIterator

import pytest
import pytest_asyncio

from omote.inputs.allowed_senders import AllowedSenders
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.trackers import tracker_listener
from omote.server.devices.trackers.tracker_listener import TrackerListener, TrackerSocket
from tests.inputs.trackers.packets import live_link_face
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
HOST = "127.0.0.1"
FACE = live_link_face([0.5 if index == 17 else 0.0 for index in range(61)])


def bound() -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.bind((HOST, 0))
    return made


@pytest.fixture
def said() -> list[str]:
    """What the terminal was told."""
    return []


@pytest_asyncio.fixture
async def listener(show_harness: ShowHarness, said: list[str]) -> AsyncIterator[TrackerListener]:
    sockets = [
        TrackerSocket(TRACKER_PROTOCOLS["livelink"], bound()),
        TrackerSocket(TRACKER_PROTOCOLS["ifacialmocap"], bound(), HOST),
    ]
    made = TrackerListener(sockets, lambda: show_harness.show.session, RejectionLog(said.append))
    show_harness.show.sources.append(made)
    yield made
    await made.close()


def send(listener: TrackerListener, data: bytes, name: str = "Live Link Face") -> None:
    (each,) = [each for each in listener._heard if each.trackers.protocol.title == name]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
        phone.sendto(data, each.tracker.datagrams.getsockname())


async def tick_until_heard(harness: ShowHarness, listener: TrackerListener, count: int) -> None:
    """Ticks until so many packets have been heard."""
    while sum(each.heard for each in listener.inputs) < count:
        harness.tick()
        await asyncio.sleep(0.001)


async def test_a_phone_plays_and_its_health_is_told(show_harness: ShowHarness, listener: TrackerListener) -> None:
    send(listener, FACE)
    await tick_until_heard(show_harness, listener, 1)
    layer = show_harness.show.session.tick(show_harness.clock()).characters["one"].layers["tracker"]
    assert layer.source == "Live Link Face Phone 127.0.0.1"
    heard = {counts.name: counts for probe in listener.probes for counts in [probe()]}
    assert (heard["Live Link Face"].heard, heard["Live Link Face"].where) == (1, HOST)
    assert heard["Live Link Face"].values["jawOpen"] == 0.5
    assert "Live Link (ARKit)" in heard["Live Link Face"].advice
    assert heard["iFacialMocap"].values == {}


async def test_damage_is_counted_and_told(
    show_harness: ShowHarness, listener: TrackerListener, said: list[str]
) -> None:
    send(listener, b"hello")
    await tick_until_heard(show_harness, listener, 1)
    assert said
    assert said[0].startswith("Live Link Face from 127.0.0.1: the packet begins with 68 65 6c 6c")
    assert sum(probe().rejected for probe in listener.probes) == 1


async def test_a_phone_that_is_named_is_asked_once_a_second(show_harness: ShowHarness, said: list[str]) -> None:
    with bound() as phone:
        phone.setblocking(False)
        protocol = TRACKER_PROTOCOLS["ifacialmocap"]
        asked = type(protocol)(**{**vars(protocol), "phone_port": phone.getsockname()[1]})
        made = TrackerListener(
            [TrackerSocket(asked, bound(), HOST)], lambda: show_harness.show.session, RejectionLog(said.append)
        )
        show_harness.show.sources.append(made)
        for _ in range(30):
            show_harness.tick()
        assert (await asyncio.get_running_loop().sock_recv(phone, 200)).endswith(b"sendDataVersion=v2")
        with pytest.raises(BlockingIOError):
            phone.recv(200)
        show_harness.clock.now += tracker_listener.ASK_SECONDS
        show_harness.tick()
        assert await asyncio.get_running_loop().sock_recv(phone, 200)
        await made.close()


async def test_who_is_not_allowed_is_named_in_the_health(show_harness: ShowHarness, said: list[str]) -> None:
    made = TrackerListener(
        [TrackerSocket(TRACKER_PROTOCOLS["vmc"], bound())],
        lambda: show_harness.show.session,
        RejectionLog(said.append),
        AllowedSenders(),
    )
    assert not made._heard[0].reader.hears("10.9.8.7")
    counts = made.probes[0]()
    assert (counts.heard, counts.rejected) == (0, 1)
    assert counts.last_rejection is not None
    assert counts.last_rejection.sender == "10.9.8.7"
    await made.close()


async def test_a_flood_takes_a_bounded_time_of_a_tick(
    show_harness: ShowHarness, listener: TrackerListener, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tracker_listener, "HEAR_SECONDS", 0.0)
    for _ in range(20):
        send(listener, FACE)
        send(listener, FACE, "iFacialMocap")
    show_harness.tick()
    assert sum(each.heard for each in listener.inputs) == 2  # one of each, then the time is over
    await tick_until_heard(show_harness, listener, 40)
