"""What stands in the place of a character in OSC, a pattern or a label: whom it means."""

from __future__ import annotations

from collections.abc import Mapping
from fnmatch import fnmatchcase

from omote.inputs.osc_packet import OscError
from omote.perform.scene.character_names import ALL, find_character


def characters_meant(pattern: str, labels: Mapping[str, str]) -> tuple[str, ...]:
    """The characters that a pattern of OSC means (`*`, `?`, `[a-c]`, `[!a]`, `{one,two}`), else the one that has the
    name or the label in any case, with `_` for a space; OscError for none, and for a label that several have.

    labels: what people call each character, by name.
    """
    if pattern in labels:
        return (pattern,)
    meant = tuple(name for name in labels if matches(pattern, name))
    if meant:
        return (ALL,) if len(meant) == len(labels) > 1 else meant
    try:
        return (find_character(pattern, labels),)
    except ValueError as error:
        raise OscError(f"{error}, and {ALL} for all") from error


def matches(pattern: str, name: str) -> bool:
    """Whether a name is one that a pattern of OSC means."""
    head, brace, rest = pattern.partition("{")
    choices, closed, tail = rest.partition("}")
    if not (brace and closed):
        return fnmatchcase(name, pattern)
    return any(fnmatchcase(name, f"{head}{choice}{tail}") for choice in choices.split(","))
