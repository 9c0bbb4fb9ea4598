"""Draws docs/pictures/sculpts.jpg and morphs.jpg with the show's own stage: `python -m tools.draw_sculpts`.

sculpts: every sculpted face at rest, turned, barking, smiling, angry and with closed eyes; morphs: from people to them.
"""

from __future__ import annotations

import base64
import sys
from pathlib import Path

from playwright.sync_api import Browser, Page

from tools.baking.sculpts import sculpt_paths
from tools.draw_show import READY, Pose, opened_show, pose

PICTURES = Path(__file__).resolve().parent.parent / "docs" / "pictures"
WIDTH, HEIGHT, COLUMNS, QUALITY = 200, 190, 6, 85
BLINK = {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}
PEOPLE = {"auntie": "gaunt", "cat": "child", "count": "round", "dog": "kaori", "noh": "man"}
STEPS = (0.0, 0.25, 0.5, 0.5, 0.75, 1.0)


def sculpts() -> list[Pose]:
    """A row for each sculpt."""
    rows = []
    for name in (path.stem for path in sculpt_paths()):
        rows += [pose(name, "neutral"), pose(name, "neutral", 0.55), pose(name, "shout", 0.45)]
        rows += [pose(name, "smile", 0.2), pose(name, "angry", -0.3), {**pose(name, "neutral", 0.3), "channels": BLINK}]
    return rows


def morphs() -> list[Pose]:
    """A row for each sculpt: from a person to it, half-way with an open mouth too."""
    rows = []
    for name, person in PEOPLE.items():
        for column, share in enumerate(STEPS):
            faces = {person: 1.0 - share, name: share}
            said = "surprise" if column == 3 else "neutral"
            rows.append(pose({face: weight for face, weight in faces.items() if weight}, said, 0.5))
    return rows


def drawn(page: Page, poses: list[Pose]) -> list[str]:
    """A picture of each pose, as data addresses."""
    found = []
    for each in poses:
        page.evaluate("pose => window.omoteStage.hold(pose)", {"channels": {}, **each})
        found.append("data:image/png;base64," + base64.b64encode(page.screenshot()).decode())
    return found


def sheet(browser: Browser, pictures: list[str]) -> bytes:
    """The pictures in rows, as a JPEG."""
    size = {"width": COLUMNS * WIDTH, "height": -(-len(pictures) // COLUMNS) * HEIGHT}
    page = browser.new_page(viewport=size, device_scale_factor=1)  # type: ignore[arg-type]
    page.set_content('<body style="margin:0;font-size:0">' + "".join(f'<img src="{one}">' for one in pictures))
    page.wait_for_function("() => [...document.images].every((image) => image.complete)")
    return page.screenshot(type="jpeg", quality=QUALITY)


def main() -> int:
    """Draws both pictures."""
    with opened_show() as (browser, address):
        page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT}, device_scale_factor=1, bypass_csp=True)
        page.goto(f"{address}/stage?quality=high")
        page.wait_for_function(READY)
        for name, poses in (("sculpts", sculpts()), ("morphs", morphs())):
            (PICTURES / f"{name}.jpg").write_bytes(sheet(browser, drawn(page, poses)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
