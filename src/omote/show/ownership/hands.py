"""Whose hands move what: consoles see who else plays a control."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from omote.perform.panic import PANIC_SECONDS
from omote.show.declaration import ClientMessage, tag_of
from omote.show.objects import faders as messages
from omote.show.objects.faders import SetChannel
from omote.show.ownership.ownership_table import OwnershipTable
from omote.show.validation import Refusal

AGAIN_SECONDS = 1.0
"""Seconds after which a console is told the same again: a message may be lost."""


class HandReports:
    """What each console was told of the hands of others; table: who moves what."""

    def __init__(self, table: OwnershipTable) -> None:
        self._table = table
        self._told: dict[str, tuple[dict[str, str], float]] = {}
        self._names: dict[str, str] = {}
        self._shown: dict[str, dict[str, str]] = {}
        self._changed = True

    def note(self, who: str, message: ClientMessage, characters: Iterable[str], now: float) -> None:
        """Notes that a client moved a control of some characters by a message, at `now` (seconds). who: the client."""
        if message.hand is not None:
            self._move(who, [message.control(character) for character in characters], now)

    def note_channels(self, who: str, character: str, names: Iterable[str], now: float) -> None:
        """Notes that a client moved channels (names) of a character, at `now` (seconds). who: the client."""
        start = f"{character}/{tag_of(SetChannel)}:"
        self._move(who, [start + name for name in names], now)

    def _move(self, who: str, controls: Iterable[str], now: float) -> None:
        if self._table.move(who, controls, now):
            self._changed = True

    def take_off(self, characters: Iterable[str]) -> None:
        """Takes all hands off these characters: panic, or they are gone."""
        self._changed = True
        self._table.take_off(characters)

    def leave(self, who: str) -> None:
        """Removes a client."""
        self._told.pop(who, None)
        self._changed = True
        self._table.let_go(who)

    def tell(
        self, consoles: Mapping[str, str], now: float, sources: Mapping[str, str] = MappingProxyType({})
    ) -> dict[str, messages.Hands]:
        """What consoles must be told at `now` (seconds), each of the others' hands; consoles, sources: their names, by
        client."""
        self._changed = self._table.expire_moves(now) or self._changed
        names = {**consoles, **sources}
        if self._changed or names != self._names or self._shown.keys() != consoles.keys():
            self._shown = {who: self._others(who, names) for who in consoles}
            self._names = names
            self._changed = False
        return {who: message for who in consoles if (message := self._news(who, now)) is not None}

    def _news(self, who: str, now: float) -> messages.Hands | None:
        hands = self._shown[who]
        before, told_at = self._told.get(who, ({}, now))
        if hands == before and (not hands or now - told_at < AGAIN_SECONDS):
            return None
        self._told[who] = hands, now
        return messages.Hands(hands)

    def _others(self, who: str, names: Mapping[str, str]) -> dict[str, str]:
        """By control: the name of the other console, or the source, that moved it last."""
        shown: dict[str, str] = {}
        for control, movers in self._table.moved.items():
            others = {other: moved for other, moved in movers.items() if other != who and other in names}
            if others:
                shown[control] = names[max(others, key=lambda other: others[other])]
        return shown


class Panics:
    """Who pressed panic of each character last, and when."""

    def __init__(self) -> None:
        self._pressed: dict[str, tuple[str, float]] = {}

    def press(self, who: str, characters: Iterable[str], now: float) -> None:
        """Notes a panic of some characters. who: the client that pressed; now: seconds."""
        self._pressed |= dict.fromkeys(characters, (who, now))

    def forget(self, character: str) -> None:
        """Forgets a character that is gone: a new one may have its name."""
        self._pressed.pop(character, None)

    def refuse_late(self, who: str, message: ClientMessage, characters: Iterable[str], now: float) -> None:
        """Rejects what a hand at another console sent before that page could know of a panic: it would undo it. who:
        the client; message: what it sent; characters: whom that is for; now: seconds."""
        if self._pressed and message.hand == "plays" and self.is_late(who, characters, now):
            raise Refusal("panic was pressed at another console: all hands are off; take the control again.")

    def is_late(self, who: str, characters: Iterable[str], now: float) -> bool:
        """Whether one of these characters still comes to rest after a panic of another client than `who`, at `now`
        (seconds)."""
        pressed = (self._pressed.get(character, (who, now)) for character in characters)
        return any(presser != who and now - at < PANIC_SECONDS for presser, at in pressed)
