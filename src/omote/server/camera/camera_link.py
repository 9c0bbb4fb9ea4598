"""The links of camera pages: landmarks and messages in, ten times a second what the page shows out."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
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
from omote.server.devices.rejection_log import RejectionLog
from omote.server.http.links import HEARTBEAT, LinkSocket
from omote.show.access.people_list import Visitor
from omote.show.messages import State
from omote.show.session import ShowSession
from omote.show.wire import encode, message_in

LANDMARKS_BEGIN = b"OMLM"
"""How a frame of landmarks begins; no message begins so."""
TOLD_SECONDS = 0.1
_from_camera: msgspec.msgpack.Decoder[wire.FromCamera] = msgspec.msgpack.Decoder(wire.FromCamera)


class CameraLinks:
    """The camera pages of one show. session: the one that plays; performers: those of the show file; holds: whether
    somebody who came in may stay; outside: gives the show's address for other machines, "" where none reaches it."""

    def __init__(
        self,
        session: Callable[[], ShowSession],
        performers: PerformerList,
        log: RejectionLog,
        holds: Callable[[Visitor], bool] = lambda _: True,
        outside: Callable[[], str] = lambda: "",
    ) -> None:
        self.cameras = CameraInput(session, performers)
        self._log, self._holds, self._outside, self._told_rejected = log, holds, outside, 0
        self._links: dict[str, LinkSocket] = {}
        self._names = map(str, itertools.count(1))
        self._tasks: set[asyncio.Task[None]] = set()

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """Hears one page until it closes."""
        socket = LinkSocket(
            heartbeat=HEARTBEAT, limit=wire.LONGEST_MESSAGE, refusal=lambda reason: encode(wire.CameraRefused(reason))
        )
        if await socket.accept(request) is None:
            return socket
        name = next(self._names)
        self._links[name] = socket
        telling = asyncio.create_task(self._tell_page(name, socket, visitor_in(request)))
        try:
            async for message in socket:
                if message.type is WSMsgType.BINARY:
                    await self._hear(name, message.data)
        finally:
            telling.cancel()
            self._links.pop(name, None)
            self.cameras.end(name)
        return socket

    def hear(self, now: float) -> None:
        """Drives by what has come since the last tick, and begins to fit what is complete."""
        for link, reason in self.cameras.play(now):
            self._answer(link, wire.CameraRefused(f"a frame was not read: {reason}"))
        for link, fit in self.cameras.take_fits():
            task = asyncio.get_running_loop().create_task(self._fit(link, fit))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)
        self._told_rejected = self._log.note_new(self.cameras.trackers, self._told_rejected)
        self._log.tell(now)

    def tell(self, state: State, now: float) -> None:
        """There is nothing to tell: pages are told at their own pace."""

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of it."""
        return [self._count]

    async def close(self) -> None:
        """Ends all links."""
        closing = [socket.close(message=b"the show ends") for socket in self._links.values()]
        await asyncio.gather(*closing, return_exceptions=True)

    async def _hear(self, link: str, data: bytes) -> None:
        if data.startswith(LANDMARKS_BEGIN):
            self.cameras.receive(link, data)
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

    async def _tell_page(self, link: str, socket: LinkSocket, visitor: Visitor) -> None:
        with contextlib.suppress(ConnectionError):
            while not socket.closed:
                if not self._holds(visitor):
                    socket.revoke()
                    return
                status = self.cameras.status(link)
                if status is not None:
                    await socket.send_bytes(encode(status))
                await asyncio.sleep(TOLD_SECONDS)

    def _answer(self, link: str, message: wire.ToCamera) -> None:
        """Answers one page soon; one that has gone is told nothing."""
        socket = self._links.get(link)
        if socket is not None:
            task = asyncio.get_running_loop().create_task(_send(socket, encode(message)))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

    def _count(self) -> SourceCounts:
        trackers = self.cameras.trackers
        place = self._outside()
        advice = advise(trackers.protocol, place, None) if place else CAMERA_HERE
        return replace(count_tracker(trackers, advice), heard=self.cameras.heard)


async def _send(socket: LinkSocket, data: bytes) -> None:
    with contextlib.suppress(ConnectionError):
        await socket.send_bytes(data)
