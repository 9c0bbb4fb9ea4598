"""The tick loop of the show: sixty drift-free ticks a second, more while devices speak; each with state, heartbeat and
journal."""

from __future__ import annotations

import asyncio
import contextlib
import os
import time
from collections.abc import Callable, Sequence
from typing import Protocol

from omote.perform.scene.scene_snapshot import SceneSnapshot, without_time
from omote.server.http.app import ShowServer
from omote.server.persistence.restore import journal_entry
from omote.server.process.notice_board import NoticeBoard
from omote.server.process.process_messages import PULSE_TICKS, TICK, write_notice
from omote.show.messages import STATE_RATE
from omote.show.ownership.leasing import LeaseSnapshot
from omote.showfile.show_file import JournalEntry

LATE_TICKS = 6
"""After a longer pause (a sleeping laptop) the loop starts anew; it never catches up in a burst."""
JOURNAL_TICKS = 2
"""Ticks between two entries of the journal while something moves: 33 ms."""
RESTING_TICKS = 60
"""Ticks between two entries while nothing moves but the clock, and between two broadcasts of the crew."""

APART = 0.25
"""Of a beat, between an early tick and the ticks on either side of it."""

Tick = Callable[[int | None], None]
"""A tick by the number of its beat; None for an early one, so that what is done every so many beats is done in time."""


class Early(Protocol):
    """Where devices are heard between ticks (`EarlyTicks`)."""

    def forget(self) -> None:
        """Forgets what has been noted so far: it is on air."""

    async def spoke_within(self, seconds: float) -> bool:
        """Whether a device has spoken since `forget`, or speaks within some seconds."""


async def run_ticks(
    tick: Tick, *, rate: float = STATE_RATE, clock: Callable[[], float] = time.monotonic, early: Early | None = None
) -> None:
    """Calls `tick(beat)` `rate` times a second, for ever; early: in every second beat at most once more, with None, as
    soon as a device speaks there.

    rate: beats a second; clock: seconds, monotonic.
    """
    start = clock()
    count = 0
    beat = 0
    extra = False
    while True:
        tick(beat)
        beat += 1
        count += 1
        wait = start + count / rate - clock()
        if wait < -LATE_TICKS / rate:
            start = clock()
            count = 0
        extra = early is not None and not extra and await _is_early(early, wait, APART / rate)
        if extra:
            tick(None)
        await asyncio.sleep(max(0.0, start + count / rate - clock()))


async def _is_early(early: Early, wait: float, apart: float) -> bool:
    """Waits for a device to speak well before the next tick, which is `wait` seconds away; whether it did."""
    early.forget()
    if wait <= 2.0 * apart:
        return False
    await asyncio.sleep(apart)
    return await early.spoke_within(wait - 2.0 * apart)


class Journal(Protocol):
    """Keeps the newest state (`JournalWriter`, `MemoryCopy`)."""

    def offer(self, entry: JournalEntry) -> None:
        """Queues the newest state; returns at once."""


class ShowTick:
    """One tick of a playing server: its state, its heartbeat and its journal."""

    def __init__(self, server: ShowServer, journals: Sequence[Journal], pulse: int, board: NoticeBoard) -> None:
        self._server = server
        self._journals = journals
        self._pulse = pulse
        self._board = board
        self._kept: tuple[SceneSnapshot, SceneSnapshot | None, LeaseSnapshot, set[tuple[str, int]]] | None = None

    def tick(self, beat: int | None) -> None:
        """Broadcasts the state and notices; on a beat sends the heartbeat, writes the journal, broadcasts who is
        connected."""
        self._server.tick()
        for sentence in self._server.session.take_lost():
            self._board.post(sentence)
        for notice in self._board.take_new():
            self._server.post(self._board.notices)
            send_pulse(self._pulse, write_notice(notice))  # so that the next server knows it too
        if beat is None:
            return
        if beat % PULSE_TICKS == 0:
            send_pulse(self._pulse, TICK)
        if self._journals and beat % JOURNAL_TICKS == 0:
            self._keep(even_resting=beat % RESTING_TICKS == 0)
        if beat % RESTING_TICKS == 0:
            self._server.broadcast_crew()
            self._server.broadcast_notices()

    def _keep(self, *, even_resting: bool) -> None:
        session = self._server.session
        surfaces = {(surface.host, surface.port) for surface in session.surfaces}
        preview = session.preview.snapshot()
        unseen = None if preview is None else without_time(preview.scene)
        still = without_time(session.scene.snapshot()), unseen, session.leasing.snapshot(), surfaces
        if still != self._kept or even_resting:
            self._kept = still
            entry = journal_entry(session)
            for journal in self._journals:
                journal.offer(entry)


def send_pulse(pulse: int, sign: bytes) -> None:
    """Sends a heartbeat to the supervisor; never waits: a full or closed pipe means that nobody reads it.

    pulse: the pipe; sign: the heartbeat, or a notice.
    """
    with contextlib.suppress(BlockingIOError, BrokenPipeError):
        os.write(pulse, sign)
