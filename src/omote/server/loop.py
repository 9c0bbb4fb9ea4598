"""The show's beat: a tick sixty times a second, drift-free, and what rides on it."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

from omote.show.messages import STATE_RATE

LATE_TICKS = 6
"""After a longer pause (a sleeping laptop) the beat starts anew; it never catches up in a burst."""


async def beat(
    tick: Callable[[int], None], *, rate: float = STATE_RATE, clock: Callable[[], float] = time.monotonic
) -> None:
    """Calls `tick(number)` `rate` times a second, for ever."""
    start, count, number = clock(), 0, 0
    while True:
        tick(number)
        number += 1
        count += 1
        wait = start + count / rate - clock()
        if wait < -LATE_TICKS / rate:
            start, count = clock(), 0
        await asyncio.sleep(max(0.0, wait))
