"""The lights that a show can call, by name; what they look like is the stages' own (`web/src/face/light/lights.ts`).
And the colours that may stand behind a head instead."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping

FIRST_LIGHT = "theatre"
"""What a show begins with."""
LIGHTS: Mapping[str, str] = {"theatre": "Theatre", "portrait": "Portrait", "flat": "Flat (keying)"}
"""The lights in the order of the console, with what they are called there."""
BACKGROUNDS: Mapping[str, str] = {
    "green": "#00b140",
    "blue": "#0047bb",
    "black": "#000000",
    "grey": "#808080",
    "white": "#ffffff",
}
"""The backgrounds that have a name; green and blue are those of keyers."""


def check_light(name: str) -> str:
    """Returns the name of a light; ValueError that lists all of them for an unknown one."""
    if name not in LIGHTS:
        raise ValueError(f"there is no light {name!r}; choose one of {', '.join(LIGHTS)}")
    return name


def find_background(text: str) -> str:
    """The colour of a background, `#rrggbb`, from that or from its name; ValueError for anything else."""
    word = text.strip().lower()
    if re.fullmatch("#?[0-9a-f]{6}", word):
        return f"#{word.removeprefix('#')}"
    if word in BACKGROUNDS:
        return BACKGROUNDS[word]
    near = difflib.get_close_matches(word, BACKGROUNDS, n=1)
    meant = f"did you mean {near[0]}? It is {BACKGROUNDS[near[0]]}" if near else f"give {', '.join(BACKGROUNDS)}"
    raise ValueError(f"the background {text!r} is no colour; {meant}; or write #rrggbb, as in #00b140")
