"""The links of camera pages: landmarks and messages in, ten times a second what the page shows out."""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Callable
from dataclasses import replace

import msgspec
from aiohttp import WSMsgType, web

from omote.inputs.page_devices.device_health import SourceCounts, count_tracker
from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.camera_input import CAMERA_HERE, CameraInput
from omote.inputs.performers.camera_performer import CalibrationFit
from omote.inputs.performers.performer_list import PerformerList
from omote.inputs.trackers.tracker_protocols import advise
from omote.server.access.access_guard import visitor_in
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.server.links.links import HEARTBEAT, SENDER_BURST, SENDER_RATE, Links, LinkSocket
from omote.show.session import ShowSession
from omote.show.wire import encode, message_in

FRAMES_BEGIN = b"OMLM", b"OMBL"
"""How frames of landmarks and of bodies begin; no message begins so."""
TOLD_SECONDS = 0.1
_from_camera: msgspec.msgpack.Decoder[wire.FromCamera] = msgspec.msgpack.Decoder(wire.FromCamera)


class CameraLinks(DeviceSource):
    """The camera pages of one show. session: the one that plays; performers: those of the show file; outside: gives
    the show's address for other machines, "" where none reaches it; clock: seconds, monotonic."""

    def __init__(
        self,
        session: Callable[[], ShowSession],
        performers: PerformerList,
        log: RejectionLog,
        outside: Callable[[], str] = lambda: "",
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.links = Links(rate=SENDER_RATE, burst=SENDER_BURST)
        self.cameras = CameraInput(session, performers)
        self._log = log
        self._outside = outside
        self._clock = clock
        self._tasks: set[asyncio.Task[None]] = set()

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """Hears one page until it closes."""
        socket = LinkSocket(
            heartbeat=HEARTBEAT, limit=wire.LONGEST_MESSAGE, refusal=lambda reason: encode(wire.CameraRefused(reason))
        )
        transport = await socket.accept(request)
        if transport is None:
            return socket
        link = self.links.open(socket, transport, visitor_in(request))
        telling = asyncio.create_task(self._tell_page(link.who, socket))
        try:
            async for message in socket:
                await link.wait_turn(self._clock)
                if message.type is WSMsgType.BINARY:
                    await self._hear(link.who, message.data)
        finally:
            telling.cancel()
            self.links.close(link)
            self.cameras.end(link.who)
        return socket

    def hear(self, now: float) -> None:
        """Drives by what has come since the last tick, and begins to fit what is complete."""
        for link, reason in self.cameras.play(now):
            self._answer(link, wire.CameraRefused(f"a frame was not read: {reason}"))
        for link, fit in self.cameras.take_fits():
            task = asyncio.get_running_loop().create_task(self._fit(link, fit))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)
        self._log.note_new(self.cameras.trackers)
        self._log.note_new(self.cameras.hands.trackers)
        self._log.note_new(self.cameras.bodies.trackers)
        self._log.tell(now)

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of it."""
        beside = [
            lambda each=each: replace(count_tracker(each.trackers, each.trackers.protocol.advice), heard=each.heard)
            for each in (self.cameras.hands, self.cameras.bodies)
            if each.heard
        ]
        return [self._count, *beside]

    async def close(self) -> None:
        """Ends all links."""
        await self.links.close_all()

    async def _hear(self, link: str, data: bytes) -> None:
        if data.startswith(FRAMES_BEGIN):
            if reason := self.cameras.receive(link, data, self._clock()):
                self._answer(link, wire.CameraRefused(f"a frame was not read: {reason}"))
            return
        try:
            displaced = self.cameras.obey(link, message_in(data, _from_camera, wire.LONGEST_MESSAGE))
        except (OSError, ValueError) as error:  # a Refusal is one; the map of landmarks may be missing
            self._answer(link, wire.CameraRefused(f"{error}".rstrip(".") + "."))
            return
        if displaced is not None:
            self._answer(displaced, wire.Displaced())

    async def _fit(self, link: str, fit: CalibrationFit) -> None:
        try:
            calibration = await asyncio.to_thread(fit.fit)
            self.cameras.receive_fit(link, fit, calibration)
        except (OSError, ValueError) as error:
            self.cameras.receive_fit(link, fit, None)
            self._answer(link, wire.CameraRefused(f"the calibration was not made: {error}."))

    async def _tell_page(self, link: str, socket: LinkSocket) -> None:
        with contextlib.suppress(ConnectionError):
            while not socket.closed:
                status = self.cameras.status(link)
                if status is not None:
                    await socket.send_bytes(encode(status))
                await asyncio.sleep(TOLD_SECONDS)

    def _answer(self, link: str, message: wire.ToCamera) -> None:
        """Answers one page at once; one that has gone, or does not read, is told nothing."""
        self.links.answer(link, encode(message))

    def _count(self) -> SourceCounts:
        trackers = self.cameras.trackers
        place = self._outside()
        advice = advise(trackers.protocol, place, None) if place else CAMERA_HERE
        return replace(count_tracker(trackers, advice), heard=self.cameras.heard)
