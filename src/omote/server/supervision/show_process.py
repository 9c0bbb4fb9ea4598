"""The process that plays the show, until its supervisor closes the pipe."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import sys
import time
from collections.abc import AsyncIterator, Callable, Coroutine, Mapping
from concurrent.futures import Future
from contextlib import asynccontextmanager, closing, suppress
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from pathlib import Path

from aiohttp import web

from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.access_setup import OPEN_TO_ALL, AccessSetup
from omote.server.access.security import own_names
from omote.server.access.show_addresses import outside_address
from omote.server.http.app import ShowServer
from omote.server.http.cast_documents import CastDocuments, built_in_documents
from omote.server.http.cast_reload import gather_cast
from omote.server.http.connection_limit import HEAD_SECONDS, ConnectionLimit
from omote.server.http.static_pages import Page, read_pages
from omote.server.persistence.authored_work import AuthoredWork, Committer, open_authored_work
from omote.server.persistence.backup_thread import BackupThread
from omote.server.persistence.commit_thread import CommitThread, RefusingCommitter
from omote.server.persistence.disk_wait import OpenedShow, open_in_time
from omote.server.persistence.file_gate import FileGate
from omote.server.persistence.file_watch import FileWatch
from omote.server.persistence.journal import JournalWriter
from omote.server.persistence.memory_copy import MemoryCopy, find_copy
from omote.server.persistence.restore import journal_entry, restore
from omote.server.process.notice_board import NoticeBoard
from omote.server.process.process_messages import Order, ShowMoved, write_notice
from omote.server.recording.recording_jobs import run_job
from omote.server.recording.recording_thread import RecordingThread
from omote.server.scans.scan_previews import ScanPreviews
from omote.server.scans.scan_routes import FileWork, ScanRoutes
from omote.server.supervision.device_sockets import NO_DEVICES, DeviceOptions
from omote.server.supervision.device_sources import start_devices
from omote.server.supervision.early_tick import EarlyTicks
from omote.server.supervision.tick_loop import ShowTick, Tick, run_ticks, send_pulse
from omote.server.workers.job_server import JobServer, open_job_server
from omote.server.workers.workshop import open_workshop
from omote.showfile.recording_file import recording_path
from omote.showfile.show_file import ShowFile

TELL_SECONDS = 0.3
"""Until the supervisor has heard a notice from this process."""
KEEPALIVE_SECONDS = 75.0
"""For which a connection stays open between two requests."""


@dataclass(frozen=True)
class Pipes:
    """Descriptors from the supervisor: the listening socket, the control pipe (closed: end), the heartbeat pipe;
    what there is of devices, and who may play."""

    listen: int
    control: int
    pulse: int
    devices: DeviceOptions = NO_DEVICES
    access: AccessSetup = OPEN_TO_ALL


@dataclass(frozen=True)
class ShowMaterial:
    """What a show process serves: the cast's documents and the built pages."""

    documents: CastDocuments
    pages: Mapping[str, Page]


def load_material() -> ShowMaterial:
    """Loads the baked cast and the built pages; FileNotFoundError, with what to do, when they are missing."""
    return ShowMaterial(built_in_documents(), read_pages())


def report(sentence: str) -> None:
    """Prints a sentence on the operator's terminal; one that is gone misses it."""
    with suppress(OSError):
        sys.stderr.write(f"omote: {sentence}\n")


def run(material: ShowMaterial, order: Order, *, show: Path, pipes: Pipes) -> None:
    """Plays the show to its end, on uvloop where it is available.

    material: cast and pages; order: from where to go on; show: its file; pipes: from the supervisor.
    """
    board = NoticeBoard(order.notices)
    tell = board.with_report(report)
    jobs = start_processes(material.documents, tell)  # while there is neither thread nor loop, which no copy may have
    playing = play(material, order, show=show, pipes=pipes, board=board, jobs=jobs)
    try:
        import uvloop
    except ImportError:  # not made for this platform: the stock loop is slower and does the same
        asyncio.run(playing)
    else:
        uvloop.run(playing)


