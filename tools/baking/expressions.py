"""The cast's expressions: ARKit's blendshapes, MakeHuman's units, and performed expressions composed from ARKit's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from omote.model.space.complexion import ComplexionNumbers

ARKIT: Sequence[str] = (
    "browDownLeft", "browDownRight", "browInnerUp", "browOuterUpLeft", "browOuterUpRight",
    "cheekPuff", "cheekSquintLeft", "cheekSquintRight",
    "eyeBlinkLeft", "eyeBlinkRight", "eyeLookDownLeft", "eyeLookDownRight", "eyeLookInLeft", "eyeLookInRight",
    "eyeLookOutLeft", "eyeLookOutRight", "eyeLookUpLeft", "eyeLookUpRight", "eyeSquintLeft", "eyeSquintRight",
    "eyeWideLeft", "eyeWideRight",
    "jawForward", "jawLeft", "jawOpen", "jawRight",
    "mouthClose", "mouthDimpleLeft", "mouthDimpleRight", "mouthFrownLeft", "mouthFrownRight", "mouthFunnel",
    "mouthLeft", "mouthLowerDownLeft", "mouthLowerDownRight", "mouthPressLeft", "mouthPressRight", "mouthPucker",
    "mouthRight", "mouthRollLower", "mouthRollUpper", "mouthShrugLower", "mouthShrugUpper",
    "mouthSmileLeft", "mouthSmileRight", "mouthStretchLeft", "mouthStretchRight",
    "mouthUpperUpLeft", "mouthUpperUpRight",
    "noseSneerLeft", "noseSneerRight", "tongueOut",
)  # fmt: skip

MAKEHUMAN: Sequence[str] = (
    "eye-left-closure", "eye-left-opened-up", "eye-left-slit",
    "eye-right-closure", "eye-right-opened-up", "eye-right-slit",
    "eyebrows-left-down", "eyebrows-left-extern-up", "eyebrows-left-inner-up", "eyebrows-left-up",
    "eyebrows-right-down", "eyebrows-right-extern-up", "eyebrows-right-inner-up", "eyebrows-right-up",
    "mouth-compression", "mouth-corner-puller", "mouth-depression", "mouth-depression-retraction", "mouth-elevation",
    "mouth-eversion", "mouth-open", "mouth-parling", "mouth-part-later", "mouth-protusion", "mouth-pursing",
    "mouth-retraction", "mouth-upward-retraction", "neck-platysma",
    "nose-compression", "nose-depression", "nose-left-dilatation", "nose-left-elevation", "nose-right-dilatation",
    "nose-right-elevation",
)  # fmt: skip

# Weights of units, MakeHuman's where ARKit's do not go far enough; `*` in a name stands for Left and Right alike.
PERFORMED: Mapping[str, Mapping[str, float]] = {
    "smile": {"mouthSmile*": 0.62, "cheekSquint*": 0.35, "eyeSquint*": 0.15, "mouthDimple*": 0.15},
    "joy": {
        "mouthSmile*": 0.85, "cheekSquint*": 0.6, "eyeSquint*": 0.25, "mouthUpperUp*": 0.6, "mouthLowerDown*": 0.3,
        "jawOpen": 0.2, "browInnerUp": 0.2, "browOuterUp*": 0.2,
    },
    "laugh": {
        "mouthSmile*": 0.9, "cheekSquint*": 0.9, "eyeSquint*": 0.55, "eyeBlink*": 0.12, "jawOpen": 0.5,
        "mouthUpperUp*": 1.2, "browInnerUp": 0.25, "noseSneer*": 0.15,
    },
    "sad": {
        "browInnerUp": 1.25, "eyebrows-left-inner-up": 1.2, "eyebrows-right-inner-up": 1.2, "browDown*": 0.4,
        "mouthFrown*": 1.2, "mouthShrugLower": 0.7, "eyeBlink*": 0.12, "eyeSquint*": 0.15, "eyeLookDown*": 0.3,
        "mouthStretch*": 0.15,
    },
    "cry": {
        "browInnerUp": 1.25, "eyebrows-left-inner-up": 0.9, "eyebrows-right-inner-up": 0.9, "browDown*": 0.5,
        "eyeSquint*": 0.7, "eyeBlink*": 0.4, "cheekSquint*": 0.6,
        "mouthFrown*": 0.7, "mouthStretch*": 0.5, "mouthLowerDown*": 0.6, "mouthUpperUp*": 0.25, "jawOpen": 0.2,
        "noseSneer*": 0.3,
    },
    "angry": {
        "browDown*": 1.25, "eyeSquint*": 0.45, "noseSneer*": 0.8, "mouthPress*": 0.3, "mouthFrown*": 0.7,
        "mouthUpperUp*": 0.4, "mouthLowerDown*": 0.25, "mouthStretch*": 0.15, "jawForward": 0.25, "jawOpen": 0.05,
    },
    "shout": {
        "browDown*": 1.0, "eyeWide*": 0.3, "noseSneer*": 0.7, "jawOpen": 0.7, "mouthUpperUp*": 1.25,
        "mouthLowerDown*": 0.7, "mouthStretch*": 0.4, "cheekSquint*": 0.3,
    },
    "surprise": {"browInnerUp": 0.9, "browOuterUp*": 0.9, "eyeWide*": 0.85, "jawOpen": 0.4, "mouthFunnel": 0.25},
    "fear": {
        "browInnerUp": 1.25, "browOuterUp*": 0.6, "browDown*": 0.5, "eyebrows-left-inner-up": 0.8,
        "eyebrows-right-inner-up": 0.8, "eyeWide*": 1.0, "mouthStretch*": 0.8, "jawOpen": 0.22, "mouthLowerDown*": 0.35,
    },
    "disgust": {
        "noseSneer*": 1.2, "browDown*": 0.7, "mouthUpperUp*": 0.9, "cheekSquint*": 0.6, "eyeSquint*": 0.5,
        "mouthFrown*": 0.6, "mouthShrugLower": 0.3, "mouthLowerDown*": 0.2,
    },
    "contempt": {
        "mouthSmileLeft": 0.45, "mouthDimpleLeft": 0.6, "mouthPressLeft": 0.4, "noseSneerLeft": 0.25,
        "eyeBlink*": 0.22, "browDownRight": 0.2, "browOuterUpLeft": 0.35,
    },
    "sleepy": {"eyeBlink*": 0.58, "browInnerUp": 0.35, "eyeLookDown*": 0.3, "jawOpen": 0.06, "mouthFrown*": 0.15},
    "asleep": {"eyeBlink*": 0.92, "jawOpen": 0.04, "mouthShrugLower": 0.1},
    "kiss": {"mouthPucker": 1.0, "mouthFunnel": 0.12, "eyeBlink*": 0.55, "browInnerUp": 0.2, "cheekSquint*": 0.1},
    "wink": {
        "eyeBlinkLeft": 0.95, "cheekSquintLeft": 0.8, "eyeSquintLeft": 0.3, "mouthSmileLeft": 0.65,
        "mouthSmileRight": 0.35, "browDownLeft": 0.3, "browOuterUpRight": 0.3,
    },
    "doubt": {
        "browOuterUpLeft": 0.95, "browDownRight": 0.7, "eyeSquintRight": 0.45, "mouthLeft": 0.3, "mouthPress*": 0.35,
        "mouthFrownRight": 0.35, "mouthShrugUpper": 0.15,
    },
    "pain": {
        "eyeBlink*": 0.75, "eyeSquint*": 0.6, "cheekSquint*": 0.9, "browDown*": 0.9, "noseSneer*": 0.7,
        "mouthStretch*": 0.7, "mouthUpperUp*": 0.45, "mouthLowerDown*": 0.5, "jawOpen": 0.08,
    },
    "pout": {
        "mouthShrugLower": 1.0, "mouthPucker": 0.45, "mouthFrown*": 0.8, "browDown*": 0.45, "browInnerUp": 0.3,
        "cheekPuff": 0.15,
    },
    "puff": {"cheekPuff": 1.0, "mouthPress*": 0.3, "eyeWide*": 0.25, "browInnerUp": 0.3},
    "cheeky": {
        "tongueOut": 1.0, "jawOpen": 0.3, "mouthSmile*": 0.6, "cheekSquint*": 0.5, "eyeSquint*": 0.3,
        "browOuterUp*": 0.4,
    },
}  # fmt: skip

# What they do to the pupils: 1 as wide as they go, -1 as narrow (method: fear, surprise and liking widen).
PUPILS: Mapping[str, float] = {
    "smile": 0.15, "joy": 0.3, "laugh": 0.15, "sad": 0.8, "cry": 0.1, "angry": -0.9, "shout": -0.2, "surprise": 0.7,
    "fear": 1.0, "disgust": -0.6, "contempt": -0.35, "sleepy": -0.3, "kiss": 0.4, "doubt": -0.2, "pain": 0.4,
    "pout": -0.1, "cheeky": 0.2,
}  # fmt: skip

# Blood of cheeks, nose, forehead, around the eyes and of the whole face, tears and sweat
# (omote.model.space.complexion). Signs from the literature: people flush in anger and pale in fear (Drummond 1997),
# cheeks fill with pleasure; the sizes are ours.
COMPLEXIONS: Mapping[str, ComplexionNumbers] = {
    "angry": (0.45, 0.2, 0.55, 0.1, 0.15, 0.0, 0.0), "shout": (0.8, 0.3, 0.8, 0.2, 0.4, 0.0, 0.35),
    "cry": (0.5, 0.95, 0.15, 1.0, 0.12, 1.0, 0.0), "sad": (-0.1, 0.65, 0.05, 1.0, -0.3, 0.3, 0.0),
    "joy": (0.28, 0.1, 0.0, 0.0, 0.05, 0.0, 0.0), "laugh": (0.55, 0.2, 0.25, 0.15, 0.15, 0.2, 0.0),
    "fear": (-0.35, -0.1, -0.2, 0.0, -0.45, 0.0, 0.75), "surprise": (-0.05, 0.0, 0.0, 0.0, -0.1, 0.0, 0.0),
    "disgust": (-0.2, 0.2, -0.1, 0.1, -0.12, 0.0, 0.0), "pain": (0.4, 0.25, 0.4, 0.4, 0.25, 0.4, 0.85),
}  # fmt: skip

# They move the pupils, or ears (of a face that answers with its ears), and nothing else; by what they do to the pupils.
OMOTE: Mapping[str, float] = {
    "pupils-wide": 1.0, "pupils-narrow": -1.0, "ears-up": 0.0, "ears-down": 0.0, "ears-back": 0.0, "ears-out": 0.0,
}  # fmt: skip

# Springs play these, to both sides of rest: ears turn by the tables below, skin goes by heads/soft_tissue.py.
SPRING_EARS = ("ears-sway", "ears-flap")
SPRING_SKIN = ("jowls-sway", "cheeks-bounce")
SPRINGS = (*SPRING_SKIN, *SPRING_EARS)

# How far both ears go back, up and out, in degrees, on a face that answers with its ears by a gain of 1 (people's do
# not). Performed ones after what dogs and cats show: pricked with attention, laid back in fear and rage, let down in
# sorrow. The units' are small, so that a tracked performer's brows and lids stir the ears too.
EARS: Mapping[str, tuple[float, float, float]] = {
    "smile": (4, 4, 4), "joy": (-4, 14, 4), "laugh": (8, 8, 10), "sad": (10, -26, 6), "cry": (12, -24, 6),
    "angry": (30, -4, 16), "shout": (24, 0, 12), "surprise": (-14, 26, 0), "fear": (40, -20, -4),
    "disgust": (16, -8, 16), "contempt": (6, 0, 6), "sleepy": (2, -12, 6), "asleep": (2, -16, 6), "kiss": (2, 4, 2),
    "wink": (0, 6, 4), "doubt": (-6, 10, 0), "pain": (30, -8, 6), "pout": (4, -14, 6), "puff": (0, 8, 0),
    "cheeky": (-4, 12, 4),
    "browInnerUp": (-4, 12, 0), "browOuterUpLeft": (-2, 6, 0), "browOuterUpRight": (-2, 6, 0),
    "browDownLeft": (8, -2, 4), "browDownRight": (8, -2, 4), "eyeWideLeft": (-3, 6, 0), "eyeWideRight": (-3, 6, 0),
    "ears-up": (0, 30, 0), "ears-down": (0, -30, 0), "ears-back": (30, 0, 0), "ears-out": (0, 0, 30),
    "ears-flap": (4, 12, 6),
}  # fmt: skip

# How far the left ear goes back, up and out where the right one goes the opposite way: both swing to one side.
OPPOSITE_EARS: Mapping[str, tuple[float, float, float]] = {"ears-sway": (5, 0, 13)}

# Yaw, pitch and roll of the head, in degrees, on a face that answers with its head by a gain of 1 (people's do not).
HEADS: Mapping[str, tuple[float, float, float]] = {
    "joy": (0, 4, 3), "laugh": (0, 6, 4), "sad": (0, -12, 6), "cry": (0, -11, 0), "angry": (0, -7, 0),
    "surprise": (0, 5, 0), "fear": (8, 5, -5), "disgust": (9, 3, 5), "contempt": (7, 5, 3), "doubt": (4, 0, 13),
    "sleepy": (0, -7, 5), "asleep": (0, -12, 6), "wink": (0, 0, 6), "kiss": (0, 3, 3), "pout": (0, -6, 0),
    "cheeky": (0, 2, 7),
}  # fmt: skip

_REGIONS = {
    "brow": "brows",
    "eye": "eyes",
    "pupils": "eyes",
    "ears": "ears",
    "nose": "nose",
    "cheek": "cheeks",
    "jowls": "jaw",
    "mouth": "mouth",
    "jaw": "jaw",
    "tongue": "tongue",
}


def unit_weights(recipe: Mapping[str, float]) -> dict[str, float]:
    """A performed expression's weight of every unit it uses, `*` written out."""
    return {name.replace("*", side): weight for name, weight in recipe.items() for side in _sides(name)}


def ear_turns(name: str) -> NDArray[np.float64]:
    """How far the left and the right ear turn back, up and out, (2, 3) radians; `Left` and `Right` name one of them."""
    if name in OPPOSITE_EARS:
        return np.outer([1.0, -1.0], np.radians(OPPOSITE_EARS[name]))
    turn = np.radians(EARS.get(name, (0.0, 0.0, 0.0)))
    return np.stack([turn * (not name.endswith("Right")), turn * (not name.endswith("Left"))])


def head_turn(name: str) -> NDArray[np.float64]:
    """Yaw, pitch and roll of the head, (3,) radians."""
    return np.radians(HEADS.get(name, (0.0, 0.0, 0.0)))


def _sides(name: str) -> tuple[str, ...]:
    return ("Left", "Right") if "*" in name else ("",)


def region(name: str) -> str:
    """The region of the face that a unit belongs to; `whole` for what is performed and for the neck."""
    if name in PERFORMED:
        return "whole"
    if name.startswith("eyebrows"):
        return "brows"
    return next((place for prefix, place in _REGIONS.items() if name.startswith(prefix)), "whole")
