"""The link of a camera page over a real socket: landmarks become a source, the page is told, wrongs are answered."""

import asyncio
import contextlib
from collections.abc import AsyncIterator

import aiohttp
import msgspec
import pytest
import pytest_asyncio
from aiohttp import web
from aiohttp.test_utils import TestClient, TestServer
from aiohttp.typedefs import Handler

from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.performer_list import PerformerList
from omote.server.access.access_guard import VISITOR
from omote.server.camera.camera_link import CameraLinks
from omote.server.devices.rejection_log import RejectionLog
from omote.show.access.people_list import ANYBODY, Visitor
from omote.show.wire import encode
from tests.inputs.performers.landmarks import packet
from tests.server.conftest import ShowHarness

pytestmark = pytest.mark.asyncio
Sender = TestClient[web.Request, web.Application]


class Room:
    """The links of one show, who may stay, and what the terminal was told."""

    def __init__(self, harness: ShowHarness) -> None:
        self.harness = harness
        self.outside = ""
        self.said: list[str] = []
        performers = PerformerList({}, lambda *_: None)
        self.links = CameraLinks(
            lambda: harness.show.session,
            performers,
            RejectionLog(self.said.append),
            lambda: self.outside,
        )
        harness.show.sources.append(self.links)

    async def tick(self) -> None:
        while True:
            self.harness.tick()
            await asyncio.sleep(0.001)


@pytest_asyncio.fixture
async def room(show_harness: ShowHarness) -> AsyncIterator[Room]:
    made = Room(show_harness)
    ticking = asyncio.create_task(made.tick())
    yield made
    ticking.cancel()
    with contextlib.suppress(asyncio.CancelledError):
        await ticking
    await made.links.close()


@pytest_asyncio.fixture
async def sender(room: Room) -> AsyncIterator[Sender]:
    @web.middleware
    async def let_in(request: web.Request, handler: Handler) -> web.StreamResponse:
        request[VISITOR] = Visitor(ANYBODY.role, "Ada")
        return await handler(request)

    application = web.Application(middlewares=[let_in])
    application.router.add_get(wire.CAMERA_PATH, room.links.respond)
    async with TestClient(TestServer(application)) as client:
        yield client


async def told(socket: aiohttp.ClientWebSocketResponse, kind: type) -> wire.ToCamera:
    """The next message of a kind."""
    while True:
        message: wire.ToCamera = msgspec.msgpack.decode(await socket.receive_bytes(timeout=60.0), type=wire.ToCamera)
        if isinstance(message, kind):
            return message


async def status(socket: aiohttp.ClientWebSocketResponse) -> wire.CameraStatus:
    message = await told(socket, wire.CameraStatus)
    assert isinstance(message, wire.CameraStatus)
    return message


@contextlib.asynccontextmanager
async def performing(sender: Sender, name: str = "Ada") -> AsyncIterator[aiohttp.ClientWebSocketResponse]:
    async with sender.ws_connect(wire.CAMERA_PATH) as socket:
        await socket.send_bytes(encode(wire.Perform(wire.CAMERA_VERSION, name)))
        yield socket


async def test_frames_calibrate_and_then_drive(room: Room, sender: Sender) -> None:
    async with performing(sender) as socket:
        time = 0.0
        while (await status(socket)).calibrated != "rest":
            for _ in range(8):
                time += 0.25
                await socket.send_bytes(packet(time))
                await asyncio.sleep(0.02)
        await socket.send_bytes(packet(time, jaw=0.06))
        while not (found := await status(socket)).weights:
            await socket.send_bytes(packet(time, jaw=0.06))
        assert found.performers == ["Ada"]
        assert [each.name for each in room.harness.show.session.sources.states({})] == ["Camera Ada"]
        (count,) = [probe() for probe in room.links.probes]
        assert (count.name, count.rejected) == ("Camera", 0)
        assert count.heard >= found.heard > 0
    while room.harness.show.session.sources.states({}):
        await asyncio.sleep(0.001)


async def test_what_cannot_be_read_or_done_is_answered(room: Room, sender: Sender) -> None:
    async with performing(sender) as socket:
        for data, reason in (
            (b"\xc1", "cannot be read"),
            (encode(wire.RedoStep("aa")), "begin the guided minute."),
            (b"OMLM", "a frame was not read: it has 4 bytes"),
            (encode(wire.Perform(7, "Ada")), "speaks version 7"),
        ):
            await socket.send_bytes(data)
            refused = await told(socket, wire.CameraRefused)
            assert isinstance(refused, wire.CameraRefused)
            assert reason in refused.reason
    assert room.said


async def test_a_message_beyond_the_limit_ends_the_link_with_a_word(sender: Sender) -> None:
    async with performing(sender) as socket:
        await socket.send_bytes(b"x" * (wire.LONGEST_MESSAGE + 1))
        refused = await told(socket, wire.CameraRefused)
        assert isinstance(refused, wire.CameraRefused)
        assert "longer than" in refused.reason


async def test_the_first_page_is_told_when_another_takes_over(sender: Sender) -> None:
    async with performing(sender) as first, performing(sender) as second:
        await status(second)
        await told(first, wire.Displaced)


async def test_a_calibration_that_cannot_be_made_is_said(
    room: Room, sender: Sender, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise ValueError("too few frames")

    monkeypatch.setattr("omote.inputs.performers.camera_performer.fit_calibration", fail)
    async with performing(sender) as socket:
        reading = asyncio.create_task(told(socket, wire.CameraRefused))
        time = 0.0
        while not reading.done():
            time += 0.25
            await socket.send_bytes(packet(time))
            await asyncio.sleep(0.01)
        refused = await reading
        assert isinstance(refused, wire.CameraRefused)
        assert refused.reason == "the calibration was not made: too few frames."


async def test_a_camera_elsewhere_is_sent_to_the_address_of_the_show_or_told_what_it_needs(room: Room) -> None:
    (probe,) = room.links.probes
    assert "omote track" not in probe().advice
    assert "this machine alone" in probe().advice
    assert "--host 0.0.0.0" in probe().advice
    room.outside = "https://192.168.1.20:8095"
    assert "omote track --to https://192.168.1.20:8095 " in probe().advice
