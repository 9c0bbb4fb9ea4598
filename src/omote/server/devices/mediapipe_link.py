"""Hears results of MediaPipe by WebSocket, of pages of this show and of programs; plays the newest once a tick."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable

from aiohttp import WSMsgType, web

from omote.inputs.page_devices.device_health import SourceCounts, count_tracker
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, advise
from omote.server.access.access_guard import visitor_in
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.server.links.links import HEARTBEAT, SENDER_BURST, SENDER_RATE, Link, Links, LinkSocket
from omote.show.session import ShowSession

LONGEST_RESULT = 262_144
"""Bytes; the 478 points of a face as Python writes them, with all their fields, are some 70,000."""
MOST_WAITING = 64
"""Results that wait for the next tick; the newest push the oldest out."""
MOST_UNSENT = 16_384
"""Bytes of reasons that a sender has not read; beyond, it is told no more of them."""
HEAR_SECONDS = 0.002


class MediapipeLink(DeviceSource):
    """Results of MediaPipe at one show. session: the one that plays. on: whether they are heard."""

    def __init__(
        self,
        session: Callable[[], ShowSession],
        log: RejectionLog,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.links = Links(rate=SENDER_RATE, burst=SENDER_BURST)
        self._clock = clock
        self.trackers = TrackerInput(TRACKER_PROTOCOLS["mediapipe"], session)
        self._log = log
        self.on = False
        self._waiting: deque[tuple[Link, str, bytes]] = deque(maxlen=MOST_WAITING)

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """Takes the results of one sender until it closes."""
        if not self.on:
            raise web.HTTPNotFound(text="results of MediaPipe are not heard: switch MediaPipe on at the page Devices.")
        socket = LinkSocket(heartbeat=HEARTBEAT, limit=LONGEST_RESULT, refusal=str.encode)
        transport = await socket.accept(request)
        if transport is None:
            return socket
        link = self.links.open(socket, transport, visitor_in(request))
        try:
            await self._listen(link, request.remote or "")
        finally:
            self.links.close(link)
        return socket

    async def _listen(self, link: Link, host: str) -> None:
        async for message in link.socket:
            if not self._is_on():
                break
            await link.wait_turn(self._clock)
            if message.type is WSMsgType.TEXT:
                self._waiting.append((link, host, message.data.encode()))
            elif message.type is WSMsgType.BINARY:
                self._waiting.append((link, host, message.data))

    async def close(self) -> None:
        """Closes all links."""
        await self.links.close_all()

    def _is_on(self) -> bool:
        """Whether results are heard still: a page may have switched it off meanwhile."""
        return self.on

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick, for a bounded time, and drives by the newest of it."""
        until = time.perf_counter() + HEAR_SECONDS
        while self._waiting and time.perf_counter() < until:
            self._hear_one(*self._waiting.popleft(), now)
        self.trackers.play(now)
        self._log.note_new(self.trackers)
        self._log.tell(now)

    def _hear_one(self, link: Link, host: str, data: bytes, now: float) -> None:
        """Reads a result; whoever sent what is none is told why."""
        rejected = self.trackers.rejected
        self.trackers.receive(host, data, now)
        if self.trackers.rejected > rejected and self.trackers.last_rejection is not None:
            link.send(self.trackers.last_rejection.reason.encode(), MOST_UNSENT)

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of it."""
        return [self._count] if self.on else []

    def _count(self) -> SourceCounts:
        return count_tracker(self.trackers, advise(self.trackers.protocol, "", None))
