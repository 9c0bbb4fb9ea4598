"""Messages between supervisor, standby and server processes."""

from __future__ import annotations

import contextlib
import os
import socket

import msgspec

from omote.show.objects.link import Notice

TICK = b"t"
"""A server's pulse, on a pipe to the supervisor: it plays."""
PULSE_TICKS = 6
"""Ticks between two pulses: ten pulses a second."""
MOVED = b'{"show":'
"""How a line of a pulse begins that is no notice."""
REJECTED = 78
"""Exit status of a standby whose cast or pages cannot be used, which it has said (EX_CONFIG of sysexits.h): another one
would say the same."""
LONGEST_ORDER = 65536
"""Bytes of an order with all its notices."""


class Failover(msgspec.Struct, frozen=True):
    """How the show process before ended: the `count`-th of this show, at `ended` seconds of the monotonic clock, which
    all processes share; `hung`: it had stopped answering, and `ended` is when it last did."""

    count: int
    ended: float
    hung: bool


class Order(msgspec.Struct, frozen=True, tag="play"):
    """Supervisor to standby, with two pipes: play, at least under this epoch; `neutral`: not from the journal;
    `failover`: in whose place; `notices`: what the crew was told so far; `show`: the show file ("": the standby's)."""

    epoch: int
    neutral: bool
    failover: Failover | None = None
    notices: list[Notice] = []
    show: str = ""


class SpareOrder(msgspec.Struct, frozen=True, tag="spare"):
    """Supervisor to standby, with a line of its own: copy yourself; the copy takes your place when you die."""


class ShowMoved(msgspec.Struct, frozen=True):
    """Show process to supervisor, in its pulse: the show file was made anew, and is opened there from now on."""

    show: str


class Ready(msgspec.Struct, frozen=True, tag="ready"):
    """Standby to supervisor: it is warmed up; `pid` is its own."""

    pid: int


class Started(msgspec.Struct, frozen=True, tag="started"):
    """Standby to supervisor: the server of the last order runs."""

    pid: int


class Ended(msgspec.Struct, frozen=True, tag="ended"):
    """Standby to supervisor: a server is gone; `code` is its exit status, or minus the signal that killed it."""

    pid: int
    code: int


News = Ready | Started | Ended

_news: msgspec.json.Decoder[News] = msgspec.json.Decoder(News)
_notice: msgspec.json.Decoder[Notice] = msgspec.json.Decoder(Notice)
_moved: msgspec.json.Decoder[ShowMoved] = msgspec.json.Decoder(ShowMoved)
_order: msgspec.json.Decoder[Order | SpareOrder] = msgspec.json.Decoder(Order | SpareOrder)


def send_order(line: socket.socket, order: Order | SpareOrder, *descriptors: int) -> None:
    """Sends an order and what belongs to it (as file descriptors): the server's ends of its two pipes, or the line of a
    spare.

    line: to the standby; order: what to do; descriptors: two for an `Order`, control and pulse, one for a `SpareOrder`.
    """
    socket.send_fds(line, [msgspec.json.encode(order)], descriptors)


def receive_order(line: socket.socket) -> tuple[Order | SpareOrder, list[int]] | None:
    """Receives the next order and what belongs to it (`send_order`); None when the supervisor is gone."""
    try:
        data, descriptors, _, _ = socket.recv_fds(line, LONGEST_ORDER, 2)
    except ConnectionError:  # it went without reading our last news
        return None
    order = _order.decode(data) if data else None
    if order is None or len(descriptors) != (2 if isinstance(order, Order) else 1):
        for descriptor in descriptors:
            os.close(descriptor)
        return None
    return order, descriptors


def send_news(line: socket.socket, news: News) -> None:
    """Sends news to the supervisor; ignores that it is gone. line: to the supervisor; news: what has happened."""
    with contextlib.suppress(ConnectionError):
        line.sendall(msgspec.json.encode(news) + b"\n")


def read_news(lines: bytes) -> list[News]:
    """Decodes the news in whole lines."""
    return [_news.decode(line) for line in lines.splitlines()]


def write_notice(notice: Notice | ShowMoved) -> bytes:
    """What a show process tells its supervisor, as it writes it into its pulse, between two ticks."""
    return msgspec.json.encode(notice) + b"\n"


def read_pulse(data: bytes) -> tuple[list[Notice | ShowMoved], bytes]:
    """What is told in what came through a pulse, and the beginning of a line whose rest is still to come."""
    *lines, rest = (line[line.find(b"{") :] if b"{" in line else b"" for line in data.split(b"\n"))
    messages = list[Notice | ShowMoved]()
    for line in filter(None, lines):
        with contextlib.suppress(msgspec.DecodeError, UnicodeDecodeError):  # a process may die while it writes
            messages.append(_moved.decode(line) if line.startswith(MOVED) else _notice.decode(line))
    return messages, rest
