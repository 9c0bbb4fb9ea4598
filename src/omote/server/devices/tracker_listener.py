"""Hears trackers once a tick, and asks phones for frames; never waits, whatever comes."""

from __future__ import annotations

import contextlib
import socket
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from omote.inputs.allowed_senders import THIS_MACHINE, AllowedSenders
from omote.inputs.page_devices.device_health import SourceCounts
from omote.inputs.rejection import Rejection
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TrackerProtocol, advise
from omote.server.access.show_addresses import own_address
from omote.server.devices.datagram_reader import DatagramReader
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.stream_reader import StreamReader
from omote.show.messages import State
from omote.show.session import ShowSession

HEAR_SECONDS = 0.003
"""Of a tick, for reading the packets of all trackers; what is left waits for the next, or the kernel drops it."""
ASK_SECONDS = 1.0
"""Seconds between two requests to a phone: it sends for a few seconds after each."""


@dataclass(frozen=True)
class TrackerSocket:
    """A protocol, the socket that hears it, and the address of a phone that is asked for frames, or ""."""

    protocol: TrackerProtocol
    datagrams: socket.socket
    phone: str = ""


@dataclass(eq=False)
class _Heard:
    tracker: TrackerSocket
    trackers: TrackerInput
    reader: DatagramReader
    advice: str
    told_rejected: int = 0
    asked: float = -ASK_SECONDS


class TrackerListener:
    """All trackers of one show. session: the one that plays; allowed: who may send beside the phones that are asked."""

    def __init__(
        self,
        sockets: Sequence[TrackerSocket],
        session: Callable[[], ShowSession],
        log: RejectionLog,
        allowed: AllowedSenders = THIS_MACHINE,
    ) -> None:
        self._log, host = log, own_address() or "127.0.0.1"
        self._heard = [
            _Heard(
                each,
                TrackerInput(each.protocol, session),
                _open_reader(each, allowed, log),
                advise(each.protocol, host, each.datagrams.getsockname()[1]),
            )
            for each in sockets
        ]

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of each protocol."""
        return [partial(_count, each) for each in self._heard]

    @property
    def inputs(self) -> list[TrackerInput]:
        """The trackers of each protocol."""
        return [each.trackers for each in self._heard]

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick, for a bounded time, and drives by the newest of it."""
        until = time.perf_counter() + HEAR_SECONDS
        for each in self._heard:
            for place, data in each.reader.read():
                for answer in each.trackers.receive(place[0], data, now):
                    with contextlib.suppress(OSError):  # the phone is away
                        each.reader.send(answer, place)
                if time.perf_counter() > until:
                    break
        for each in self._heard:
            each.trackers.play(now)
            self._note_rejections(each)
        self._heard.append(self._heard.pop(0))  # none of them waits for ever behind a flood
        self._log.tell(now)

    def tell(self, state: State, now: float) -> None:  # noqa: ARG002  (every source is told; phones are not)
        """Asks phones for frames."""
        for each in self._heard:
            ask, port = each.tracker.protocol.ask, each.tracker.protocol.phone_port
            if each.tracker.phone and ask is not None and port is not None and now - each.asked >= ASK_SECONDS:
                each.asked = now
                with contextlib.suppress(OSError):  # the phone is away; it is asked again
                    own = each.tracker.datagrams.getsockname()[1]
                    each.reader.send(ask(own), (each.tracker.phone, port))

    async def close(self) -> None:
        """Closes this process's copies of the sockets."""
        for each in self._heard:
            each.reader.close()

    def _note_rejections(self, each: _Heard) -> None:
        new, newest = each.trackers.rejected - each.told_rejected, each.trackers.last_rejection
        if new and newest is not None:
            self._log.note(f"{newest.sender}: {newest.reason}", new)
            each.told_rejected = each.trackers.rejected


def _open_reader(tracker: TrackerSocket, allowed: AllowedSenders, log: RejectionLog) -> DatagramReader:
    kind = StreamReader if tracker.protocol.stream else DatagramReader
    return kind(tracker.datagrams, tracker.protocol.title, allowed.with_host(tracker.phone or None), log)


def _count(each: _Heard) -> SourceCounts:
    trackers, foreign = each.trackers, each.reader.foreign
    rejection = trackers.last_rejection
    if foreign and rejection is None:
        rejection = Rejection(0.0, each.reader.foreign_host, "is not heard: --allow and its address let it play")
    return SourceCounts(
        name=trackers.protocol.title,
        kind="tracker",
        where=trackers.where,
        heard=trackers.heard,
        rejected=trackers.rejected + foreign,
        newest=trackers.newest,
        last_rejection=rejection,
        values=trackers.values(),
        advice=each.advice,
    )
