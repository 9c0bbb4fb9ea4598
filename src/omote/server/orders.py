"""What supervisor and server say to each other over their two pipes."""

from __future__ import annotations

import msgspec

READY, TICK = b"r", b"t"
"""A server's pulse: it is warmed up and waits; it plays."""
PULSE_TICKS = 6
"""Ticks between two pulses: ten pulses a second."""


class Order(msgspec.Struct, frozen=True):
    """Tells a waiting server to play, under an epoch of at least `epoch`; `neutral`: not from the journal's state."""

    epoch: int
    neutral: bool


def encode_order(order: Order) -> bytes:
    """An order as one line."""
    return msgspec.json.encode(order) + b"\n"


def decode_order(line: bytes) -> Order:
    """The order in a line; ValueError for anything else."""
    return msgspec.json.decode(line, type=Order)
