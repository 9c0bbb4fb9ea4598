"""Which messages have been executed: one that comes again, by a retry or a key that bounces, changes nothing.

Ids of one client end in a number that rises. As in IPsec's protection against replay (RFC 4303, 3.4.3) the highest one
is kept, and which of the last were executed: what is older than those counts as executed. So nobody else makes a
session forget the calls of a seat, and no fader of the same seat does, however much it sends.
"""

from __future__ import annotations

import re
from collections import OrderedDict
from collections.abc import Mapping
from typing import TypeVar

WINDOW = 512
"""Numbers below the highest of a client that may still come: messages overtake each other where a link breaks."""
MOST_SEATS = 64
MOST_CLIENTS = 64
"""Clients of a seat (pages, programs) whose numbers are remembered; the one that was silent longest makes room."""
NUMBERED = re.compile(r"(.*?)(\d{1,15})", re.DOTALL)

Executed = dict[str, dict[str, list[int]]]
"""Numbers by seat and client, the one that was heard last at the end."""


Remembered = TypeVar("Remembered")


class ExecutedCalls:
    """The ids of messages that a session has executed, by the seat that sent them."""

    def __init__(self, executed: Mapping[str, Mapping[str, list[int]]] | None = None) -> None:
        self._seats: OrderedDict[str, OrderedDict[str, _Numbers]] = OrderedDict()
        for seat, clients in (executed or {}).items():
            self._seats[seat] = OrderedDict((client, _Numbers(numbers)) for client, numbers in clients.items())

    def has(self, seat: str, call: str) -> bool:
        """Whether an id of a seat was executed. seat: its token; call: the id."""
        client, number = split_id(call)
        numbers = self._seats[seat].get(client) if seat in self._seats else None
        return numbers is not None and number in numbers

    def note(self, seat: str, call: str) -> None:
        """Notes an id as executed. seat: the token of the seat that sent it; call: the id."""
        client, number = split_id(call)
        clients = self._seats.setdefault(seat, OrderedDict())
        clients.setdefault(client, _Numbers()).add(number)
        _use(self._seats, seat, MOST_SEATS)
        _use(clients, client, MOST_CLIENTS)

    def snapshot(self) -> Executed:
        """What is remembered, as plain values."""
        return {
            seat: {client: list(numbers.recent) for client, numbers in clients.items()}
            for seat, clients in self._seats.items()
        }


class _Numbers:
    """The numbers of one client: the highest, and those within the window below it."""

    def __init__(self, recent: list[int] | None = None) -> None:
        self.recent = dict.fromkeys(recent or [])
        self._highest = max(self.recent, default=0)

    def __contains__(self, number: int) -> bool:
        return number in self.recent or number <= self._highest - WINDOW

    def add(self, number: int) -> None:
        self.recent[number] = None
        self._highest = max(self._highest, number)
        if len(self.recent) > 2 * WINDOW:
            self.recent = {kept: None for kept in self.recent if kept > self._highest - WINDOW}


def _use(remembered: OrderedDict[str, Remembered], name: str, most: int) -> None:
    """Moves what is used to the end, and drops the first where there are too many."""
    remembered.move_to_end(name)
    if len(remembered) > most:
        remembered.popitem(last=False)


def split_id(call: str) -> tuple[str, int]:
    """The client and the number of an id; an id that ends in no number is a client of its own, with the number 0."""
    numbered = NUMBERED.fullmatch(call)
    return (call, 0) if numbered is None else (numbered[1], int(numbered[2]))
