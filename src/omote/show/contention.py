"""Whose hands move what: consoles see who else plays a control."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType

from omote.show import messages as wire

MOVING = wire.FadeFace, wire.FadeExpression, wire.SetChannel, wire.SetHead, wire.SetGaze
"""What a hand sends on and on while it moves a control."""
MOVING_SECONDS = 1.0
"""Seconds after its last message for which a hand counts as moving a control."""
LONGEST_NAME = 24
"""Characters of a console's name, as a hello may have it."""
NAMELESS = "console 1"
"""What a console is called that asks for nothing, with another number where that is taken."""
AGAIN_SECONDS = 1.0
"""Seconds after which a console is told the same again: a message may be lost."""


def control_of(message: wire.Message) -> str:
    """The control that a message of a hand moves: its tag, with the channel's name."""
    tag = str(type(message).__struct_config__.tag)
    return f"{tag}:{message.name}" if isinstance(message, wire.SetChannel) else tag


class Hands:
    """When each client last moved each control, and what each console was told of the others."""

    def __init__(self) -> None:
        self._moved: dict[str, dict[str, float]] = {}
        self._told: dict[str, tuple[dict[str, str], float]] = {}

    def note(self, who: str, message: wire.Message, now: float) -> None:
        """Notes that a client moved a control."""
        if isinstance(message, MOVING):
            self._moved.setdefault(control_of(message), {})[who] = now

    def take_off(self) -> None:
        """All hands are off: panic."""
        self._moved.clear()

    def leave(self, who: str) -> None:
        """Removes a client."""
        self._told.pop(who, None)
        for movers in self._moved.values():
            movers.pop(who, None)

    def tell(
        self, consoles: Mapping[str, str], now: float, sources: Mapping[str, str] = MappingProxyType({})
    ) -> dict[str, wire.Hands]:
        """What consoles must be told now, each of the others' hands; consoles, sources: their names, by client."""
        self._forget_old(now)
        names = {**consoles, **sources}
        return {who: message for who in consoles if (message := self._news(who, names, now)) is not None}

    def _forget_old(self, now: float) -> None:
        for control, movers in list(self._moved.items()):
            recent = {who: moved for who, moved in movers.items() if now - moved < MOVING_SECONDS}
            if recent:
                self._moved[control] = recent
            else:
                del self._moved[control]

    def _news(self, who: str, names: Mapping[str, str], now: float) -> wire.Hands | None:
        hands = self._others(who, names)
        before, told = self._told.get(who, ({}, now))
        if hands == before and (not hands or now - told < AGAIN_SECONDS):
            return None
        self._told[who] = hands, now
        return wire.Hands(hands)

    def _others(self, who: str, names: Mapping[str, str]) -> dict[str, str]:
        """By control: the name of the other console, or the source, that moved it last."""
        found: dict[str, str] = {}
        for control, movers in self._moved.items():
            others = {other: moved for other, moved in movers.items() if other != who and other in names}
            if others:
                found[control] = names[max(others, key=lambda other: others[other])]
        return found


def name_apart(consoles: Mapping[str, tuple[str, bool]], who: str) -> dict[str, str]:
    """The names of a console that comes, and of one that gives way to it; consoles: by client, what each is called or
    wants to be, and whether it asked for that. A name that somebody asks for is taken from one that was given it."""
    wanted, asks = consoles[who]
    same = [other for other, (name, _) in consoles.items() if name.casefold() == wanted.casefold()]
    yields = [other for other in same if other != who and asks and not consoles[other][1]]
    names = {other: name for other, (name, _) in consoles.items() if other not in (who, *yields)}
    for each in (who, *yields):
        taken = {name.casefold() for name in names.values()}
        names[each] = free_name(consoles[each][0] or NAMELESS, taken)
    return {each: names[each] for each in (who, *yields)}


def free_name(wanted: str, taken: set[str]) -> str:
    """The name of a console: the one wanted, else the lowest number beside its words that makes it its own."""
    words = re.sub(r"(?<=\S) \d+$", "", wanted)
    room = LONGEST_NAME - len(f" {len(taken) + 3}")
    numbered = (f"{words[:room]} {number}" for number in range(2, len(taken) + 4))
    return next(name for name in (wanted, *numbered) if name.casefold() not in taken)
