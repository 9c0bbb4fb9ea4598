"""Patterns of OSC in the place of a character: whom they mean."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase

from omote.inputs.osc_packet import OscError
from omote.perform.scene.character_names import ALL


def characters_meant(pattern: str, characters: Sequence[str]) -> tuple[str, ...]:
    """The characters that a pattern of OSC means (`*`, `?`, `[a-c]`, `[!a]`, `{one,two}`); OscError for none."""
    if pattern in characters:
        return (pattern,)
    meant = tuple(name for name in characters if matches(pattern, name))
    if not meant:
        known = ", ".join(characters)
        raise OscError(f"there is no character {pattern[:80]!r}; there is {known}, and {ALL} for all")
    return (ALL,) if len(meant) == len(characters) > 1 else meant


def matches(pattern: str, name: str) -> bool:
    """Whether a name is one that a pattern of OSC means."""
    head, brace, rest = pattern.partition("{")
    choices, closed, tail = rest.partition("}")
    if not (brace and closed):
        return fnmatchcase(name, pattern)
    return any(fnmatchcase(name, f"{head}{choice}{tail}") for choice in choices.split(","))
