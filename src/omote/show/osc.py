"""How a command is reached by OSC: the address, its values and what it has on air, declared beside the command."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal

ROOT = "omote"
CALL_SECONDS = 1.0
"""How long a call takes that names no time."""

Argument = float | int | str | bytes | bool | None
"""A value of a message of OSC."""
ValueKind = Literal[
    "face", "expression", "region", "channel", "light", "framing", "layer", "part", "lease", "scene_lease",
    "character", "text", "number", "switch", "seconds", "time", "press", "speech", "language", "gesture",
    "cue", "pad", "macro", "spring", "skin", "pose", "pose_region", "body", "shot",
]  # fmt: skip


@dataclass(frozen=True)
class Value:
    """A value of an address: what it is, its unit, its range where it is a number (both ends included), and what it is
    where a message leaves it out. name: "" for the name of the field that it stands beside. optional: a message may
    leave it out, and what it sets stays. An angle is in degrees here and in radians in the command."""

    kind: ValueKind = "number"
    low: float = 0.0
    high: float = 1.0
    unit: str = ""
    default: float | str | None = None
    name: str = ""
    optional: bool = False

    @property
    def may_be_left_out(self) -> bool:
        """Whether a message may end before it."""
        return self.optional or self.default is not None or self.kind in ("seconds", "time", "press")

    def convert(self, value: Any) -> Any:
        """What the field of a command holds; ValueError, in the degrees that came, for an angle out of its range."""
        if self.kind == "switch":
            return value == 1.0
        if self.unit != "degrees":
            return value
        if not self.low <= value <= self.high:
            span = f"{self.low:g} to {self.high:g}"
            raise ValueError(f"the {self.name} is {value:g} degrees; give a number from {span}")
        return math.radians(value)

    @property
    def is_converted(self) -> bool:
        """Whether a field holds it otherwise than it comes."""
        return self.kind == "switch" or self.unit == "degrees"


PRESS = Value("press", name="press")
"""A button: a number above 0, or nothing, is a press."""


def angle(limit: float) -> Value:
    """An angle of at most `limit` radians either way."""
    degrees = round(math.degrees(limit), 9)
    return Value(low=-degrees, high=degrees, unit="degrees")


@dataclass(frozen=True)
class Osc:
    """An address of a command.

    path: behind the character, or behind the root where it is the whole show's; a part in braces is a value. tells:
    what it does, in words. takes: the values behind the address: names of fields, or values of another kind than their
    field has. fixed: fields that this address alone sets. of_show: it names no character. on_air: the values that it
    has on air, of a character's state (of the show's, for the whole show) and the names in its path; reported: for
    which names in its path surfaces are told, of the same state.
    """

    path: str
    tells: str
    takes: tuple[str | Value, ...] = ()
    fixed: Mapping[str, object] = field(default_factory=lambda: MappingProxyType({}))
    of_show: bool = False
    on_air: Callable[..., tuple[Argument, ...]] | None = None
    reported: Callable[[Any], Iterable[tuple[str, ...]]] = lambda _: ((),)


def osc(path: str, tells: str, *takes: str | Value, of_show: bool = False, **fixed: object) -> Osc:
    """An address without a value on air.

    path, tells, takes, of_show, fixed: as of `Osc`.
    """
    return Osc(path, tells, takes, MappingProxyType(fixed), of_show)
