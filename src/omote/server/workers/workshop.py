"""Where orders are made: beside the server, in a process that shares its loaded cast, so that no tick is late.

The server opens it before it has a thread or a loop. Two copies of the server make it up: a keeper that only passes
orders on, and a hand that works. A hand that dies or hangs is replaced and the order given again; an order that no hand
survives is answered with nothing. Both end with the line to the server. An order is bytes, and so is what is made of
it (`bench`); whoever makes it refuses with a ValueError, whose sentence comes back.
"""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import struct
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

from omote.server.process.fork import close_descriptors, fork_process
from omote.server.process.priority import lower_priority

TRIES = 2
"""Hands that an order may cost."""
HANG_SECONDS = 20.0
"""Silence of a working hand after which it is replaced; a compound takes milliseconds."""

Make = Callable[[bytes], bytes]

MADE, REFUSED = b"+", b"-"
"""Begin the answers; an empty one: it could not be made."""

_length = struct.Struct("!I")


class ClosedWorkshopError(RuntimeError):
    """The workshop has ended."""


class FailedOrderError(RuntimeError):
    """The workshop could not make this."""


class RefusedOrderError(ValueError):
    """Whoever makes orders has refused this one, and why, in one sentence."""


@dataclass
class Workshop:
    """The server's end of a workshop: one order at a time."""

    line: socket.socket
    supervisor_pid: int
    _streams: tuple[asyncio.StreamReader, asyncio.StreamWriter] | None = None

    async def make(self, order: bytes) -> bytes:
        """What was ordered.

        RefusedOrderError when it must not be made, FailedOrderError when it cannot, ClosedWorkshopError when nobody is
        there.
        """
        try:
            if self._streams is None:
                self._streams = await asyncio.open_unix_connection(sock=self.line)
            reader, writer = self._streams
            writer.write(frame(order))
            (size,) = _length.unpack(await reader.readexactly(_length.size))
            made = await reader.readexactly(size)
        except (OSError, EOFError) as error:
            raise ClosedWorkshopError("the process that computes beside the show is gone") from error
        return read_answer(made)

    def close(self) -> None:
        """Ends it at once."""
        with suppress(ProcessLookupError):
            os.kill(self.supervisor_pid, signal.SIGKILL)
        with suppress(ChildProcessError):
            os.waitpid(self.supervisor_pid, 0)
        if self._streams is None:
            self.line.close()
        else:
            self._streams[1].transport.abort()


def open_workshop(make: Make) -> Workshop:
    """A workshop that makes with `make`; to be opened while this process has one thread. OSError where none can be."""
    ours, theirs = socket.socketpair()
    ours.setblocking(False)

    def work() -> None:
        close_descriptors([theirs.fileno()])
        lower_priority()
        supervise_worker(theirs, make)

    try:
        supervisor_pid = fork_process(work)
    except OSError:
        ours.close()
        raise
    finally:
        theirs.close()
    return Workshop(ours, supervisor_pid)


@dataclass(eq=False)
class WorkerProcess:
    """A copy of the keeper that works."""

    pid: int
    line: socket.socket

    def ask(self, order: bytes) -> bytes | None:
        """What it made, nothing if it could not; None when it died or hangs."""
        try:
            self.line.sendall(frame(order))
            return receive(self.line)
        except OSError:
            return None

    def kill(self) -> None:
        """Ends it, whatever it does."""
        self.line.close()
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)


def spawn_worker(make: Make) -> WorkerProcess:
    """A new hand."""
    ours, theirs = socket.socketpair()

    def work() -> None:
        close_descriptors([theirs.fileno()])
        serve_orders(theirs, make)

    pid = fork_process(work)
    theirs.close()
    ours.settimeout(HANG_SECONDS)
    return WorkerProcess(pid, ours)


def supervise_worker(line: socket.socket, make: Make) -> None:
    """Has every order made, by another hand if need be, until the line ends."""
    worker = spawn_worker(make)
    try:
        while (order := receive(line)) is not None:
            made, tries = None, 0
            while tries < TRIES and (made := worker.ask(order)) is None:
                worker.kill()
                worker, tries = spawn_worker(make), tries + 1
            line.sendall(frame(made or b""))
    except ConnectionError:
        pass  # the server went without waiting for its order
    finally:
        worker.kill()


def serve_orders(line: socket.socket, make: Make) -> None:
    """Makes what is ordered until the line ends; what cannot be made is answered with nothing, a refusal with why."""
    while (order := receive(line)) is not None:
        try:
            made = MADE + make(order)
        except ValueError as error:
            made = REFUSED + str(error).encode()
        except Exception:
            traceback.print_exc()
            made = b""
        with suppress(ConnectionError):  # the keeper went without waiting for it
            line.sendall(frame(made))


def read_answer(data: bytes) -> bytes:
    """What an answer holds; FailedOrderError and RefusedOrderError where it holds nothing."""
    if data.startswith(REFUSED):
        raise RefusedOrderError(data[len(REFUSED) :].decode())
    if not data:
        raise FailedOrderError("this cannot be computed; the terminal of the show says why")
    return data[len(MADE) :]


def frame(data: bytes) -> bytes:
    """Data with its length before it."""
    return _length.pack(len(data)) + data


def receive(line: socket.socket) -> bytes | None:
    """The next data of a line; None when it has ended."""
    head = _receive_exactly(line, _length.size)
    return None if head is None else _receive_exactly(line, _length.unpack(head)[0])


def _receive_exactly(line: socket.socket, size: int) -> bytes | None:
    data = bytearray()
    while len(data) < size:
        try:
            more = line.recv(size - len(data))
        except ConnectionError:  # it died with something unread
            return None
        if not more:
            return None
        data += more
    return bytes(data)
