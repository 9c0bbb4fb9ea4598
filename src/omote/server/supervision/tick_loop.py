"""The show's beat: a tick sixty times a second, drift-free, and what rides on it."""

from __future__ import annotations

import asyncio
import contextlib
import os
import time
from collections.abc import Callable
from dataclasses import replace

from omote.perform.snapshot import Snapshot
from omote.server.http.app import ShowServer
from omote.server.persistence.journal import JournalWriter
from omote.server.persistence.restore import journal_entry
from omote.server.process.process_messages import PULSE_TICKS, TICK
from omote.show.messages import STATE_RATE

LATE_TICKS = 6
"""After a longer pause (a sleeping laptop) the beat starts anew; it never catches up in a burst."""
JOURNAL_TICKS = 2
"""Ticks between two entries of the journal while something moves: 33 ms."""
RESTING_TICKS = 60
"""Ticks between two entries while nothing moves but the clock, and between two roll calls."""

Tick = Callable[[int], None]


async def run_ticks(tick: Tick, *, rate: float = STATE_RATE, clock: Callable[[], float] = time.monotonic) -> None:
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


class ShowTick:
    """A server that plays, its journal and its pulse, tick by tick."""

    def __init__(self, server: ShowServer, journal: JournalWriter | None, pulse: int) -> None:
        self._server, self._journal, self._pulse = server, journal, pulse
        self._kept: Snapshot | None = None

    def tick(self, number: int) -> None:
        """A state for everybody, the pulse, the journal, the roll call."""
        self._server.tick()
        if number % PULSE_TICKS == 0:
            send_pulse(self._pulse, TICK)
        if self._journal and number % JOURNAL_TICKS == 0:
            self._keep(self._journal, even_resting=number % RESTING_TICKS == 0)
        if number % RESTING_TICKS == 0:
            self._server.broadcast_crew()

    def _keep(self, journal: JournalWriter, *, even_resting: bool) -> None:
        session = self._server.session
        still = replace(session.performer.snapshot(), time=0.0)
        if still != self._kept or even_resting:
            self._kept = still
            journal.offer(journal_entry(session))


def send_pulse(pulse: int, sign: bytes) -> None:
    """Lets the supervisor know; a full or closed pipe means that it does not listen, which is no reason to wait."""
    with contextlib.suppress(BlockingIOError, BrokenPipeError):
        os.write(pulse, sign)
