"""sACN and Art-Net at a show: packets and times in, readings of the slots that are bound out."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice

from omote.inputs.dmx.artnet_packet import ArtDmx, ArtPoll, decode_artnet, encode_poll_replies
from omote.inputs.dmx.dmx_universe import SLOTS, Universe
from omote.inputs.dmx.sacn_packet import SacnPacket, decode_sacn
from omote.inputs.reading import Reading
from omote.inputs.rejection import PacketError, Rejection

SACN = "sACN"
ARTNET = "Art-Net"
"""The devices whose controls are `universe/slot`, both as a lighting desk shows them; slots begin at 1."""
FULL = 255.0


@dataclass
class DmxCounts:
    """Packets of one protocol: how many were heard and rejected, the newest, the last rejection, and from where."""

    heard: int = 0
    rejected: int = 0
    host: str = ""
    newest: str = ""
    last_rejection: Rejection | None = None


class DmxInput:
    """Universes of both protocols. counts: of each.

    sacn: the universes that are heard by sACN; of Art-Net, and for readings, those that `watch` names.
    """

    def __init__(self, sacn: Iterable[int] = ()) -> None:
        self._universes = {(SACN, number): Universe() for number in sacn}
        self._watched: dict[tuple[str, int], dict[int, int | None]] = {}
        self._told_lost: set[tuple[str, int]] = set()
        self.counts = {SACN: DmxCounts(), ARTNET: DmxCounts()}

    @property
    def heard(self) -> int:
        """The count of packets of both protocols."""
        return sum(packets.heard for packets in self.counts.values())

    @property
    def rejected(self) -> int:
        """The count of those that were rejected."""
        return sum(packets.rejected for packets in self.counts.values())

    @property
    def last_rejection(self) -> Rejection | None:
        """The newest of these."""
        rejections = (packets.last_rejection for packets in self.counts.values() if packets.last_rejection is not None)
        return max(rejections, key=lambda rejection: rejection.time, default=None)

    def values_of(self, device: str) -> dict[str, float]:
        """Where the watched slots of a protocol stand, sixty-four at most."""
        slots = (
            (f"{number}/{slot}", level)
            for (name, number), watched_slots in self._watched.items()
            for slot, level in watched_slots.items()
            if name == device and level is not None
        )
        return {control: level / FULL for control, level in islice(slots, 64)}

    def watch(self, controls: Iterable[tuple[str, str]]) -> None:
        """Reads these controls from now on, each a device and a control; those of other devices are left out. One that
        was watched already is read when it moves next."""
        before = self._watched
        self._watched = {}
        for device, control in controls:
            if device in (SACN, ARTNET):
                universe, slot = read_control(control)
                stood = before.get((device, universe), {}).get(slot)
                self._watched.setdefault((device, universe), {})[slot] = stood
                if device == ARTNET:
                    self._universes.setdefault((device, universe), Universe())

    def receive_sacn(self, host: str, data: bytes, now: float) -> None:
        """Takes a packet (data) of sACN from a host. now: seconds of the show's clock."""
        self._count(SACN, host)
        try:
            packet = decode_sacn(data)
            if packet is not None and packet.start_code == 0 and not packet.preview:
                self._take_sacn(packet, now)
                self.counts[SACN].newest = f"universe {packet.universe}, {len(packet.slots)} slots"
        except PacketError as error:
            self.reject(SACN, f"{SACN} from {host}", str(error), now)

    def receive_artnet(self, host: str, data: bytes, now: float, own: str) -> list[bytes]:
        """Takes a packet (data) of Art-Net from a host; returns what is answered. now: seconds of the show's clock;
        own: this node's address."""
        self._count(ARTNET, host)
        try:
            packet = decode_artnet(data)
            if isinstance(packet, ArtPoll):
                return encode_poll_replies(own, [number for device, number in self._universes if device == ARTNET])
            if isinstance(packet, ArtDmx) and (ARTNET, packet.universe) in self._universes:
                universe = self._universes[ARTNET, packet.universe]
                universe.receive(host.encode(), packet.slots, now, sequence=packet.sequence or None)
                self.counts[ARTNET].newest = f"universe {packet.universe}, {len(packet.slots)} slots"
        except PacketError as error:
            self.reject(ARTNET, f"{ARTNET} from {host}", str(error), now)
        return []

    def take_readings(self, now: float) -> list[Reading]:
        """The watched slots whose levels are others than at the last call."""
        readings = []
        for (device, number), slots in self._watched.items():
            universe = self._universes.get((device, number))
            levels = b"" if universe is None else universe.levels(now)
            for slot, before in slots.items():
                if slot <= len(levels) and levels[slot - 1] != before:
                    slots[slot] = levels[slot - 1]
                    readings.append(Reading(device, f"{number}/{slot}", levels[slot - 1] / FULL))
        return readings

    def take_lost(self, now: float) -> list[str]:
        """The universes that have lost their last source since the last call, in words."""
        for universe in self._universes.values():
            universe.levels(now)
        lost = {key for key, universe in self._universes.items() if universe.lost}
        new = sorted(lost - self._told_lost)
        self._told_lost = lost
        return [f"{device} universe {number} has lost its source; its last levels hold" for device, number in new]

    def _take_sacn(self, packet: SacnPacket, now: float) -> None:
        universe = self._universes.get((SACN, packet.universe))
        if universe is None:
            heard = ", ".join(str(number) for device, number in self._universes if device == SACN) or "none"
            raise PacketError(f"universe {packet.universe} came; heard are {heard} (--sacn)")
        if packet.terminated:
            universe.end(packet.source, now)
        else:
            universe.receive(packet.source, packet.slots, now, priority=packet.priority, sequence=packet.sequence)

    def reject(self, device: str, sender: str, reason: str, now: float) -> None:
        """Counts what was not obeyed.

        device: the protocol; sender: who sent it, in words; reason: why; now: seconds of the show's clock.
        """
        self.counts[device].rejected += 1
        self.counts[device].last_rejection = Rejection(now, sender, reason)

    def _count(self, device: str, host: str) -> None:
        self.counts[device].heard += 1
        self.counts[device].host = host


def read_control(text: str) -> tuple[int, int]:
    """The universe and the slot that a control's name says; ValueError where it says none."""
    universe, slash, slot = text.partition("/")
    if not (slash and universe.isdecimal() and slot.isdecimal() and universe.isascii() and slot.isascii()):
        raise ValueError(f"{text[:40]!r} is no slot of DMX; expected universe/slot, such as 1/17")
    number = int(universe[:9])
    place = int(slot[:9])
    if not 1 <= place <= SLOTS:
        raise ValueError(f"slot {place} of {text[:40]!r} does not exist; expected 1 to {SLOTS}")
    return number, place
