"""Hears sACN and Art-Net once a tick; never waits, whatever comes."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import Callable
from functools import partial

from omote.inputs.allowed_senders import THIS_MACHINE, AllowedSenders
from omote.inputs.bindings.binding_input import BindingInput
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.dmx.artnet_packet import ARTNET_PORT
from omote.inputs.dmx.dmx_input import ARTNET, SACN, DmxInput
from omote.inputs.page_devices.device_health import SourceCounts
from omote.inputs.reading import Reading
from omote.server.devices.datagram_reader import DatagramReader
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.rejection_log import RejectionLog
from omote.show.objects.bindings import SourceKind
from omote.show.objects.state import State

LOST_TICKS = 30
"""Ticks between two looks for sources that are lost."""


class DmxListener(DeviceSource):
    """sACN and Art-Net of one show. bindings: play what is read; sacn, artnet: sockets, None where not heard."""

    def __init__(
        self,
        dmx: DmxInput,
        bindings: BindingInput,
        log: RejectionLog,
        *,
        sacn: socket.socket | None = None,
        artnet: socket.socket | None = None,
        allowed: AllowedSenders = THIS_MACHINE,
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        self.dmx = dmx
        self.bindings = bindings
        self._log = log
        self._report = report
        self._sacn = None if sacn is None else DatagramReader(sacn, SACN, allowed, log)
        self._artnet = None if artnet is None else DatagramReader(artnet, ARTNET, allowed, log)
        self._watched: tuple[Binding, ...] | None = None
        self._ticks = 0

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """How pages are told of each protocol that is heard."""
        heard: list[tuple[DatagramReader | None, str, SourceKind]] = [
            (self._sacn, SACN, "sacn"),
            (self._artnet, ARTNET, "artnet"),
        ]
        return [partial(self._counts, name, kind) for reader, name, kind in heard if reader is not None]

    def _counts(self, name: str, kind: SourceKind) -> SourceCounts:
        counts = self.dmx.counts[name]
        return SourceCounts(
            name=name,
            kind=kind,
            where=counts.host,
            heard=counts.heard,
            rejected=counts.rejected,
            newest=counts.newest,
            last_rejection=counts.last_rejection,
            values=self.dmx.values_of(name),
        )

    def hear(self, now: float) -> None:
        """Takes what has come since the last tick, for a bounded time."""
        for (host, _), data in self._sacn.read() if self._sacn else ():
            self.dmx.receive_sacn(host, data, now)
        for place, data in self._artnet.read() if self._artnet else ():
            self._take_artnet(place, data, now)
        if self._watched is not (controls := self.bindings.bindings.bindings):
            self._watched = controls
            self.dmx.watch(self.bindings.bindings.controls)
        self._play(self.dmx.take_readings(now), now)
        self._note_rejections(now)

    def tell(self, state: State, now: float) -> None:
        """Notes what is on air, and says which universes have lost their sources.

        state: the newest; now: seconds, monotonic.
        """
        self.bindings.note_state(state)
        self._ticks += 1
        if self._ticks % LOST_TICKS == 0:
            for sentence in self.dmx.take_lost(now):
                self._report(f"{sentence}.")

    async def close(self) -> None:
        """Closes this process's copies of the sockets."""
        for reader in (self._sacn, self._artnet):
            if reader is not None:
                reader.socket.close()

    def _take_artnet(self, place: tuple[str, int], data: bytes, now: float) -> None:
        assert self._artnet is not None
        for answer in self.dmx.receive_artnet(place[0], data, now, _own_address(place)):
            for port in {place[1], ARTNET_PORT}:  # some ask from another port than they listen at
                with contextlib.suppress(OSError):
                    self._artnet.socket.sendto(answer, (place[0], port))

    def _play(self, readings: list[Reading], now: float) -> None:
        before = self.bindings.osc.rejected
        self.bindings.hear(readings, now)
        newest = self.bindings.osc.last_rejection
        if self.bindings.osc.rejected > before and newest is not None and newest.sender in self.dmx.counts:
            self.dmx.reject(newest.sender, newest.sender, newest.reason, now)

    def _note_rejections(self, now: float) -> None:
        self._log.note_new(self.dmx)
        self._log.tell(now)


def _own_address(place: tuple[str, int]) -> str:
    """This machine's address as another host sees it; nothing is sent."""
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.connect(place)
            return str(probe.getsockname()[0])
    except OSError:  # there is no way to it, or no descriptor left
        return "0.0.0.0"
