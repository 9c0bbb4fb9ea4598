"""Reads what has come to a socket of datagrams, without waiting, from those who may play."""

from __future__ import annotations

import socket
import time
from collections.abc import Iterator

from omote.inputs.allowed_senders import AllowedSenders
from omote.server.devices.rejection_log import RejectionLog

READ_SECONDS = 0.002
"""Of a tick, for reading datagrams; beyond, the kernel keeps or drops them."""
LONGEST_DATAGRAM = 65507
"""Bytes: what UDP over IPv4 carries at most."""


class DatagramReader:
    """Datagrams of one socket. what: the protocol, as people read it; foreign: the count of those not heard, of
    which the newest came from `foreign_host`."""

    def __init__(self, datagrams: socket.socket, what: str, allowed: AllowedSenders, log: RejectionLog) -> None:
        self.socket = datagrams
        self._what = what
        self._allowed = allowed
        self._log = log
        self.foreign = 0
        self.foreign_host = ""
        datagrams.setblocking(False)

    def read(self) -> Iterator[tuple[tuple[str, int], bytes]]:
        """What has come: the sender's host and port, and the bytes."""
        until = time.perf_counter() + READ_SECONDS
        while time.perf_counter() < until:
            try:
                data, (host, port, *_) = self.socket.recvfrom(LONGEST_DATAGRAM)
            except BlockingIOError:
                return
            except OSError:  # an answer that nobody took is told here (ICMP), once
                continue
            if self.hears(host):
                yield (host, port), data

    def send(self, packet: bytes, place: tuple[str, int]) -> None:
        """Sends a packet to a host and port; OSError where that cannot be. place: the host and the port."""
        self.socket.sendto(packet, place)

    def close(self) -> None:
        """Closes the socket."""
        self.socket.close()

    def hears(self, host: str) -> bool:
        """Whether a host may play; who may not is counted and named."""
        if self._allowed.allows(host):
            return True
        self.foreign = self.foreign + 1
        self.foreign_host = host
        self._log.note(f"{self._what} from {host} is not heard: --allow {host} lets it play")
        return False
