"""Devices at pages, as a source of a show: pages' messages in, once a tick, and what pages are told out."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from omote.inputs.page_devices.device_health import SourceCounts
from omote.inputs.page_devices.page_devices import PageDevices
from omote.show.messages import State
from omote.show.outgoing import Outgoing
from omote.show.session import ShowSession
from omote.show.wire import encode

Send = Callable[[str, bytes], None]


class PageDeviceSource:
    """Reads what pages have said of their devices since the last tick. send: sends bytes to a client, never waits."""

    def __init__(self, devices: PageDevices, session: Callable[[], ShowSession], send: Send) -> None:
        self.devices, self._session, self._send = devices, session, send

    def hear(self, now: float) -> None:
        """Plays what has come."""
        for who, message in self._session().take_device_messages():
            self._deliver(self.devices.receive(who, message, now))

    def tell(self, state: State, now: float) -> None:
        """Tells devices and pages what is on air, and pages how devices do."""
        self._deliver(self.devices.tick(state, now))

    @property
    def probes(self) -> list[Callable[[], SourceCounts]]:
        """None: it tells of its devices itself."""
        return []

    async def close(self) -> None:
        """There is nothing to close."""

    def _deliver(self, outgoing: Iterable[Outgoing]) -> None:
        encoded: dict[int, bytes] = {}
        for each in list(outgoing):  # the same message may go to many
            data = encoded.get(id(each.message)) or encoded.setdefault(id(each.message), encode(each.message))
            self._send(each.who, data)
