"""Hears trackers once a tick, and asks phones for frames; never waits, whatever comes."""

from __future__ import annotations

import contextlib
import socket
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

from omote.inputs.allowed_senders import THIS_MACHINE, AllowedSenders
from omote.inputs.page_devices.device_health import SourceCounts, count_tracker
from omote.inputs.rejection import Rejection
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_TITLES, TrackerProtocol, advise
from omote.server.access.show_addresses import own_address
from omote.server.devices.datagram_reader import DatagramReader
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.server.devices.trackers.stream_reader import StreamReader
from omote.show.objects.state import State
from omote.show.session import ShowSession

HEAR_SECONDS = 0.003
"""Of a tick, for reading the packets of all trackers; what is left waits for the next, or the kernel drops it."""
ASK_SECONDS = 1.0
"""Seconds between two requests to a phone: it sends for a few seconds after each."""


@dataclass(frozen=True)
class TrackerSocket:
    """A protocol, the socket that hears it, and the address of a phone that is asked for frames where its protocol has
    that, and that may play in any case, or ""."""

    protocol: TrackerProtocol
    datagrams: socket.socket
    phone: str = ""


@dataclass(eq=False)
class _HeardTracker:
    tracker: TrackerSocket
    trackers: TrackerInput
    reader: DatagramReader
    advice: str
    asked: float = -ASK_SECONDS
    count: Callable[[], SourceCounts] = field(init=False)

    def __post_init__(self) -> None:
        self.count = partial(_count, self)


class TrackerListener(DeviceSource):
    """All trackers of one show. session: the one that plays; allowed: who may send beside the phones that are asked."""

    def __init__(
        self,
        sockets: Sequence[TrackerSocket],
        session: Callable[[], ShowSession],
        log: RejectionLog,
        allowed: AllowedSenders = THIS_MACHINE,
    ) -> None:
        self._log = log
        self._session = session
        self._allowed = allowed
        self._heard: list[_HeardTracker] = []
        for tracker in sockets:
            self.add(tracker)

    def add(self, tracker: TrackerSocket) -> None:
        """Hears a tracker from now on."""
        advice = advise(tracker.protocol, own_address() or "127.0.0.1", tracker.datagrams.getsockname()[1])
        reader = _open_reader(tracker, self._allowed, self._log)
        self._heard.append(
            _HeardTracker(tracker, TrackerInput(tracker.protocol, self._session, self.port), reader, advice)
        )

    def remove(self, name: str) -> None:
        """Hears a tracker no more; name: its protocol's."""
        for heard in [heard for heard in self._heard if heard.tracker.protocol.name == name]:
            self._heard.remove(heard)
            heard.trackers.leave()
            heard.reader.close()

    def port(self, name: str) -> int | None:
        """The port on which a protocol is heard; None where it is not."""
        sockets = (heard.tracker.datagrams for heard in self._heard if heard.tracker.protocol.name == name)
        return next((int(datagrams.getsockname()[1]) for datagrams in sockets), None)

    def stranger(self, name: str) -> str:
        """The host that sent last to a protocol and may not play, or ""."""
        return next((heard.reader.foreign_host for heard in self._heard if heard.tracker.protocol.name == name), "")

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of each protocol."""
        order = {title: place for place, title in enumerate(TRACKER_TITLES)}
        return [heard.count for heard in sorted(self._heard, key=lambda heard: order[heard.tracker.protocol.title])]

    @property
    def inputs(self) -> list[TrackerInput]:
        """The trackers of each protocol."""
        return [heard.trackers for heard in self._heard]

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick, for a bounded time, and drives by the newest of it."""
        until = time.perf_counter() + HEAR_SECONDS
        for heard in self._heard:
            for place, data in heard.reader.read():
                for answer in heard.trackers.receive(place[0], data, now):
                    with contextlib.suppress(OSError):  # the phone is away
                        heard.reader.send(answer, place)
                if time.perf_counter() > until:
                    break
        for heard in self._heard:
            heard.trackers.play(now)
            self._log.note_new(heard.trackers)
        self._heard = self._heard[1:] + self._heard[:1]  # none of them waits for ever behind a flood
        self._log.tell(now)

    def tell(self, state: State, now: float) -> None:  # noqa: ARG002  (every source is told; phones are not)
        """Asks phones for frames. state: the newest; now: seconds, monotonic."""
        for heard in self._heard:
            ask = heard.tracker.protocol.ask
            port = heard.tracker.protocol.phone_port
            if heard.tracker.phone and ask is not None and port is not None and now - heard.asked >= ASK_SECONDS:
                heard.asked = now
                with contextlib.suppress(OSError):  # the phone is away; it is asked again
                    own = heard.tracker.datagrams.getsockname()[1]
                    heard.reader.send(ask(own), (heard.tracker.phone, port))

    async def close(self) -> None:
        """Closes this process's copies of the sockets."""
        for heard in self._heard:
            heard.reader.close()


def _open_reader(tracker: TrackerSocket, allowed: AllowedSenders, log: RejectionLog) -> DatagramReader:
    kind = StreamReader if tracker.protocol.stream else DatagramReader
    return kind(tracker.datagrams, tracker.protocol.title, allowed.with_host(tracker.phone or None), log)


def _count(heard: _HeardTracker) -> SourceCounts:
    trackers = heard.trackers
    foreign = heard.reader.foreign
    rejection = trackers.last_rejection
    if foreign and rejection is None:
        rejection = Rejection(0.0, heard.reader.foreign_host, "is not heard: --allow and its address let it play")
    counts = count_tracker(trackers, heard.advice)
    return replace(counts, rejected=counts.rejected + foreign, last_rejection=rejection)
