"""Validates numbers of messages that no performer checks: each passes unchanged or is rejected, never clamped."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

from omote.perform.limits import check_within

_ESCAPED = re.compile(r"(?<!\\)((?:\\\\)*)\\(?:x[0-9a-f]{2}|u[0-9a-f]{4}|U[0-9a-f]{8})")


def name_escapes(sentence: str) -> str:
    """Names the characters of quoted names that Python writes by numbers, since nobody sees them: `\\u202e` becomes
    <right-to-left override>. sentence: for people, on a page."""

    def named(found: re.Match[str]) -> str:
        character = chr(int(found[0][len(found[1]) + 2 :], 16))
        name = unicodedata.name(character, "").lower() or f"U+{ord(character):04X}"
        return f"{found[1]}<{name}>"

    return _ESCAPED.sub(named, sentence)


class Refusal(ValueError):  # noqa: N818  (what an operator reads, not a fault)
    """A message was rejected, and why, in one sentence: what came, what was expected."""


@dataclass(frozen=True)
class Quantity:
    """A number from outside: its name in error messages, and its range, both ends included."""

    what: str
    low: float
    high: float


SENT = Quantity("the time a ping was sent", -1e15, 1e15)
DARK = Quantity("the seconds for which a stage draws nothing", 0.0, 1e7)
FPS = Quantity("the rate of drawn frames", 0.0, 1000.0)


def validate_number(value: object, quantity: Quantity) -> float:
    """Validates that `value` is a real number in the range of `quantity`; Refusal for anything else, NaN too."""
    try:
        return check_within(value, quantity.low, quantity.high, quantity.what)
    except (ValueError, TypeError) as error:
        raise Refusal(f"{error}.") from error
