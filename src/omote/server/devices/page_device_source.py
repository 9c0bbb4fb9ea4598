"""Devices at pages, as a source of a show: pages' messages in, once a tick, and what pages are told out."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from omote.inputs.osc_hands import OscHands
from omote.inputs.page_devices.page_devices import PageDevices
from omote.server.devices.device_source import DeviceSource
from omote.show.declaration import Outgoing
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.wire import encode

Send = Callable[[str, bytes], None]


class PageDeviceSource(DeviceSource):
    """Reads what pages have said of their devices since the last tick. send: sends bytes to a client, never waits;
    hands: what programs send of hands, None where no OSC is heard."""

    def __init__(
        self, devices: PageDevices, session: Callable[[], ShowSession], send: Send, hands: OscHands | None = None
    ) -> None:
        self.devices = devices
        self._hands = hands
        self._session = session
        self._send = send

    def hear(self, now: float) -> None:
        """Plays what has come."""
        for who, message in self._session().take_device_messages():
            self._deliver(self.devices.receive(who, message, now))
        if self._hands is not None:
            self._deliver(self.devices.play_hands(self._hands.take(), now))

    def tell(self, state: State, now: float) -> None:
        """Tells devices and pages what is on air, and pages how devices do.

        state: the newest; now: seconds, monotonic.
        """
        self._deliver(self.devices.tick(state, now))

    def _deliver(self, outgoing: Iterable[Outgoing]) -> None:
        encoded: dict[int, bytes] = {}
        for delivery in list(outgoing):  # the same message may go to many
            data = encoded.get(id(delivery.message)) or encoded.setdefault(
                id(delivery.message), encode(delivery.message)
            )
            self._send(delivery.who, data)
