"""One universe of DMX512 from several sources: priority, sequence, merge and loss, after E1.31 and Art-Net."""

from __future__ import annotations

from dataclasses import dataclass

from omote.inputs.rejection import PacketError

LOST_SECONDS = 2.5
"""Silence after which a source counts as lost (E1.31 6.7.1); Art-Net is sent as often."""
MOST_SOURCES = 16
"""Sources of one universe; a further one is rejected."""
OLD_WITHIN = 20
"""Packets whose number is behind by less than this came late and are left out (E1.31 6.7.2); by more: a new start."""
SLOTS = 512


@dataclass
class _Source:
    priority: int
    sequence: int | None
    levels: bytes
    heard: float


class Universe:
    """Levels of one universe; they hold when the last source is lost. late: packets that came out of their order."""

    def __init__(self) -> None:
        self._sources: dict[bytes, _Source] = {}
        self._levels = b""
        self.late = 0
        self.lost = False

    def receive(
        self, source: bytes, levels: bytes, now: float, *, priority: int = 100, sequence: int | None = None
    ) -> None:
        """Takes the levels of a source. sequence: 0 to 255, None where the source does not count; PacketError for one
        source too many; levels: of slots from 1 on, 0 to 255; now: seconds; priority: 0 to 200, of which the highest
        counts."""
        self._forget_lost(now)
        sender = self._sources.get(source)
        if sender is None and len(self._sources) >= MOST_SOURCES:
            raise PacketError(f"more than {MOST_SOURCES} sources send one universe; the newest is not heard")
        if sender is not None and _is_late(sender.sequence, sequence):
            self.late += 1
            return
        self._sources[source] = _Source(priority, sequence, levels, now)
        self.lost = False

    def end(self, source: bytes, now: float) -> None:
        """Takes a source away that says that it ends. now: seconds of the same clock."""
        self._forget_lost(now)
        self._merge()
        self._sources.pop(source, None)
        self.lost = not self._sources

    def levels(self, now: float) -> bytes:
        """The levels, of the sources of the highest priority the highest each; what was there last without any."""
        self._forget_lost(now)
        self._merge()
        return self._levels

    def _forget_lost(self, now: float) -> None:
        heard = {key: sender for key, sender in self._sources.items() if now - sender.heard <= LOST_SECONDS}
        if self._sources and not heard:
            self._merge()
            self.lost = True
        self._sources = heard

    def _merge(self) -> None:
        if self._sources:
            top = max(source.priority for source in self._sources.values())
            self._levels = merge_levels([sender.levels for sender in self._sources.values() if sender.priority == top])


def merge_levels(parts: list[bytes]) -> bytes:
    """Of each slot the highest level that any part has."""
    if len(parts) == 1:
        return parts[0]
    longest = max(map(len, parts))
    return bytes(map(max, *(part.ljust(longest, b"\0") for part in parts)))


def _is_late(before: int | None, sequence: int | None) -> bool:
    if before is None or sequence is None:
        return False
    ahead = (sequence - before + 128) % 256 - 128
    return -OLD_WITHIN < ahead <= 0
