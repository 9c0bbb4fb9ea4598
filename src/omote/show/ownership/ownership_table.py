"""Who owns what: one table of the parts that seats hold and want, and of the controls that hands move.

The first touch takes a free part; a foreign one is rejected until it is released. A wish for a part stands until it is
answered or taken back, or until its seat has gone.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from omote.show.ownership.parts import expression_of, regions_of

AWAY_SECONDS = 5.0
"""Seconds after its last link is gone for which a seat keeps what it holds: a reload and a restart take less."""
TOUCH_SECONDS = 15.0
"""Seconds after its last touch for which a wish of a seat without a console stands: no fader takes a wish back."""
MOVING_SECONDS = 1.0
"""Seconds after its last message for which a hand counts as moving a control."""


@dataclass(frozen=True)
class Wish:
    """A wish of a seat for a part. since: its first touch; touched: its last; seen: when its seat was here last."""

    seat: str
    key: str
    since: float
    touched: float
    seen: float


class OwnershipTable:
    """Who holds and wants which part, by the tokens of seats, and who moves which control, by client.

    on: whether leases count; manager: the seat of the stage manager; held: by part, the seat that holds it. All
    operations leave the table as it was where they raise.
    """

    def __init__(self, *, on: bool = False, manager: str = "", held: Mapping[str, str] | None = None) -> None:
        self.on = on
        self.manager = manager
        self.held: dict[str, str] = dict(held or {}) if on else {}
        self._gone: dict[str, float] = {}
        self._wishes: dict[tuple[str, str], Wish] = {}
        self.moved: dict[str, dict[str, float]] = {}
        self._oldest_move = math.inf

    def foreign(self, seat: str, keys: Iterable[str]) -> dict[str, str]:
        """What others than a seat hold of some parts (keys): by part, the holder. A region that nobody holds is its
        expression's."""
        touched = dict.fromkeys(part for key in keys for part in (key, *regions_of(key)))
        holders = {key: self.held.get(key) or self.held.get(expression_of(key), seat) for key in touched}
        return {key: holder for key, holder in holders.items() if holder != seat}

    def take(self, seat: str, keys: Iterable[str]) -> dict[str, str]:
        """Gives parts (keys) to a seat, also those of others; returns what these have lost, by part. A region that is
        taken from an expression leaves its holder the rest."""
        lost: dict[str, str] = {}
        for key in keys if self.on else ():
            whole = regions_of(key)
            lost |= {part: self.held.pop(part) for part in (key, *whole) if self.held.get(part, seat) != seat}
            self.held[key] = seat
        return lost

    def release(self, seat: str, keys: Collection[str]) -> None:
        """Frees what a seat holds of some parts (keys)."""
        self.held = {key: holder for key, holder in self.held.items() if holder != seat or key not in keys}

    def switch(self, on: bool, seat: str) -> None:
        """Switches leases on or off, by a seat: on, it becomes the stage manager where none is there."""
        if not on:
            self._wishes = {}
            self.held = {}
            self.manager = ""
        elif not self.has_manager():
            self.manager = seat
        self.on = on

    def has_manager(self) -> bool:
        """Whether the stage manager is there; one whose seat was left has no say any more."""
        return self.on and self.manager != ""

    def expire(self, present: Collection[str], characters: Collection[str], now: float) -> None:
        """Frees what seats hold that went away some seconds ago, and what characters had that are gone. present: the
        seats that have a link, or are sources; characters: of the scene; now: seconds."""
        holders = {*self.held.values(), self.manager} - {""}
        self._gone = {seat: self._gone.get(seat, now) for seat in holders if seat not in present}
        late = {seat for seat, since in self._gone.items() if now - since >= AWAY_SECONDS}
        in_scene = {*characters, "*"}
        stale = [key for key, seat in self.held.items() if seat in late or key.rpartition("/")[0] not in in_scene]
        for key in stale:
            del self.held[key]
        if self.manager in late:
            self.manager = ""

    def wishes(self) -> Iterator[Wish]:
        """All wishes, the oldest first."""
        return iter(self._wishes.values())

    def want(self, seat: str, keys: Iterable[str], now: float) -> None:
        """Notes that a seat has touched parts (keys) that others hold, at `now` (seconds)."""
        for key in keys:
            wish = self._wishes.get((seat, key), Wish(seat, key, now, now, now))
            self._wishes[seat, key] = replace(wish, touched=now, seen=now)

    def withdraw(self, seat: str, keys: Collection[str]) -> bool:
        """Takes back what a seat wants of some parts (keys); whether it wanted any."""
        before = len(self._wishes)
        self._wishes = {of: wish for of, wish in self._wishes.items() if wish.seat != seat or wish.key not in keys}
        return len(self._wishes) < before

    def answer(self, keys: Collection[str]) -> dict[str, list[str]]:
        """Ends the wishes for parts whose holder keeps them; returns who wanted which, by seat."""
        answered: dict[str, list[str]] = {}
        for wish in [wish for wish in self._wishes.values() if wish.key in keys]:
            answered.setdefault(wish.seat, []).append(wish.key)
            del self._wishes[wish.seat, wish.key]
        return answered

    def expire_wishes(self, present: Collection[str], consoles: Collection[str], now: float) -> bool:
        """Ends the wishes whose reason has gone; whether there were any.

        present, consoles: the seats that are here, and those at a console; now: seconds.
        """
        before = len(self._wishes)
        for of, wish in list(self._wishes.items()):
            seen = now if wish.seat in present else wish.seen
            silent = wish.seat in present and wish.seat not in consoles and now - wish.touched >= TOUCH_SECONDS
            if now - seen >= AWAY_SECONDS or silent or wish.key not in self.foreign(wish.seat, (wish.key,)):
                del self._wishes[of]
            else:
                self._wishes[of] = replace(wish, seen=seen)
        return len(self._wishes) < before

    def move(self, who: str, controls: Iterable[str], now: float) -> bool:
        """Notes that a client moves controls, at `now` (seconds); whether others see anything new by that. who: the
        client."""
        self._oldest_move = min(self._oldest_move, now)
        is_news = False
        for control in controls:
            movers = self.moved.get(control)
            if movers is None:
                movers = self.moved[control] = {}
            is_news = is_news or len(movers) != 1 or who not in movers
            movers[who] = now
        return is_news

    def take_off(self, characters: Iterable[str]) -> None:
        """Takes all hands off characters: panic, or they are gone."""
        gone = set(characters)
        self.moved = {c: movers for c, movers in self.moved.items() if c.partition("/")[0] not in gone}

    def let_go(self, who: str) -> None:
        """Forgets the hands of a client that has gone."""
        for movers in self.moved.values():
            movers.pop(who, None)

    def expire_moves(self, now: float) -> bool:
        """Forgets the hands that have rested since; whether it has looked at them."""
        if now - self._oldest_move < MOVING_SECONDS:
            return False
        recent = {
            control: {who: moved for who, moved in movers.items() if now - moved < MOVING_SECONDS}
            for control, movers in self.moved.items()
        }
        self.moved = {control: movers for control, movers in recent.items() if movers}
        self._oldest_move = min((at for movers in self.moved.values() for at in movers.values()), default=math.inf)
        return True
