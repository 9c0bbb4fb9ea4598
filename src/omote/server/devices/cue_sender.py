"""Sends what cues send to other programs and to MIDI devices at pages, after each tick; it never waits for anybody."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import cast

from omote.inputs.osc_packet import OscError, encode_message
from omote.inputs.page_devices.page_devices import PageDevices
from omote.interchange.formats.error_reasons import explain_error
from omote.perform.cues.cue_action import MidiSend, OscSend
from omote.server.devices.device_source import DeviceSource
from omote.server.devices.page_device_source import Send
from omote.show.cues.cue_lines import CUES
from omote.show.objects.devices import DeviceBytes
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.wire import encode

MOST_WAITING = 64
"""Packets that wait until the address of a host is found."""
MOST_TARGETS = 64


@dataclass(eq=False)
class OscTarget(asyncio.DatagramProtocol):
    """A program that cues send to, by a socket of its own, which hears that nobody is there (ICMP). The address of a
    host is found beside the ticks.

    report: says what is wrong; told: whether that was said since something arrived, or may have.
    """

    host: str
    port: int
    report: Callable[[str], None]
    told: bool = False
    waiting: list[bytes] = field(default_factory=list)
    transport: asyncio.DatagramTransport | None = None
    opening: asyncio.Task[None] | None = None
    quiet: bool = True

    def send(self, packet: bytes) -> None:
        """Sends a packet, or has it wait until the host is found."""
        if self.transport is not None:
            self.told = self.told and not self.quiet
            self.quiet = True
            self.transport.sendto(packet)
            return
        self.waiting = [*self.waiting, packet][-MOST_WAITING:]
        if self.opening is None:
            self.opening = asyncio.get_running_loop().create_task(self._open())

    async def _open(self) -> None:
        try:
            loop = asyncio.get_running_loop()
            await loop.create_datagram_endpoint(lambda: self, remote_addr=(self.host, self.port))
        except OSError as error:
            self.opening = None
            self.waiting = []
            self._tell(f"the host is not found ({explain_error(error)})")

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Sends what has waited. transport: of the socket."""
        self.transport = cast(asyncio.DatagramTransport, transport)  # that of uvloop says of itself that it is none
        for packet in self.waiting:
            self.transport.sendto(packet)
        self.waiting = []

    def error_received(self, exc: Exception) -> None:
        """Says once that what cues send does not arrive. exc: why."""
        self.quiet = False
        nobody = isinstance(exc, ConnectionRefusedError)
        self._tell("nobody hears there" if nobody else explain_error(cast(OSError, exc)))

    def _tell(self, reason: str) -> None:
        if not self.told:
            self.report(f"what cues send to {self.host}:{self.port} does not arrive: {reason}.")
        self.told = True

    def close(self) -> None:
        """Closes the socket."""
        if self.opening is not None:
            self.opening.cancel()
        if self.transport is not None:
            self.transport.close()


class CueSender(DeviceSource):
    """What sends for cues. session: the one that plays; devices: those at pages; send: sends bytes to a client, never
    waits; report: tells the crew what is wrong."""

    def __init__(
        self, session: Callable[[], ShowSession], devices: PageDevices, send: Send, report: Callable[[str], None]
    ) -> None:
        self._session = session
        self._devices = devices
        self._send = send
        self._report = report
        self._targets: dict[tuple[str, int], OscTarget] = {}
        self._absent: set[str] = set()

    def tell(self, state: State, now: float) -> None:  # noqa: ARG002  (cues say what is sent, not the state)
        """Sends what cues have sent since the last tick, and says what no voice has spoken for them.

        state: the newest; now: seconds, monotonic.
        """
        session = self._session()
        for cue, send in session.cues.take_sends():
            if isinstance(send, OscSend):
                self._send_osc(cue, send)
            else:
                self._send_midi(cue, send)
        for text, reason in session.texts.take_refused(lambda who: who == CUES):
            session.cues.reject(f"{text.message.text[:40]!r}: {reason}")

    def _send_osc(self, cue: str, send: OscSend) -> None:
        try:
            packet = encode_message(send.address, *send.arguments)
        except OscError as error:
            self._report(f"{cue} cannot send {send.address[:60]}: {error}.")
            return
        place = send.host, send.port
        if place not in self._targets and len(self._targets) >= MOST_TARGETS:
            self._targets.pop(next(iter(self._targets))).close()
        self._targets.setdefault(place, OscTarget(*place, self._report)).send(packet)

    def _send_midi(self, cue: str, send: MidiSend) -> None:
        device = self._devices.find_midi(send.device)
        if device is None:
            if send.device not in self._absent:
                self._report(f"{cue} sends MIDI to {send.device}, which is plugged in at no page of devices.")
            self._absent.add(send.device)
            return
        self._absent.discard(send.device)
        self._send(device.who, encode(DeviceBytes(device.name, send.data, cue=True)))

    async def close(self) -> None:
        """Closes all sockets."""
        for target in self._targets.values():
            target.close()
            if target.opening is not None:
                with contextlib.suppress(asyncio.CancelledError):
                    await target.opening
