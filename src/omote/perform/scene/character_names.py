"""The names of characters and of framings, and their validation."""

from __future__ import annotations

import re
from collections.abc import Iterable

from omote.perform.limits import check_known

FIRST_CHARACTER = "one"
"""The name of the first character of a new show."""
ALL = "*"
"""In the place of a character: all of them; as a framing: a shot of all that are on the stage."""
JOINT = "+"
"""Between the names of the characters of a framing."""
MOST_CHARACTERS = 8
LONGEST_NAME = 24

_NAME = re.compile(rf"[a-z0-9_-]{{1,{LONGEST_NAME}}}")


def check_character_name(name: object) -> str:
    """Returns `name` where a character can have it, in addresses too; ValueError that says what it is made of."""
    if isinstance(name, str) and _NAME.fullmatch(name):
        return name
    written = repr(name)[:80]
    raise ValueError(
        f"a character cannot be called {written}; give 1 to {LONGEST_NAME} lower case letters, digits, _ or -"
    )


def framing_of(characters: Iterable[str], known: Iterable[str]) -> str:
    """The framing that holds these characters, as text: `*` for none, else their names, sorted and joined by `+`.

    ValueError for a character that is not `known`.
    """
    if isinstance(characters, str):
        raise TypeError(f"the characters of a framing are the text {characters!r}; give a list of their names")
    choices = list(known)
    names = {check_known(name, choices, "character") for name in characters}
    return JOINT.join(sorted(names)) if names else ALL


def names_in(framing: str) -> frozenset[str]:
    """The characters that a framing names: none for that of all."""
    return frozenset() if framing == ALL else frozenset(framing.split(JOINT))
