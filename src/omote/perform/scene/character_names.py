"""The names of characters, and their validation."""

from __future__ import annotations

import re
from collections.abc import Mapping

from omote.perform.name_lookup import fold

FIRST_CHARACTER = "one"
"""The name of the first character of a new show."""
ALL = "*"
"""In the place of a character: all of them; as a framing: a shot of all that are on the stage."""
MOST_CHARACTERS = 8
LONGEST_NAME = 24
"""Characters."""

_NAME = re.compile(rf"[a-z0-9_-]{{1,{LONGEST_NAME}}}")


def check_character_name(name: object) -> str:
    """Returns `name` where a character can have it, in addresses too; ValueError that says what it is made of."""
    if isinstance(name, str) and _NAME.fullmatch(name):
        return name
    written = repr(name)[:80]
    raise ValueError(
        f"a character cannot be called {written}; give 1 to {LONGEST_NAME} lower case letters, digits, _ or -"
    )


def find_character(typed: str, labels: Mapping[str, str]) -> str:
    """Returns the name of the character that a person means: by its name, else by its label, both in any case.

    typed: what was written.

    labels: what people call each, by name. ValueError with all that there are where none is meant, and with the names
    where several have the label.
    """
    if typed in labels:
        return typed
    meant = fold(typed)
    matches = [name for name in labels if meant and fold(name) == meant]
    matches = matches or [name for name, label in labels.items() if meant and fold(label) == meant]
    if len(matches) == 1:
        return matches[0]
    if matches:
        raise ValueError(f"the character {typed[:80]!r} could be {' or '.join(matches)}; give one of these names")
    raise ValueError(explain_missing(typed, labels))


def check_character(name: str, labels: Mapping[str, str]) -> str:
    """Returns the name of a character; ValueError with all that there are, by name and label, where there is none.
    labels: what people call each, by name."""
    if name in labels:
        return name
    raise ValueError(explain_missing(name, labels))


def explain_missing(typed: str, labels: Mapping[str, str]) -> str:
    """That nobody is called so, and who there is. typed: what was written; labels: what people call each, by name."""
    there = ", ".join(describe_character(name, label) for name, label in labels.items())
    return f"there is no character {typed[:80]!r} in this scene, which has {there or 'none'}"


def describe_character(name: str, label: str) -> str:
    """A character in words: `two`, and with a label that is not its name in other letters `two (Rex)`."""
    return name if fold(name) == fold(label) else f"{name} ({label})"
