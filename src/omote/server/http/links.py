"""The open links: states go to everybody at once, and whoever is slow slows nobody.

A state is written straight to the socket of a link whose buffer is (nearly) empty; a link that is behind is passed over
until its buffer is empty again and then gets the newest state, so nothing piles up. Sending never waits.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import socket
from collections.abc import Callable, Coroutine, Iterator
from dataclasses import dataclass, field

from aiohttp import WSCloseCode, web

from omote.show.messages import MESSAGE_LIMIT, Refused
from omote.show.rate_limit import TokenBucket
from omote.show.wire import encode

UNSENT_LIMIT = 2048
"""Bytes that may wait in a link's buffer before it counts as behind: a frame or two."""
ANSWER_LIMIT = 32768
"""Bytes that may wait before answers (refusals, pongs) are dropped too."""
STALL_LIMIT = 10.0
"""Seconds a link may be behind before it is cut; a browser comes back and is given the newest state."""
SEND_BUFFER = 32768
"""Bytes of the kernel's buffer: large ones would hold seconds of old states for a browser that pauses."""
CLOSE_SECONDS = 1.0
HEARTBEAT = 8.0
"""Seconds of silence after which a link is asked whether it lives; it has half as long to answer."""
HEARD_RATE, HEARD_BURST = 1200.0, 240.0
"""Messages per second heard from one link: ten fingers on faders; more waits in its own socket."""


class LinkSocket(web.WebSocketResponse):
    """A browser's socket; on a message that is too long it says so before it closes."""

    def __init__(
        self,
        *,
        heartbeat: float,
        limit: int = MESSAGE_LIMIT,
        refusal: Callable[[str], bytes] = lambda reason: encode(Refused(reason)),
    ) -> None:
        super().__init__(compress=False, max_msg_size=limit, heartbeat=heartbeat)
        self._limit, self._refusal = limit, refusal

    async def accept(self, request: web.Request) -> asyncio.Transport | None:
        """Opens the link that a request asks for; None when the browser has gone before."""
        try:
            await self.prepare(request)
        except ConnectionResetError:
            return None
        return request.transport

    async def close(self, *, code: int = WSCloseCode.OK, message: bytes = b"", drain: bool = True) -> bool:
        """Closes; aiohttp calls it when a message is over the limit."""
        if code == WSCloseCode.MESSAGE_TOO_BIG and not self.closed:
            message = f"a message was longer than {self._limit} bytes, the most that is read.".encode()
            with contextlib.suppress(ConnectionError):
                finish_now(self.send_bytes(self._refusal(message.decode())))
        try:
            return await super().close(code=code, message=message, drain=drain)
        except RuntimeError:  # gone before it was let in: aiohttp ends the answer that never began
            return False


@dataclass(eq=False)
class Link:
    """One browser."""

    who: str
    socket: web.WebSocketResponse
    transport: asyncio.Transport
    bucket: TokenBucket = field(default_factory=lambda: TokenBucket(HEARD_RATE, HEARD_BURST))
    behind_since: float | None = None
    skipped: int = 0

    async def wait_turn(self, clock: Callable[[], float]) -> None:
        """Waits until this link may say one more thing; meanwhile its socket fills, not our memory."""
        while not self.bucket.take(clock()):
            await asyncio.sleep(1.0 / self.bucket.rate)

    def send(self, data: bytes, limit: int) -> bool:
        """Sends now, or not at all when more than `limit` bytes still wait; never waits."""
        if self.socket.closed or self.transport.is_closing() or self.transport.get_write_buffer_size() > limit:
            return False
        try:
            finish_now(self.socket.send_bytes(data))
        except ConnectionError:
            return False
        return True


class Links:
    """All open links."""

    def __init__(self, stall_limit: float = STALL_LIMIT) -> None:
        self._links: dict[str, Link] = {}
        self._names = map(str, itertools.count(1))
        self._stall_limit = stall_limit

    def __iter__(self) -> Iterator[Link]:
        return iter(list(self._links.values()))

    def __len__(self) -> int:
        return len(self._links)

    def open(self, ws: web.WebSocketResponse, transport: asyncio.Transport) -> Link:
        """A new link, under a name of its own."""
        shrink_send_buffer(transport)
        link = Link(next(self._names), ws, transport)
        self._links[link.who] = link
        return link

    def close(self, link: Link) -> None:
        """Forgets a link."""
        self._links.pop(link.who, None)

    async def close_all(self) -> None:
        """Tells every browser that the server goes; waits a second at most."""
        closing = [link.socket.close(code=WSCloseCode.GOING_AWAY, message=b"the server ends") for link in self]
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(asyncio.gather(*closing, return_exceptions=True), CLOSE_SECONDS)

    def answer(self, who: str, data: bytes) -> None:
        """Sends to one link; dropped when it does not read."""
        if who in self._links:
            self._links[who].send(data, ANSWER_LIMIT)

    def broadcast(self, data: bytes, now: float) -> None:
        """Sends the same bytes to everybody who keeps up; cuts who has been behind for too long."""
        for link in list(self._links.values()):
            if link.send(data, UNSENT_LIMIT):
                link.behind_since = None
                continue
            link.skipped += 1
            link.behind_since = now if link.behind_since is None else link.behind_since
            if now - link.behind_since > self._stall_limit:
                link.transport.abort()
                self.close(link)


def finish_now(sending: Coroutine[object, None, None]) -> None:
    """Runs a send as far as it goes without waiting; the frame is written before it would wait for room."""
    try:
        sending.send(None)
    except StopIteration:
        return
    sending.close()


def shrink_send_buffer(transport: asyncio.Transport) -> None:
    """Keeps the kernel's send buffer small, where there is a real socket."""
    endpoint = transport.get_extra_info("socket")
    if endpoint is not None:
        endpoint.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER)
