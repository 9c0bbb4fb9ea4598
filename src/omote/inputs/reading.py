"""What a control of any device reads: the one form in which knobs, keys, axes and slots of DMX come to bindings."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Reading:
    """A control's value. device: its name, for ever; control: the control's name on it; value: 0 to 1 (an axis that
    rests in the middle: 0.5); key: it is a key, pressed at anything above 0, where a level is from one half on."""

    device: str
    control: str
    value: float
    key: bool = False
