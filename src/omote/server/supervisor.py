"""Keeps a server playing: one plays, one waits warmed up to take over.

The supervisor owns the listening socket, so browsers that come back while no server plays wait in its queue and are
heard by the next one. It does nothing else, so that nothing can bring it down. A server is gone when its pulse pipe
ends (at once, whatever killed it) and hangs when its pulse stops; the pipe to a server tells it to end by ending
itself, so no server outlives its supervisor.
"""

from __future__ import annotations

import os
import selectors
import signal
import socket
import subprocess
import sys
import time
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from omote.server.orders import READY, Order, encode_order

PROGRAM = (sys.executable, "-m", "omote.server.child")
HANG_SECONDS = 1.0
"""Silence of a playing server after which it is replaced."""
START_SECONDS = 10.0
"""The same, from its order to its first tick."""
CRASHES, CRASH_SECONDS = 3, 30.0
"""So many deaths within so many seconds blame the state that the servers started from."""
END_SECONDS = 3.0
RESPAWN_SECONDS = 2.0
"""Pause before another try when a server died before it was warmed up."""
WAIT_SECONDS = 0.25


@dataclass(eq=False)
class Server:
    """A server process; `order`: the pipe to it, `pulse`: the pipe from it."""

    process: subprocess.Popen[bytes]
    order: int
    pulse: int
    ready: bool = False
    playing: bool = False
    heard: float = field(default_factory=time.monotonic)

    def tell(self, order: Order) -> None:
        """Sends the order to play."""
        os.write(self.order, encode_order(order))
        self.heard = time.monotonic()

    def hangs(self, now: float) -> bool:
        """Whether a server that should play has been silent for too long."""
        return now - self.heard > (HANG_SECONDS if self.playing else START_SECONDS)


class Supervisor:
    """Starts, watches and replaces the servers of one show."""

    def __init__(
        self,
        listen: socket.socket,
        lock: int,
        show: Path,
        *,
        report: Callable[[str], None],
        opened: Callable[[], None],
        program: Sequence[str] = PROGRAM,
    ) -> None:
        self._listen, self._lock, self._show, self._program = listen, lock, show, tuple(program)
        self._report, self._opened = report, opened
        self._active: Server | None = None
        self._standby: Server | None = None
        self._spawn_at = 0.0
        self._epoch = 0
        self._deaths: deque[float] = deque(maxlen=CRASHES)
        self._failed = 0
        self._played = False
        self._ending = False
        self._selector = selectors.DefaultSelector()

    def run(self) -> int:
        """Keeps the show playing until a signal ends it; exit status 1 when no server could be started at all."""
        wake, woken = socket.socketpair()
        woken.setblocking(False)
        previous = signal.set_wakeup_fd(woken.fileno(), warn_on_full_buffer=False)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, self._end)
        self._selector.register(wake, selectors.EVENT_READ)
        try:
            while not self._ending:
                if not self._keep_playing():
                    return 1
                self._listen_to_servers()
            return 0
        finally:
            signal.set_wakeup_fd(previous)
            self._end_servers()
            self._selector.close()
            wake.close()
            woken.close()

    def _end(self, *_: object) -> None:
        self._ending = True

    def _keep_playing(self) -> bool:
        now = time.monotonic()
        if self._active is None and self._standby is not None and self._standby.ready:
            self._promote(now)
        if self._standby is None and now >= self._spawn_at:
            self._standby = self._spawn()
        if self._active is not None and self._active.hangs(now):
            self._report("the server hangs; another one takes over.")
            self._active.process.kill()
            self._bury(self._active)
        alive = self._active is not None or self._standby is not None
        return self._played or (alive and self._failed < CRASHES)

    def _promote(self, now: float) -> None:
        server, self._standby = self._standby, None
        if server is None:
            return
        self._epoch += 1
        neutral = len(self._deaths) == CRASHES and now - self._deaths[0] < CRASH_SECONDS
        if neutral:
            self._report(
                f"{CRASHES} servers died within {CRASH_SECONDS:g} seconds; the show starts again from neutral."
            )
            self._deaths.clear()
        self._active = server
        try:
            server.tell(Order(epoch=self._epoch, neutral=neutral))
        except BrokenPipeError:
            self._bury(server)

    def _spawn(self) -> Server:
        order_read, order_write = os.pipe()
        pulse_read, pulse_write = os.pipe()
        handed = {"--listen": self._listen.fileno(), "--control": order_read, "--pulse": pulse_write}
        command = [*self._program, "--show", str(self._show)]
        command += [word for name, descriptor in handed.items() for word in (name, str(descriptor))]
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            pass_fds=(*handed.values(), self._lock),
            start_new_session=True,  # Ctrl-C reaches the supervisor only
            env={"OPENBLAS_NUM_THREADS": "1", **os.environ},
        )
        os.close(order_read)
        os.close(pulse_write)
        server = Server(process, order_write, pulse_read)
        self._selector.register(pulse_read, selectors.EVENT_READ, server)
        return server

    def _listen_to_servers(self) -> None:
        for key, _ in self._selector.select(WAIT_SECONDS):
            if isinstance(key.data, Server):
                self._hear(key.data)

    def _hear(self, server: Server) -> None:
        pulse = os.read(server.pulse, 4096)
        if not pulse:
            self._bury(server)
            return
        server.heard = time.monotonic()
        if READY in pulse:
            server.ready = True
        elif not server.playing:
            server.playing = True
            if not self._played:
                self._played = True
                self._opened()

    def _bury(self, server: Server) -> None:
        self._selector.unregister(server.pulse)
        os.close(server.pulse)
        os.close(server.order)
        server.process.kill()
        status = server.process.wait()
        if server is self._active:
            self._active = None
            self._deaths.append(time.monotonic())
            if not server.playing:  # it never came to a tick: trying again at once would help nobody
                self._failed += 1
                self._spawn_at = time.monotonic() + RESPAWN_SECONDS
            else:
                self._failed = 0
            if not self._ending:
                self._report(f"the server ended (status {status}); another one takes over.")
        else:
            self._standby = None
            self._spawn_at = time.monotonic() + RESPAWN_SECONDS
            if self._played:
                self._report(f"the waiting server ended (status {status}); another one is started.")

    def _end_servers(self) -> None:
        servers = [server for server in (self._active, self._standby) if server is not None]
        for server in servers:
            os.close(server.order)
            os.close(server.pulse)
        deadline = time.monotonic() + END_SECONDS
        for server in servers:
            try:
                server.process.wait(max(0.0, deadline - time.monotonic()))
            except subprocess.TimeoutExpired:
                server.process.kill()
                server.process.wait()


def listen_on(host: str, port: int) -> socket.socket:
    """The listening socket of a show; OSError, in a sentence, when the port is taken or the address is not ours."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        listening = socket.create_server((host, port), family=family, backlog=512)
    except OSError as error:
        raise OSError(
            f"port {port} on {host} cannot be opened ({error.strerror}): name another with --port."
        ) from error
    return listening
