"""Who wants what others hold: a wish stands until it is answered or taken back, or until its seat has gone."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, replace

from omote.show.leases.lease_table import AWAY_SECONDS

TOUCH_SECONDS = 15.0
"""Seconds after its last touch for which a wish of a seat without a console stands: no fader takes a wish back."""


@dataclass(frozen=True)
class Wish:
    """A wish of a seat for a part. since: its first touch; touched: its last; seen: when its seat was here last."""

    seat: str
    key: str
    since: float
    touched: float
    seen: float


class LeaseWishes:
    """All wishes of a show; seats are known by their tokens."""

    def __init__(self) -> None:
        self._wishes: dict[tuple[str, str], Wish] = {}

    def __iter__(self) -> Iterator[Wish]:
        return iter(self._wishes.values())

    def note(self, seat: str, keys: Iterable[str], now: float) -> None:
        """Notes that a seat has touched parts that others hold."""
        for key in keys:
            wish = self._wishes.get((seat, key), Wish(seat, key, now, now, now))
            self._wishes[seat, key] = replace(wish, touched=now, seen=now)

    def withdraw(self, seat: str, keys: Collection[str]) -> bool:
        """Takes back what a seat wants of some parts; whether it wanted any."""
        before = len(self._wishes)
        self._wishes = {of: wish for of, wish in self._wishes.items() if wish.seat != seat or wish.key not in keys}
        return len(self._wishes) < before

    def answer(self, keys: Collection[str]) -> dict[str, list[str]]:
        """Ends the wishes for parts whose holder keeps them; returns who wanted which, by seat."""
        found: dict[str, list[str]] = {}
        for wish in [each for each in self._wishes.values() if each.key in keys]:
            found.setdefault(wish.seat, []).append(wish.key)
            del self._wishes[wish.seat, wish.key]
        return found

    def clear(self) -> None:
        """Ends all wishes."""
        self._wishes = {}

    def expire(
        self, is_foreign: Callable[[str, str], bool], present: Collection[str], consoles: Collection[str], now: float
    ) -> bool:
        """Ends the wishes whose reason has gone; whether there were any. is_foreign: whether a part is another's than a
        seat's; present, consoles: the seats that are here, and those at a console."""
        before = len(self._wishes)
        for of, wish in list(self._wishes.items()):
            seen = now if wish.seat in present else wish.seen
            silent = wish.seat in present and wish.seat not in consoles and now - wish.touched >= TOUCH_SECONDS
            if now - seen >= AWAY_SECONDS or silent or not is_foreign(*of):
                del self._wishes[of]
            else:
                self._wishes[of] = replace(wish, seen=seen)
        return len(self._wishes) < before
