"""Draws the README's picture, docs/pictures/show.png, with the show's own stage: `python tools/draw_show.py`.

Starts `omote show`, opens one stage in a browser, holds a pose after the other, and puts the pictures side by side.
"""

from __future__ import annotations

import base64
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, sync_playwright

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from tools.browser import SENTENCE, find_browser

TARGET = Path(__file__).resolve().parent.parent / "docs" / "pictures" / "show.png"
WIDTH, HEIGHT, COLUMNS = 320, 350, 5
CHROMIUM = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
READY = "() => Boolean(window.omoteStage?.counters().drawn)"
Pose = dict[str, Any]


def pose(face: str | dict[str, float], expression: str, yaw: float = 0.0, roll: float = 0.0, look: float = 0.0) -> Pose:
    """A pose of a stage: face or mix of faces, expression, the head's turn and tilt, where the eyes go (radians)."""
    faces = {face: 1.0} if isinstance(face, str) else face
    return {"faces": faces, "expressions": {expression: 1.0}, "head": [yaw, 0, roll], "eyes": [look, 0, look, 0]}


POSES = (
    pose("kaori", "smile", 0.2, 0.05, -0.15),
    pose("old", "laugh", 0.35),
    pose("man", "angry", -0.2),
    pose("doll", "surprise"),
    pose("child", "asleep", 0.1, 0.12),
    pose({"kaori": 0.5, "goblin": 0.5}, "joy", -0.15),
    pose("goblin", "disgust", -0.45, 0.08, 0.2),
    pose("baby", "cry", 0.15),
    pose("heavy", "doubt", -0.15, -0.08, 0.2),
    pose({"round": 0.5, "alien": 0.5}, "pout", 0.2),
)


def pictures(browser: Browser, url: str) -> list[str]:
    """A PNG of each pose, as data addresses."""
    page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT}, device_scale_factor=1, bypass_csp=True)
    page.goto(f"{url}/stage?quality=high")
    page.wait_for_function(READY)
    drawn = []
    for each in POSES:
        page.evaluate("pose => window.omoteStage.hold(pose)", each)
        drawn.append("data:image/png;base64," + base64.b64encode(page.screenshot()).decode())
    return drawn


def sheet(browser: Browser, drawn: list[str]) -> bytes:
    """The pictures side by side, as a PNG."""
    rows = -(-len(drawn) // COLUMNS)
    page = browser.new_page(viewport={"width": COLUMNS * WIDTH, "height": rows * HEIGHT}, device_scale_factor=1)
    page.set_content('<body style="margin:0;font-size:0">' + "".join(f'<img src="{one}">' for one in drawn))
    page.wait_for_function("() => [...document.images].every((image) => image.complete)")
    return page.screenshot()


def opened(process: subprocess.Popen[str]) -> str:
    """The address of the show, once it says where it is."""
    assert process.stdout is not None
    for line in process.stdout:
        if found := re.search(r"(http://\S+)/stage", line):
            return found[1]
    raise RuntimeError("the show did not open")


@contextmanager
def opened_show() -> Iterator[tuple[Browser, str]]:
    """A browser and the address of a show that nobody else plays; both end with the block.

    RuntimeError with a sentence where there is no browser.
    """
    path = find_browser()
    if path is None:
        raise RuntimeError(SENTENCE)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        command = [sys.executable, "-c", "from omote.cli import main; main()", "show", f"{folder}/show.omote"]
        process = subprocess.Popen([*command, "--port", "0", "--no-open"], stdout=subprocess.PIPE, text=True)
        try:
            browser = playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
            yield browser, opened(process)
            browser.close()
        finally:
            process.terminate()
            process.communicate(timeout=20.0)


def main() -> int:
    """Draws the picture."""
    with opened_show() as (browser, address):
        TARGET.write_bytes(sheet(browser, pictures(browser, address)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
