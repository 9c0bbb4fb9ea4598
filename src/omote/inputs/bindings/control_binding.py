"""A binding: a control of a device, what it plays, and how; validated once, when it is made."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Literal, get_args

from omote.inputs.bindings.target import BoundTarget
from omote.inputs.osc_hands import HAND_AXES
from omote.show.objects.bindings import address_after_rename

Button = Literal["momentary", "toggle"]
Encoding = Literal["twos_complement", "binary_offset", "sign_magnitude"]
STEEPEST = 10.0
WIDEST_DEAD_ZONE = 0.45
"""Of the way to either side of the middle: beyond, a stick would have no way left."""
MIDDLE = 0.5
LONGEST_NAME = 80
LARGEST_STEP = 1.0
HIGHEST_BYTE = 127

STEPS: Mapping[str, Callable[[int], int]] = {
    "twos_complement": lambda byte: byte if byte < 64 else byte - 128,
    "binary_offset": lambda byte: byte - 64,
    "sign_magnitude": lambda byte: -(byte & 63) if byte & 64 else byte,
}
"""Steps of an encoder from the byte that it sends."""


@dataclass(frozen=True)
class Binding:
    """A control of a device and what it plays; ValueError for what cannot be.

    device, control: their names, as a `Reading` has them; low, high: the values at both ends of the control (high may
    be the lower one); curve: exponent of the way between them; pick_up: a fader acts once it has crossed the value on
    air, never an axis of a hand, which moves all the time; button: of a button that moves a level; relative: of an
    encoder without ends; step: part of the range that one step of an encoder moves; bank: the bank in which it plays,
    "" for all; dead_zone: how far from its middle a stick counts as there, 0 to 0.45 of its way.
    """

    device: str
    control: str
    target: BoundTarget
    low: float = 0.0
    high: float = 1.0
    curve: float = 1.0
    pick_up: bool = True
    button: Button | None = None
    relative: Encoding | None = None
    step: float = 1.0 / 128.0
    bank: str = ""
    dead_zone: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "pick_up", self.pick_up and self.control not in HAND_AXES)
        for what, name in (("device", self.device), ("control", self.control)):
            if not 1 <= len(name) <= LONGEST_NAME:
                raise ValueError(f"the {what} is {name[:80]!r}; give its name, of at most {LONGEST_NAME} characters")
        numbers = (
            ("curve", self.curve, 1 / STEEPEST, STEEPEST),
            ("step", self.step, 1e-6, 1.0),
            ("dead_zone", self.dead_zone, 0.0, WIDEST_DEAD_ZONE),
        )
        for what, value, least, most in numbers:
            if not least <= value <= most:
                raise ValueError(f"{what} is {value}; give {least:g} to {most:g}")
        if self.button not in (None, *get_args(Button)) or self.relative not in (None, *get_args(Encoding)):
            raise ValueError(f"button is one of {get_args(Button)}, relative one of {get_args(Encoding)}")
        if self.target.is_level:
            self._check_range()
        elif self.button is not None or self.relative is not None:
            raise ValueError(f"{self.target.path} is called by a press; button and relative are for levels")

    def _check_range(self) -> None:
        value = self.target.values[self.target.axis]
        for what, number in (("low", self.low), ("high", self.high)):
            if not value.low <= number <= value.high:
                raise ValueError(f"{what} is {number}; {self.target.path} takes {value.low:g} to {value.high:g}")
        if self.low == self.high:
            raise ValueError(f"low and high are both {self.low}; a control needs a range")
        if self.button is not None and self.relative is not None:
            raise ValueError("a control is a button or an encoder, not both")

    def value_at(self, position: float) -> float:
        """The value of the target where the control stands at a position, 0 to 1."""
        return self.low + (self.high - self.low) * math.pow(self.leave_middle(position), self.curve)

    def leave_middle(self, position: float) -> float:
        """Where a control counts as being that stands at a position: in its middle within the dead zone, and from there
        on without a jump."""
        if not self.dead_zone:
            return position
        away = abs(position - MIDDLE) - self.dead_zone
        if away <= 0.0:
            return MIDDLE
        return MIDDLE + math.copysign(away * MIDDLE / (MIDDLE - self.dead_zone), position - MIDDLE)

    def position_of(self, value: float) -> float:
        """The position at which the control has a value of the target; the nearer end where it has none."""
        part = (value - self.low) / (self.high - self.low)
        counts = math.pow(min(1.0, max(0.0, part)), 1.0 / self.curve)
        if not self.dead_zone or counts == MIDDLE:
            return counts
        away = self.dead_zone + abs(counts - MIDDLE) * (MIDDLE - self.dead_zone) / MIDDLE
        return MIDDLE + math.copysign(away, counts - MIDDLE)

    def steps(self, position: float) -> int:
        """How many steps an encoder was turned, from what its control reads."""
        return STEPS[self.relative](round(position * HIGHEST_BYTE)) if self.relative else 0


def binding_after_rename(binding: Binding, pad: str, to: str) -> Binding:
    """A binding that moves the point of a pad under its new name; any other as it is.

    binding: as it is; pad: the name before; to: the name now.
    """
    path = address_after_rename(binding.target.path, pad, to)
    return binding if path == binding.target.path else replace(binding, target=replace(binding.target, path=path))
