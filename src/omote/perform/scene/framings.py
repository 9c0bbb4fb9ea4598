"""Framings: what the picture holds, as text, and the validation of that.

A framing is whom it holds, `*` (all that are on the stage) or names joined by `+` and sorted, and behind a `:` how much
of their figures, if they are seen: `*`, `kaori+one`, `*:full`. So a mix of framings is weights over names like every
other mix.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal, get_args

from omote.perform.limits import check_known
from omote.perform.scene.character_names import ALL

JOINT = "+"
"""Between the names of the characters of a framing."""
SIZED = ":"
"""Before the size of its shot."""
ShotSize = Literal["portrait", "head", "bust", "half", "full"]
"""How much a shot shows of figures; a portrait of heads alone, which a framing's text leaves out."""
SHOT_SIZES: tuple[str, ...] = get_args(ShotSize)
PORTRAIT = SHOT_SIZES[0]
FIGURE_SHOTS = SHOT_SIZES[1:]
"""Those that show figures."""


def framing_of(characters: Iterable[str], present: Iterable[str], size: str = PORTRAIT) -> str:
    """The framing that holds these characters, as text.

    characters: their names, none for all; present: those that there are; size: of the shot.

    ValueError for a character that is not `present`, and for a size that there is not.
    """
    if isinstance(characters, str):
        raise TypeError(f"the characters of a framing are the text {characters!r}; give a list of their names")
    choices = list(present)
    names = {check_known(name, choices, "character") for name in characters}
    return write_framing(names, check_shot_size(size))


def write_framing(names: Iterable[str], size: str) -> str:
    """The text of a framing; nothing is checked.

    names: of the characters that it holds, none for all; size: of the shot.
    """
    held = JOINT.join(sorted(names)) or ALL
    return held if size == PORTRAIT else f"{held}{SIZED}{size}"


def check_shot_size(size: str) -> str:
    """Returns the size of a shot; ValueError with all that there are for another text."""
    return check_known(size, SHOT_SIZES, "size of a shot")


def names_in(framing: str) -> frozenset[str]:
    """The characters that a framing names: none for that of all."""
    held = held_by(framing)
    return frozenset() if held == ALL else frozenset(held.split(JOINT))


def held_by(framing: str) -> str:
    """Whom a framing holds, as text."""
    return framing.partition(SIZED)[0]


def size_in(framing: str) -> str:
    """The size of the shot of a framing."""
    return framing.partition(SIZED)[2] or PORTRAIT


def framing_or_none(text: str, characters: Mapping[str, object]) -> str | None:
    """The framing that a text means, in its one spelling; None where it names somebody else or no size of a shot.

    characters: those in the scene.
    """
    names = names_in(text)
    size = size_in(text)
    if not names <= characters.keys() or size not in SHOT_SIZES:
        return None
    return framing_of(names, characters, size)
