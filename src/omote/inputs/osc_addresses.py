"""Every address of OSC that a show obeys, from the commands that declare them (`show/objects`).

The parser, the documentation and what surfaces are told use this list. Angles are in degrees. A number comes as float,
integer, boolean or numeric text, a switch as 0, 1, true or false; as OSC's buttons send 1 when they are pressed and 0
when they are let go, a command without a value happens at a number above 0 or without any.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import msgspec

from omote.inputs.osc_packet import OscError
from omote.inputs.trackers.packet_format import explain_format
from omote.show.declaration import ClientMessage, values_of
from omote.show.messages import CLIENT_MESSAGES
from omote.show.objects.faders import SetChannel
from omote.show.osc import PRESS, ROOT, Osc, Value

BY_HAND = "hand"
"""In the place of the seconds: the T-bar moves the call."""
REMEMBERED_LENGTH = 120
"""Characters of an address that is remembered when it was found: a fader sends the same one again and again."""
VMC_ROOT = "/VMC/"
"""How addresses begin that a tracker sends: to its own port, not to this one."""
PLACES = re.compile(r"{(\w+)}")
"""Where values stand in an address."""
CHARACTER = "character"
CHARACTER_PLACE = f"{{{CHARACTER}}}"


@dataclass(frozen=True)
class Address:
    """An address as it is read: its values, and the command that it becomes.

    make: the command for a character, of the id of a call, with the values in their order. sets_channel: it is the
    weight of a channel, of which many come in one tick.
    """

    declared: Osc
    values: tuple[Value, ...]
    make: Callable[..., ClientMessage]
    sets_channel: bool

    @property
    def path(self) -> str:
        """The address behind the character, or behind the root."""
        return self.declared.path

    @property
    def tells(self) -> str:
        """What it does."""
        return self.declared.tells

    @property
    def of_show(self) -> bool:
        """Whether it names no character."""
        return self.declared.of_show

    @property
    def pattern(self) -> str:
        """The address as people write it."""
        return f"/{ROOT}/{self.path}" if self.of_show else f"/{ROOT}/{{character}}/{self.path}"


def addresses_of(kind: type[ClientMessage]) -> Iterator[Address]:
    """The addresses that a kind of command declares."""
    value_of = values_of(kind)
    for declared in kind.osc:
        own = {value.name: value for value in declared.takes if isinstance(value, Value)}
        placed = [own.get(name) or value_of[name] for name in PLACES.findall(declared.path)]
        behind = [value_of[taken] if isinstance(taken, str) else taken for taken in declared.takes]
        fields = [*PLACES.findall(declared.path), *(_field(taken) for taken in declared.takes if taken not in placed)]
        values = (*placed, *(value for value in behind if value not in placed))
        make = _maker(kind, fields, values, declared.fixed)
        yield Address(declared, values, make, kind is SetChannel)


def fill_places(path: str, names: Iterable[str]) -> str:
    """A path with names in the places of its values, in their order."""
    for name in names:
        path = PLACES.sub(lambda _, name=name: name, path, count=1)  # type: ignore[misc]
    return path


def _field(taken: str | Value) -> str:
    return taken if isinstance(taken, str) else taken.name


def _maker(
    kind: type[ClientMessage], fields: list[str], values: tuple[Value, ...], fixed: Mapping[str, object]
) -> Callable[..., ClientMessage]:
    """What makes a command of the values of an address; a button has none."""
    fields_of_kind = msgspec.structs.fields(kind)
    has_character = any(field.name == CHARACTER for field in fields_of_kind)
    has_id = any(field.name == "id" and field.required for field in fields_of_kind)
    taken = [(name, value) for name, value in zip(fields, values, strict=True) if value is not PRESS]
    converted = any(value.is_converted for _, value in taken)
    names = [name for name, _ in taken]

    def make(character: str, call: str, *passed: Any) -> ClientMessage:
        if converted:
            passed = tuple(value.convert(argument) for (_, value), argument in zip(taken, passed, strict=False))
        arguments = dict(zip(names, passed, strict=False))
        if has_character:
            arguments[CHARACTER] = character
        if has_id:
            arguments["id"] = call
        return kind(**arguments, **fixed)

    return make


ADDRESSES: tuple[Address, ...] = tuple(address for kind in CLIENT_MESSAGES for address in addresses_of(kind))


def find_address(written: str, is_character: Callable[[str], bool] = lambda _: True) -> tuple[Address, str, list[str]]:
    """The address, the character, and the values that stand in the address itself; OscError where there is none.

    written: as it came; is_character: whether a name means somebody, so that no address of nobody is called near.
    """
    find = _find_again if len(written) <= REMEMBERED_LENGTH else _find_address
    found = find(written)
    if found is None:
        raise OscError(_explain_unknown(written[:80], is_character(_character_of(written))))
    address, character, named = found
    return address, character, list(named)


def _character_of(written: str) -> str:
    return "".join(written.strip("/").split("/")[1:2])


def _find_address(written: str) -> tuple[Address, str, tuple[str, ...]] | None:
    root, *parts = written.strip("/").split("/")
    for address in ADDRESSES if root == ROOT else ():
        character, rest = ("", parts) if address.of_show else ("".join(parts[:1]), parts[1:])
        wanted = address.path.split("/")
        if len(rest) != len(wanted) or (not character and not address.of_show):
            continue
        if all(want == part or (want.startswith("{") and part) for want, part in zip(wanted, rest, strict=True)):
            named = tuple(part for want, part in zip(wanted, rest, strict=True) if want.startswith("{"))
            return address, character, named
    return None


_find_again = lru_cache(maxsize=1024)(_find_address)


@lru_cache(maxsize=256)
def _explain_unknown(written: str, known: bool) -> str:
    """Why an address is none, with the nearest that there are; remembered: what sends one wrong sends it again.

    known: whether the character in it is one; an address of nobody is none, however near.
    """
    if written.startswith(VMC_ROOT):
        return explain_format("vmc")
    typed = _character_of(written) or CHARACTER_PLACE
    said = typed if known else CHARACTER_PLACE
    patterns = {
        address.pattern.replace(CHARACTER_PLACE, typed): address.pattern.replace(CHARACTER_PLACE, said)
        for address in ADDRESSES
    }
    near = [patterns[pattern] for pattern in difflib.get_close_matches(written, patterns, n=3, cutoff=0.7)]
    like = next(iter(patterns.values()))
    there = f"near are {', '.join(near)}" if near else f"they are like {like}; /{ROOT} of the show's pages lists all"
    return f"there is no address {written!r}; {there}"
