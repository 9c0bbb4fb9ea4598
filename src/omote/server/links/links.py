"""The open WebSocket links: broadcasts states without waiting, so that a slow browser delays nobody (backpressure).

A state is written straight to the socket of a link whose buffer is (nearly) empty; a link that is behind is skipped
until its buffer is empty again and then gets the newest state, so nothing piles up. Sending never waits.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import socket
from collections.abc import Callable, Coroutine, Iterable, Iterator
from dataclasses import dataclass, field

from aiohttp import WSCloseCode, web

from omote.show.access.access_documents import REVOKED_CODE
from omote.show.access.people_list import ANYBODY, Visitor
from omote.show.declaration import MESSAGE_LIMIT
from omote.show.objects.link import Refused
from omote.show.rate_limit import TokenBucket
from omote.show.wire import encode

UNSENT_LIMIT = 2048
"""Bytes that may wait in a link's buffer before it counts as behind: a frame or two of one character."""
ANSWER_LIMIT = 32768
"""Bytes that may wait before answers (rejections, pongs) are dropped too."""
STALL_LIMIT = 10.0
"""Seconds a link may be behind before it is cut; the browser reconnects and gets the newest state."""
SEND_BUFFER = 32768
"""Bytes of the kernel's buffer: large ones would hold seconds of old states for a browser that pauses."""
CLOSE_SECONDS = 1.0
HEARTBEAT = 8.0
"""Seconds of silence after which a link is pinged; it has half as long to answer."""
HEARD_RATE = 1200.0
HEARD_BURST = 240.0
"""Messages per second read from one link (ten fingers on faders); more waits in the socket."""
SENDER_RATE = 250.0
SENDER_BURST = 100.0
"""Packets per second read from one camera, microphone or tracker."""


REVOKED = "your token was revoked or has ended: ask whoever runs the show for a new one."


class LinkSocket(web.WebSocketResponse):
    """A WebSocket that reports a message over the size limit before it closes."""

    def __init__(
        self,
        *,
        heartbeat: float,
        limit: int = MESSAGE_LIMIT,
        refusal: Callable[[str], bytes] = lambda reason: encode(Refused(reason)),
    ) -> None:
        super().__init__(compress=False, max_msg_size=limit, heartbeat=heartbeat)
        self._limit = limit
        self._refusal = refusal
        self._revoking: asyncio.Task[bool] | None = None

    async def accept(self, request: web.Request) -> asyncio.Transport | None:
        """Accepts the WebSocket of a request and returns its transport; None when the browser has gone already."""
        try:
            await self.prepare(request)
        except ConnectionResetError:
            return None
        return request.transport

    def revoke(self) -> None:
        """Ends the link of somebody whose token is not valid any more."""
        with contextlib.suppress(ConnectionError):
            finish_now(self.send_bytes(self._refusal(REVOKED)))
        closing = self.close(code=REVOKED_CODE, message=REVOKED.encode())
        self._revoking = asyncio.get_running_loop().create_task(closing)

    async def close(self, *, code: int = WSCloseCode.OK, message: bytes = b"", drain: bool = True) -> bool:
        """Closes the socket; aiohttp calls this when a message is over the limit.

        code: of WebSocket; message: for the page; drain: waits until it is sent.
        """
        if code == WSCloseCode.MESSAGE_TOO_BIG and not self.closed:
            message = f"a message was longer than {self._limit} bytes, the most that is read.".encode()
            with contextlib.suppress(ConnectionError):
                finish_now(self.send_bytes(self._refusal(message.decode())))
        try:
            return await super().close(code=code, message=message, drain=drain)
        except RuntimeError:  # gone before it was accepted: aiohttp ends the response that never began
            return False