def start_processes(documents: CastDocuments, tell: Callable[[str], None]) -> JobServer | None:
    """Starts the workshop, which computes orders (where that fails, a thread of the server does), and the process that
    begins imports and exports (None where that fails).

    documents: compute by the workshop from now on; tell: tells the operator.
    """
    try:
        documents.use_workshop(open_workshop(documents.compute), tell)
    except OSError as error:
        tell(f"no process can be made that computes ({explain_error(error)}); the server computes by itself.")
    try:
        return open_job_server(run_job)
    except OSError as error:
        tell(f"no process can be made for imports and exports ({explain_error(error)}); there are none in this show.")
        return None


async def play(
    material: ShowMaterial, order: Order, *, show: Path, pipes: Pipes, board: NoticeBoard, jobs: JobServer | None = None
) -> None:
    """Plays until the control pipe ends or SIGTERM comes; raises what a tick raises.

    material, order, show, pipes: as of `run`; board: the notices; jobs: does imports and exports, None for none.
    """
    os.set_blocking(pipes.pulse, False)  # a supervisor that does not read holds up no tick
    tell = board.with_report(report)
    opened = open_in_time(show, order, tell)
    file = opened.file
    kept = opened.on_disk
    documents = material.documents
    gate = FileGate()
    backup = BackupThread(kept.again(), tell, gate) if kept else None
    memory = open_memory_copy(show, kept, tell, gate)
    authored_work, reopen = open_reopenable_work(file, documents, tell, backup, gate, memory, opened.away)
    server = ShowServer(restore(documents.playing, file, order, tell), documents, material.pages)
    server.post(board.notices)
    server.tell_crew = tell
    server.enable_editing(authored_work, reopen, tell)
    scans = ScanPreviews()
    enable_files(server, (lambda: kept.path, jobs.run) if kept and jobs else None, scans)
    recording = (
        RecordingThread(recording_path(kept.path), tell, version("omote"), server.sounds.find)
        if kept and pipes.devices.recorded
        else None
    )
    if recording:
        server.recording.enable(recording, jobs.run if jobs else None)
    journal = JournalWriter(kept, tell, gate, solved=tell) if kept else None
    watch = FileWatch(kept, gate, tell, partial(tell_moved, pipes.pulse)) if kept else None
    journals = [each for each in (journal, memory) if each]
    leave_when_back(opened, show, tell)
    try:
        await serve(server, ShowTick(server, journals, pipes.pulse, board).tick, pipes, show if kept else None)
        if memory:
            memory.remove()
    finally:
        documents.close()
        scans.close()
        for each in journals:
            each.offer(journal_entry(server.session))
        for resource in (jobs, watch, authored_work and authored_work.committer, *journals, recording, backup):
            if resource:
                resource.close()


def open_memory_copy(
    show: Path, kept: ShowFile | None, tell: Callable[[str], None], gate: FileGate
) -> MemoryCopy | None:
    """Keeps the show in memory too, where the system can.

    show: the path of its file; kept: the open file, None while its disk is away; tell: tells the operator; gate: before
    the file.
    """
    copy = find_copy(show)
    return None if copy is None else MemoryCopy(copy, kept.again() if kept else None, tell, gate)


def leave_when_back(opened: OpenedShow, show: Path, tell: Callable[[str], None]) -> None:
    """Ends this process, which plays from memory, once the disk answers: the next one plays the file.

    opened: how it was opened; show: its path; tell: tells the operator.
    """

    def leave(back: Future[ShowFile | None]) -> None:
        if back.exception() is None and back.result() is not None:
            tell(f"the disk of {show} answers again: the show's process starts anew with it.")
            time.sleep(TELL_SECONDS)
            os._exit(0)

    if opened.back is not None:
        opened.back.add_done_callback(leave)


def enable_files(server: ShowServer, work: FileWork | None, scans: ScanPreviews) -> None:
    """Adds imports, exports and scans; work: where the show file lies, and what does a `FileJob`, None where there is
    no file.

    server: gets them; scans: those under way.
    """
    if work is not None:
        server.enable_files(*work)
    if server.editing is not None:
        routes = ScanRoutes(work, server.long_requests, server.editing.add_items, scans)
        server.more_routes.append(routes.add_routes)


