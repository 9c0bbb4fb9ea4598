"""Records what a tracker sends into a capture (pcap), as it comes, until it is told to stop."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from omote.inputs.takes.packet_capture import Packet, encode_capture, encode_packet, read_packets
from omote.server.devices.trackers.tracker_sockets import TrackerWish, open_tracker

ASK_SECONDS, WAIT_SECONDS = 1.0, 0.1
LONGEST_DATAGRAM = 65507


def record_take(
    path: Path,
    wish: TrackerWish,
    *,
    seconds: float = float("inf"),
    tell: Callable[[int, str], None] = lambda *_: None,
    clock: Callable[[], float] = time.monotonic,
) -> int:
    """Records for so many seconds after the first packet, or until Ctrl-C; returns the count of packets. tell: is told
    of each second's count and of who sends; OSError where the port or the file cannot be had."""
    protocol, until, asked, told = wish.protocol, float("inf"), -ASK_SECONDS, 0.0
    count, host = 0, ""
    with open_tracker(wish) as datagrams, path.open("wb") as file:
        datagrams.settimeout(WAIT_SECONDS)
        file.write(b"".join(encode_capture(())))
        begun, port = clock(), int(datagrams.getsockname()[1])
        while (now := clock()) < until:
            if wish.phone and protocol.ask and protocol.phone_port and now - asked >= ASK_SECONDS:
                asked = now
                datagrams.sendto(protocol.ask(port), (wish.phone, protocol.phone_port))
            if count and now - told >= ASK_SECONDS:
                told = now
                tell(count, host)
            try:
                data, (host, *_) = datagrams.recvfrom(LONGEST_DATAGRAM)
            except (TimeoutError, ConnectionError):
                continue
            file.write(encode_packet(Packet(clock() - begun, host, protocol.port or port, data)))
            count += 1
            until = min(until, now + seconds)
    return count


def count_packets(path: Path) -> int:
    """The packets of a capture; none of one that holds nothing yet."""
    data = path.read_bytes()
    return len(read_packets(data)) if len(data) > len(b"".join(encode_capture(()))) else 0


def check_recordable(wish: TrackerWish) -> None:
    """ValueError for a tracker that does not come in packets of UDP."""
    if not wish.protocol.heard or wish.protocol.stream:
        raise ValueError(f"{wish.protocol.title} does not come in packets of UDP, and cannot be recorded")
