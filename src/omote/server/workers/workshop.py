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

from omote.server.process.fork import copied, let_go
from omote.server.process.priority import behind_the_show

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
    keeper: int
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
            writer.write(framed(order))
            (size,) = _length.unpack(await reader.readexactly(_length.size))
            made = await reader.readexactly(size)
        except (OSError, EOFError) as error:
            raise ClosedWorkshopError("the process that computes beside the show is gone") from error
        return answered(made)

    def close(self) -> None:
        """Ends it at once."""
        with suppress(ProcessLookupError):
            os.kill(self.keeper, signal.SIGKILL)
        with suppress(ChildProcessError):
            os.waitpid(self.keeper, 0)
        if self._streams is None:
            self.line.close()
        else:
            self._streams[1].transport.abort()


def open_workshop(make: Make) -> Workshop:
    """A workshop that makes with `make`; to be opened while this process has one thread. OSError where none can be."""
    ours, theirs = socket.socketpair()
    ours.setblocking(False)

    def work() -> None:
        let_go([theirs.fileno()])
        behind_the_show()
        keep(theirs, make)

    try:
        keeper = copied(work)
    except OSError:
        ours.close()
        raise
    finally:
        theirs.close()
    return Workshop(ours, keeper)


@dataclass(eq=False)
class Hand:
    """A copy of the keeper that works."""

    pid: int
    line: socket.socket

    def ask(self, order: bytes) -> bytes | None:
        """What it made, nothing if it could not; None when it died or hangs."""
        try:
            self.line.sendall(framed(order))
            return received(self.line)
        except OSError:
            return None

    def dismiss(self) -> None:
        """Ends it, whatever it does."""
        self.line.close()
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)


def hired(make: Make) -> Hand:
    """A new hand."""
    ours, theirs = socket.socketpair()

    def work() -> None:
        let_go([theirs.fileno()])
        work_on(theirs, make)

    pid = copied(work)
    theirs.close()
    ours.settimeout(HANG_SECONDS)
    return Hand(pid, ours)


def keep(line: socket.socket, make: Make) -> None:
    """Has every order made, by another hand if need be, until the line ends."""
    hand = hired(make)
    try:
        while (order := received(line)) is not None:
            made, tries = None, 0
            while tries < TRIES and (made := hand.ask(order)) is None:
                hand.dismiss()
                hand, tries = hired(make), tries + 1
            line.sendall(framed(made or b""))
    except ConnectionError:
        pass  # the server went without waiting for its order
    finally:
        hand.dismiss()


def work_on(line: socket.socket, make: Make) -> None:
    """Makes what is ordered until the line ends; what cannot be made is answered with nothing, a refusal with why."""
    while (order := received(line)) is not None:
        try:
            made = MADE + make(order)
        except ValueError as error:
            made = REFUSED + str(error).encode()
        except Exception:
            traceback.print_exc()
            made = b""
        with suppress(ConnectionError):  # the keeper went without waiting for it
            line.sendall(framed(made))


def answered(data: bytes) -> bytes:
    """What an answer holds; FailedOrderError and RefusedOrderError where it holds nothing."""
    if data.startswith(REFUSED):
        raise RefusedOrderError(data[len(REFUSED) :].decode())
    if not data:
        raise FailedOrderError("this cannot be computed; the terminal of the show says why")
    return data[len(MADE) :]


def framed(data: bytes) -> bytes:
    """Data with its length before it."""
    return _length.pack(len(data)) + data


def received(line: socket.socket) -> bytes | None:
    """The next data of a line; None when it has ended."""
    head = _exactly(line, _length.size)
    return None if head is None else _exactly(line, _length.unpack(head)[0])


def _exactly(line: socket.socket, size: int) -> bytes | None:
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
