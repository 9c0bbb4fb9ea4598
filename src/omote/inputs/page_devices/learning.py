"""Learn: the next control that is clearly moved is bound; what merely trembles is not, and encoders are known."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from omote.inputs.bindings.control_binding import HIGHEST_BYTE, STEPS, Binding, Encoding
from omote.inputs.bindings.target import DOWNWARD, BoundTarget
from omote.inputs.midi_stream import FINE
from omote.inputs.osc_hands import HAND_AXES
from omote.inputs.reading import Reading

LEARN_SECONDS = 30.0
"""Seconds after which learning ends by itself."""
MOVED = 0.08
PUSHED = 0.3
"""Of its way: how far a hand has moved a dial, and a stick or an axis of a hand, which tremble and move others too."""
PASSED = 3
"""Values through which a dial passes at least; a button has two."""
REPEATED = 3
"""Times in a row that an encoder sends the same step; a dial never sends the same value twice in a row."""
FARTHEST_STEP = 16
MOST_CONTROLS = 512
STICK_DEAD_ZONE = 0.05
"""Of its way, to either side: a stick that is let go stands up to a tenth of its half beside its middle."""
STICKS = ("axis", "x", "y", "z", "rx", "ry", "rz")


@dataclass
class _Seen:
    """What a control has read since learning began."""

    values: list[float] = field(default_factory=list)

    @property
    def way(self) -> float:
        return max(self.values) - min(self.values)


class Learning:
    """What the next control that moves will be bound to. until: when that ends."""

    def __init__(self, target: BoundTarget, now: float, bank: str = "") -> None:
        self.target = target
        self.bank = bank
        self.until = now + LEARN_SECONDS
        self._seen: dict[tuple[str, str], _Seen] = {}
        self._held: set[tuple[str, str]] = set()

    def hear(self, readings: Iterable[Reading]) -> Binding | None:
        """The binding of the control that has moved, None while none has; a button is known when it is let go."""
        moved: list[tuple[float, Reading]] = []
        for reading in readings:
            if not 0.0 <= reading.value <= 1.0 or len(self._seen) > MOST_CONTROLS:
                continue
            seen = self._seen.setdefault((reading.device, reading.control), _Seen())
            seen.values = [*seen.values[-63:], reading.value]
            if self._is_let_go(reading, seen):
                return self._pressed(reading)
            if (encoding := self._encoding(reading, seen)) is not None:
                return self._bind(reading, pick_up=False, relative=encoding)
            if self._is_moved(reading, seen):
                moved.append((seen.way, reading))
        return None if not moved else self._bind(max(moved, key=lambda way_and_reading: way_and_reading[0])[1])

    def _is_let_go(self, reading: Reading, seen: _Seen) -> bool:
        """Whether a button has been pressed and let go: a key, or a controller that knows its two ends alone."""
        control = reading.device, reading.control
        if reading.key and not self._is_trigger(reading):
            was_held = control in self._held
            (self._held.add if reading.value > 0.0 else self._held.discard)(control)
            return was_held and reading.value == 0.0
        return not reading.key and not _is_stick(reading) and seen.values == [1.0, 0.0]

    def _is_trigger(self, reading: Reading) -> bool:
        """Whether a level of the same trigger is heard too, which plays a level better than its key."""
        level = reading.device, reading.control.replace("button", "trigger")
        return self.target.is_level and level in self._seen and level[1] != reading.control

    def _encoding(self, reading: Reading, seen: _Seen) -> Encoding | None:
        """How an encoder counts; None for anything else. A code that explains all that came is taken."""
        if not self.target.is_level or "/cc" not in reading.control or reading.key:
            return None
        received = [round(value * HIGHEST_BYTE) for value in seen.values]
        if max(len(list(same)) for _, same in groupby(received)) < REPEATED:
            return None
        fits: list[Encoding] = [code for code in STEPS if _are_steps(received, code)]  # type: ignore[misc]
        return fits[0] if fits else None

    def _is_moved(self, reading: Reading, seen: _Seen) -> bool:
        if reading.key or ("pressure" in reading.control and self._held):
            return False
        if reading.control.startswith("trigger") and not self.target.is_level:
            return False
        return len({*seen.values}) >= PASSED and seen.way >= (PUSHED if _is_stick(reading) else MOVED)

    def _pressed(self, reading: Reading) -> Binding:
        return self._bind(reading, pick_up=False, button="toggle") if self.target.is_level else self._bind(reading)

    def _bind(self, reading: Reading, **more: Any) -> Binding:
        control = reading.control if more else self._whole(reading)
        is_stick = _is_stick(reading)
        low, high = (0.0, 1.0) if not self.target.is_level else self.target.usual_range
        fits: dict[str, Any] = {"pick_up": not is_stick and not control.startswith("trigger")}
        if is_stick and control not in HAND_AXES and self.target.is_level:
            low, high = self.target.stick_range
            fits |= {"dead_zone": STICK_DEAD_ZONE} if low < 0.0 else {}
            low, high = (high, low) if control in DOWNWARD else (low, high)
        return Binding(
            reading.device, control, self.target, **{"low": low, "high": high, "bank": self.bank, **fits, **more}
        )

    def _whole(self, reading: Reading) -> str:
        """The control of 14 bits of which this one is a half, where both halves have moved; else itself."""
        channel, separator, number = reading.control.partition("/cc")
        if not separator or not number.isdecimal():
            return reading.control
        coarse = int(number) % FINE if int(number) < 2 * FINE else int(number)
        half = f"{channel}/cc{coarse}"
        other = f"{channel}/cc{coarse + FINE}"
        counts = [
            len(seen.values) if (seen := self._seen.get((reading.device, control))) else 0 for control in (half, other)
        ]
        whole = f"{half}+{coarse + FINE}"
        return whole if min(counts) >= PASSED - 1 and (reading.device, whole) in self._seen else reading.control


def _is_stick(reading: Reading) -> bool:
    return reading.control in HAND_AXES or reading.control.rstrip("0123456789") in STICKS


def _are_steps(received: list[int], code: str) -> bool:
    return all(1 <= abs(STEPS[code](byte)) <= FARTHEST_STEP for byte in received)
