"""Numbers of a program as the wire has them."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from numbers import Real

LARGEST = 1e30


def pack_numbers(values: Iterable[object], what: str) -> bytes:
    """Numbers as float32, little-endian; TypeError or ValueError for what is none. what: "a time (seconds)"."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise TypeError(f"{values!r} came; give a list of numbers, each {what}")
    numbers = list[float]()
    for value in values:
        if isinstance(value, bool) or not isinstance(value, Real):
            raise TypeError(f"{what} is {value!r}; give a number")
        if abs(float(value)) > LARGEST:
            raise ValueError(f"{what} is {value!r}; give a number that is not so large")
        numbers.append(float(value))
    return struct.pack(f"<{len(numbers)}f", *numbers)
