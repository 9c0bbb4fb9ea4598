"""Draws the contact sheets of docs/gallery.md as `omote render` draws; names as arguments draw only those.

docs/pictures/gallery-*.jpg: ten expressions of four faces, a turntable of every face, mouths open at 30 degrees, eyes
at nine gazes, the lights, other backgrounds, half-way morphs, figures in poses, limb fields. Judge by eye.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import omote
from omote.model.cast import Cast
from omote.stage_data.picture_setting import Setting
from tools.pictures.drawing import PICTURES, Picture, draw_wanted, grid_of

MOST_BYTES = 6_000_000
PLAYERS = ("kaori", "old", "child", "dog")
EXPRESSIONS = ("neutral", "smile", "laugh", "sad", "angry", "surprise", "disgust", "kiss", "cry", "doubt")
YAWS = (-75, -50, -25, 0, 25, 50, 75)
MOUTHS = {
    "half open": "jawOpen=0.5",
    "open": "jawOpen",
    "wide": "mouth-open=1",
    "funnel": "mouthFunnel+jawOpen=0.4",
}
POSES = {"stand": "neutral", "wave": "smile", "think": "doubt", "point": "angry", "shrug": "kiss", "bow": "smile"}
LIMBS = {
    "as they are": "",
    "belly": "belly",
    "chest": "chest",
    "thighs, calves": "thighLeft+thighRight+calfLeft+calfRight",
    "puffed sleeves": "puffedSleeves",
}
GAZES = ("-30,20", "0,20", "30,20", "-30,0", "0,0", "30,0", "-30,-25", "0,-25", "30,-25")
LIGHTS = ("theatre", "portrait", "flat", "theatre=0.5+portrait=0.5")
MORPHS = (("kaori", "dog"), ("kaori", "old"), ("child", "man"), ("old", "cat"))
STEPS = (0.0, 0.17, 0.33, 0.5, 0.67, 0.83, 1.0)
BLUE = "#2a5aa8"
PAPER = "#cfc6b4"


def expressions(cast: Cast, face: str) -> Picture:
    """Ten expressions of a face, in two rows of five."""
    worn = [(name, {"face": face, "expression": name}) for name in EXPRESSIONS]
    drawn = replace(grid_of(cast, [("", worn[:5]), ("", worn[5:])]), rows=())
    return Picture(f"gallery-{face}", drawn, Setting(400, 450))


def turntable(cast: Cast) -> Picture:
    """Every face from seven sides."""
    rows = [(face, [("", {"face": face, "turn": str(yaw)}) for yaw in YAWS]) for face in cast.faces]
    return Picture("gallery-turntable", grid_of(cast, rows), Setting(280, 240))


def mouths(cast: Cast) -> Picture:
    """Mouths open at 30 degrees."""
    rows = [
        (face, [(name, {"face": face, "channel": unit, "turn": "30"}) for name, unit in MOUTHS.items()])
        for face in (*PLAYERS, "man")
    ]
    return Picture("gallery-mouths", grid_of(cast, rows), Setting(380, 400))


def eyes(cast: Cast) -> Picture:
    """Eyes at nine gazes, from near, in rows of three."""
    rows = []
    for face in PLAYERS:
        looks = [(f"{face} {gaze}", {"face": face, "gaze": gaze}) for gaze in GAZES]
        rows += [(face, looks[at : at + 3]) for at in (0, 3, 6)]
    drawn = replace(grid_of(cast, rows), rows=(), part=(0.19, 0.33, 0.62, 0.2))
    return Picture("gallery-eyes", drawn, Setting(760, 860))


def lights(cast: Cast) -> Picture:
    """The lights, and half way between two."""
    rows = [
        (face, [(light, {"face": face, "expression": "smile", "light": light, "turn": "-20"}) for light in LIGHTS])
        for face in PLAYERS
    ]
    return Picture("gallery-lights", grid_of(cast, rows), Setting(400, 430))


def draw_keyed(cast: Cast, name: str, setting: Setting, paper: str) -> Picture:
    """Four faces before one colour."""
    row = [(face, {"face": face, "expression": "smile", "light": "portrait", "turn": "15"}) for face in PLAYERS]
    return Picture(f"gallery-{name}", replace(grid_of(cast, [("", row)]), rows=(), paper=paper), setting)


def morphs(cast: Cast) -> Picture:
    """From face to face, smiling, in seven steps."""
    rows = [
        (
            f"{one} to {other}",
            [("", {"face": f"{one}={1 - step}+{other}={step}", "expression": "smile", "turn": "20"}) for step in STEPS],
        )
        for one, other in MORPHS
    ]
    return Picture("gallery-morphs", grid_of(cast, rows), Setting(260, 290))


def figures(cast: Cast) -> Picture:
    """Whole figures in poses, each face on its own body."""
    rows = [
        (face, [(pose, {"face": face, "expression": worn, "pose": pose}) for pose, worn in POSES.items()])
        for face in (*PLAYERS, "heavy")
    ]
    return Picture("gallery-figures", grid_of(cast, rows), Setting(240, 400, framing="full"))


def limbs(cast: Cast) -> Picture:
    """Limb fields on four bodies, dark before a light ground: what they do shows in the outline."""
    rows = [
        (face, [(name, {"face": face, "channel": worn, "light": "portrait"}) for name, worn in LIMBS.items()])
        for face in ("kaori", "heavy", "child", "dog")
    ]
    return Picture("gallery-limbs", grid_of(cast, rows), Setting(240, 400, background=PAPER, framing="full"))


def gallery(cast: Cast) -> list[Picture]:
    """All sheets of the gallery."""
    blue = Setting(400, 430, background=BLUE)
    clear = Setting(400, 430, transparent=True)
    return [
        *(expressions(cast, face) for face in PLAYERS),
        turntable(cast),
        mouths(cast),
        eyes(cast),
        lights(cast),
        draw_keyed(cast, "background", blue, "#000"),
        draw_keyed(cast, "transparent", clear, PAPER),
        morphs(cast),
        figures(cast),
        limbs(cast),
    ]


def main() -> int:
    """Draws the gallery, or those sheets whose names are given."""
    failed = draw_wanted(gallery(omote.load_cast()), sys.argv[1:])
    total = sum(path.stat().st_size for path in PICTURES.glob("gallery-*.jpg"))
    print(f"{total / 1e6:.1f} MB of {MOST_BYTES / 1e6:.0f}")
    return failed or int(total >= MOST_BYTES)


if __name__ == "__main__":
    sys.exit(main())
