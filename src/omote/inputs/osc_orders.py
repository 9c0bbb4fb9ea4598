"""What messages of OSC ask for: each becomes messages of the show, and what is wrong is said in words."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

from omote.inputs.character_patterns import characters_meant
from omote.inputs.osc_addresses import ADDRESSES, BY_HAND, find_address
from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.model.body.pose_regions import check_pose_region
from omote.model.known_names import check_play_region
from omote.perform.called_names import find_called
from omote.perform.complexion import check_skin_fader
from omote.perform.cues.cue import check_cue_number, write_cue_number
from omote.perform.gestures import check_gesture
from omote.perform.layers.layer_names import check_layer, check_part
from omote.perform.lights import LIGHTS
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST
from omote.perform.name_lookup import find_name
from omote.perform.scene.character_names import ALL, find_character
from omote.perform.scene.framings import check_shot_size
from omote.perform.snapshot import Playable
from omote.perform.speech.spelling import check_language
from omote.perform.springs.cast_springs import check_spring
from omote.show.declaration import ClientMessage
from omote.show.osc import CALL_SECONDS, ROOT, Value
from omote.show.ownership.parts import find_part

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
CHECKS: Mapping[str, Callable[[str], str]] = {
    "region": check_play_region, "layer": check_layer, "part": check_part,
    "gesture": check_gesture, "language": check_language, "spring": check_spring,
    "skin": check_skin_fader, "pose_region": check_pose_region, "shot": check_shot_size,
    "lease": partial(find_part, of_scene=False), "scene_lease": partial(find_part, of_scene=True),
}  # fmt: skip
"""What finds the names that every show has."""
NAMED = (
    "face",
    "expression",
    "channel",
    "light",
    "gesture",
    "layer",
    "region",
    "character",
    "spring",
    "skin",
    "pose",
    "pose_region",
    "body",
)
"""What is called by a name."""
BUTTON = (0.0, 1.0)
"""What a button sends, as decimals or true and false: where the number of a cue may be left out it is let go or
pressed."""
MOST_REMEMBERED = 1024
"""Names and addresses that are remembered when they were found, or were not: what sends one sends it again."""
LONGEST_REMEMBERED = 120


class Names(NamedTuple):
    """Whose names a message can have. characters: what people call each, by name; pads: the dimensions of each, macros:
    those of each character, where they are listed."""

    cast: Playable
    characters: Mapping[str, str]
    pads: Mapping[str, int] = MappingProxyType({})
    macros: Mapping[str, Sequence[str]] = MappingProxyType({})


class Level(NamedTuple):
    """An address that takes numbers alone, as it was read: a fader sends the same one again and again. channel: the
    one that it sets, "" for another address."""

    make: Callable[..., ClientMessage]
    meant: tuple[str, ...]
    named: list[Any]
    length: int
    channel: str


class OrderReader:
    """Reads messages for a cast and characters; what it has found once it finds again at once."""

    def __init__(self, cast: Playable, characters: Mapping[str, str]) -> None:
        self._names = Names(cast, dict(characters))
        self._meant: dict[str, tuple[str, ...]] = {}
        self._levels: dict[str, Level] = {}
        self._found: dict[tuple[str, str], str | ValueError] = {}

    def fits(self, cast: Playable, characters: Mapping[str, str]) -> bool:
        """Whether it was made for this cast and these characters."""
        return self._names.cast is cast and self._names.characters == characters

    def read(self, message: OscMessage, call: str) -> tuple[ClientMessage, ...]:
        """What a message asks for: none for a button that is let go, one for each character that its pattern means.

        call: the id of a call that it makes. Names are found as everywhere: in any case, with spaces, hyphens or
        underscores. OscError for an address or a character that there is not, for a name that there is not and for a
        value that is missing, too many or of a wrong kind; whether a number is in its range the scene decides.
        """
        level = self._levels.get(message.address)
        try:
            if level is not None and len(message.arguments) == level.length and all(map(_is_float, message.arguments)):
                return tuple(level.make(who, call, *level.named, *message.arguments) for who in level.meant)
            return self._read(message, call)
        except OscError:
            raise
        except ValueError as error:
            raise OscError(f"{message.address[:80]}: {error}") from error

    def channel_set(self, message: OscMessage) -> Level | None:
        """The address of a message that sets a channel to a weight in its range, where it was read before."""
        address, arguments = message
        level = self._levels.get(address)
        if level is None or not level.channel or len(arguments) != 1:
            return None
        weight = arguments[0]
        return level if type(weight) is float and CHANNEL_LOWEST <= weight <= CHANNEL_HIGHEST else None

    def _read(self, message: OscMessage, call: str) -> tuple[ClientMessage, ...]:
        address, character, named = find_address(message.address, self._is_character)
        if not address.of_show and not self._is_character(character):
            self._refuse_nobody(character, message.address)
        values = self._read_values(address.values, [*named, *message.arguments])
        if values is None:
            return ()
        if address.of_show:
            return (address.make(ALL, call, *values),)
        meant = self.characters_meant(character)
        if all(value.kind == "number" for value in address.values[len(named) :]):
            names = values[: len(named)]
            channel = str(values[0]) if address.sets_channel else ""
            self._remember_level(message.address, Level(address.make, meant, names, len(message.arguments), channel))
        if len(meant) == 1:
            return (address.make(meant[0], call, *values),)
        return tuple(address.make(who, f"{call} {who}", *values) for who in meant)

    def _remember_level(self, path: str, level: Level) -> None:
        if len(self._levels) < MOST_REMEMBERED and len(path) <= LONGEST_REMEMBERED:
            self._levels[path] = level

    def characters_meant(self, pattern: str) -> tuple[str, ...]:
        """The characters that a pattern means, `*` for all of them."""
        characters = self._meant.get(pattern)
        if characters is None:
            characters = characters_meant(pattern, self._names.characters)
            if len(self._meant) < MOST_REMEMBERED and len(pattern) <= LONGEST_REMEMBERED:
                self._meant[pattern] = characters
        return characters

    def _refuse_nobody(self, character: str, written: str) -> None:
        """Says that nobody is so called; where a word of an address stands in the place of who, also what is meant."""
        if any(address.path.split("/")[0] == character for address in ADDRESSES if not address.of_show):
            behind = written.strip("/").partition("/")[2]
            first = next(iter(self._names.characters), "CHARACTER")
            raise OscError(f"{written[:80]} names no character; write whose it is: /{ROOT}/{first}/{behind[:80]}")
        self.characters_meant(character)

    def _is_character(self, pattern: str) -> bool:
        try:
            return bool(self.characters_meant(pattern))
        except OscError:
            return False

    def _read_values(self, values: Sequence[Value], arguments: Sequence[Argument]) -> list[Any] | None:
        """What `make` takes; None where a button is let go."""
        if len(arguments) > len(values):
            raise ValueError(f"{len(arguments)} values came; expected at most {len(values)}: {_listed(values)}")
        read_values: list[Any] = []
        for value, argument in zip(values, [*arguments, *[None] * (len(values) - len(arguments))], strict=True):
            if value.kind == "press":
                if argument is not None and not _number(value, argument) > 0.0:
                    return None
            elif value.kind == "cue" and value.default is not None and _is_button(argument):
                if not argument:
                    return None
                read_values.append(value.default)
            else:
                read_values.append(self._read_value(value, argument))
        return read_values

    def _read_value(self, value: Value, argument: Argument) -> Any:
        if value.kind == "number" and type(argument) is float:
            return argument
        if argument is None and (value.optional or value.default is not None):
            return value.default
        if argument is None and not value.may_be_left_out:
            expected = f"the name of a {value.kind}, as text" if value.kind in NAMED else _listed([value])
            raise ValueError(f"the {value.name} is missing; expected {expected}")
        if value.kind == "seconds":
            return _seconds(value, argument)
        if value.kind == "time":
            return CALL_SECONDS if argument is None else _number(value, argument)
        if value.kind == "switch":
            return _switch(value, argument)
        if value.kind == "cue":
            return _cue_number(argument)
        return _number(value, argument) if value.kind == "number" else self._name(value, argument)

    def _name(self, value: Value, argument: Argument) -> str | list[str]:
        if not isinstance(argument, str):
            raise ValueError(
                f"the {value.name} is {str(argument)[:80]!r}; expected the name of a {value.kind}, as text"
            )
        if value.kind == "speech":
            return argument
        if value.kind in SCENE_NAMES:
            return SCENE_NAMES[value.kind](argument, self._names.characters)
        if value.kind in CHECKS:
            return CHECKS[value.kind](argument.lower())
        name = self._found.get((value.kind, argument))
        if name is None:
            name = _look_up(argument, value.kind, self._names.cast)
            if len(self._found) < MOST_REMEMBERED and len(argument) <= LONGEST_REMEMBERED:
                self._found[value.kind, argument] = name
        if isinstance(name, ValueError):
            raise ValueError(str(name))
        return name


def _is_button(argument: Argument) -> bool:
    return type(argument) is bool or (type(argument) is float and argument in BUTTON)


def _is_float(value: Argument) -> bool:
    return type(value) is float


def _look_up(text: str, kind: str, cast: Playable) -> str | ValueError:
    try:
        return find_name(text, LIGHTS, kind) if kind == "light" else find_called(text, kind, cast)
    except ValueError as error:
        return error


def _seconds(value: Value, argument: Argument) -> float | None:
    """A time of a call; None for one by hand, as on the wire."""
    if argument == BY_HAND:
        return None
    return CALL_SECONDS if argument is None else _number(value, argument)


def _number(value: Value, argument: Argument) -> float:
    if isinstance(argument, str) and NUMBER.fullmatch(argument.strip()):
        return float(argument)
    if isinstance(argument, int | float):
        return float(argument)
    raise ValueError(f"the {value.name} is {str(argument)[:80]!r}; expected {_listed([value])}")


def _cue_number(argument: Argument) -> str:
    """The number of a cue, as text or as a number."""
    if isinstance(argument, str):
        return check_cue_number(argument.strip())
    if isinstance(argument, int | float) and not isinstance(argument, bool):
        return write_cue_number(argument)
    raise ValueError(f"a cue cannot be numbered {str(argument)[:80]!r}; give its number, such as 12.5")


def _switch(value: Value, argument: Argument) -> float:
    """1 for on, 0 for off."""
    text = argument.strip().lower() if isinstance(argument, str) else argument
    if text in ("true", "false"):
        return float(text == "true")
    number = float(text) if isinstance(text, str) and NUMBER.fullmatch(text) else text
    if isinstance(number, int | float) and number in (0, 1):
        return float(number)
    said = repr(argument) if isinstance(argument, str) else f"{argument:g}" if isinstance(argument, float) else argument
    raise ValueError(f"the {value.name} is {str(said)[:80]}; expected {_listed([value])}")


def _characters(text: str, characters: Mapping[str, str]) -> list[str]:
    """The characters of a framing: none for `*`."""
    if text.strip() == ALL:
        return []
    return [find_character(name, characters) for name in re.split(r"[+,\s]+", text.strip())]


SCENE_NAMES: Mapping[str, Callable[[str, Mapping[str, str]], str | list[str]]] = {
    "framing": _characters, "character": find_character, "text": lambda text, _: text, "pad": lambda text, _: text,
    "macro": lambda text, _: text,
}  # fmt: skip
"""What finds the names of a scene, by its characters' names and labels."""


def _listed(values: Sequence[Value]) -> str:
    return ", ".join(map(_describe, values))


def _describe(value: Value) -> str:
    if value.kind == "switch":
        return "1 or true for on, 0 or false for off"
    return f"a number from {value.low:g} to {value.high:g}" if value.kind == "number" else value.name
