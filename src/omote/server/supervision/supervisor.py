"""Supervises the show: one server plays, and a standby process waits to fork the next one.

The supervisor owns the listening socket, so browsers that reconnect while no server plays wait in its queue for
the next one. It does little else, so that nothing can bring it down. A server is gone when its heartbeat pipe closes
(at once, whatever killed it) and hangs when its heartbeat stops. Servers and standby end when the supervisor's pipes to
them close, so nothing outlives the supervisor.
"""

from __future__ import annotations

import contextlib
import os
import selectors
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

from omote.server.process.notice_board import MOST_NOTICES
from omote.server.process.priority import others_waiting_seconds, raise_priority, waiting_seconds
from omote.server.process.process_messages import (
    Ended,
    Failover,
    News,
    Order,
    Ready,
    ShowMoved,
    SpareOrder,
    Started,
    read_news,
    read_pulse,
    send_order,
)
from omote.server.supervision.crash_loop import CrashLoop
from omote.server.supervision.start_limit import FAILURES, PAUSE_SECONDS, StartLimit
from omote.show.objects.link import Notice

PROGRAM = (sys.executable, "-m", "omote.server.supervision.standby")
HANG_SECONDS = 0.6
"""Silence of a playing server after which it is replaced."""
START_SECONDS = 10.0
"""Seconds from an order to the first tick after which a server counts as hung."""
END_SECONDS = 3.0
"""How long servers may take to end when told to."""
WAIT_SECONDS = 0.15
LONGEST_EXCUSE = 4.0
"""Seconds of silence at most that the starving of others than a server's main thread excuses: one that hangs on a
starved machine is found by then."""

Report = Callable[[str], None]


@dataclass(eq=False)
class Standby:
    """A standby process and the line to it; process: None where another standby has forked it, `pid` as it tells."""

    process: subprocess.Popen[bytes] | None
    line: socket.socket
    ready: bool = False
    pid: int | None = None

    def end(self, deadline: float) -> int | None:
        """Has it end by itself until a deadline (s, monotonic), and kills it then; its exit status, None where it is
        not ours to wait for."""
        ended = self._hears_end(deadline)
        self.line.close()
        if self.process is not None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                return self.process.wait(max(0.0, deadline - time.monotonic()))
            self.process.kill()
            return self.process.wait()
        if self.pid is not None and not ended:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, signal.SIGKILL)
        return None

    def _hears_end(self, deadline: float) -> bool:
        """Waits for the end of the line, which this process alone holds at its other side."""
        with contextlib.suppress(OSError):
            self.line.shutdown(socket.SHUT_WR)
        try:
            while (left := deadline - time.monotonic()) > 0:
                self.line.settimeout(left)
                if not self.line.recv(65536):
                    return True
        except ConnectionError:
            return True
        except TimeoutError:
            pass
        return False


@dataclass(eq=False)
class Server:
    """A server process: closing `control` ends it, `pulse` is its heartbeat, `pid` comes from the standby."""

    control: int
    pulse: int
    pid: int | None = None
    playing: bool = False
    rest: bytes = b""
    heard: float = field(default_factory=time.monotonic)
    waited: float = 0.0
    locked: float = 0.0
    late: float = 0.0

    def hear(self, now: float) -> None:
        """Notes a sign of life."""
        self.heard = now
        self.late = 0.0
        self.waited, self.locked = self._waiting()

    def hangs(self, now: float) -> bool:
        """Whether it has been silent for too long, without the time in which other programs had all processors: one
        that takes over would get no more.

        That is when its main thread was ready and waited; when another of its threads did, which may hold what the main
        one needs; and when the supervisor itself came late.
        """
        silent = now - self.heard
        most = HANG_SECONDS if self.playing else START_SECONDS
        if silent <= most:
            return False
        waited, locked = self._waiting()
        around = max(0.0, locked - self.locked) + self.late
        return silent - (waited - self.waited) - min(around, LONGEST_EXCUSE) > most

    def _waiting(self) -> tuple[float, float]:
        if self.pid is None:
            return 0.0, 0.0
        return waiting_seconds(self.pid), others_waiting_seconds(self.pid)


