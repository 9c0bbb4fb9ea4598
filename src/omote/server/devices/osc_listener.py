"""Hears OSC over UDP and TCP once a tick, and tells surfaces what is on air; never waits, whatever comes."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import socket
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from omote.inputs.osc_input import OscInput, Place
from omote.inputs.osc_packet import LONGEST_PACKET, OscError
from omote.inputs.osc_stream import Framing, choose_framing
from omote.show.messages import State

MOST_READ = 1500
"""Datagrams read in one tick; beyond, the kernel keeps or drops them."""
MOST_WAITING = 512
"""Packets that wait to be obeyed; the newest push the oldest out."""
OBEY_SECONDS = 0.003
"""Of a tick, for obeying packets; what is left waits for the next."""
NEWS_TICKS = 2
"""Ticks between two reports to surfaces: 30 a second."""
REPORT_SECONDS = 1.0
"""Between two lines on the terminal about what was rejected."""
MOST_CONNECTIONS = 32
UNSENT_LIMIT = 65536
"""Bytes that may wait for a surface that does not read; it misses what comes then."""


@dataclass(frozen=True)
class OscSockets:
    """The sockets of a show's OSC: of datagrams, and one that listens for connections (None: it could not be had)."""

    datagrams: socket.socket
    connections: socket.socket | None

    @property
    def handed(self) -> dict[str, int]:
        """Their descriptors, by the option of a standby that takes each."""
        more = {} if self.connections is None else {"--osc-connections": self.connections.fileno()}
        return {"--osc": self.datagrams.fileno(), **more}

    def close(self) -> None:
        """Closes both."""
        for each in (self.datagrams, self.connections):
            if each is not None:
                each.close()


class OscListener:
    """OSC of one show. `dropped` counts packets that there was no time for."""

    def __init__(self, osc: OscInput, sockets: OscSockets, report: Callable[[str], None]) -> None:
        self.osc, self._sockets, self._report = osc, sockets, report
        self._waiting: deque[tuple[Place, bytes]] = deque()
        self._connections: dict[str, _Connection] = {}
        self._names = map(str, itertools.count(1))
        self._server: asyncio.Server | None = None
        self._reported, self._told_rejected, self._ticks = -REPORT_SECONDS, 0, 0
        self.dropped = 0
        sockets.datagrams.setblocking(False)

    async def start(self) -> None:
        """Accepts connections from now on."""
        if self._sockets.connections is not None:
            loop = asyncio.get_running_loop()
            self._server = await loop.create_server(lambda: _Connection(self), sock=self._sockets.connections)

    def hear(self, now: float) -> None:
        """Obeys what has come since the last tick, for a bounded time."""
        self._read_datagrams()
        until = time.perf_counter() + OBEY_SECONDS
        while self._waiting and time.perf_counter() < until:
            place, packet = self._waiting.popleft()
            for other, answer in self.osc.receive(place, packet, now):
                self._send(other, answer)
        for connection in self._connections.values():
            connection.go_on()
        self._report_rejections(now)

    def tell(self, state: State, now: float) -> None:
        """Tells surfaces what is new on air."""
        self._ticks += 1
        if self._ticks % NEWS_TICKS == 0:
            for place, packet in self.osc.news(state, now):
                self._send(place, packet)

    async def close(self) -> None:
        """Closes all connections; the sockets belong to the supervisor."""
        if self._server is not None:
            self._server.close()
        for connection in list(self._connections.values()):
            connection.transport.abort()

    def add(self, connection: _Connection, host: str) -> str | None:
        """Takes a connection; returns its name, None where there are too many."""
        if len(self._connections) >= MOST_CONNECTIONS:
            return None
        name = f"{host}#{next(self._names)}"
        self._connections[name] = connection
        return name

    def remove(self, name: str) -> None:
        """Forgets a connection that is closed."""
        self._connections.pop(name, None)
        self.osc.leave((name, 0))

    def wait(self, place: Place, packet: bytes) -> None:
        """Lets a packet wait for the next tick."""
        if len(self._waiting) >= MOST_WAITING:
            self._waiting.popleft()
            self.dropped += 1
        self._waiting.append((place, packet))

    @property
    def full(self) -> bool:
        """Whether connections are to send no more for now."""
        return len(self._waiting) >= MOST_WAITING // 2

    def _read_datagrams(self) -> None:
        for _ in range(MOST_READ):
            try:
                data, (host, port, *_) = self._sockets.datagrams.recvfrom(LONGEST_PACKET)
            except BlockingIOError:
                return
            except OSError:  # an answer that nobody took is told here (ICMP), once
                continue
            self.wait((host, port), data)

    def _send(self, place: Place, packet: bytes) -> None:
        name, port = place
        if port == 0:
            if name in self._connections:
                self._connections[name].send(packet)
            return
        with contextlib.suppress(OSError):  # full, or there is no way to that host
            self._sockets.datagrams.sendto(packet, place)

    def _report_rejections(self, now: float) -> None:
        """One line a second at most, however much is rejected."""
        new, newest = self.osc.rejected - self._told_rejected, self.osc.last_rejection
        if not new or newest is None or now - self._reported < REPORT_SECONDS:
            return
        more = f" ({new} were rejected)" if new > 1 else ""
        self._report(f"OSC from {newest.sender}: {newest.reason.rstrip('.')}{more}.")
        self._reported, self._told_rejected = now, self.osc.rejected


class _Connection(asyncio.Protocol):
    """A connection of TCP."""

    transport: asyncio.Transport

    def __init__(self, listener: OscListener) -> None:
        self._listener = listener
        self._framing: Framing | None = None
        self._name: str | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport
        self._name = self._listener.add(self, str(transport.get_extra_info("peername")[0]))
        if self._name is None:
            transport.abort()

    def data_received(self, data: bytes) -> None:
        if self._name is None:
            return
        self._framing = self._framing or choose_framing(data)
        try:
            packets = self._framing.feed(data)
        except OscError:
            self.transport.abort()  # where a frame ends is not known any more
            return
        for packet in packets:
            self._listener.wait((self._name, 0), packet)
        if self._listener.full:
            self.transport.pause_reading()

    def go_on(self) -> None:
        """Reads on, where that was put off."""
        if not self._listener.full and not self.transport.is_closing():
            self.transport.resume_reading()

    def send(self, packet: bytes) -> None:
        """Sends a packet in the framing of the stream; a surface that does not read misses it."""
        if self._framing is not None and self.transport.get_write_buffer_size() < UNSENT_LIMIT:
            self.transport.write(self._framing.frame(packet))

    def connection_lost(self, _: Exception | None) -> None:
        if self._name is not None:
            self._listener.remove(self._name)
