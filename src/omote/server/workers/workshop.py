"""The workshop: a process beside the server that computes orders, so that no tick is late; it shares the loaded cast.

The server forks it before it has a thread or an event loop. It consists of two processes: a supervisor that passes
orders on, and a worker that computes them. A worker that dies or hangs is replaced and the order repeated; an order
that kills every worker is answered with that. Both processes end with the server's socket. Orders and answers are
bytes (`order_worker`); a ValueError of the worker comes back to the server with its message.
"""

from __future__ import annotations

import asyncio
import os
import select
import signal
import socket
import struct
import sys
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

from omote.server.process.fork import fork_beside
from omote.server.process.priority import lower_priority, waiting_seconds

TRIES = 2
"""Workers that one order may kill or hang."""
HANG_SECONDS = 20.0
"""Seconds after which a silent worker is replaced; a compound takes milliseconds. Time in which other programs had all
processors does not count."""

Make = Callable[[bytes], bytes]

MADE = b"+"
REFUSED = b"-"
FAILED = b"!"
"""First byte of the answers; what follows is the result, or why there is none."""
ENDED = "the process that computes ended or was silent for too long, each time that it was asked"

_length = struct.Struct("!I")


class ClosedWorkshopError(RuntimeError):
    """The workshop has ended."""


class FailedOrderError(RuntimeError):
    """The workshop failed to compute this order."""


class RefusedOrderError(ValueError):
    """The worker rejected this order; the message says why."""


@dataclass
class Workshop:
    """The server's end of a workshop: one order at a time."""

    line: socket.socket
    supervisor_pid: int
    _streams: tuple[asyncio.StreamReader, asyncio.StreamWriter] | None = None

    async def make(self, order: bytes) -> bytes:
        """Sends an order and returns the answer.

        RefusedOrderError when the worker rejects it, FailedOrderError when it fails, ClosedWorkshopError when the
        workshop has ended.
        """
        try:
            if self._streams is None:
                self._streams = await asyncio.open_unix_connection(sock=self.line)
            reader, writer = self._streams
            writer.write(frame(order))
            (size,) = _length.unpack(await reader.readexactly(_length.size))
            answer = await reader.readexactly(size)
        except (OSError, EOFError) as error:
            raise ClosedWorkshopError("the process that computes beside the show is gone") from error
        return read_answer(answer)

    def close(self) -> None:
        """Kills the workshop at once."""
        with suppress(ProcessLookupError):
            os.kill(self.supervisor_pid, signal.SIGKILL)
        with suppress(ChildProcessError):
            os.waitpid(self.supervisor_pid, 0)
        if self._streams is None:
            self.line.close()
        else:
            self._streams[1].transport.abort()


def open_workshop(make: Make) -> Workshop:
    """Forks a workshop that computes with `make`, while this process has one thread; OSError where that fails."""

    def work(line: socket.socket) -> None:
        lower_priority(leaves_session=True)
        supervise_worker(line, make)

    pid, line = fork_beside(work)
    line.setblocking(False)
    return Workshop(line, pid)


@dataclass(eq=False)
class WorkerProcess:
    """A worker process and the socket to it."""

    pid: int
    line: socket.socket

    def ask(self, order: bytes) -> bytes | None:
        """Sends an order and returns the answer; None when the worker died or hangs."""
        try:
            self.line.sendall(frame(order))
            self._wait()
            return receive(self.line)
        except OSError:
            return None

    def _wait(self) -> None:
        """Waits for the beginning of an answer; TimeoutError where the worker had its time and was silent."""
        began = time.monotonic()
        waited = waiting_seconds(self.pid)
        while not select.select([self.line], [], [], HANG_SECONDS / 4)[0]:
            if time.monotonic() - began - (waiting_seconds(self.pid) - waited) > HANG_SECONDS:
                raise TimeoutError

    def kill(self) -> None:
        """Kills the worker."""
        self.line.close()
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)


def spawn_worker(make: Make) -> WorkerProcess:
    """Forks a new worker."""
    pid, line = fork_beside(lambda theirs: serve_orders(theirs, make))
    line.settimeout(HANG_SECONDS)
    return WorkerProcess(pid, line)


def supervise_worker(line: socket.socket, make: Make) -> None:
    """Passes every order to a worker, replacing workers that die or hang, until the line ends.

    line: to the server; make: computes an order.
    """
    worker = spawn_worker(make)
    try:
        while (order := receive(line)) is not None:
            answer = None
            tries = 0
            while tries < TRIES and (answer := worker.ask(order)) is None:
                worker.kill()
                worker = spawn_worker(make)
                tries = tries + 1
            if answer is None:
                sys.stderr.write(f"omote: something cannot be computed: {ENDED}.\n")
                answer = FAILED + ENDED.encode()
            line.sendall(frame(answer))
    except ConnectionError:
        pass  # the server went without waiting for its order
    finally:
        worker.kill()


def serve_orders(line: socket.socket, make: Make) -> None:
    """Computes orders until the line ends; failures are answered with the error, rejections with their message.

    line: to the supervisor; make: computes an order.
    """
    while (order := receive(line)) is not None:
        try:
            answer = MADE + make(order)
        except ValueError as error:
            answer = REFUSED + str(error).encode()
        except Exception as error:
            traceback.print_exc()
            answer = FAILED + f"a fault of Omote, {type(error).__name__}: {error}".encode()
        with suppress(ConnectionError):  # the supervisor ended without waiting for it
            line.sendall(frame(answer))


def read_answer(data: bytes) -> bytes:
    """Decodes an answer; raises FailedOrderError for a failed order and RefusedOrderError for a rejected one."""
    if data.startswith(REFUSED):
        raise RefusedOrderError(data[len(REFUSED) :].decode())
    if not data.startswith(MADE):
        raise FailedOrderError(f"this cannot be computed ({data[len(FAILED) :].decode(errors='replace')[:300]})")
    return data[len(MADE) :]


def frame(data: bytes) -> bytes:
    """Prefixes data with its length."""
    return _length.pack(len(data)) + data


def receive(line: socket.socket, pipes: list[int] | None = None) -> bytes | None:
    """Receives the next length-prefixed data of a line; None when the line has ended.

    line: a socket of this machine; pipes: gets the descriptors that come along, one with each piece at most.
    """
    head = _receive_exactly(line, _length.size, pipes)
    return None if head is None else _receive_exactly(line, _length.unpack(head)[0], pipes)


def _receive_exactly(line: socket.socket, size: int, pipes: list[int] | None) -> bytes | None:
    data = bytearray()
    while len(data) < size:
        try:
            more, descriptors, _, _ = socket.recv_fds(line, size - len(data), 0 if pipes is None else 1)
        except ConnectionError:  # it died with something unread
            return None
        if pipes is not None:
            pipes += descriptors
        if not more:
            return None
        data += more
    return bytes(data)
