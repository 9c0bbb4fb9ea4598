"""Lets in connections of TCP: so many of one address, and each only once the head of its first request is there.

Whoever opens a thousand connections and says nothing, or half a request, takes no descriptor from the show for long.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any, cast

MOST_OF_ADDRESS = 512
"""Connections of one address: the pages of a wall of screens, of a crew behind one router, and many more."""
MOST_ADDRESSES = 1024
"""Addresses that are remembered before those without a connection are forgotten."""
HEAD_SECONDS = 10.0
"""In which the head of a connection's first request is to come; TLS has its own limit before."""
LONGEST_HEAD = 65536
"""Bytes that wait for the end of a head; what reads requests has its own limits, and is more exact."""
HEAD_ENDS = b"\r\n\r\n"

Serve = Callable[[], asyncio.Protocol]


class ConnectionLimit:
    """Makes the protocol of each new connection. serve: makes what answers requests; most: connections of one address;
    seconds: for the head of the first request."""

    def __init__(self, serve: Serve, most: int = MOST_OF_ADDRESS, seconds: float = HEAD_SECONDS) -> None:
        self.serve = serve
        self.seconds = seconds
        self._most = most
        self._open: dict[str, list[asyncio.BaseTransport]] = {}

    def __call__(self) -> asyncio.Protocol:
        """The protocol of a connection that has just come."""
        return WaitingConnection(self)

    def takes(self, transport: asyncio.BaseTransport) -> bool:
        """Whether a new connection may stay; it counts from now on."""
        peer = transport.get_extra_info("peername")
        host = str(peer[0]) if isinstance(peer, tuple) else ""
        if len(self._open) >= MOST_ADDRESSES:
            self._open = {other: still for other, known in self._open.items() if (still := _open_of(known))}
        others = self._open[host] = _open_of(self._open.get(host, []))
        if len(others) >= self._most:
            return False
        others.append(transport)
        return True


def _open_of(transports: list[asyncio.BaseTransport]) -> list[asyncio.BaseTransport]:
    return [transport for transport in transports if not transport.is_closing()]


class WaitingConnection(asyncio.Protocol):
    """A connection until the head of its first request is there."""

    def __init__(self, limit: ConnectionLimit) -> None:
        self._limit = limit
        self._head = bytearray()
        self._transport: asyncio.Transport | None = None
        self._end: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Waits for the head; ends the connection at once where its address has too many."""
        self._transport = cast(asyncio.Transport, transport)  # that of uvloop says of itself that it is none
        if not self._limit.takes(transport):
            self._transport.abort()
            return
        self._end = asyncio.get_running_loop().call_later(self._limit.seconds, self._transport.abort)

    def data_received(self, data: bytes) -> None:
        """Hands the connection over to what answers, with all that has come, once the head is there."""
        self._head += data
        transport = self._transport
        if transport is None or transport.is_closing():
            return
        if HEAD_ENDS not in self._head and len(self._head) <= LONGEST_HEAD:
            return
        self._forget_end()
        serving: Any = self._limit.serve()
        transport.set_protocol(serving)
        serving.connection_made(transport)
        serving.data_received(bytes(self._head))

    def eof_received(self) -> None:
        """Lets the connection end: its other side has, before its request was there."""

    def connection_lost(self, _: Exception | None) -> None:
        """Waits no more."""
        self._forget_end()

    def _forget_end(self) -> None:
        if self._end is not None:
            self._end.cancel()
            self._end = None
