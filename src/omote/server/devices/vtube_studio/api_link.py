"""Keeps a connection to one VTube Studio open; never waits, whatever comes."""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque
from collections.abc import Callable

import aiohttp

from omote.inputs.trackers.vtube_studio.api_message import LONGEST_MESSAGE
from omote.inputs.trackers.vtube_studio.api_session import ApiSession

RETRY_SECONDS = 2.0
CONNECT_SECONDS = 3.0
MOST_WAITING = 64
MOST_UNSENT = 128
"""Messages that wait for the next tick, and to be sent; what is too much is dropped, the oldest first."""
Endpoint = tuple[str, int]


class ApiLink:
    """A connection. find: where VTube Studio is now; open_session: makes the session of a new connection, given what
    sends and where it is. session: the one that is open now; fault: why there is none, or ""."""

    def __init__(
        self, find: Callable[[], Endpoint], open_session: Callable[[Callable[[bytes], None], Endpoint], ApiSession]
    ) -> None:
        self._find = find
        self._open_session = open_session
        self.session: ApiSession | None = None
        self.place = find()
        self.fault = ""
        self.waiting: deque[bytes] = deque(maxlen=MOST_WAITING)
        self._unsent: deque[bytes] = deque(maxlen=MOST_UNSENT)
        self._news = asyncio.Event()
        self._task = asyncio.get_running_loop().create_task(self._keep_open())

    async def close(self) -> None:
        """Closes it."""
        self._task.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await self._task

    def send(self, data: bytes) -> None:
        """Sends a message when there is room."""
        self._unsent.append(data)
        self._news.set()

    async def _keep_open(self) -> None:
        async with aiohttp.ClientSession(timeout=aiohttp.ClientTimeout(connect=CONNECT_SECONDS)) as client:
            while True:
                self.place = self._find()
                host, port = self.place
                try:
                    async with client.ws_connect(f"ws://{host}:{port}", max_msg_size=LONGEST_MESSAGE) as link:
                        await self._converse(link)
                except (OSError, aiohttp.ClientError, TimeoutError):
                    pass
                self.session = None
                self.fault = f"VTube Studio does not answer at {host}:{port}; is Allow Plugin API access on there?"
                await asyncio.sleep(RETRY_SECONDS)

    async def _converse(self, link: aiohttp.ClientWebSocketResponse) -> None:
        """Takes what comes until the connection ends."""
        self.fault = ""
        self._unsent.clear()
        self.waiting.clear()
        self.session = self._open_session(self.send, self.place)
        self.session.begin()
        sending = asyncio.create_task(self._send_all(link))
        try:
            async for message in link:
                if message.type is aiohttp.WSMsgType.TEXT:
                    self.waiting.append(message.data.encode())
                elif message.type is aiohttp.WSMsgType.BINARY:
                    self.waiting.append(message.data)
        finally:
            sending.cancel()
            with contextlib.suppress(asyncio.CancelledError, OSError, aiohttp.ClientError):
                await sending

    async def _send_all(self, link: aiohttp.ClientWebSocketResponse) -> None:
        while True:
            await self._news.wait()
            self._news.clear()
            while self._unsent:
                await link.send_str(self._unsent.popleft().decode())
