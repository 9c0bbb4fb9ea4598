"""Which channels of a sender of many move most: what a page shows of it in a line."""

from __future__ import annotations

from collections.abc import Mapping

MOST_SHOWN = 6
FADING = 0.9
"""What is left of a movement from one look to the next, of ten a second: about two seconds."""
OF_VALUE = 0.02
"""How much a channel counts by where it stands: it decides where nothing moves."""


class SenderActivity:
    """How much each channel of a sender has moved lately."""

    def __init__(self) -> None:
        self._before: dict[str, float] = {}
        self._moved: dict[str, float] = {}

    def look(self, values: Mapping[str, float]) -> dict[str, float]:
        """The newest values of the few channels that move most, in the order of the sender's."""
        self._moved = {
            name: FADING * self._moved.get(name, 0.0) + abs(value - self._before.get(name, value))
            for name, value in values.items()
        }
        self._before = dict(values)
        ranked = sorted(values, key=lambda name: -(self._moved[name] + OF_VALUE * abs(values[name])))
        shown = {name for name in ranked[:MOST_SHOWN] if self._moved[name] + abs(values[name]) > 0.0}
        return {name: value for name, value in values.items() if name in shown}
