"""Which action units of FACS a channel is nearest to (Ekman, Friesen and Hager, Facial Action Coding System, 2002).

The one source of the tables in docs/reference/action-units.md and .csv, of `omote cast --json` and of exported tables.
The units of the cast are named movements, not scores of a coder: what is here is the nearest unit by what moves.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

ACTION_UNITS: Mapping[int, str] = MappingProxyType(
    {
        1: "Inner brow raiser", 2: "Outer brow raiser", 4: "Brow lowerer", 5: "Upper lid raiser", 6: "Cheek raiser",
        7: "Lid tightener", 8: "Lips toward each other", 9: "Nose wrinkler", 10: "Upper lip raiser",
        12: "Lip corner puller", 14: "Dimpler", 15: "Lip corner depressor", 16: "Lower lip depressor",
        17: "Chin raiser", 18: "Lip pucker", 19: "Tongue show", 20: "Lip stretcher", 21: "Neck tightener",
        22: "Lip funneler", 24: "Lip pressor", 25: "Lips part", 26: "Jaw drop", 27: "Mouth stretch", 28: "Lips suck",
        29: "Jaw thrust", 30: "Jaw sideways", 34: "Cheek puff", 38: "Nostril dilator", 39: "Nostril compressor",
        43: "Eye closure", 45: "Blink", 61: "Eyes turn left", 62: "Eyes turn right", 63: "Eyes up", 64: "Eyes down",
    }
)  # fmt: skip
"""Names of the action units and descriptors that channels come near to, by number."""

ARKIT: Mapping[str, tuple[int, ...]] = MappingProxyType(
    {
        "browDown": (4,), "browInnerUp": (1,), "browOuterUp": (2,), "cheekPuff": (34,), "cheekSquint": (6,),
        "eyeBlink": (45,), "eyeLookDown": (64,), "eyeLookUp": (63,), "eyeLookInLeft": (62,), "eyeLookInRight": (61,),
        "eyeLookOutLeft": (61,), "eyeLookOutRight": (62,), "eyeSquint": (7,), "eyeWide": (5,), "jawForward": (29,),
        "jawLeft": (30,), "jawRight": (30,), "jawOpen": (26,), "mouthClose": (8,), "mouthDimple": (14,),
        "mouthFrown": (15,), "mouthFunnel": (22,), "mouthLowerDown": (16,), "mouthPress": (24,), "mouthPucker": (18,),
        "mouthRollLower": (28,), "mouthRollUpper": (28,), "mouthShrugLower": (17,), "mouthSmile": (12,),
        "mouthStretch": (20,), "mouthUpperUp": (10,), "noseSneer": (9,), "tongueOut": (19,),
    }
)  # fmt: skip
"""Of ARKit's shapes, without the side where both sides are alike."""
MAKEHUMAN: Mapping[str, tuple[int, ...]] = MappingProxyType(
    {
        "eye-closure": (43,), "eye-opened-up": (5,), "eye-slit": (7,), "eyebrows-down": (4,),
        "eyebrows-extern-up": (2,), "eyebrows-inner-up": (1,), "eyebrows-up": (1, 2), "mouth-compression": (24,),
        "mouth-corner-puller": (12,), "mouth-depression": (15,), "mouth-depression-retraction": (16, 20),
        "mouth-elevation": (10,), "mouth-eversion": (17,), "mouth-open": (27,), "mouth-parling": (25,),
        "mouth-part-later": (20, 25), "mouth-protusion": (22,), "mouth-pursing": (18,), "mouth-retraction": (20,),
        "mouth-upward-retraction": (12, 25), "neck-platysma": (21,), "nose-compression": (39,),
        "nose-dilatation": (38,), "nose-elevation": (9,),
    }
)  # fmt: skip
"""Of MakeHuman's units, without `left` and `right`."""
UPPER = ("mouthRollUpper",)
LOWER = ("mouthRollLower",)
HEAD_TURNS = range(51, 57)
"""Units that the head does: turns to both sides, up, down, and tilts."""
SIDES = ("LR", "TB")
"""Letters of halves of the face that make a whole unit together."""
GRADES: Mapping[str, str] = MappingProxyType(
    {"A": "trace", "B": "slight", "C": "marked", "D": "severe", "E": "maximum"}
)  # fmt: skip
"""Intensities of FACS, which follow the number of a unit."""
_GRADED = re.compile(r"((?:au)?[lrtb]?\d{1,2}[lrt]?)([a-e])")
_CODE = re.compile(r"(au)?([lrtb]?)(\d{1,2})([lrtb]?)")
_NUMBERS = {re.sub(r"[^a-z]", "", name.lower()): number for number, name in ACTION_UNITS.items()}


class ActionUnit(NamedTuple):
    """A unit of FACS, by its number, and the letter of the half of the face that moves, or of the direction, or ""."""

    number: int
    side: str = ""

    def __str__(self) -> str:
        return f"AU{self.number}{self.side}"


