"""What a control surface is told by OSC: all that it could have sent, as it is on air now."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache

from omote.inputs.addresses.address import ROOT
from omote.inputs.addresses.character_patterns import characters_meant
from omote.inputs.osc_addresses import CHANNEL, find_address
from omote.inputs.osc_packet import Argument, OscError
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, LAYER_PARTS
from omote.perform.scene.character_names import ALL
from omote.show.messages import CallState, CharacterState, HeldState, Place, State

Told = Mapping[str, tuple[Argument, ...]]

QUIET_SECONDS = 0.3
"""Seconds after a surface's own message in which that address is not told to it: its fader is in a hand."""
REST = (0.0,)
SWITCH = "layer_on/{name}"
FIRST_INFLUENCES: Mapping[str, list[float]] = {
    layer: [each.influence[part] for part in LAYER_PARTS] for layer, each in DEFAULT_SETTINGS.items()
}
"""The influences of layers that are as at first."""
NO_INFLUENCE = [0.0] * len(LAYER_PARTS)
PART_PLACES: Mapping[str, int] = {part: place for place, part in enumerate(LAYER_PARTS)}


def tell_state(state: State) -> dict[str, tuple[Argument, ...]]:
    """Each address with the values that it has; a channel that has no weight is left out."""
    told: dict[str, tuple[Argument, ...]] = {f"/{ROOT}/{path}": tell(state) for path, tell in OF_SHOW.items()}
    for name, character in state.characters.items():
        told |= tell_character(character, f"/{ROOT}/{name}")
    return told


def tell_character(state: CharacterState, own: str) -> dict[str, tuple[Argument, ...]]:
    """Each address of a character, below `own`, with the values that it has: those of hands as hands hold them."""
    told = {f"{own}/{path}": tell(state) for path, tell in OF_CHARACTER.items()}
    told |= {f"{own}/expression/{region}": (name,) for region, name in _named_in_regions(state).items()}
    for layer, each in state.layers.items():
        told |= {f"{own}/layer/{layer}": (max(each.influence),), f"{own}/layer_on/{layer}": (float(each.on),)}
    return told | {f"{own}/channel/{name}": (weight,) for name, weight in _hands(state).channels.items()}


class OnAir:
    """The values of addresses in a state, each told when it is asked for; of a pattern of characters, the first's."""

    def __init__(self, state: State | None = None) -> None:
        self._state = state
        self._told: dict[str, tuple[Argument, ...]] = {}

    def get(self, path: str, default: tuple[Argument, ...] = ()) -> tuple[Argument, ...]:
        """The values that an address has; the default where there is none, or nobody of that name."""
        told = self._told.get(path)
        if told is None:
            told = self._told[path] = self._tell(path, default)
        return told

    def _tell(self, path: str, default: tuple[Argument, ...]) -> tuple[Argument, ...]:
        if self._state is None:
            return default
        channel = _channel_at(path)
        state = None if channel is None else self._state.characters.get(channel[0])
        if channel is not None and state is not None:
            return ((state if state.held is None else state.held).channels.get(channel[1], 0.0),)
        address, pattern, named = find_address(path)
        if address.of_show:
            return OF_SHOW[address.path](self._state) if address.path in OF_SHOW else default
        characters = self._state.characters
        who = _first_meant(pattern, characters)
        if who is None:
            return default
        if address.path == CHANNEL:  # of a pattern
            return (_hands(characters[who]).channels.get(named[0], 0.0),)
        if address.path.startswith("layer"):
            switch = address.path == SWITCH
            return (float(_is_on(characters[who], *named)),) if switch else _of_layer(characters[who], *named)
        if named:
            shown = {str(region): name for region, name in _named_in_regions(characters[who]).items()}
            return (shown[named[0]],) if named[0] in shown else default
        return OF_CHARACTER[address.path](characters[who]) if address.path in OF_CHARACTER else default


def _first_meant(pattern: str, characters: Mapping[str, CharacterState]) -> str | None:
    """The first character that a pattern or a label means; None for nobody."""
    try:
        meant = characters_meant(pattern, {name: each.label for name, each in characters.items()})
    except OscError:
        return None
    return next(iter(characters)) if meant == (ALL,) else meant[0]


class Feedback:
    """What one surface was told last, so that it is told what is new alone."""

    def __init__(self) -> None:
        self._told: Told = {}
        self._sent: dict[str, float] = {}

    def note(self, address: str, now: float) -> None:
        """Notes that the surface itself has sent to an address."""
        self._sent[address] = now

    def news(self, values: Told, now: float) -> dict[str, tuple[Argument, ...]]:
        """What has changed since the last call; a channel that is gone stands at rest."""
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
    return (pattern, named[0]) if address.path == CHANNEL else None


def _named(mix: Mapping[str, float], call: CallState | None) -> str:
    """The name that is called, else the one that weighs most."""
    return call.target if call is not None else max(mix, key=lambda name: mix[name])


def _named_in_regions(state: CharacterState) -> dict[PlayRegion, str]:
    """What each region shows or comes to show: its own, or that of the whole face."""
    whole = _named(state.expressions, state.expression_call)
    own = {region: _named(mix, state.region_calls.get(region)) for region, mix in state.regions.items()}
    return {region: own.get(region, whole) for region in PLAY_REGIONS}


def _hands(state: CharacterState) -> CharacterState | HeldState:
    """What holds channels, head and gaze as hands do."""
    return state if state.held is None else state.held


def _of_layer(state: CharacterState, name: str, part: str = "") -> tuple[Argument, ...]:
    """The influence of a layer, as set: of a part, or the largest."""
    shown = state.layers.get(name)  # type: ignore[call-overload]
    influence = shown.influence if shown is not None else FIRST_INFLUENCES.get(name, NO_INFLUENCE)
    return (influence[PART_PLACES[part]] if part in PART_PLACES else max(influence),)


def _is_on(state: CharacterState, layer: str) -> bool:
    """Whether a layer is switched on; one that is as at first is."""
    shown = state.layers.get(layer)  # type: ignore[call-overload]
    return shown is None or bool(shown.on)


def _place(place: Place) -> tuple[Argument, ...]:
    return place.x, place.depth, place.size, _degrees(place.turn)


def _degrees(angle: float) -> float:
    return round(math.degrees(angle), 4)


OF_SHOW: Mapping[str, Callable[[State], tuple[Argument, ...]]] = {
    "light": lambda state: (_named(state.light, state.light_call),),
    "framing": lambda state: (_named(state.framing, state.framing_call),),
}
"""What the whole show's addresses have on air."""
OF_CHARACTER: Mapping[str, Callable[[CharacterState], tuple[Argument, ...]]] = {
    "face": lambda state: (_named(state.faces, state.face_call),),
    "expression": lambda state: (_named(state.expressions, state.expression_call),),
    "head": lambda state: tuple(map(_degrees, _hands(state).head)),
    "gaze": lambda state: tuple(map(_degrees, _hands(state).gaze)),
    "place": lambda state: _place(state.place),
    "fade/face": lambda state: (state.face_fader,),
    "fade/expression": lambda state: (state.expression_fader,),
}
"""What a character's addresses have on air, but for its channels."""