class Supervisor:
    """Starts, watches and replaces the servers of one show; `opened` is called when the first of them plays.

    notices: what the crew is to know from the start; what servers tell it is kept here for those after them. handed:
    descriptors of more sockets, by the option of a standby that takes each.
    """

    def __init__(
        self,
        listen: socket.socket,
        lock: int,
        show: Path,
        *,
        report: Report,
        opened: Callable[[], None],
        program: Sequence[str] = PROGRAM,
        notices: Sequence[Notice] = (),
        handed: Mapping[str, int] = MappingProxyType({}),
    ) -> None:
        self._listen = listen
        self._lock = lock
        self._show = show
        self._program = tuple(program)
        self._report = report
        self._opened = opened
        self._standby: Standby | None = None
        self._spare: Standby | None = None
        self._server: Server | None = None
        self._crash_loop = CrashLoop()
        self._start_limit = StartLimit()
        self._failover: Failover | None = None
        self._notices = list(notices)
        self._handed = handed
        self._not_before = self._spare_not_before = self._checked = 0.0
        self._epoch = 0
        self._ending = False
        self._selector = selectors.DefaultSelector()

    def run(self) -> int:
        """Keeps the show playing until a signal ends it; exit status 1 when no server could ever play."""
        wake, woken = socket.socketpair()
        woken.setblocking(False)
        self._selector.register(wake, selectors.EVENT_READ)
        before = signal.set_wakeup_fd(woken.fileno(), warn_on_full_buffer=False)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._end)
        if signal.getsignal(signal.SIGHUP) is not signal.SIG_IGN:  # nohup
            signal.signal(signal.SIGHUP, self._end)
        try:
            while not self._ending:
                if self._start_limit.reached:
                    return self._give_up()
                self._keep_playing(time.monotonic())
                self._listen_to_all()
            return 0
        finally:
            signal.set_wakeup_fd(before)
            self._end_all()
            self._selector.close()
            wake.close()
            woken.close()

    def _end(self, *_: object) -> None:
        self._ending = True

    def _give_up(self) -> int:
        if not self._start_limit.rejected:  # a standby that was rejected has said why itself
            self._report(f"the show could not be started in {FAILURES} tries; what went wrong stands above.")
        return 1

    def _keep_playing(self, now: float) -> None:
        if self._server is not None and now - self._checked > HANG_SECONDS / 2:
            self._server.hear(now)  # we got no time ourselves, so its silence proves nothing
        elif self._server is not None:
            self._server.late += max(0.0, now - self._checked - WAIT_SECONDS)
        self._checked = now
        if self._server is not None and self._server.hangs(now):
            self._report("the server hangs; another one takes over.")
            self._note_failover(self._server, self._server.heard, hung=True)
            if not self._server.playing:
                self._crash_loop.record_hang(now)
            self._drop_server(self._server)
        self._start_what_lacks(now)

    def _start_what_lacks(self, now: float) -> None:
        if now >= self._not_before:
            if self._standby is None:
                self._standby = self._start_standby()
            if self._server is None and self._standby.ready:
                self._server = self._start_server(self._standby, now)
        plays = self._server is not None and self._server.playing  # a spare delays no start
        if plays and self._spare is None and now >= self._spare_not_before:
            self._spare = self._start_spare()

    def _start_standby(self) -> Standby:
        ours, theirs = socket.socketpair()
        handed = {"--listen": self._listen.fileno(), "--line": theirs.fileno(), **self._handed}
        words = [word for name, descriptor in handed.items() for word in (name, str(descriptor))]
        process = subprocess.Popen(
            [*self._program, "--show", str(self._show), *words],
            stdin=subprocess.DEVNULL,
            pass_fds=(*handed.values(), self._lock),
            start_new_session=True,  # Ctrl-C reaches the supervisor only
            env={"OPENBLAS_NUM_THREADS": "1", **os.environ},  # and a process of one thread can be copied
        )
        theirs.close()
        standby = Standby(process, ours)
        self._selector.register(ours, selectors.EVENT_READ, standby)
        return standby

    def _start_spare(self) -> Standby | None:
        """Has the standby copy itself; None where it cannot now."""
        if self._standby is None or not self._standby.ready:
            return None
        ours, theirs = socket.socketpair()
        try:
            send_order(self._standby.line, SpareOrder(), theirs.fileno())
        except OSError:
            ours.close()
            return None
        finally:
            theirs.close()
        spare = Standby(None, ours)
        self._selector.register(ours, selectors.EVENT_READ, spare)
        return spare

    def _start_server(self, standby: Standby, now: float) -> Server | None:
        neutral = self._crash_loop.suspects_state(now)
        if neutral:
            self._report("the servers that started from the last state died; the show starts again from neutral.")
        self._epoch += 1
        control, ours = os.pipe()
        theirs, pulse = os.pipe()
        try:
            order = Order(self._epoch, neutral, self._failover, self._notices, str(self._show))
            send_order(standby.line, order, control, pulse)
        except OSError:
            os.close(ours)
            os.close(theirs)
            return None
        finally:
            os.close(control)
            os.close(pulse)
        server = Server(ours, theirs)
        self._selector.register(theirs, selectors.EVENT_READ, server)
        return server

    def _listen_to_all(self) -> None:
        for key, _ in self._selector.select(WAIT_SECONDS):
            if isinstance(key.data, Standby):
                self._read_standby(key.data)
            elif isinstance(key.data, Server):
                self._read_pulse(key.data)

    def _read_standby(self, standby: Standby) -> None:
        try:
            lines = standby.line.recv(65536)
        except ConnectionError:
            lines = b""
        if not lines:
            self._drop_standby(standby)
        for news in read_news(lines):
            self._handle_news(standby, news)

    def _handle_news(self, standby: Standby, news: News) -> None:
        match news:
            case Ready(pid):
                standby.ready = True
                standby.pid = pid
            case Started(pid) if self._server is not None and self._server.pid is None:
                self._server.pid = pid
            case Ended(_, code):
                self._crash_loop.record_end(time.monotonic(), code)

    def _read_pulse(self, server: Server) -> None:
        data = os.read(server.pulse, 4096)
        if not data:
            self._report("the server is gone; another one takes over.")
            self._note_failover(server, time.monotonic(), hung=False)
            self._drop_server(server)
            return
        server.hear(time.monotonic())
        messages, server.rest = read_pulse(server.rest + data)
        notices = [message for message in messages if isinstance(message, Notice)]
        self._notices = [*self._notices, *notices][-MOST_NOTICES:]
        moves = [message for message in messages if isinstance(message, ShowMoved)]
        self._show = Path(moves[-1].show) if moves else self._show
        if not server.playing:
            server.playing = True
            raise_priority()
            if self._start_limit.record_play():
                self._opened()

    def _note_failover(self, server: Server, ended: float, *, hung: bool) -> None:
        """Remembers how a server ended, for the crew; one that never played only makes the pause longer."""
        if server.playing:
            count = self._failover.count + 1 if self._failover else 1
            self._failover = Failover(count, ended, hung)

    def _drop_server(self, server: Server) -> None:
        if server.pid is not None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(server.pid, signal.SIGKILL)
        self._selector.unregister(server.pulse)
        os.close(server.pulse)
        os.close(server.control)
        self._server = None
        if not server.playing:
            self._not_before = time.monotonic() + self._start_limit.record_server()
        elif self._standby is None:
            self._not_before = 0.0  # the pause was for a standby beside a server that plays

    def _drop_standby(self, standby: Standby) -> None:
        self._selector.unregister(standby.line)
        now = time.monotonic()
        status = standby.end(now)
        if standby is self._spare:
            self._spare_not_before = now + PAUSE_SECONDS
            self._spare = None
            return
        self._standby = self._spare
        self._spare = None
        plays = self._server is not None
        code = 0 if status is None else status
        self._not_before = now + self._start_limit.record_standby(code, ready=standby.ready, plays=plays)
        if self._standby is not None:
            self._report("the standby ended; its spare takes its place.")
        elif self._start_limit.played and self._start_limit.unready < 2:  # the next ones would only say the same
            self._report(f"the standby ended (status {status}); another one is started.")

    def _end_all(self) -> None:
        if self._server is not None:
            os.close(self._server.control)
            self._wait_for_end(self._server.pulse)
            os.close(self._server.pulse)
        deadline = time.monotonic() + 2 * END_SECONDS  # they see their servers out
        for standby in filter(None, (self._spare, self._standby)):
            standby.end(deadline)

    def _wait_for_end(self, pulse: int) -> None:
        deadline = time.monotonic() + END_SECONDS
        with selectors.DefaultSelector() as selector:
            selector.register(pulse, selectors.EVENT_READ)
            while (left := deadline - time.monotonic()) > 0:
                if selector.select(left) and not os.read(pulse, 4096):
                    return
        if self._server is not None and self._server.pid is not None:
            os.kill(self._server.pid, signal.SIGKILL)