async def serve(server: ShowServer, tick: Tick, pipes: Pipes, show: Path | None = None) -> None:
    """Hears devices, answers pages and ticks until the control pipe ends or SIGTERM comes. show: its file.

    server: answers; tick: called on each beat; pipes: from the supervisor.
    """
    early = EarlyTicks()
    server.device_spoke = early.note
    devices = await start_devices(server, pipes.devices, report, early, show)
    async with serving(server, pipes.listen, pipes.access):
        try:
            await run_until_ended(run_ticks(tick, early=early), pipes.control)
        finally:  # before what answers is cleaned up, which waits for links that are open
            await asyncio.gather(server.close_all(), *(device.close() for device in devices))


def tell_moved(pulse: int, path: Path) -> None:
    """Tells the supervisor from where the next process is to open the show file.

    pulse: the pipe to it; path: where the file lies now.
    """
    send_pulse(pulse, write_notice(ShowMoved(str(path))))


@asynccontextmanager
async def serving(server: ShowServer, listen: int, access: AccessSetup = OPEN_TO_ALL) -> AsyncIterator[None]:
    """Answers pages and links on a listening socket, given by its descriptor, for as long as it is entered.

    server: answers; listen: the descriptor; access: whom, and over https or not.
    """
    server.enable_access(access.open_control(report), access.authority)
    server.embedders = access.embedders
    server.tell_frame = report
    listening = socket.socket(fileno=listen)
    host, port = listening.getsockname()[:2]
    server.outside = outside_address(host, port, "http" if access.tls is None else "https")
    runner = web.AppRunner(
        server.application(own_names()), access_log=None, shutdown_timeout=1.0, keepalive_timeout=KEEPALIVE_SECONDS
    )
    await runner.setup()
    answering = runner.server
    assert answering is not None
    handshake = None if access.tls is None else HEAD_SECONDS
    listener = await asyncio.get_running_loop().create_server(
        ConnectionLimit(answering), sock=listening, ssl=access.tls, ssl_handshake_timeout=handshake
    )
    try:
        yield
    finally:
        listener.close()
        await runner.cleanup()


def open_reopenable_work(
    file: ShowFile | None,
    documents: CastDocuments,
    report: Callable[[str], None],
    backup: BackupThread | None = None,
    gate: FileGate | None = None,
    memory: MemoryCopy | None = None,
    away: str = "",
) -> tuple[AuthoredWork | None, Callable[[], AuthoredWork | None]]:
    """Opens the authored work of a show file and adds it to the cast; also returns the function that reopens it.

    file: the show file, None for none; documents: of the cast; report: tells the operator; backup: keeps copies; gate:
    before the file; memory: copies what is committed; away: why nothing can be committed, "" where it can.
    """
    if file is None:
        return None, lambda: None
    gate = gate or FileGate()
    committed = memory.note_commit if memory else lambda: None
    committer: Committer = (
        RefusingCommitter(away) if away else CommitThread(file.again(), report, backup, gate, committed=committed)
    )

    def reopen() -> AuthoredWork | None:
        with gate, closing(file.again()) as own:  # the journal's thread writes with the other connection
            return open_authored_work(own, committer, documents.worker, report)

    authored_work = reopen()
    if authored_work is None:
        committer.close()
        return None, lambda: None
    documents.contents = authored_work.session.contents
    documents.play(gather_cast(documents.cast, authored_work.session.own(), documents.contents, report))
    return authored_work, reopen


async def run_until_ended(ticking: Coroutine[object, object, None], control: int) -> None:
    """Runs `ticking` until the pipe `control` or SIGTERM ends it; raises what it raises."""
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    loop.add_reader(control, ended.set)
    loop.add_signal_handler(signal.SIGTERM, ended.set)
    tasks = {asyncio.create_task(ticking), asyncio.ensure_future(ended.wait())}
    done, rest = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    loop.remove_reader(control)
    for task in rest:
        task.cancel()
    await asyncio.gather(*rest, return_exceptions=True)  # it lets go of sockets that are closed next
    for task in done:
        task.result()
