"""Hears results of MediaPipe by WebSocket, of pages of this show and of programs; plays the newest once a tick."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable

from aiohttp import WSMsgType, web

from omote.inputs.page_devices.device_health import SourceCounts, count_tracker
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, advise
from omote.server.devices.rejection_log import RejectionLog
from omote.show.messages import State
from omote.show.session import ShowSession

LONGEST_RESULT = 65536
MOST_WAITING = 64
"""Results that wait for the next tick; the newest push the oldest out."""
HEAR_SECONDS = 0.002
HEARTBEAT = 8.0


class MediapipeLink:
    """Results of MediaPipe at one show. session: the one that plays. on: whether they are heard."""

    def __init__(self, session: Callable[[], ShowSession], log: RejectionLog) -> None:
        self.trackers = TrackerInput(TRACKER_PROTOCOLS["mediapipe"], session)
        self._log, self._told_rejected, self.on = log, 0, False
        self._waiting: deque[tuple[str, bytes]] = deque(maxlen=MOST_WAITING)

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """Takes the results of one sender until it closes."""
        if not self.on:
            raise web.HTTPNotFound(text="results of MediaPipe are not heard: switch MediaPipe on at the page Devices.")
        link = web.WebSocketResponse(compress=False, max_msg_size=LONGEST_RESULT, heartbeat=HEARTBEAT)
        await link.prepare(request)
        host = request.remote or ""
        async for message in link:
            if not self.hears():
                break
            if message.type is WSMsgType.TEXT:
                self._waiting.append((host, message.data.encode()))
            elif message.type is WSMsgType.BINARY:
                self._waiting.append((host, message.data))
        return link

    def hears(self) -> bool:
        """Whether results are heard."""
        return self.on

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick, for a bounded time, and drives by the newest of it."""
        until = time.perf_counter() + HEAR_SECONDS
        while self._waiting and time.perf_counter() < until:
            self.trackers.receive(*self._waiting.popleft(), now)
        self.trackers.play(now)
        self._told_rejected = self._log.note_new(self.trackers, self._told_rejected)
        self._log.tell(now)

    def tell(self, state: State, now: float) -> None:
        """There is nothing to tell."""

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of it."""
        return [self._count] if self.on else []

    async def close(self) -> None:
        """There is nothing to close: links end with the server."""

    def _count(self) -> SourceCounts:
        return count_tracker(self.trackers, advise(self.trackers.protocol, "", None))