@dataclass(eq=False)
class Link:
    """One page's open link, with its rate limit."""

    who: str
    socket: web.WebSocketResponse
    transport: asyncio.Transport
    visitor: Visitor = ANYBODY
    bucket: TokenBucket = field(default_factory=lambda: TokenBucket(HEARD_RATE, HEARD_BURST))
    behind_since: float | None = None
    skipped: int = 0

    async def wait_turn(self, clock: Callable[[], float], size: int = 0) -> None:
        """Waits until the rate limit allows this link one more message; meanwhile the socket fills, not our memory.

        Others come first: what many links have sent at one time is heard between ticks, not in place of one.

        size: its bytes; a long one, which only a speech may be, counts as often as it is longer than others may be.
        clock: seconds, monotonic.
        """
        await asyncio.sleep(0.0)
        for _ in range(1 + size // MESSAGE_LIMIT):
            while not self.bucket.take(clock()):
                await asyncio.sleep(1.0 / self.bucket.rate)

    def send(self, data: bytes, limit: int) -> bool:
        """Sends at once, or drops the data when more than `limit` bytes are unsent; returns whether it was sent."""
        if self.socket.closed or self.transport.is_closing() or self.transport.get_write_buffer_size() > limit:
            return False
        try:
            finish_now(self.socket.send_bytes(data))
        except ConnectionError:
            return False
        return True


class Links:
    """All open links of one kind; a server ends those of them whose token was revoked (`close_revoked`)."""

    def __init__(
        self, stall_limit: float = STALL_LIMIT, *, rate: float = HEARD_RATE, burst: float = HEARD_BURST
    ) -> None:
        self._links: dict[str, Link] = {}
        self._names = map(str, itertools.count(1))
        self._stall_limit = stall_limit
        self._rate = rate
        self._burst = burst

    def __iter__(self) -> Iterator[Link]:
        return iter(list(self._links.values()))

    def __len__(self) -> int:
        return len(self._links)

    def open(self, ws: web.WebSocketResponse, transport: asyncio.Transport, visitor: Visitor = ANYBODY) -> Link:
        """Adds a link under a new name. ws: its socket; transport: beneath it; visitor: who has opened it."""
        shrink_send_buffer(transport)
        link = Link(next(self._names), ws, transport, visitor, TokenBucket(self._rate, self._burst))
        self._links[link.who] = link
        return link

    def close(self, link: Link) -> None:
        """Removes a link."""
        self._links.pop(link.who, None)

    async def close_all(self) -> None:
        """Closes every link with "going away"; waits a second at most."""
        closing = [link.socket.close(code=WSCloseCode.GOING_AWAY, message=b"the server ends") for link in self]
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(asyncio.gather(*closing, return_exceptions=True), CLOSE_SECONDS)

    def answer(self, who: str, data: bytes) -> None:
        """Sends to one link; the data is dropped when the link does not read.

        who: the name of the link; data: one message.
        """
        if who in self._links:
            self._links[who].send(data, ANSWER_LIMIT)

    def broadcast(self, data: bytes, now: float, links: Iterable[Link] | None = None) -> None:
        """Sends the same bytes to every link that keeps up; cuts links that have been behind for too long.

        data: one message; now: seconds, monotonic; links: those that get it, all where none are given.
        """
        for link in list(self) if links is None else links:
            if link.send(data, max(UNSENT_LIMIT, len(data))):  # a state of many characters may itself be more
                link.behind_since = None
                continue
            link.skipped += 1
            link.behind_since = now if link.behind_since is None else link.behind_since
            if now - link.behind_since > self._stall_limit:
                link.transport.abort()
                self.close(link)


def close_revoked(links: Iterable[Link], holds: Callable[[Visitor], bool]) -> None:
    """Closes at once the links of those who may not stay, with a word for their pages.

    links: all that are open; holds: whether a visitor may stay.
    """
    for link in links:
        if isinstance(link.socket, LinkSocket) and not link.socket.closed and not holds(link.visitor):
            link.socket.revoke()


def finish_now(sending: Coroutine[object, None, None]) -> None:
    """Runs a send coroutine up to its first wait; by then the frame is written to the transport."""
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
