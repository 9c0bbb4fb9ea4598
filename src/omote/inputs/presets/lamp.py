"""Lamps of a device that show what is on air otherwise than its controls send."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class DeviceLamp:
    """How a control is shown that is shown otherwise than it sends: the message's status and number, and its value at
    both ends."""

    status: int
    number: int
    low: int = 0
    high: int = 127

    def message(self, position: float) -> bytes:
        """The message that shows a position, 0 to 1."""
        return bytes([self.status, self.number, self.low + round(position * (self.high - self.low))])
