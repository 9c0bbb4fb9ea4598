"""Draws the contact sheets of docs/transfer.md and docs/sculpts.md, and the README's faces; names draw only those.

Every face of the cast (rows) with ten expressions, with wide mouths, blinks, sums of three and half-way morphs, and its
eyes from near; every sculpted face, and the way from a person to it. At a low quality: shapes are judged, not skin.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import omote
from omote.model.cast import Cast
from omote.stage_data.picture_setting import Setting
from tools.baking.sculpts import sculpt_paths
from tools.pictures.drawing import Picture, Words, draw_wanted, grid_of

TILE = Setting(150, 172, quality="low")
EXPRESSIONS = ("neutral", "smile", "laugh", "sad", "angry", "surprise", "disgust", "kiss", "pain", "doubt")
BLINK = "eyeBlinkLeft=1+eyeBlinkRight=1"
SHAPES: dict[str, Words] = {
    "jaw open": {"channel": "jawOpen=1"},
    "mouth wide open": {"channel": "mouth-open=1", "turn": "29"},
    "jaw open, lips closed": {"channel": "jawOpen=1+mouthClose=1"},
    "funnel": {"channel": "mouthFunnel=1"},
    "smile, blink, jaw": {"channel": f"mouthSmileLeft=1+mouthSmileRight=1+{BLINK}+jawOpen=0.6"},
    "sneer, squint, pucker": {
        "channel": "noseSneerLeft=1+noseSneerRight=1+eyeSquintLeft=1+eyeSquintRight=1+mouthPucker=1"
    },
}
EYES: dict[str, Words] = {
    "half blink": {"channel": "eyeBlinkLeft=0.5+eyeBlinkRight=0.5"},
    "blink": {"channel": BLINK},
    "asleep": {"expression": "asleep"},
    "closure (MakeHuman)": {"channel": "eye-left-closure=1+eye-right-closure=1"},
    "wide": {"channel": "eyeWideLeft=1+eyeWideRight=1"},
    "down": {"gaze": "0,-28"},
    "up": {"gaze": "0,26"},
    "squint": {"channel": "eyeSquintLeft=1+eyeSquintRight=1"},
}
SCULPTS: tuple[Words, ...] = (
    {},
    {"turn": "32"},
    {"expression": "shout", "turn": "26"},
    {"expression": "smile", "turn": "11"},
    {"expression": "angry", "turn": "-17"},
    {"channel": BLINK, "turn": "17"},
)
PEOPLE = {"auntie": "gaunt", "cat": "child", "count": "round", "dog": "kaori", "noh": "man"}
STEPS = (0.0, 0.25, 0.5, 0.5, 0.75, 1.0)
SHOWN = ("kaori", "man", "dog", "cat", "noh")
SHOWN_EXPRESSIONS = ("neutral", "smile", "surprise", "angry", "shout")


def show(cast: Cast) -> Picture:
    """Five faces by five expressions, as the stage shows them."""
    rows = [("", [("", {"face": face, "expression": name}) for name in SHOWN_EXPRESSIONS]) for face in SHOWN]
    return Picture("show", replace(grid_of(cast, rows), rows=()), Setting(256, 280))


def expressions(cast: Cast) -> Picture:
    """Ten expressions of every face."""
    rows = [(face, [(name, {"face": face, "expression": name}) for name in EXPRESSIONS]) for face in cast.faces]
    return Picture("contact-expressions", grid_of(cast, rows), TILE)


def shapes(cast: Cast) -> Picture:
    """Wide mouths, sums, and half way to the next face of the cast."""
    faces = list(cast.faces)
    rows = []
    for face, following in zip(faces, [*faces[1:], faces[0]], strict=True):
        half = {"face": f"{face}=0.5+{following}=0.5"}
        between: dict[str, Words] = {
            "half way to the next": half,
            "... laughing": half | {"expression": "laugh"},
            "... blinking": half | {"channel": BLINK},
        }
        worn = {name: {"face": face, **words} for name, words in SHAPES.items()} | between
        rows.append((face, list(worn.items())))
    return Picture("contact-shapes", grid_of(cast, rows), TILE)


def eyes(cast: Cast) -> Picture:
    """Eyes and lids of every face, from near."""
    rows = [(face, [(name, {"face": face, **words}) for name, words in EYES.items()]) for face in cast.faces]
    return Picture(
        "contact-eyes", replace(grid_of(cast, rows), part=(0.19, 0.33, 0.62, 0.22)), Setting(480, 550, quality="low")
    )


def sculpts(cast: Cast) -> Picture:
    """A row for each sculpt: at rest, turned, barking, smiling, angry, with closed eyes."""
    rows = [(path.stem, [("", {"face": path.stem, **words}) for words in SCULPTS]) for path in sculpt_paths()]
    return Picture("sculpts", grid_of(cast, rows), Setting(200, 190))


def morphs(cast: Cast) -> Picture:
    """A row for each sculpt: from a person to it, half way with an open mouth too."""
    rows = []
    for name, person in PEOPLE.items():
        faces = [f"{person}={1.0 - share}+{name}={share}" for share in STEPS]
        said = ["surprise=0.5" if column == 3 else "neutral" for column in range(len(STEPS))]
        worn = [("", {"face": face, "expression": word}) for face, word in zip(faces, said, strict=True)]
        rows.append((f"{person} to {name}", worn))
    return Picture("morphs", grid_of(cast, rows), Setting(200, 190))


def contact_sheets(cast: Cast) -> list[Picture]:
    """All sheets."""
    return [drawn(cast) for drawn in (show, expressions, shapes, eyes, sculpts, morphs)]


def main() -> int:
    """Draws the sheets, or those whose names are given."""
    return draw_wanted(contact_sheets(omote.load_cast()), sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
