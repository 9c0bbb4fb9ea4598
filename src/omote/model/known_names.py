"""The names that every cast has, and mappings by name that tell where a name is not there which ones are near."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from typing import Literal, NoReturn, TypeVar, get_args

from omote.model.action_units import explain_action_unit

PlayRegion = Literal["brows", "eyes", "mouth", "rest"]
PLAY_REGIONS: tuple[PlayRegion, ...] = get_args(PlayRegion)
"""The groups of regions of a face in which an expression can be called alone."""
GENERIC = "generic"
NEUTRAL = "neutral"
"""The face and the expression that every cast has."""
UNIT_NOUNS = ("expression", "channel")
"""What may be named by an action unit of FACS too."""
_FIXED = (
    "gesture", "kind of timing", "kind of what eyes look at", "language", "layer", "part", "part of a clip",
    "region of a layer", "part of a character to hold", "spring", "fader of the skin", "step", "tracker", "viseme",
    "way to send a face", "cue of this list", "part of this cue", "way to go on after a cue",
    "lane of this clip",
)  # fmt: skip
PLACES: Mapping[str, str] = {
    **dict.fromkeys(("character", "removed character", "gaze point"), " in this scene"),
    **dict.fromkeys(
        ("performer", "source", "voice", "variant of a voice", "list of cues", "clip", "set-up"), " in this show"
    ),
    **dict.fromkeys(("macro", "change of a macro"), " of this character"),
    **dict.fromkeys(_FIXED, ""),
}
"""Where names of each kind are, as messages say it; "" for those that are the same everywhere; else in the cast."""
_MOST_LISTED = 3
Value = TypeVar("Value")
Region = TypeVar("Region", bound=str)


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
    """A clause that says that a name is not one of `names`, and which of them are near. what: what messages call it."""
    choices = list(names)
    where = PLACES.get(what, " in this cast")
    if what in UNIT_NOUNS and (known := explain_action_unit(str(name)[:80], choices)):
        return f"there is no {what} {str(name)[:80]!r}{where}; {known}"
    near = difflib.get_close_matches(str(name)[:80], choices, n=3, cutoff=0.4)
    if where:
        there = list_near(near, choices)
    else:
        there = f"near are {', '.join(near)}" if near else f"there are {', '.join(choices)}"
    return f"there is no {what} {str(name)[:80]!r}{where}; {there}"


def list_near(near: Sequence[str], choices: Iterable[str]) -> str:
    """A clause that lists the names that are near, or, where none is, the first that there are.

    near: the nearest of `choices` first.
    """
    if near:
        return f"near are {', '.join(near)}"
    names = sorted(choices)
    more = len(names) - _MOST_LISTED
    return f"there are {', '.join(names[:_MOST_LISTED]) or 'none'}{f' and {more} more' if more > 0 else ''}"


def check_play_region(name: str, /) -> PlayRegion:
    """The play region of this name; ValueError where there is none."""
    return check_region(name, PLAY_REGIONS, "to play in")


def check_region(name: str, regions: tuple[Region, ...], where: str) -> Region:
    """The one of some regions that has this name; ValueError where there is none. where: "of a pose"."""
    for region in regions:
        if region == name:
            return region
    raise ValueError(f"there is no region {name!r} {where}; expected one of {', '.join(regions)}")
