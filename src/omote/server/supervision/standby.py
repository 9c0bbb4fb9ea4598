"""The standby process: it waits with everything loaded and forks servers from itself.

Starting Python, loading the cast and its kernels takes seconds, so it is done once, here. On an order this
process forks (`fork_server`) in milliseconds, and the child plays. The standby has no thread and no event loop, so that
a fork is safe. It lives as long as its supervisor, and each server as long as its own pipe. Its spare is a fork of it
too: where standby and server die at one instant, nothing has to be loaded anew.
"""

from __future__ import annotations

import argparse
import contextlib
import gc
import os
import resource
import select
import signal
import socket
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from omote.model.transfer.fold_repair import warm_repair
from omote.perform.mappings.mapping import MacroMapping, MacroTarget
from omote.perform.scene.character_names import FIRST_CHARACTER
from omote.perform.scene.scene import Scene
from omote.server.access.access_setup import add_access_options, load_access, read_access_options
from omote.server.http.cast_documents import CastDocuments
from omote.server.process.fork import fork_process
from omote.server.process.priority import raise_priority
from omote.server.process.process_messages import (
    REJECTED,
    Ended,
    Order,
    Ready,
    SpareOrder,
    Started,
    receive_order,
    send_news,
)
from omote.server.supervision.device_sockets import add_device_options, read_device_options
from omote.server.supervision.show_process import Pipes, ShowMaterial, load_material, report, run
from omote.show.messages import STATE_RATE
from omote.showfile.database_errors import describe_error
from omote.stage_data.assets import compound_asset

END_SECONDS = 3.0
"""How long servers may take to end when their supervisor is gone."""
MOST_DESCRIPTORS = 65536

Play = Callable[[Order, int, int], None]
"""Plays an order, with the control and the pulse of its server."""


def main(arguments: list[str] | None = None, load: Callable[[], ShowMaterial] = load_material) -> int:
    """Loads and warms everything, reports ready, and serves orders; returns the exit status.

    arguments: of the command line; load: gives the cast and the pages.
    """
    options = _options(arguments)
    allow_descriptors()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a terminal sends it to all; the supervisor decides
    try:
        access = load_access(read_access_options(options))
        material = load()
        warm(material.documents)
    except (OSError, ValueError) as error:
        report(describe_error(error))
        return REJECTED

    def play(order: Order, control: int, pulse: int) -> None:
        pipes = Pipes(options.listen, control, pulse, read_device_options(options), access)
        run(material, order, show=Path(order.show or options.show), pipes=pipes)

    with socket.socket(fileno=options.line) as line:
        stand_by(line, play)
    return 0


def stand_by(line: socket.socket, play: Play) -> None:
    """Reports ready and serves orders, before other programs, until the supervisor is gone.

    line: to the supervisor; play: what servers do.
    """
    raise_priority(leads_session=True)
    send_news(line, Ready(os.getpid()))
    serve_orders(line, play)


def allow_descriptors() -> None:
    """Raises the number of descriptors that servers may have, as far as this process may: pages and programs that
    connect take one each."""
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = MOST_DESCRIPTORS if most == resource.RLIM_INFINITY else min(most, MOST_DESCRIPTORS)
    resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, most))


def warm(documents: CastDocuments) -> None:
    """Runs once what is slow the first time: compiles or loads kernels and fills caches."""
    cast = documents.cast
    # Another face than the generic one goes through more kernels: the first that a show calls would wait for them.
    for face in list(cast.faces.values())[:2]:
        for expression in list(cast.expressions)[:2]:
            compound_asset(cast, face, expression)
    warm_repair()
    scene = Scene.begun(cast)
    for pad in [*scene.pads][:1]:
        scene.move_pad(FIRST_CHARACTER, pad, None)
    scene[FIRST_CHARACTER].set_motion(0.5)
    scene[FIRST_CHARACTER].set_mapping(MacroMapping("turn", (MacroTarget("head/yaw"),)))
    scene[FIRST_CHARACTER].move_macro("turn", 0.5)
    scene.advance(1.0 / STATE_RATE)
    _ = documents.worker.runner, documents.worker.net, documents.worker.welcome
    gc.collect()
    gc.freeze()  # children share this memory (copy on write) as long as nobody touches it


def serve_orders(line: socket.socket, play: Play) -> None:
    """Starts a server for each order and reports each that ended, and spares, until the supervisor is gone.

    line: to the supervisor; play: what servers do.
    """
    wake, woken = os.pipe()
    os.set_blocking(wake, False)
    os.set_blocking(woken, False)
    signal.set_wakeup_fd(woken)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    servers: set[int] = set()
    while True:
        readable = select.select([line.fileno(), wake], [], [])[0]
        if wake in readable:
            os.read(wake, 4096)
            for ended in reap_servers():
                servers.discard(ended.pid)
                send_news(line, ended)
        if line.fileno() in readable:
            taken = receive_order(line)
            if taken is None:
                return wait_for_servers(servers, wake)
            order, descriptors = taken
            if isinstance(order, SpareOrder):
                fork_spare([line.fileno(), wake, woken], descriptors[0], play)
            else:
                pid = fork_server(line, partial(play, order, *descriptors))
                servers.add(pid)
                send_news(line, Started(pid))
            for descriptor in descriptors:
                os.close(descriptor)


def wait_for_servers(servers: set[int], wake: int) -> None:
    """Waits until servers whose supervisor is gone have ended, and kills those that do not.

    servers: their process ids; wake: readable once one has ended.
    """
    deadline = time.monotonic() + END_SECONDS
    while (servers := servers - {ended.pid for ended in reap_servers()}) and (left := deadline - time.monotonic()) > 0:
        select.select([wake], [], [], left)
        with contextlib.suppress(BlockingIOError):
            os.read(wake, 4096)
    for pid in servers:
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)


def fork_server(line: socket.socket, play: Callable[[], None]) -> int:
    """Forks a child that plays and exits; returns its process id. The child closes its copy of the line.

    line: to the supervisor; play: what the child does.
    """

    def play_in_child() -> None:
        line.close()
        play()

    return fork_process(play_in_child)


def fork_spare(own: Sequence[int], line: int, play: Play) -> None:
    """Forks a child that stands by in a session of its own, and is no child of this process: whatever ends this one,
    with its children or its session, leaves the other alone.

    own: descriptors that the child closes, of this process alone; line: from the supervisor, for the child; play: what
    servers do.
    """

    def stand_by_in_child() -> None:
        for descriptor in own:
            os.close(descriptor)
        with socket.socket(fileno=line) as spare:
            stand_by(spare, play)

    def leave() -> None:
        os.setsid()
        fork_process(stand_by_in_child)

    os.waitpid(fork_process(leave), 0)


def reap_servers() -> list[Ended]:
    """Reaps and returns the servers that have ended since the last call."""
    ended: list[Ended] = []
    while True:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return ended
        if pid == 0:
            return ended
        ended.append(Ended(pid, os.waitstatus_to_exitcode(status)))


def _options(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="omote.server.supervision.standby", description=__doc__)
    parser.add_argument("--show", type=Path, required=True)
    parser.add_argument("--listen", type=int, required=True)
    parser.add_argument("--line", type=int, required=True)
    add_device_options(parser)
    add_access_options(parser)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    sys.exit(main())
