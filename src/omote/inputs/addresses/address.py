"""What an address of OSC is: its values, and the message that it becomes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from omote.perform.limits import LONGEST_CALL
from omote.show import messages as wire

ROOT = "omote"

Kind = Literal[
    "face", "expression", "region", "channel", "light", "framing", "layer", "part", "lease", "scene_lease",
    "character", "text", "number", "switch", "seconds", "time", "press", "speech", "language", "gesture",
]  # fmt: skip


@dataclass(frozen=True)
class Value:
    """A value of an address: what it is, its unit, its range where it is a number (both ends included), and what it is
    where a message leaves it out."""

    name: str
    kind: Kind = "number"
    low: float = 0.0
    high: float = 1.0
    unit: str = ""
    default: float | str | None = None

    @property
    def may_be_left_out(self) -> bool:
        """Whether a message may end before it."""
        return self.default is not None or self.kind in ("seconds", "time", "press")


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


SECONDS = Value("seconds", "seconds", 0.0, LONGEST_CALL, "s")
PRESS = Value("press", "press")
