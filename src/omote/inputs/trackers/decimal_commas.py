"""Numbers of countries that write a comma where others write a point."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

_WHOLE = re.compile(r"[-+]?\d+")
_FRACTION = re.compile(r"(\d+)(?:[eE][-+]?\d+)?")


def join_decimals(parts: Sequence[str], count: int) -> list[str] | None:
    """Numbers of a list whose commas stand between them and within them; None where it can be read in several ways.

    A program that cuts zeros off writes none at the end of a fraction; one that keeps them has a fraction for each.

    parts: what stands between the commas; count: of the numbers.
    """
    tight = [part.strip() for part in parts]
    if len(tight) > 2 * count:
        return None
    readings = list(_readings(tight, count, zeros=len(tight) == 2 * count))
    return readings[0] if len(readings) == 1 else None


def _readings(parts: Sequence[str], count: int, *, zeros: bool) -> Iterator[list[str]]:
    """All ways to read so many numbers. zeros: whether a fraction may end with one."""
    if not parts or not count:
        if not parts and not count:
            yield []
        return
    for rest in _readings(parts[1:], count - 1, zeros=zeros):
        yield [parts[0], *rest]
    if len(parts) > 1 and _WHOLE.fullmatch(parts[0]) and (fraction := _FRACTION.fullmatch(parts[1])):
        for rest in _readings(parts[2:], count - 1, zeros=zeros) if zeros or not fraction[1].endswith("0") else ():
            yield [f"{parts[0]}.{parts[1]}", *rest]
