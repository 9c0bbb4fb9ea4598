"""The 52 coefficients of ARKit as trackers name and order them: a name is looked up, never a place in a list."""

from __future__ import annotations

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
ALIASES: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "browinnerupleft": {"browInnerUp": 1.0},
        "browinnerupright": {"browInnerUp": 1.0},
        "blink": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0},
        "blinkleft": {"eyeBlinkLeft": 1.0},
        "blinkright": {"eyeBlinkRight": 1.0},
        **{spelling: shares for spellings, shares in _VOWELS.items() for spelling in spellings},
    }
)
"""Names that are not ARKit's, and what says the same: MeowFace halves the inner brow; expressions of VRM, of version 0
and 1, close the eyes and shape vowels (recipes of our own)."""
_SIDES = {"_l": "left", "_r": "right"}


def plain_spelling(name: str) -> str:
    """A name in the one spelling that all carriers share: `eyeBlink_L`, `EyeBlinkLeft` and `eyeblinkleft` are the
    same."""
    small = name.lower()
    return small[:-2] + _SIDES[small[-2:]] if small[-2:] in _SIDES else small


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

    def find(self, name: str) -> tuple[str, ...]:
        """The channels that a tracker means by a name; none where the cast has none of that name."""
        return tuple(self.shares(name))

    def shares(self, name: str) -> Mapping[str, float]:
        """The same, each with its share of the name's weight."""
        return self._found.get(plain_spelling(name), {})


ARKIT_CHANNELS = ChannelNames(ARKIT_NAMES)
"""Those of ARKit alone."""
