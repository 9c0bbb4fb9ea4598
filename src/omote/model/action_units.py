"""Which action units of FACS a channel is nearest to (Ekman, Friesen and Hager, Facial Action Coding System, 2002).

The one source of the table in docs/reference/action-units.md and .csv, of `omote cast --json` and of exported tables.
The units of the cast are named movements, not scores of a coder: what is here is the nearest unit by what moves.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

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
UPPER, LOWER = ("mouthRollUpper",), ("mouthRollLower",)


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
