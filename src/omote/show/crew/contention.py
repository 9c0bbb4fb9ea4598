"""Whose hands move what: consoles see who else plays a control."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from omote.perform.panic import PANIC_SECONDS
from omote.show import messages as wire
from omote.show.validation import Refusal

PLAYING = wire.FadeFace, wire.FadeExpression, wire.SetChannel, wire.SetHead, wire.SetGaze
"""What a hand sends on and on while it plays, and what a panic takes out of its hands."""
MOVING = *PLAYING, wire.PlaceCharacter, wire.SetLayer, wire.SetMotion
"""What a hand sends on and on while it moves a control."""
MOVING_SECONDS = 1.0
"""Seconds after its last message for which a hand counts as moving a control."""
LONGEST_NAME = 24
"""Characters of a console's name, as a hello may have it."""
NAMELESS = "console 1"
"""What a console is called that asks for nothing, with another number where that is taken."""
AGAIN_SECONDS = 1.0
"""Seconds after which a console is told the same again: a message may be lost."""


def control_of(message: wire.Message, character: str) -> str:
    """The control of a character that a message of a hand moves: the message's tag, with the channel's name,
    or the layer's and the region's."""
    control = f"{character}/{type(message).__struct_config__.tag}"
    if isinstance(message, wire.SetLayer):
        return f"{control}:{message.layer}" if message.region is None else f"{control}:{message.layer}:{message.region}"
    return f"{control}:{message.name}" if isinstance(message, wire.SetChannel) else control


class Hands:
    """When each client last moved each control, and what each console was told of the others."""

    def __init__(self) -> None:
        self._moved: dict[str, dict[str, float]] = {}
        self._told: dict[str, tuple[dict[str, str], float]] = {}
        self._names: dict[str, str] = {}
        self._shown: dict[str, dict[str, str]] = {}
        self._changed = True
        self._oldest = math.inf  # nothing was moved before

    def note(self, who: str, message: wire.Message, characters: Iterable[str], now: float) -> None:
        """Notes that a client moved a control of some characters."""
        if isinstance(message, MOVING):
            self._note(who, [control_of(message, character) for character in characters], now)

    def note_channels(self, who: str, character: str, names: Iterable[str], now: float) -> None:
        """Notes that a client moved channels of a character."""
        start = f"{character}/{wire.SetChannel.__struct_config__.tag}:"
        self._note(who, [start + name for name in names], now)

    def _note(self, who: str, controls: Iterable[str], now: float) -> None:
        self._oldest = min(self._oldest, now)
        for control in controls:
            movers = self._moved.setdefault(control, {})
            if len(movers) != 1 or who not in movers:  # else the same hand goes on, and nobody sees anything new
                self._changed = True
            movers[who] = now

    def take_off(self, characters: Iterable[str]) -> None:
        """All hands are off these characters: panic, or they are gone."""
        gone, self._changed = set(characters), True
        self._moved = {c: movers for c, movers in self._moved.items() if c.partition("/")[0] not in gone}

    def leave(self, who: str) -> None:
        """Removes a client."""
        self._told.pop(who, None)
        self._changed = True
        for movers in self._moved.values():
            movers.pop(who, None)

    def tell(
        self, consoles: Mapping[str, str], now: float, sources: Mapping[str, str] = MappingProxyType({})
    ) -> dict[str, wire.Hands]:
        """What consoles must be told now, each of the others' hands; consoles, sources: their names, by client."""
        self._forget_old(now)
        names = {**consoles, **sources}
        if self._changed or names != self._names or self._shown.keys() != consoles.keys():
            self._shown = {who: self._others(who, names) for who in consoles}
            self._names, self._changed = names, False
        return {who: message for who in consoles if (message := self._news(who, now)) is not None}

    def _forget_old(self, now: float) -> None:
        if now - self._oldest < MOVING_SECONDS:
            return
        self._changed = True
        for control, movers in list(self._moved.items()):
            recent = {who: moved for who, moved in movers.items() if now - moved < MOVING_SECONDS}
            if recent:
                self._moved[control] = recent
            else:
                del self._moved[control]
        self._oldest = min((moved for movers in self._moved.values() for moved in movers.values()), default=math.inf)

    def _news(self, who: str, now: float) -> wire.Hands | None:
        hands = self._shown[who]
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


class Panics:
    """Who pressed panic of each character last, and when."""

    def __init__(self) -> None:
        self._pressed: dict[str, tuple[str, float]] = {}

    def press(self, who: str, characters: Iterable[str], now: float) -> None:
        """Notes a panic of some characters."""
        self._pressed |= dict.fromkeys(characters, (who, now))

    def forget(self, character: str) -> None:
        """Forgets a character that is gone: a new one may have its name."""
        self._pressed.pop(character, None)

    def any_late(self, now: float) -> bool:
        """Whether any character still settles."""
        return any(now - at < PANIC_SECONDS for _, at in self._pressed.values())

    def refuse_late(self, who: str, message: wire.Message, characters: Iterable[str], now: float) -> None:
        """Rejects what a hand at another console sent before that page could know of a panic: it would undo it."""
        if self.any_late(now) and isinstance(message, PLAYING) and self.is_late(who, characters, now):
            raise Refusal("panic was pressed at another console: all hands are off; take the control again.")

    def is_late(self, who: str, characters: Iterable[str], now: float) -> bool:
        """Whether one of these characters still settles after a panic of another client."""
        pressed = (self._pressed.get(each, (who, now)) for each in characters)
        return any(presser != who and now - at < PANIC_SECONDS for presser, at in pressed)


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
