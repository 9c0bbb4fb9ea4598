"""The names that every cast has, and mappings by name that tell where a name is not there which ones are near."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from typing import NoReturn, TypeVar

from omote.model.action_units import explain_action_unit

GENERIC, NEUTRAL = "generic", "neutral"
"""The face and the expression that every cast has."""
UNIT_NOUNS = ("expression", "channel")
"""What may be named by an action unit of FACS too."""
Value = TypeVar("Value")


class UnknownNameError(KeyError):
    """A name that is not there; the message names the nearest ones."""

    def __str__(self) -> str:
        return str(self.args[0])  # KeyError's own shows quotation marks around a sentence


class KnownNames(dict[str, Value]):
    """Values by name; `[...]` with another name raises UnknownNameError, which is a KeyError. what: "face"."""

    def __init__(self, what: str, values: Mapping[str, Value]) -> None:
        super().__init__(values)
        self.what = what

    def __missing__(self, name: object) -> NoReturn:
        raise UnknownNameError(explain_unknown(name, self, self.what))


def explain_unknown(name: object, names: Iterable[str], what: str) -> str:
    """A clause that says that a name is not one of `names`, and which of them are near."""
    choices = list(names)
    if what in UNIT_NOUNS and (told := explain_action_unit(str(name)[:80], choices)):
        return f"there is no {what} {str(name)[:80]!r} in this cast; {told}"
    near = difflib.get_close_matches(str(name)[:80], choices, n=3, cutoff=0.4) or sorted(choices)[:3]
    there = f"near are {', '.join(near)}" if near else "there are none"
    return f"there is no {what} {str(name)[:80]!r} in this cast; {there}"
