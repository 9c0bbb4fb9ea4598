"""The pads that come with the cast: moods of the whole face, the mouth, and faces."""

from __future__ import annotations

from collections.abc import Mapping

from omote.model.known_names import GENERIC, NEUTRAL
from omote.perform.pads.blend_space import FEWEST_LOOKS, Pad, PadLook, PadPart, PadPlace
from omote.perform.snapshot import Playable

Layout = Mapping[str, tuple[PadPlace, str]]
"""By label: the place of a look, and its name in the cast."""

MOODS: Layout = {
    "Neutral": ((0.0, 0.0), NEUTRAL),
    "Smile": ((0.6, 0.0), "smile"),
    "Joy": ((0.95, 0.45), "joy"),
    "Laugh": ((0.6, 0.9), "laugh"),
    "Surprise": ((0.0, 0.7), "surprise"),
    "Fear": ((-0.6, 0.9), "fear"),
    "Angry": ((-0.95, 0.45), "angry"),
    "Disgust": ((-0.6, 0.0), "disgust"),
    "Sad": ((-0.6, -0.75), "sad"),
    "Sleepy": ((0.6, -0.75), "sleepy"),
    "Doubt": ((0.0, -0.6), "doubt"),
}
"""To the right what is pleasant, up what is awake, as in the circumplex of Russell (1980)."""
MOUTH: Layout = {
    "Neutral": ((0.0, 0.0), NEUTRAL),
    "Smile": ((0.7, 0.6), "smile"),
    "Stretch": ((0.85, -0.05), "mouth-retraction"),
    "Bared": ((0.6, -0.7), "mouth-depression-retraction"),
    "Disgust": ((0.0, -0.75), "disgust"),
    "Angry": ((-0.6, -0.75), "angry"),
    "Pout": ((-0.85, -0.1), "pout"),
    "Funnel": ((-0.65, 0.55), "mouthFunnel"),
    "Pressed": ((0.0, 0.75), "mouth-compression"),
}
"""To the right what is wide, to the left what is round."""
FACES: Layout = {
    "Generic": ((0.0, 0.0), GENERIC),
    "Kaori": ((0.6, 0.0), "kaori"),
    "Child": ((0.5, 0.7), "child"),
    "Doll": ((0.0, 0.8), "doll"),
    "Cat": ((-0.55, 0.75), "cat"),
    "Dog": ((-0.8, 0.2), "dog"),
    "Goblin": ((-0.7, -0.45), "goblin"),
    "Old": ((-0.15, -0.75), "old"),
    "Man": ((0.4, -0.75), "man"),
    "Heavy": ((0.85, -0.4), "heavy"),
}
"""The young above, the old below, animals to the left."""
_PADS: Mapping[str, tuple[PadPart, Layout]] = {
    "moods": ("expression", MOODS),
    "mouth": ("mouth", MOUTH),
    "faces": ("face", FACES),
}


def cast_pads(cast: Playable) -> dict[str, Pad]:
    """The pads of a cast by name: those of which it has two looks or more."""
    pads = {}
    for name, (plays, layout) in _PADS.items():
        known = cast.faces if plays == "face" else cast.expressions
        looks = [PadLook(label, {of: 1.0}, place) for label, (place, of) in layout.items() if of in known]
        if len(looks) >= FEWEST_LOOKS:
            pads[name] = Pad(name, plays, 2, tuple(looks))
    return pads
