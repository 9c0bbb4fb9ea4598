"""Every address of OSC that a show obeys, once: the parser, the documentation and what surfaces are told use this list.

Angles are in degrees. A number comes as float, integer, boolean or numeric text; as OSC's buttons send 1 when they are
pressed and 0 when they are let go, a command without a value happens at a number above 0 or without any.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from omote.inputs.osc_packet import Argument, OscError, OscMessage
from omote.perform.easing import DEFAULT_EASING
from omote.perform.lights import LIGHTS
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS, LONGEST_CALL
from omote.perform.name_lookup import find_name
from omote.perform.snapshot import Playable
from omote.show import messages as wire

ROOT = "omote"
CALL_SECONDS = 1.0
"""How long a call takes that names no time."""
BY_HAND = "hand"
"""In the place of the seconds: the T-bar moves the call."""
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")

Kind = Literal["face", "expression", "channel", "light", "number", "seconds", "press"]


@dataclass(frozen=True)
class Value:
    """A value of an address: what it is, its unit, and its range where it is a number (both ends included)."""

    name: str
    kind: Kind = "number"
    low: float = 0.0
    high: float = 1.0
    unit: str = ""

    @property
    def may_be_left_out(self) -> bool:
        """Whether a message may end before it."""
        return self.kind in ("seconds", "press")


@dataclass(frozen=True)
class Address:
    """An address, what it does, and the message that it becomes.

    path: behind the character, or behind the root where it is the whole show's; a part in braces is a value.
    """

    path: str
    tells: str
    values: tuple[Value, ...]
    make: Callable[..., wire.FromClient]
    of_show: bool = False

    @property
    def pattern(self) -> str:
        """The address as people write it."""
        return f"/{ROOT}/{self.path}" if self.of_show else f"/{ROOT}/{{character}}/{self.path}"


@dataclass(frozen=True)
class Order:
    """What a message of OSC asks for: of a character ("*": of all), or of the whole show ("")."""

    character: str
    message: wire.FromClient


SECONDS = Value("seconds", "seconds", 0.0, LONGEST_CALL, "s")
PRESS = Value("press", "press")
FADER = Value("position")


def _angles(limits: Mapping[str, float]) -> tuple[Value, ...]:
    return tuple(
        Value(name, low=-math.degrees(limit), high=math.degrees(limit), unit="degrees")
        for name, limit in limits.items()
    )


def _turn(message: Callable[..., wire.FromClient]) -> Callable[..., wire.FromClient]:
    return lambda _, *degrees: message(*map(math.radians, degrees))


ADDRESSES: tuple[Address, ...] = (
    Address(
        "face",
        "brings a face on air",
        (Value("name", "face"), SECONDS),
        lambda call, name, seconds: wire.CallFace(call, name, seconds, DEFAULT_EASING),
    ),
    Address(
        "expression",
        "brings an expression on air",
        (Value("name", "expression"), SECONDS),
        lambda call, name, seconds: wire.CallExpression(call, name, seconds, DEFAULT_EASING),
    ),
    Address(
        "channel/{name}",
        "sets the weight of a unit or of any expression, beside the calls",
        (Value("name", "channel"), Value("weight", low=CHANNEL_LOWEST, high=CHANNEL_HIGHEST)),
        lambda _, name, weight: wire.SetChannel(name, weight),
    ),
    Address("head", "turns the head", _angles(HEAD_LIMITS), _turn(wire.SetHead)),
    Address("gaze", "turns the eyes, relative to the head", _angles(GAZE_LIMITS), _turn(wire.SetGaze)),
    Address("fade/face", "moves the T-bar of the faces", (FADER,), lambda _, x: wire.FadeFace(x)),
    Address("fade/expression", "moves the T-bar of the expressions", (FADER,), lambda _, x: wire.FadeExpression(x)),
    Address("release/face", "lets go of the T-bar of the faces", (PRESS,), lambda _: wire.ReleaseFace()),
    Address(
        "release/expression", "lets go of the T-bar of the expressions", (PRESS,), lambda _: wire.ReleaseExpression()
    ),
    Address(
        "light",
        "brings a light on air",
        (Value("name", "light"), SECONDS),
        lambda call, name, seconds: wire.CallLight(call, name, seconds, DEFAULT_EASING),
        of_show=True,
    ),
    Address(
        "panic",
        "holds all faces still and neutral; again, it brings the home face",
        (PRESS,),
        lambda _: wire.Panic(),
        of_show=True,
    ),
)


def read_order(message: OscMessage, cast: Playable, call: str) -> Order | None:
    """What a message of OSC asks for; None for a button that is let go. call: the id of a call that it makes.

    Names are found as everywhere: in any case, with spaces, hyphens or underscores. OscError for an address that there
    is not, for a name that there is not and for a value that is missing, too many or of a wrong kind; whether a number
    is in its range the performer decides.
    """
    address, character, named = _find_address(message.address)
    try:
        values = _read_values(address.values, [*named, *message.arguments], cast)
    except ValueError as error:
        raise OscError(f"{message.address[:80]}: {error}") from error
    if values is None:
        return None
    return Order(character, address.make(call, *values))


def _find_address(written: str) -> tuple[Address, str, list[str]]:
    """The address, the character, and the values that stand in the address itself."""
    root, *parts = written.strip("/").split("/")
    for address in ADDRESSES if root == ROOT else ():
        character, rest = ("", parts) if address.of_show else ("".join(parts[:1]), parts[1:])
        wanted = address.path.split("/")
        if len(rest) != len(wanted) or (not character and not address.of_show):
            continue
        if all(want == part or (want.startswith("{") and part) for want, part in zip(wanted, rest, strict=True)):
            return address, character, [part for want, part in zip(wanted, rest, strict=True) if want.startswith("{")]
    known = ", ".join(address.pattern for address in ADDRESSES)
    raise OscError(f"there is no address {written[:80]!r}; there are {known}")


def _read_values(values: Sequence[Value], given: Sequence[Argument], cast: Playable) -> list[Any] | None:
    """What `make` takes; None where a button is let go."""
    if len(given) > len(values):
        raise ValueError(f"{len(given)} values came; expected at most {len(values)}: {_listed(values)}")
    found: list[Any] = []
    for value, argument in zip(values, [*given, *[None] * (len(values) - len(given))], strict=True):
        if value.kind == "press":
            if argument is not None and not _number(value, argument) > 0.0:
                return None
        else:
            found.append(_read_value(value, argument, cast))
    return found


def _read_value(value: Value, argument: Argument, cast: Playable) -> Any:
    if argument is None and not value.may_be_left_out:
        raise ValueError(f"the {value.name} is missing; expected {_listed([value])}")
    if value.kind == "seconds":
        return _seconds(value, argument)
    return _number(value, argument) if value.kind == "number" else _name(value, argument, cast)


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


def _name(value: Value, argument: Argument, cast: Playable) -> str:
    if not isinstance(argument, str):
        raise ValueError(f"the {value.name} is {str(argument)[:80]!r}; expected the name of a {value.kind}, as text")
    names: Mapping[str, Any] = {"face": cast.faces, "light": LIGHTS}.get(value.kind, cast.expressions)
    return find_name(argument, names, value.kind)


def _listed(values: Sequence[Value]) -> str:
    return ", ".join(f"a number from {v.low:g} to {v.high:g}" if v.kind == "number" else v.name for v in values)
