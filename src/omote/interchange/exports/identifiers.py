"""Identifiers and file names for what people named freely: letters, digits and _, as all programs take them."""

from __future__ import annotations

import re
from collections.abc import Iterable

_STRANGE = re.compile(r"\W", re.ASCII)


def identifiers(names: Iterable[str], /) -> dict[str, str]:
    """A valid identifier for each name, none twice, nor alike but for capitals, which some file systems confuse."""
    identifier_of: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        plain = _STRANGE.sub("_", name) or "_"
        plain = f"_{plain}" if plain[0].isdigit() else plain
        wanted = plain
        number = 1
        while wanted.lower() in taken:
            wanted = f"{plain}_{number}"
            number = number + 1
        taken.add(wanted.lower())
        identifier_of[name] = wanted
    return identifier_of
