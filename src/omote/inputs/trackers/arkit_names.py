"""The 52 coefficients of ARKit as trackers name and order them: a name is looked up, never a place in a list."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from types import MappingProxyType

ARKIT_NAMES: tuple[str, ...] = tuple(
    """
    eyeBlinkLeft eyeLookDownLeft eyeLookInLeft eyeLookOutLeft eyeLookUpLeft eyeSquintLeft eyeWideLeft
    eyeBlinkRight eyeLookDownRight eyeLookInRight eyeLookOutRight eyeLookUpRight eyeSquintRight eyeWideRight
    jawForward jawLeft jawRight jawOpen
    mouthClose mouthFunnel mouthPucker mouthLeft mouthRight mouthSmileLeft mouthSmileRight
    mouthFrownLeft mouthFrownRight mouthDimpleLeft mouthDimpleRight mouthStretchLeft mouthStretchRight
    mouthRollLower mouthRollUpper mouthShrugLower mouthShrugUpper mouthPressLeft mouthPressRight
    mouthLowerDownLeft mouthLowerDownRight mouthUpperUpLeft mouthUpperUpRight
    browDownLeft browDownRight browInnerUp browOuterUpLeft browOuterUpRight
    cheekPuff cheekSquintLeft cheekSquintRight noseSneerLeft noseSneerRight tongueOut
    """.split()
)
"""In the order of Live Link Face over UDP (Unreal's EARFaceBlendShape); its CSV files swap jawLeft with jawRight and
mouthLeft with mouthRight."""
_SMILES = ("mouthSmileLeft", "mouthSmileRight")
_STRETCHES = ("mouthStretchLeft", "mouthStretchRight")
_VOWELS: Mapping[tuple[str, str], Mapping[str, float]] = {
    ("a", "aa"): {"jawOpen": 0.7},
    ("i", "ih"): {"jawOpen": 0.2, **dict.fromkeys(_SMILES + _STRETCHES, 0.3)},
    ("u", "ou"): {"jawOpen": 0.2, "mouthPucker": 0.7},
    ("e", "ee"): {"jawOpen": 0.35, **dict.fromkeys(_STRETCHES, 0.4)},
    ("o", "oh"): {"jawOpen": 0.45, "mouthFunnel": 0.5},
}
_GAZE: Mapping[str, tuple[str, str]] = {
    "lookup": ("eyeLookUpLeft", "eyeLookUpRight"),
    "lookdown": ("eyeLookDownLeft", "eyeLookDownRight"),
    "lookleft": ("eyeLookOutLeft", "eyeLookInRight"),
    "lookright": ("eyeLookInLeft", "eyeLookOutRight"),
}
_EMOTIONS: Mapping[str, str] = {
    "happy": "joy", "sorrow": "sad", "relaxed": "smile", "fun": "smile", "surprised": "surprise",
}  # fmt: skip
ALIASES: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "browinnerupleft": {"browInnerUp": 1.0},
        "browinnerupright": {"browInnerUp": 1.0},
        "blink": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0},
        "blinkleft": {"eyeBlinkLeft": 1.0},
        "blinkright": {"eyeBlinkRight": 1.0},
        **{spelling: shares for spellings, shares in _VOWELS.items() for spelling in spellings},
        **{spelling: dict.fromkeys(channels, 1.0) for spelling, channels in _GAZE.items()},
        **{spelling: {expression: 1.0} for spelling, expression in _EMOTIONS.items()},
    }
)
"""Names that are not ARKit's, and what says the same: MeowFace halves the inner brow; expressions of VRM, of version 0
and 1, close and turn the eyes, shape vowels (recipes of our own) and are the cast's feelings by other names."""
_BETWEEN = re.compile(r"[\W_]+")
_SIDE = re.compile(r"[\W_]([lr])[\W_]*$")
_SIDES = {"_l": "left", "_r": "right"}


def plain_spelling(name: str) -> str:
    """A name in the one spelling that all carriers share: `eyeBlink_L`, `EyeBlinkLeft` and `eyeblinkleft` are the
    same."""
    small = name.lower()
    return small[:-2] + _SIDES[small[-2:]] if small[-2:] in _SIDES else small


def loose_spelling(name: str) -> str:
    """The same with letters and digits alone: `Eye Blink_Left` and `eye-blink L` are the same too."""
    side = _SIDE.search(small := name.lower())
    return _BETWEEN.sub("", small if side is None else small[: side.start()] + _SIDES[f"_{side[1]}"])


class ChannelNames:
    """The channels of a cast by the spellings of trackers. channels: their names, ARKit's and others."""

    def __init__(self, channels: Iterable[str]) -> None:
        self.channels = tuple(channels)
        exact = {plain_spelling(name): {name: 1.0} for name in self.channels}
        known = set(self.channels)
        aliases = {
            spelling: {name: share for name, share in shares.items() if name in known}
            for spelling, shares in ALIASES.items()
        }
        self._found = {**{spelling: shares for spelling, shares in aliases.items() if shares}, **exact}
        self._loosely = {loose_spelling(spelling): shares for spelling, shares in self._found.items()}

    def find(self, name: str) -> tuple[str, ...]:
        """The channels that a tracker means by a name; none where the cast has none of that name."""
        return tuple(self.shares(name))

    def shares(self, name: str) -> Mapping[str, float]:
        """The same, each with its share of the name's weight."""
        shares = self._found.get(plain_spelling(name))
        return self._loosely.get(loose_spelling(name), {}) if shares is None else shares


ARKIT_CHANNELS = ChannelNames(ARKIT_NAMES)
"""Those of ARKit alone."""
