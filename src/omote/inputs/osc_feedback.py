"""What a control surface is told by OSC: all that it could have sent, as it is on air now."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from omote.inputs.character_patterns import characters_meant
from omote.inputs.osc_addresses import ADDRESSES, fill_places, find_address
from omote.inputs.osc_packet import OscError
from omote.perform.scene.character_names import ALL
from omote.show.objects.state import CharacterState, State
from omote.show.osc import ROOT, Argument, Osc

Told = Mapping[str, tuple[Argument, ...]]

QUIET_SECONDS = 0.3
"""Seconds after a surface's own message in which that address is not told to it: its fader is in a hand."""
REST = (0.0,)
DECLARED: Mapping[bool, tuple[Osc, ...]] = {
    of_show: tuple(address.declared for address in ADDRESSES if address.of_show == of_show) for of_show in (True, False)
}
"""The addresses of the whole show, and those of a character."""


def tell_state(state: State) -> dict[str, tuple[Argument, ...]]:
    """Each address with the values that it has; a channel that has no weight is left out."""
    values = _tell_all(state, f"/{ROOT}", of_show=True)
    for name, character in state.characters.items():
        values |= tell_character(character, f"/{ROOT}/{name}")
    return values


def tell_character(state: CharacterState, own: str) -> dict[str, tuple[Argument, ...]]:
    """Each address of a character, below `own`, with the values that it has: those of hands as hands hold them.

    state: the character's.
    """
    return _tell_all(state, own, of_show=False)


def _tell_all(state: State | CharacterState, own: str, *, of_show: bool) -> dict[str, tuple[Argument, ...]]:
    return {
        f"{own}/{fill_places(declared.path, names)}": declared.on_air(state, *names)
        for declared in DECLARED[of_show]
        if declared.on_air is not None
        for names in declared.reported(state)
    }


class AddressValues:
    """The values of addresses in a state, each told when it is asked for; of a pattern of characters, the first's."""

    def __init__(self, state: State | None = None) -> None:
        self._state = state
        self._told: dict[str, tuple[Argument, ...]] = {}

    def get(self, path: str, default: tuple[Argument, ...] = ()) -> tuple[Argument, ...]:
        """The values that an address (path) has; the default where there is none, or nobody of that name."""
        values = self._told.get(path)
        if values is None:
            values = self._told[path] = self._tell(path, default)
        return values

    def _tell(self, path: str, default: tuple[Argument, ...]) -> tuple[Argument, ...]:
        if self._state is None:
            return default
        channel = _channel_at(path)
        state = None if channel is None else self._state.characters.get(channel[0])
        if channel is not None and state is not None:
            return ((state if state.held is None else state.held).channels.get(channel[1], 0.0),)
        address, pattern, named = find_address(path)
        tell = address.declared.on_air
        if tell is None:
            return default
        if address.of_show:
            return tell(self._state, *named)
        who = _first_meant(pattern, self._state.characters)
        return default if who is None else tell(self._state.characters[who], *named)


def _first_meant(pattern: str, characters: Mapping[str, CharacterState]) -> str | None:
    """The first character that a pattern or a label means; None for nobody."""
    try:
        meant = characters_meant(pattern, {name: state.label for name, state in characters.items()})
    except OscError:
        return None
    return next(iter(characters)) if meant == (ALL,) else meant[0]


class Feedback:
    """What one surface was told last, so that it is told what is new alone."""

    def __init__(self) -> None:
        self._told: Told = {}
        self._sent: dict[str, float] = {}

    def note(self, address: str, now: float) -> None:
        """Notes that the surface itself has sent to an address. now: seconds of the show's clock."""
        self._sent[address] = now

    def news(self, values: Told, now: float) -> dict[str, tuple[Argument, ...]]:
        """What has changed since the last call; a channel that is gone stands at rest.

        values: of all addresses; now: seconds of the show's clock.
        """
        self._sent = {address: sent for address, sent in self._sent.items() if now - sent < QUIET_SECONDS}
        gone = {address: REST for address in self._told if address not in values and self._told[address] != REST}
        wanted = {**gone, **values}
        news = {a: v for a, v in wanted.items() if a not in self._sent and self._told.get(a) != v}
        self._told = {**self._told, **news}
        return news


@lru_cache(maxsize=1024)
def _channel_at(path: str) -> tuple[str, str] | None:
    """The character and the channel of an address; None of another address."""
    address, pattern, named = find_address(path)
    return (pattern, named[0]) if address.sets_channel else None
