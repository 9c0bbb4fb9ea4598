"""The machine's own measure: how long a named piece of work takes here, beside the machine for which bars were set.

A bar in seconds fails on a slower machine though nothing is wrong, so that every bar in time is asked *at the pace of
the machine*: a bar of 2 ms where the piece of work takes 1.5 times as long as it did there is one of 3 ms here. The
piece of work is `work`: what a show's programs do most, and nothing of ours, so that no change of Omote moves it.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable

import numpy as np

REFERENCE_SECONDS = 0.23e-3
"""What `work` takes where the pace is 1: on the machine for which bars in time were set, whose tick with all of it took
1.13 ms at 99 % (`benchmarks/tick.py`, load 1). On another, where 99 % of these ticks took at most 13.83 ms, 99 % of the
pieces, done by turns with them, took at most 2.81 ms."""
PIECES = 300
NUMBERS = {f"channel {number}": number / 7 for number in range(100)}
ROW = np.linspace(0.0, 1.0, 60)
POINTS = np.linspace(-1.0, 1.0, 3 * 5000).reshape(-1, 3)
PICKED = np.random.default_rng(5).integers(0, len(POINTS), len(POINTS))


def work() -> float:
    """Three parts, each about a third: a document of a hundred numbers written as JSON and read again by the standard
    library; sums of small NumPy arrays; 5,000 points gathered out of order and crossed. Gives a number of all."""
    heard = json.loads(json.dumps(NUMBERS))
    total = 0.0
    for _ in range(25):
        total += float((np.clip(ROW, 0.1, 0.9) * 0.5 + ROW).sum())
    a, b = POINTS[PICKED], POINTS
    crossed = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return total + float(np.abs(crossed).max()) + len(heard)


class Pace:
    """Times of `work`, taken beside what is measured, so that whatever slows the one slows the other.

    clock: of this thread's processor time, or `time.perf_counter` beside figures that wait.
    """

    def __init__(self, clock: Callable[[], float] = time.thread_time) -> None:
        self._clock = clock
        self._seconds = list[float]()
        work()  # what is loaded at the first call is no work

    def measure(self) -> None:
        """Does one piece of work, and keeps how long it took."""
        begun = self._clock()
        work()
        self._seconds.append(self._clock() - begun)

    def ratio(self, share: float = 0.5) -> float:
        """How many times as long as there the work takes here: `share` (0 to 1) of the pieces took at most this."""
        return float(np.quantile(self._seconds, share)) / REFERENCE_SECONDS


def measure_pace(clock: Callable[[], float] = time.thread_time) -> float:
    """The ratio of some pieces of work done now, in the median; clock: as `Pace`."""
    pace = Pace(clock)
    for _ in range(PIECES):
        pace.measure()
    return pace.ratio()


def measure_waiting_pace() -> float:
    """The pace by the clock on the wall, at least 1: what waits for a display, a sound or other programs takes longer
    on a slower or busier machine, and on a faster one no less."""
    return max(1.0, measure_pace(time.perf_counter))
