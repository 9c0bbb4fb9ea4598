"""Records what a tracker sends into a capture (pcap), as it comes, until it is told to stop."""

from __future__ import annotations

import contextlib
import errno
import os
import socket
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from omote.inputs.takes.packet_capture import Packet, encode_capture, encode_packet
from omote.server.devices.trackers.tracker_sockets import TrackerWish, open_tracker

ASK_SECONDS = 1.0
WAIT_SECONDS = 0.1
LONGEST_DATAGRAM = 65507
"""Bytes: what UDP over IPv4 carries at most."""


def record_take(
    path: Path,
    wish: TrackerWish,
    *,
    seconds: float = float("inf"),
    opened: Callable[[int], None] = lambda _: None,
    tell: Callable[[int, str, float], None] = lambda *_: None,
    clock: Callable[[], float] = time.monotonic,
) -> int:
    """Records for so many seconds after the first packet, or until Ctrl-C; returns the count of packets. The file is
    written from the first packet on. opened: is told of the port once it is heard; tell: each second of the count, of
    who sends, and of the seconds since the newest; OSError where the port or the file cannot be had.

    path: of the capture; wish: which tracker, and where; seconds: how long; clock: seconds, monotonic.
    """
    until = float("inf")
    told_at = float("-inf")
    count = 0
    _check_place(path)
    with contextlib.suppress(KeyboardInterrupt), open_tracker(wish) as datagrams, contextlib.ExitStack() as stack:
        begun = newest = clock()
        host = ""
        write = None
        opened(int(datagrams.getsockname()[1]))
        for now, packet in _hear(wish, datagrams, clock):
            if now >= until:
                break
            if now - told_at >= ASK_SECONDS:
                told_at = now
                tell(count, host, now - newest)
            if packet is None:
                continue
            if write is None:
                write = stack.enter_context(path.open("wb", buffering=0)).write  # whatever ends it, packets are there
                write(b"".join(encode_capture(())))
            host = packet.host
            newest = now
            write(encode_packet(replace(packet, time=packet.time - begun)))
            count += 1
            until = min(until, now + seconds)
    return count


def _hear(
    wish: TrackerWish, datagrams: socket.socket, clock: Callable[[], float]
) -> Iterator[tuple[float, Packet | None]]:
    """What comes, without end, and when; None where nothing came for a moment. A phone is asked once a second."""
    protocol = wish.protocol
    port = int(datagrams.getsockname()[1])
    asked = -ASK_SECONDS
    datagrams.settimeout(WAIT_SECONDS)
    while True:
        now = clock()
        if wish.phone and protocol.ask and protocol.phone_port and now - asked >= ASK_SECONDS:
            asked = now
            datagrams.sendto(protocol.ask(port), (wish.phone, protocol.phone_port))
        try:
            data, (host, *_) = datagrams.recvfrom(LONGEST_DATAGRAM)
        except (TimeoutError, ConnectionError):
            yield now, None
            continue
        yield now, Packet(clock(), host, protocol.port or port, data)


def _check_place(path: Path) -> None:
    """OSError where no file can be written there; nothing is written."""
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(path.parent))
    if not os.access(path if path.exists() else path.parent, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))


def check_recordable(wish: TrackerWish) -> None:
    """Rejects, by ValueError, a tracker that does not come in packets of UDP."""
    if not wish.protocol.heard or wish.protocol.stream:
        raise ValueError(f"{wish.protocol.title} does not come in packets of UDP, and cannot be recorded")
