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
BOTH_SIDES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "browinnerupleft": ("browInnerUp",),
        "browinnerupright": ("browInnerUp",),
        "blink": ("eyeBlinkLeft", "eyeBlinkRight"),
        "blinkleft": ("eyeBlinkLeft",),
        "blinkright": ("eyeBlinkRight",),
    }
)
"""Names that are not ARKit's and say the same: MeowFace halves the inner brow, expressions of VRM close the eyes."""
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
        exact = {plain_spelling(name): (name,) for name in self.channels}
        known = set(self.channels)
        aliases = {spelling: tuple(n for n in names if n in known) for spelling, names in BOTH_SIDES.items()}
        self._found = {**{spelling: names for spelling, names in aliases.items() if names}, **exact}

    def find(self, name: str) -> tuple[str, ...]:
        """The channels that a tracker means by a name; none where the cast has none of that name."""
        return self._found.get(plain_spelling(name), ())


ARKIT_CHANNELS = ChannelNames(ARKIT_NAMES)
"""Those of ARKit alone."""
