"""What people read of each expression: plain words, the side behind them; a name stays what files and the wire say."""

from __future__ import annotations

from collections.abc import Mapping

# `*` in a name stands for Left and Right, left and right; the label of either says its side.
LABELS: Mapping[str, str] = {
    "browDown*": "Brow down",
    "browInnerUp": "Inner brows up",
    "browOuterUp*": "Outer brow up",
    "cheekPuff": "Puff cheeks",
    "cheekSquint*": "Raise cheek",
    "eyeBlink*": "Blink",
    "eyeLookDown*": "Look down",
    "eyeLookIn*": "Look to the nose",
    "eyeLookOut*": "Look outward",
    "eyeLookUp*": "Look up",
    "eyeSquint*": "Squint",
    "eyeWide*": "Widen eye",
    "jawForward": "Jaw forward",
    "jawLeft": "Jaw to the left",
    "jawOpen": "Open jaw",
    "jawRight": "Jaw to the right",
    "mouthClose": "Close lips over open jaw",
    "mouthDimple*": "Dimple",
    "mouthFrown*": "Mouth corner down",
    "mouthFunnel": "Funnel lips",
    "mouthLeft": "Mouth to the left",
    "mouthLowerDown*": "Lower lip down",
    "mouthPress*": "Press lips",
    "mouthPucker": "Pucker lips",
    "mouthRight": "Mouth to the right",
    "mouthRollLower": "Roll lower lip in",
    "mouthRollUpper": "Roll upper lip in",
    "mouthShrugLower": "Push lower lip up",
    "mouthShrugUpper": "Push upper lip up",
    "mouthSmile*": "Mouth corner up",
    "mouthStretch*": "Stretch mouth corner",
    "mouthUpperUp*": "Upper lip up",
    "noseSneer*": "Sneer",
    "tongueOut": "Tongue out",
    "eye-*-closure": "Close eye",
    "eye-*-opened-up": "Open eye wide",
    "eye-*-slit": "Eye to a slit",
    "eyebrows-*-down": "Lower brow",
    "eyebrows-*-extern-up": "Raise outer brow",
    "eyebrows-*-inner-up": "Raise inner brow",
    "eyebrows-*-up": "Raise brow",
    "mouth-compression": "Press lips together",
    "mouth-corner-puller": "Smile with closed lips",
    "mouth-depression": "Mouth corners down",
    "mouth-depression-retraction": "Bare lower teeth",
    "mouth-elevation": "Bare upper teeth",
    "mouth-eversion": "Turn lower lip out",
    "mouth-open": "Open mouth wide",
    "mouth-parling": "Part lips",
    "mouth-part-later": "Bare all teeth",
    "mouth-protusion": "Push open lips forward",
    "mouth-pursing": "Purse lips",
    "mouth-retraction": "Mouth corners back",
    "mouth-upward-retraction": "Grin with teeth",
    "neck-platysma": "Tense neck",
    "nose-compression": "Pinch nostrils",
    "nose-depression": "Nose tip down",
    "nose-*-dilatation": "Flare nostril",
    "nose-*-elevation": "Raise nostril",
    "pupils-wide": "Widen pupils",
    "pupils-narrow": "Narrow pupils",
    "ears-up": "Ears up",
    "ears-down": "Ears down",
    "ears-back": "Ears back",
    "ears-out": "Ears out",
    "jowls-sway": "Jowls sway",
    "cheeks-bounce": "Cheeks bounce",
    "ears-sway": "Ears sway",
    "ears-flap": "Ears flap",
}
SIDES = (("Left", "left"), ("Right", "right"), ("left", "left"), ("right", "right"))


def label(name: str) -> str:
    """What people read: `Brow down, left` for browDownLeft, `Part lips` for mouth-parling, `Smile` for smile."""
    if name in LABELS:
        return LABELS[name]
    for written, side in SIDES:
        words = LABELS.get(name.replace(written, "*", 1))
        if words is not None:
            return f"{words}, {side}"
    return name[0].upper() + name[1:]
