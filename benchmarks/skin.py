"""Skin that answers, beside the same pictures without folds, blood and tears, in one run (issue 33).

* How far it shows at the size of a head at three metres (120x135 pixels of a picture of 200x225): the mean distance of
  the colours of both pictures on the face, of 255.
* How deep the folds between the brows are in *angry* (800x900): what a high pass of 8 pixels leaves there, over the
  light around, of old beside child, of kaori, and of old beside old without folds.
* Milliseconds of a frame at each level, by turns on two pages: *cry* with sixty channels that move, with all of it and
  without (strains are found on both).

`--rounds N` of the turns, `--level NAME` for one level alone.
"""

from __future__ import annotations

import argparse
import asyncio
import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from playwright.async_api import Page, async_playwright
from rich.console import Console
from rich.table import Table
from scipy.ndimage import gaussian_filter

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import omote
from benchmarks.peers.frame_costs import LEVELS, open_level
from benchmarks.stage import CHROMIUM, HEIGHT, WIDTH, moving_channels
from omote.model.space.complexion import PALE
from omote.server.headless.picture_renderer import serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from tools.browser import SENTENCE, find_browser

FAR = (200, 225)
NEAR = (800, 900)
LEAST_FAR = {"angry": 5.0, "cry": 5.0, "sad": 4.0}
PEOPLE = ("kaori", "man", "old", "child")
OTHERS = ("dog", "cat", "noh")
BROWS = (slice(315, 375), slice(360, 440))
"""Rows and columns between the brows in the near picture."""
MOST = {"lowest": 1.03, "low": 1.03, "medium": 1.1, "good": 1.15, "high": 1.15}
TURN = """async ({ pose, channels, frames }) => {
    const gl = document.querySelector("canvas").getContext("webgl2");
    const times = [];
    for (window.number ??= 0; times.length < frames; window.number++) {
        const weights = channels.map((name, n) => [name, 0.06 * (1.2 + Math.sin(window.number / 12 + n))]);
        const begun = performance.now();
        await window.omoteStage.hold({ ...pose, channels: Object.fromEntries(weights) });
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        times.push(performance.now() - begun);
    }
    return times;
}"""
WITH: Mapping[str, Any] = {"faces": {"kaori": 1}, "expressions": {"cry": 1}}
WITHOUT: Mapping[str, Any] = {**WITH, "folds": 0, "complexion": []}
FRAMES = 4

Picture = NDArray[np.float64]


def draw(renderer: omote.Renderer, face: str, worn: str, *, answers: bool = True) -> Picture:
    """The picture of a face with an expression (rows, columns, 4), whose skin answers or does not."""
    frame = omote.parse_pose(omote.load_cast(), face=face, expression=worn)
    shown = frame if answers else replace(frame, folds=0.0, complexion=PALE)
    return renderer(shown).astype(np.float64)


def distance(one: Picture, other: Picture) -> float:
    """The mean distance of the colours of two pictures where both show the face."""
    face = np.minimum(one[..., 3], other[..., 3]) == 255.0
    return float(np.linalg.norm(one[face, :3] - other[face, :3], axis=1).mean())


def relief(picture: Picture) -> float:
    """What a high pass of 8 pixels leaves between the brows, over the light around."""
    light = picture[..., :3].mean(axis=2)
    around = gaussian_filter(light, 8.0)
    return float(((light - around) / np.maximum(around, 1.0))[BROWS].std())


async def turns(rounds: int, levels: tuple[str, ...]) -> dict[str, list[float]]:
    """By level the ratios of both ways' frames, a pair a round."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    channels = moving_channels()

    async def frame(page: Page, pose: Mapping[str, Any]) -> float:
        asked = {"pose": pose, "channels": channels, "frames": FRAMES}
        return float(np.median(await page.evaluate(TURN, asked)))

    ratios: dict[str, list[float]] = {}
    async with serve_pages(built_in_documents(), read_pages()) as pages, async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
        for level in levels:
            page = await open_level(browser, pages, level, (WIDTH, HEIGHT))
            ratios[level] = []
            for number in range(rounds + 1):
                order = (WITH, WITHOUT) if number % 2 else (WITHOUT, WITH)
                times = {id(pose): await frame(page, pose) for pose in order}
                if number > 0:  # the first compiles shaders and loads compounds
                    ratios[level].append(times[id(WITH)] / times[id(WITHOUT)])
            await page.context.close()
        await browser.close()
    return ratios


def main() -> int:
    """Prints the figures; 0 when all bars are held."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--level", choices=LEVELS)
    chosen = parser.parse_args()
    table = Table("figure", "found", "bar")
    missed = 0

    def row(name: str, found: float, bar: float | None, *, least: bool) -> None:
        nonlocal missed
        held = bar is None or (found >= bar if least else found <= bar)
        missed += not held
        said = "" if bar is None else f"{'at least' if least else 'at most'} {bar:g}{'' if held else '  MISSED'}"
        table.add_row(name, f"{found:.3g}", said)

    cast = omote.load_cast()
    with omote.Renderer(cast, size=FAR, mask="face", transparent=True) as renderer:
        for face in (*PEOPLE, *OTHERS):
            for worn, least in LEAST_FAR.items():
                apart = distance(draw(renderer, face, worn), draw(renderer, face, worn, answers=False))
                row(f"{worn} on {face}, of 255", apart, least if face in PEOPLE else None, least=True)
    with omote.Renderer(cast, size=NEAR) as renderer:
        found = {face: relief(draw(renderer, face, "angry")) for face in PEOPLE}
        bare = relief(draw(renderer, "old", "angry", answers=False))
    for face, deep in found.items():
        row(f"relief between {face}'s brows", deep, 0.03 if face == "kaori" else None, least=True)
    row("old beside child", found["old"] / found["child"], 1.3, least=True)
    row("old beside old without folds", found["old"] / bare, 2.0, least=True)
    levels = LEVELS if chosen.level is None else (chosen.level,)
    for level, ratios in asyncio.run(turns(chosen.rounds, levels)).items():
        row(f"frame at {level}", float(np.median(ratios)), MOST[level], least=False)
    Console(width=100).print(table)
    return int(missed > 0)


if __name__ == "__main__":
    sys.exit(main())
