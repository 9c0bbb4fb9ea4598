"""The process that plays: it warms up, waits for its order, plays until its supervisor closes the pipe."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import gc
import os
import signal
import socket
import sys
from collections.abc import Coroutine
from dataclasses import replace
from pathlib import Path

from aiohttp import web

from omote.perform.performer import Performer
from omote.perform.snapshot import Snapshot
from omote.server.app import ShowServer
from omote.server.bundle import Page, read_bundle
from omote.server.journal import JournalWriter
from omote.server.library import Library, built_in
from omote.server.loop import beat
from omote.server.orders import PULSE_TICKS, READY, TICK, Order, decode_order
from omote.server.restore import journal_entry, open_journal, restore
from omote.server.security import own_names
from omote.show.assets import compound_asset
from omote.show.messages import STATE_RATE

JOURNAL_TICKS = 3
"""Ticks between two entries while something moves: 50 ms."""
RESTING_TICKS = int(STATE_RATE)
"""Ticks between two entries while nothing moves but the clock."""


class Playing:
    """A server that plays, its journal and its pulse, tick by tick."""

    def __init__(self, server: ShowServer, journal: JournalWriter | None, pulse: int) -> None:
        self._server, self._journal, self._pulse = server, journal, pulse
        self._kept: Snapshot | None = None

    def tick(self, number: int) -> None:
        """A state for everybody, the journal, the pulse, the roll call."""
        self._server.tick()
        if number % PULSE_TICKS == 0:
            beat_pulse(self._pulse, TICK)
        if number % JOURNAL_TICKS == 0:
            self._keep(resting=number % RESTING_TICKS != 0)
        if number % RESTING_TICKS == 0:
            self._server.call_the_roll()

    def _keep(self, *, resting: bool) -> None:
        if self._journal is None:
            return
        now = replace(self._server.session.performer.snapshot(), time=0.0)
        if now == self._kept and resting:
            return
        self._kept = now
        self._journal.offer(journal_entry(self._server.session))


def main(arguments: list[str] | None = None) -> int:
    """Warms up, says so, and plays when told to; the exit status."""
    options = _options(arguments)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal sends it to all; the supervisor decides
    os.set_blocking(options.pulse, False)
    try:
        pages, library = read_bundle(), built_in()
        warm(library)
    except (OSError, ValueError) as error:
        report(str(error))
        return 1
    beat_pulse(options.pulse, READY)
    with os.fdopen(options.control, "rb", buffering=0) as control:
        line = control.readline()
        if line:
            _run(_play(options, decode_order(line), control.fileno(), library, pages))
    return 0


def warm(library: Library) -> None:
    """Does once all that is slow the first time: kernels are compiled or loaded, caches filled."""
    cast = library.cast
    performer = Performer(cast)
    for expression in list(cast.expressions)[:2]:
        compound_asset(cast, next(iter(cast.faces.values())), expression)
    performer.advance(1.0 / STATE_RATE)
    gc.collect()
    gc.freeze()


def report(sentence: str) -> None:
    """Says a sentence to the operator's terminal."""
    sys.stderr.write(f"omote: {sentence}\n")


def beat_pulse(pulse: int, beat_of: bytes) -> None:
    """Lets the supervisor know; a full pipe means that it does not listen, which is no reason to wait."""
    with contextlib.suppress(BlockingIOError, BrokenPipeError):
        os.write(pulse, beat_of)


async def _play(
    options: argparse.Namespace, order: Order, control: int, library: Library, pages: dict[str, Page]
) -> None:
    show = open_journal(options.show, report)
    session = restore(library.cast, show, order, report)
    server = ShowServer(session, library, pages)
    journal = JournalWriter(show, report) if show else None
    runner = web.AppRunner(server.application(own_names()), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    await web.SockSite(runner, socket.socket(fileno=options.listen)).start()
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    loop.add_reader(control, ended.set)  # its end is the supervisor's end
    loop.add_signal_handler(signal.SIGTERM, ended.set)
    beating = asyncio.create_task(beat(Playing(server, journal, options.pulse).tick))
    waiting = asyncio.create_task(ended.wait())
    done, _ = await asyncio.wait({beating, waiting}, return_when=asyncio.FIRST_COMPLETED)
    loop.remove_reader(control)
    beating.cancel()
    await runner.cleanup()
    library.close()
    if journal:
        journal.close()
    if beating in done:
        beating.result()  # a tick that failed ends this server with its traceback; the next one takes over


def _run(main_coroutine: Coroutine[object, object, None]) -> None:
    try:
        import uvloop
    except ImportError:  # no uvloop on Windows
        asyncio.run(main_coroutine)
    else:
        uvloop.run(main_coroutine)


def _options(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="omote.server.child", description=__doc__)
    for pipe in ("listen", "control", "pulse"):
        parser.add_argument(f"--{pipe}", type=int, required=True)
    parser.add_argument("--show", type=Path, required=True)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    sys.exit(main())
