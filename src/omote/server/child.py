"""The process that plays: it warms up, waits for its order, plays until its supervisor closes the pipe."""

from __future__ import annotations

import argparse
import asyncio
import gc
import os
import signal
import socket
import sys
from collections.abc import Callable, Coroutine, Mapping
from dataclasses import dataclass
from pathlib import Path

from aiohttp import web

from omote.perform.performer import Performer
from omote.server.app import ShowServer
from omote.server.beat import Playing, beat, send_pulse
from omote.server.bundle import Page, read_bundle
from omote.server.journal import JournalWriter
from omote.server.library import Library, built_in
from omote.server.orders import READY, Order, decode_order
from omote.server.restore import open_journal, restore
from omote.server.security import own_names
from omote.show.assets import compound_asset
from omote.show.messages import STATE_RATE


@dataclass(frozen=True)
class Pipes:
    """Descriptors handed over by the supervisor: the listening socket, the pipe from it, the pipe to it."""

    listen: int
    control: int
    pulse: int


@dataclass(frozen=True)
class Material:
    """What a server serves: the cast's documents and the pages."""

    library: Library
    pages: Mapping[str, Page]


def built_in_material() -> Material:
    """The baked cast and the built pages; FileNotFoundError, with what to do, when they are missing."""
    return Material(built_in(), read_bundle())


def main(arguments: list[str] | None = None, load: Callable[[], Material] = built_in_material) -> int:
    """Warms up, says so, and plays when told to; the exit status."""
    show, pipes = _options(arguments)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal sends it to all; the supervisor decides
    os.set_blocking(pipes.pulse, False)
    try:
        material = load()
        warm(material.library)
    except (OSError, ValueError) as error:
        report(str(error))
        return 1
    send_pulse(pipes.pulse, READY)
    with os.fdopen(pipes.control, "rb", buffering=0) as control:
        line = control.readline()
        if line:
            _run(play(material, decode_order(line), show=show, pipes=pipes))
    return 0


def warm(library: Library) -> None:
    """Does once all that is slow the first time: kernels are compiled or loaded, caches filled."""
    cast = library.cast
    face = next(iter(cast.faces.values()))
    for expression in list(cast.expressions)[:2]:
        compound_asset(cast, face, expression)
    Performer(cast).advance(1.0 / STATE_RATE)
    gc.collect()
    gc.freeze()


def report(sentence: str) -> None:
    """Says a sentence to the operator's terminal."""
    sys.stderr.write(f"omote: {sentence}\n")


async def play(material: Material, order: Order, *, show: Path, pipes: Pipes) -> None:
    """Plays until the supervisor's pipe ends or SIGTERM comes; raises what a tick raises."""
    file = open_journal(show, report)
    server = ShowServer(restore(material.library.cast, file, order, report), material.library, material.pages)
    journal = JournalWriter(file, report) if file else None
    runner = web.AppRunner(server.application(own_names()), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    await web.SockSite(runner, socket.socket(fileno=pipes.listen)).start()
    try:
        await until_ended(beat(Playing(server, journal, pipes.pulse).tick), pipes.control)
    finally:
        await server.links.hang_up()
        await runner.cleanup()
        material.library.close()
        if journal:
            journal.close()


async def until_ended(beating: Coroutine[object, object, None], control: int) -> None:
    """Runs `beating` until the control pipe or SIGTERM ends it; raises what it raises."""
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    loop.add_reader(control, ended.set)
    loop.add_signal_handler(signal.SIGTERM, ended.set)
    tasks = {asyncio.create_task(beating), asyncio.ensure_future(ended.wait())}
    done, rest = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    loop.remove_reader(control)
    for task in rest:
        task.cancel()
    for task in done:
        task.result()


def _run(playing: Coroutine[object, object, None]) -> None:
    try:
        import uvloop
    except ImportError:  # not made for this platform: the stock loop is slower and does the same
        asyncio.run(playing)
    else:
        uvloop.run(playing)


def _options(arguments: list[str] | None) -> tuple[Path, Pipes]:
    parser = argparse.ArgumentParser(prog="omote.server.child", description=__doc__)
    for pipe in ("listen", "control", "pulse"):
        parser.add_argument(f"--{pipe}", type=int, required=True)
    parser.add_argument("--show", type=Path, required=True)
    options = parser.parse_args(arguments)
    return options.show, Pipes(options.listen, options.control, options.pulse)


if __name__ == "__main__":
    sys.exit(main())
