"""Who holds which part: the first touch takes a free one, a foreign one is rejected until it is released."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from omote.show.leases.leased_parts import expression_of, regions_of

AWAY_SECONDS = 5.0
"""Seconds after its last link is gone for which a seat keeps what it holds: a reload and a restart take less."""


class LeaseTable:
    """Who holds what, by part; seats are known by their tokens. on: whether leases count; manager: the stage manager.

    All operations leave the table as it was where they raise.
    """

    def __init__(self, *, on: bool = False, manager: str = "", held: Mapping[str, str] | None = None) -> None:
        self.on, self.manager = on, manager
        self.held: dict[str, str] = dict(held or {}) if on else {}
        self._gone: dict[str, float] = {}

    def foreign(self, seat: str, keys: Iterable[str]) -> dict[str, str]:
        """What others hold of some parts: by part, the holder. A region that nobody holds is its expression's."""
        touched = dict.fromkeys(each for key in keys for each in (key, *regions_of(key)))
        holders = {key: self.held.get(key) or self.held.get(expression_of(key), seat) for key in touched}
        return {key: holder for key, holder in holders.items() if holder != seat}

    def take(self, seat: str, keys: Iterable[str]) -> dict[str, str]:
        """Gives parts to a seat, also those of others; returns what these have lost, by part.

        A region that is taken from an expression leaves its holder the rest.
        """
        lost: dict[str, str] = {}
        for key in keys if self.on else ():
            whole = regions_of(key)
            lost |= {each: self.held.pop(each) for each in (key, *whole) if self.held.get(each, seat) != seat}
            self.held[key] = seat
        return lost

    def release(self, seat: str, keys: Collection[str]) -> None:
        """Frees what a seat holds of some parts."""
        self.held = {key: holder for key, holder in self.held.items() if holder != seat or key not in keys}

    def switch(self, on: bool, seat: str) -> None:
        """Switches leases on or off, by a seat: on, it becomes the stage manager where none is there."""
        if not on:
            self.held, self.manager = {}, ""
        elif not self.has_manager():
            self.manager = seat
        self.on = on

    def has_manager(self) -> bool:
        """Whether the stage manager is there; one whose seat was left has no say any more."""
        return self.on and self.manager != ""

    def expire(self, present: Collection[str], characters: Collection[str], now: float) -> None:
        """Frees what seats hold that went away some seconds ago, and what characters had that are gone.

        present: the seats that have a link, or are sources.
        """
        holders = {*self.held.values(), self.manager} - {""}
        self._gone = {seat: self._gone.get(seat, now) for seat in holders if seat not in present}
        late = {seat for seat, since in self._gone.items() if now - since >= AWAY_SECONDS}
        known = {*characters, "*"}
        stale = [key for key, seat in self.held.items() if seat in late or key.rpartition("/")[0] not in known]
        for key in stale:
            del self.held[key]
        if self.manager in late:
            self.manager = ""
