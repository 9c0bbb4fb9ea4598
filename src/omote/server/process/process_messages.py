"""Messages between supervisor, standby and server processes."""

from __future__ import annotations

import contextlib
import os
import socket

import msgspec

TICK = b"t"
"""A server's pulse, on a pipe to the supervisor: it plays."""
PULSE_TICKS = 6
"""Ticks between two pulses: ten pulses a second."""


class Order(msgspec.Struct, frozen=True):
    """Supervisor to standby, with two pipes: play, at least under this epoch; `neutral`: not from the journal."""

    epoch: int
    neutral: bool


class Ready(msgspec.Struct, frozen=True, tag="ready"):
    """Standby to supervisor: it is warmed up."""


class Started(msgspec.Struct, frozen=True, tag="started"):
    """Standby to supervisor: the server of the last order runs."""

    pid: int


class Ended(msgspec.Struct, frozen=True, tag="ended"):
    """Standby to supervisor: a server is gone; `code` is its exit status, or minus the signal that killed it."""

    pid: int
    code: int


News = Ready | Started | Ended

_news: msgspec.json.Decoder[News] = msgspec.json.Decoder(News)
_order: msgspec.json.Decoder[Order] = msgspec.json.Decoder(Order)


def send_order(line: socket.socket, order: Order, control: int, pulse: int) -> None:
    """Sends an order and the server's ends of its two pipes (as file descriptors)."""
    socket.send_fds(line, [msgspec.json.encode(order)], [control, pulse])


def receive_order(line: socket.socket) -> tuple[Order, int, int] | None:
    """Receives the next order and its pipes; None when the supervisor is gone."""
    try:
        data, descriptors, _, _ = socket.recv_fds(line, 4096, 2)
    except ConnectionError:  # it went without reading our last news
        return None
    if not data or len(descriptors) != 2:
        for descriptor in descriptors:
            os.close(descriptor)
        return None
    return _order.decode(data), descriptors[0], descriptors[1]


def send_news(line: socket.socket, news: News) -> None:
    """Sends news to the supervisor; ignores that it is gone."""
    with contextlib.suppress(ConnectionError):
        line.sendall(msgspec.json.encode(news) + b"\n")


def read_news(lines: bytes) -> list[News]:
    """Decodes the news in whole lines."""
    return [_news.decode(line) for line in lines.splitlines()]
