"""The One-Euro filter: what is still is held still, what moves fast follows at once.

Source: G. Casiez, N. Roussel, D. Vogel, 1 Euro Filter, CHI 2012.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Values

LONGEST_GAP = 0.5
"""Seconds; after more it begins anew."""


@dataclass(frozen=True)
class Smoothing:
    """calm: cut-off at rest, Hz; lively: Hz more for each unit a second; slope: cut-off of the speed, Hz."""

    calm: float = 3.0
    lively: float = 8.0
    slope: float = 2.0


class OneEuroFilter:
    """Filters many values at once, each by its own speed."""

    def __init__(self, smoothing: Smoothing) -> None:
        self.smoothing = smoothing
        self._time: float | None = None
        self._values = self._speeds = np.zeros(0)

    def reset(self) -> None:
        """Forgets what was; the next values come through as they are."""
        self._time = None

    def follow(self, values: Values, time: float) -> Values:
        """The filtered values (n,) at a time (seconds); a clock that jumps begins anew."""
        gap = LONGEST_GAP + 1.0 if self._time is None else time - self._time
        if not 0.0 < gap <= LONGEST_GAP:
            if gap != 0.0:
                self._time = time
                self._values = values.copy()
                self._speeds = np.zeros_like(values)
            return self._values
        one = self.smoothing
        self._speeds = self._speeds + _share(one.slope, gap) * ((values - self._values) / gap - self._speeds)
        share = _share(one.calm + one.lively * np.abs(self._speeds), gap)
        self._values = self._values + share * (values - self._values)
        self._time = time
        return self._values


def _share(cut_off: Values | float, gap: float) -> Values:
    """How far a filter of first order goes towards a new value within a gap of seconds."""
    turn = 2.0 * np.pi * np.asarray(cut_off) * gap
    result: Values = turn / (turn + 1.0)
    return result
