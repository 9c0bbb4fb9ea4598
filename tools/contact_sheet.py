"""Draws the contact sheets of docs/transfer.md with the show's own stage: `python -m tools.contact_sheet`.

Every face of the cast (rows) in docs/pictures/contact-expressions.jpg, contact-shapes.jpg and contact-eyes.jpg: ten
expressions; wide mouths, blinks, sums of three and half-way morphs; and the eyes from near. Judge by eye.
"""

from __future__ import annotations

import base64
import html
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, FloatRect, Page

import omote
from tools.draw_show import READY, opened_show

PICTURES = Path(__file__).resolve().parent.parent / "docs" / "pictures"
QUALITY = 82
Pose = dict[str, Any]


@dataclass(frozen=True)
class Column:
    """One pose for every face: an expression, channels over it, the eyes' yaw and pitch, another face mixed in."""

    title: str
    expression: str = "neutral"
    channels: tuple[tuple[str, float], ...] = ()
    look: tuple[float, float] = (0.0, 0.0)
    other: float = 0.0
    turn: float = 0.0

    def pose(self, face: str, following: str) -> Pose:
        """The pose of a face; `following` is the one that is mixed in."""
        faces = {face: 1.0 - self.other, following: self.other} if self.other and face != following else {face: 1.0}
        return {
            "faces": faces,
            "expressions": {self.expression: 1.0},
            "channels": dict(self.channels),
            "head": [self.turn, 0.0, 0.0],
            "eyes": [*self.look, *self.look],
        }


@dataclass(frozen=True)
class Sheet:
    """A picture: a stage of some size per tile, of which a part is kept: left, top, width, height, as shares."""

    name: str
    columns: tuple[Column, ...]
    size: tuple[int, int] = (150, 172)
    part: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 1.0)

    def clip(self) -> FloatRect:
        """What is kept of a tile, in pixels."""
        (width, height), (left, top, wide, high) = self.size, self.part
        return {"x": left * width, "y": top * height, "width": wide * width, "height": high * height}


def both(unit: str, weight: float = 1.0) -> tuple[tuple[str, float], ...]:
    """A unit of the left and its sister of the right, at a weight."""
    return ((f"{unit}Left", weight), (f"{unit}Right", weight))


SHEETS = (
    Sheet(
        "expressions",
        tuple(
            Column(name, name)
            for name in ("neutral", "smile", "laugh", "sad", "angry", "surprise", "disgust", "kiss", "pain", "doubt")
        ),
    ),
    Sheet(
        "shapes",
        (
            Column("jaw open", channels=(("jawOpen", 1.0),)),
            Column("mouth wide open", channels=(("mouth-open", 1.0),), turn=0.5),
            Column("jaw open, lips closed", channels=(("jawOpen", 1.0), ("mouthClose", 1.0))),
            Column("funnel", channels=(("mouthFunnel", 1.0),)),
            Column("smile + blink + jaw", channels=(*both("mouthSmile"), *both("eyeBlink"), ("jawOpen", 0.6))),
            Column("sneer + squint + pucker", channels=(*both("noseSneer"), *both("eyeSquint"), ("mouthPucker", 1.0))),
            Column("half way to the next", other=0.5),
            Column("... laughing", "laugh", other=0.5),
            Column("... blinking", channels=both("eyeBlink"), other=0.5),
        ),
    ),
    Sheet(
        "eyes",
        (
            Column("half blink", channels=both("eyeBlink", 0.5)),
            Column("blink", channels=both("eyeBlink")),
            Column("asleep", "asleep"),
            Column("closure (MakeHuman)", channels=(("eye-left-closure", 1.0), ("eye-right-closure", 1.0))),
            Column("wide", channels=both("eyeWide")),
            Column("down", channels=both("eyeLookDown"), look=(0.0, -0.5)),
            Column("up", channels=both("eyeLookUp"), look=(0.0, 0.45)),
            Column("squint", channels=both("eyeSquint")),
        ),
        size=(480, 550),
        part=(0.19, 0.33, 0.62, 0.22),
    ),
)  # fmt: skip


def tiles(page: Page, sheet: Sheet, faces: Sequence[str]) -> Iterator[str]:
    """A JPEG of each face in each column, row by row, as data addresses."""
    for face, following in zip(faces, [*faces[1:], faces[0]], strict=True):
        for column in sheet.columns:
            page.evaluate("pose => window.omoteStage.hold(pose)", column.pose(face, following))
            picture = page.screenshot(type="jpeg", quality=95, clip=sheet.clip())
            yield "data:image/jpeg;base64," + base64.b64encode(picture).decode()


def draw(browser: Browser, url: str, sheet: Sheet, faces: Sequence[str]) -> bytes:
    """A sheet as a JPEG."""
    width, height = sheet.size
    stage = browser.new_page(viewport={"width": width, "height": height}, device_scale_factor=1, bypass_csp=True)
    stage.goto(f"{url}/stage?quality=high")
    stage.wait_for_function(READY)
    page = browser.new_page(device_scale_factor=1)
    page.set_content(table(sheet, faces, list(tiles(stage, sheet, faces))))
    page.wait_for_function("() => [...document.images].every((image) => image.complete)")
    picture = page.locator("table").screenshot(type="jpeg", quality=QUALITY)
    stage.close()
    page.close()
    return picture


def table(sheet: Sheet, faces: Sequence[str], drawn: Sequence[str]) -> str:
    """The page that puts the tiles side by side, with their names."""
    count = len(sheet.columns)
    head = "".join(f"<th>{html.escape(column.title)}</th>" for column in sheet.columns)
    rows = (
        f"<tr><th>{html.escape(face)}</th>"
        + "".join(f'<td><img src="{one}"></td>' for one in drawn[row * count : (row + 1) * count])
        + "</tr>"
        for row, face in enumerate(faces)
    )
    style = (
        "body{margin:0;background:#000;width:max-content}table{border-spacing:1px;font:12px sans-serif;color:#ddd}"
        "td{padding:0;line-height:0}th{padding:4px;font-weight:400}"
    )
    return f"<style>{style}</style><table><tr><th></th>{head}</tr>{''.join(rows)}</table>"


def main() -> int:
    """Draws the sheets, or those whose names are given."""
    wanted = [sheet for sheet in SHEETS if sheet.name in sys.argv[1:] or len(sys.argv) == 1]
    if not wanted:
        print(f"expected some of {', '.join(sheet.name for sheet in SHEETS)}")
        return 1
    faces = list(omote.load_cast().faces)
    with opened_show() as (browser, address):
        for sheet in wanted:
            target = PICTURES / f"contact-{sheet.name}.jpg"
            target.write_bytes(draw(browser, address, sheet, faces))
            print(f"docs/pictures/{target.name}: {len(faces)} faces, {target.stat().st_size // 1000} kB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
