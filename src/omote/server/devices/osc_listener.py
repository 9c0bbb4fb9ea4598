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
from typing import TypeGuard, cast

from omote.inputs.allowed_senders import THIS_MACHINE, AllowedSenders
from omote.inputs.osc_input import Endpoint, OscInput
from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.inputs.osc_stream import Framing, choose_framing, require_packets
from omote.inputs.page_devices.device_health import SourceCounts
from omote.server.devices.datagram_reader import DatagramReader
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.show.objects.state import State

MOST_WAITING = 512
"""Packets that wait to be obeyed; the newest push the oldest out."""
OBEY_SECONDS = 0.003
"""Of a tick, for obeying messages; what is left waits for the next."""
NEWS_TICKS = 2
"""Ticks between two reports to surfaces: 30 a second."""
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
        for opened in (self.datagrams, self.connections):
            if opened is not None:
                opened.close()


class OscListener(DeviceSource):
    """OSC of one show. `dropped` counts packets that there was no time for. spoke: called when a connection sends."""

    def __init__(
        self,
        osc: OscInput,
        sockets: OscSockets,
        log: RejectionLog,
        allowed: AllowedSenders = THIS_MACHINE,
        spoke: Callable[[], None] = lambda: None,
    ) -> None:
        self.osc = osc
        self._sockets = sockets
        self._log = log
        self.spoke = spoke
        self._reader = DatagramReader(sockets.datagrams, "OSC", allowed, log)
        self._waiting: deque[tuple[Endpoint, bytes]] = deque()
        self._messages: deque[tuple[Endpoint, OscMessage]] = deque()
        self._connections: dict[str, _OscConnection] = {}
        self._names = map(str, itertools.count(1))
        self._server: asyncio.Server | None = None
        self._ticks = 0
        self.dropped = 0

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of OSC."""
        return [self._counts]

    def _counts(self) -> SourceCounts:
        osc = self.osc
        where = ""
        newest = ""
        values = dict[str, float]()
        if osc.newest is not None:
            place, message = osc.newest
            where = place[0]
            newest = f"{message.address} {' '.join(map(str, message.arguments))}".strip()
            values = {message.address[:80]: argument for argument in message.arguments[-1:] if _is_position(argument)}
        return SourceCounts(
            "OSC", "osc", where, osc.heard, osc.rejected, newest, osc.last_rejection, values, alike=osc.alike
        )

    async def start(self) -> None:
        """Accepts connections from now on."""
        if self._sockets.connections is not None:
            loop = asyncio.get_running_loop()
            self._server = await loop.create_server(lambda: _OscConnection(self), sock=self._sockets.connections)

    def hear(self, now: float) -> None:
        """Obeys what has come since the last tick, for a bounded time."""
        for place, data in self._reader.read():
            self.wait(place, data)
        until = time.perf_counter() + OBEY_SECONDS
        while (self._messages or self._waiting) and time.perf_counter() < until:
            for other, answer in self._go_on(now):
                self._send(other, answer)
        for connection in self._connections.values():
            connection.go_on()
        self._note_rejections(now)

    def _go_on(self, now: float) -> list[tuple[Endpoint, bytes]]:
        """Obeys one message, or decodes one packet: either takes a small part of a tick."""
        if self._messages:
            return self.osc.obey(*self._messages.popleft(), now)
        place, packet = self._waiting.popleft()
        messages, answers = self.osc.read(place, packet, now)
        self._messages.extend((place, message) for message in messages)
        return answers

    def tell(self, state: State, now: float) -> None:
        """Tells surfaces what is new on air. state: the newest; now: seconds, monotonic."""
        self._ticks += 1
        if self._ticks % NEWS_TICKS == 0:
            for place, packet in self.osc.news(state, now):
                self._send(place, packet)

    async def close(self) -> None:
        """Closes all connections, and this process's copies of the sockets."""
        if self._server is not None:
            self._server.close()
        for connection in list(self._connections.values()):
            connection.transport.abort()
        self._sockets.close()

    def add(self, connection: _OscConnection, host: str) -> str | None:
        """Takes a connection; returns its name, None where there are too many, or its host may not play."""
        if not self._reader.hears(host) or len(self._connections) >= MOST_CONNECTIONS:
            return None
        name = f"{host}#{next(self._names)}"
        self._connections[name] = connection
        return name

    def remove(self, name: str) -> None:
        """Forgets a connection that is closed."""
        self._connections.pop(name, None)
        self.osc.leave((name, 0))

    def reject(self, name: str, error: OscError) -> None:
        """Forgets a connection whose stream cannot be read on, and notes why. name: its own; error: the reason."""
        self._log.note(f"OSC from {name.partition('#')[0]}: {error}")
        self.remove(name)

    def wait(self, place: Endpoint, packet: bytes) -> None:
        """Lets a packet wait for the next tick. place: where it came from; packet: its bytes."""
        if len(self._waiting) >= MOST_WAITING:
            self._waiting.popleft()
            self.dropped += 1
        self._waiting.append((place, packet))

    @property
    def full(self) -> bool:
        """Whether connections are to send no more for now."""
        return len(self._waiting) >= MOST_WAITING // 2

    def _send(self, place: Endpoint, packet: bytes) -> None:
        name, port = place
        if port == 0:
            if name in self._connections:
                self._connections[name].send(packet)
            return
        with contextlib.suppress(OSError):  # full, or there is no way to that host
            self._sockets.datagrams.sendto(packet, place)

    def _note_rejections(self, now: float) -> None:
        self._log.note_new(self.osc, "OSC from ")
        self._log.tell(now)


def _is_position(value: Argument) -> TypeGuard[float]:
    return isinstance(value, float) and 0.0 <= value <= 1.0


class _OscConnection(asyncio.Protocol):
    """A connection of TCP."""

    transport: asyncio.Transport

    def __init__(self, listener: OscListener) -> None:
        self._listener = listener
        self._framing: Framing | None = None
        self._name: str | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = cast(asyncio.Transport, transport)  # that of uvloop says of itself that it is none
        self._name = self._listener.add(self, str(transport.get_extra_info("peername")[0]))
        if self._name is None:
            self.transport.abort()

    def data_received(self, data: bytes) -> None:
        if self._name is None:
            return
        try:
            self._framing = self._framing or choose_framing(data)
            packets = require_packets(self._framing.feed(data))
        except OscError as error:
            self._listener.reject(self._name, error)
            self.transport.abort()  # where a frame ends is not known any more, or the sender speaks something else
            self._name = None
            return
        for packet in packets:
            self._listener.wait((self._name, 0), packet)
            self._listener.spoke()
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
