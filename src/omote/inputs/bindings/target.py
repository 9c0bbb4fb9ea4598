"""What a control may play: an address of OSC, so that all that a surface plays a dial plays too."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from omote.inputs.osc_addresses import find_address
from omote.inputs.osc_packet import Argument
from omote.show.objects.bindings import pad_of
from omote.show.osc import Value

BANK = "bank:"
"""Instead of an address: the bank that a button turns to."""
MACRO = "macro"
USUAL_RANGE = {"channel": (0.0, 1.0), "macro": (0.0, 1.0)}
"""The range of a fader where an address takes more than a fader usually gives."""
STICK_DEGREES = {
    ("head", "yaw"): 60.0,
    ("head", "pitch"): 40.0,
    ("head", "roll"): 30.0,
    ("gaze", "yaw"): 35.0,
    ("gaze", "pitch"): 25.0,
}
"""How far a stick turns a head or a gaze at its end: the address takes more, and shows hair or a profile then."""
DOWNWARD = frozenset({"axis1", "axis3", "rx", "z"})
"""Sticks whose numbers grow as they are pulled down, or tilted forward: up is more, of whatever they play."""


@dataclass(frozen=True)
class BoundTarget:
    """An address with its character. arguments: of a call; values: what a level may move, with their ranges; axis: the
    one that it moves. character: a pattern, "" where the address is the whole show's."""

    path: str
    arguments: tuple[Argument, ...] = ()
    values: tuple[Value, ...] = ()
    axis: int = 0
    character: str = ""

    @property
    def axis_name(self) -> str:
        """The name of its axis; "" where the address has one alone."""
        return self.values[self.axis].name if len(self.values) > 1 else ""

    @property
    def is_level(self) -> bool:
        """Whether a fader moves it; a button alone plays the rest."""
        return bool(self.values)

    @property
    def bank(self) -> str | None:
        """The bank that it turns to, None where it plays."""
        return self.path.removeprefix(BANK) if self.path.startswith(BANK) else None

    @property
    def pad(self) -> str:
        """The pad whose point it moves, as its address has the name; "" for none."""
        return pad_of(self.path)

    @property
    def is_macro(self) -> bool:
        """Whether it is a macro, whose middle is 0: a stick plays both of its halves."""
        return f"/{MACRO}/" in self.path

    @property
    def usual_range(self) -> tuple[float, float]:
        """The range of a fader that has none of its own."""
        value = self.values[self.axis]
        return next((span for part, span in USUAL_RANGE.items() if f"/{part}/" in self.path), (value.low, value.high))

    @property
    def stick_range(self) -> tuple[float, float]:
        """The range of a stick that has none of its own; its middle is rest where that of the target is."""
        low, high = self.usual_range
        farthest = STICK_DEGREES.get((self.path.rpartition("/")[2], self.axis_name), high)
        return (-farthest, farthest) if self.is_macro or low < 0.0 else (low, high)


def read_target(path: str, arguments: Sequence[Argument] = (), axis: str | None = None) -> BoundTarget:
    """The target of an address; ValueError for one that there is not, for arguments or an axis that it has not.

    arguments: what a call needs, its name and seconds; axis: `yaw` of a head, needed where an address has several;
    path: the address, or `bank:NAME`.
    """
    if path.startswith(BANK):
        return BoundTarget(path)
    address, character, named = find_address(path)
    left = address.values[len(named) :]
    numbers = tuple(value for value in left if value.kind in ("number", "switch") and value.default is None)
    if not numbers:
        most = [value for value in left if value.kind != "press"]
        least = sum(not value.may_be_left_out for value in most)
        if axis is not None or not least <= len(arguments) <= len(most):
            wanted = ", ".join(value.name for value in most) or "nothing"
            raise ValueError(f"{path} takes {wanted} as arguments, and no axis")
        return BoundTarget(path, tuple(arguments), character=character)
    names = [value.name for value in numbers]
    if arguments or (axis is None and len(names) > 1) or (axis is not None and axis not in names):
        raise ValueError(f"{path} takes no arguments and one axis of {', '.join(names)}; not {axis!r}")
    return BoundTarget(path, (), numbers, 0 if axis is None else names.index(axis), character)
