"""The process that plays: until its supervisor closes the pipe."""

from __future__ import annotations

import asyncio
import signal
import socket
import sys
from collections.abc import Callable, Coroutine, Mapping
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from aiohttp import web

from omote.server.http.app import ShowServer
from omote.server.http.cast_documents import Library, built_in
from omote.server.http.cast_reload import gathered
from omote.server.http.security import own_names
from omote.server.http.static_pages import Page, read_bundle
from omote.server.persistence.authored_work import Desk, open_desk
from omote.server.persistence.commit_thread import Scribe
from omote.server.persistence.journal import JournalWriter
from omote.server.persistence.restore import journal_entry, open_journal, restore
from omote.server.process.process_messages import Order
from omote.server.supervision.tick_loop import Playing, beat
from omote.server.workers.workshop import open_workshop
from omote.showfile.show_file import ShowFile


@dataclass(frozen=True)
class Pipes:
    """Descriptors from the supervisor: the listening socket, the pipe from it (its end is our end), the pulse."""

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


def report(sentence: str) -> None:
    """Says a sentence to the operator's terminal."""
    sys.stderr.write(f"omote: {sentence}\n")


def run(material: Material, order: Order, *, show: Path, pipes: Pipes) -> None:
    """Plays to the end, on the fastest event loop there is."""
    employ_workshop(material.library)  # while there is neither thread nor loop, which no copy may have
    playing = play(material, order, show=show, pipes=pipes)
    try:
        import uvloop
    except ImportError:  # not made for this platform: the stock loop is slower and does the same
        asyncio.run(playing)
    else:
        uvloop.run(playing)


def employ_workshop(library: Library) -> None:
    """Has everything computed beside the server; where no process can be made, in a thread of it."""
    try:
        library.employ(open_workshop(library.compute), report)
    except OSError as error:
        report(f"no process can be made that computes ({error}); the server computes by itself.")


async def play(material: Material, order: Order, *, show: Path, pipes: Pipes) -> None:
    """Plays until the supervisor's pipe ends or SIGTERM comes; raises what a tick raises."""
    file, library = open_journal(show, report), material.library
    desk, reopen = open_desks(file, library, report)
    server = ShowServer(restore(library.troupe, file, order, report), library, material.pages)
    server.edit(desk, reopen, report)
    journal = JournalWriter(file, report) if file else None
    runner = web.AppRunner(server.application(own_names()), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    await web.SockSite(runner, socket.socket(fileno=pipes.listen)).start()
    try:
        await until_ended(beat(Playing(server, journal, pipes.pulse).tick), pipes.control)
    finally:
        await server.hang_up()
        await runner.cleanup()
        library.close()
        if desk:
            desk.keeper.close()
        if journal:
            journal.offer(journal_entry(server.session))
            journal.close()


def open_desks(
    file: ShowFile | None, library: Library, report: Callable[[str], None]
) -> tuple[Desk | None, Callable[[], Desk | None]]:
    """The desk of a show file, its own things in the cast already, and what gives the desk anew."""
    if file is None:
        return None, lambda: None
    keeper = Scribe(file.again(), report)

    def reopened() -> Desk | None:
        with closing(file.again()) as own:  # the journal's thread writes with the other connection
            return open_desk(own, keeper, library.bench, report)

    desk = reopened()
    if desk is None:
        keeper.close()
        return None, lambda: None
    library.contents = desk.session.contents
    library.play(gathered(library.cast, desk.session.own(), library.contents, report))
    return desk, reopened


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