def read_action_unit(typed: str, /) -> ActionUnit | None:
    """Reads a unit as people write it: `AU12`, `au 12`, `AU12L`, `L12`, `Lip corner puller`, the name with left or
    right; None for anything else."""
    text = re.sub(r"[^a-z0-9]", "", typed.lower())
    if code := _CODE.fullmatch(text):
        prefix, before, digits, after = code.groups()
        if (prefix or before or after) and not (before and after):
            return ActionUnit(int(digits), (before + after).upper())
    if text in _NUMBERS:
        return ActionUnit(_NUMBERS[text])
    for word in ("left", "right"):
        for name in (text.removesuffix(word), text.removeprefix(word)):
            if name in _NUMBERS:
                return ActionUnit(_NUMBERS[name], word[0].upper())
    return None


def find_units(typed: str, channels: Iterable[str], /) -> tuple[str, ...]:
    """Which of the channels are the action unit that was typed: the one that moves the whole face, else its halves.

    ARKit's before MakeHuman's. Empty for what is no unit, has no channel, or is of opposite directions (AU30).
    """
    unit = read_action_unit(typed)
    if unit is None:
        return ()
    coded: dict[str, str] = {}
    for channel in sorted(channels, key=lambda name: "-" in name):  # as MakeHuman's names have it
        codes = action_units(channel)
        if len(codes) == 1:
            coded.setdefault(codes[0], channel)
    number, side = unit
    whole = coded.get(f"{side}{number}") or coded.get(f"{number}{side}")
    if whole or side:
        return (whole,) if whole else ()
    pairs = ([coded[code] for letter in letters if (code := f"{letter}{number}") in coded] for letters in SIDES)
    return tuple(next((pair for pair in pairs if pair), ()))


def explain_action_unit(typed: str, channels: Iterable[str], /) -> str:
    """A clause that says what an action unit is here, for whoever typed one where no single name is found; "" for what
    is none.

    channels: the names that there are.
    """
    choices = list(channels)
    if units := find_units(typed, choices):
        return f"{read_action_unit(typed)} is {' and '.join(units)}{' together' if len(units) > 1 else ''}"
    if graded := _explain_grade(typed, choices):
        return graded
    unit = read_action_unit(typed)
    if unit is None:
        return ""
    if unit.number in HEAD_TURNS:
        return f"{unit} is a turn of the head (turn)"
    if either := [units for side in "LR" for units in find_units(f"{unit}{side}", choices)]:
        return f"{unit} is {' or '.join(either)}"
    there = ", ".join(f"AU{number}" for number in ACTION_UNITS if _is_there(number, choices))
    return f"no channel is {unit}{f'; there are {there}' if there else ''}"


def _explain_grade(typed: str, choices: Iterable[str]) -> str:
    """A clause on an intensity of FACS behind a unit that is there, `AU12C`; "" for anything else."""
    code = _GRADED.fullmatch(re.sub(r"[^a-z0-9]", "", typed.lower()))
    unit = read_action_unit(code[1] if code[1].startswith("au") else f"au{code[1]}") if code else None
    if code is None or unit is None or not find_units(str(unit), choices):
        return ""
    grade = code[2].upper()
    share = (1 + list(GRADES).index(grade)) / len(GRADES)
    return (
        f"{unit}{grade} is {unit} at FACS's intensity {grade} ({GRADES[grade]}), which a coder judges and no number "
        "measures; weights are shares of the unit as sculpted: where data count A to E as 1 to 5, write "
        f"{unit}={share:g}"
    )


def _is_there(number: int, channels: Iterable[str]) -> bool:
    return any(number in _numbers_of(channel)[0] for channel in channels)


def action_units(channel: str, /) -> tuple[str, ...]:
    """The action units of FACS that a channel is nearest to, as coders write them.

    Parameters
    ----------
    channel : str
        The name of a unit of the cast, "mouthSmileLeft".

    Returns
    -------
    tuple of str
        "L12" is unit 12 on the character's left, "R12" on its right, "T28" and "B28" of the upper (top) and the lower
        (bottom) lip, "30L" to the left; empty for what FACS has no unit for, and for other expressions.

    Examples
    --------
    >>> omote.action_units("mouthSmileLeft"), omote.action_units("eyebrows-right-up"), omote.action_units("joy")
    (('L12',), ('R1', 'R2'), ())

    References
    ----------
    docs/exchange.md; the table of all is docs/reference/action-units.md.
    """
    if not isinstance(channel, str):
        raise TypeError(f"a channel is named by text, not by {channel!r}; write for instance 'jawOpen'")
    numbers, side = _numbers_of(channel)
    if channel.startswith("jaw"):
        return tuple(f"{number}{side}" for number in numbers)
    return tuple(f"{side}{number}" for number in numbers)


def _numbers_of(channel: str) -> tuple[tuple[int, ...], str]:
    """The numbers of a channel's units, and the letter of the part of the face that it moves alone."""
    lip = "T" if channel in UPPER else "B" if channel in LOWER else ""
    for word in ("Left", "Right"):
        one_side = channel.removesuffix(word)
        if one_side != channel and (channel in ARKIT or one_side in ARKIT):
            return ARKIT.get(channel) or ARKIT[one_side], word[0]
    for word in ("left", "right"):
        both = channel.replace(f"-{word}-", "-")
        if both != channel:
            return MAKEHUMAN.get(both, ()), word[0].upper()
    return ARKIT.get(channel) or MAKEHUMAN.get(channel, ()), lip
