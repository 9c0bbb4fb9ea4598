"""Reads what trackers send over TCP, without waiting, from those who may play: packets, as datagrams are."""

from __future__ import annotations

import contextlib
import socket
import time
from collections.abc import Iterator
from dataclasses import dataclass, field

from omote.inputs.allowed_senders import AllowedSenders
from omote.inputs.rejection import PacketError
from omote.inputs.trackers.face_motion.face_stream import FaceStream
from omote.server.devices.datagram_reader import READ_SECONDS, DatagramReader
from omote.server.devices.rejection_log import RejectionLog

MOST_CONNECTIONS = 8
"""Of one tracker; the oldest makes room: a phone that comes again has left the one before open."""
READ_BYTES = 65536

Endpoint = tuple[str, int]


@dataclass
class _StreamConnection:
    socket: socket.socket
    stream: FaceStream = field(default_factory=FaceStream)


class StreamReader(DatagramReader):
    """Packets of the connections of one listening socket. what: the protocol, as people read it."""

    def __init__(self, listening: socket.socket, what: str, allowed: AllowedSenders, log: RejectionLog) -> None:
        super().__init__(listening, what, allowed, log)
        self._connections: dict[Endpoint, _StreamConnection] = {}
        self._asking = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._asking.setblocking(False)

    def read(self) -> Iterator[tuple[Endpoint, bytes]]:
        """What has come: the sender's host and port, and a packet."""
        self._accept()
        until = time.perf_counter() + READ_SECONDS
        for place, connection in list(self._connections.items()):
            while time.perf_counter() < until:
                packets = self._receive(place, connection)
                if packets is None:
                    break
                yield from ((place, packet) for packet in packets)

    def send(self, packet: bytes, place: Endpoint) -> None:
        """Answers by the connection that came from a place; where there is none, asks there over UDP.

        packet: its bytes; place: host and port.
        """
        connection = self._connections.get(place)
        if connection is None:
            self._asking.sendto(packet, place)
        else:
            connection.socket.send(packet)

    def close(self) -> None:
        """Closes all connections."""
        for place in list(self._connections):
            self._drop(place)
        self._asking.close()
        super().close()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):  # nobody comes, or has gone already
            while True:
                connection, (host, port, *_) = self.socket.accept()
                if not self.hears(host):
                    connection.close()
                    continue
                while len(self._connections) >= MOST_CONNECTIONS:
                    self._drop(next(iter(self._connections)))
                connection.setblocking(False)
                self._connections[host, port] = _StreamConnection(connection)

    def _receive(self, place: Endpoint, connection: _StreamConnection) -> list[bytes] | None:
        """The packets of what has come; None where nothing has. What cannot be read on is closed."""
        try:
            data = connection.socket.recv(READ_BYTES)
            if data:
                return connection.stream.feed(data)
        except BlockingIOError:
            return None
        except PacketError as error:
            self._log.note(f"{self._what} from {place[0]}: {error}")
        except OSError:  # it has been cut
            pass
        self._drop(place)
        return None

    def _drop(self, place: Endpoint) -> None:
        self._connections.pop(place).socket.close()
