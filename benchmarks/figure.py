"""What a full figure costs a frame: beside the head alone at the same size and level, and beside three.js (issue 34).

The peer is three.js's SkinnedMesh on the figure that Omote exports, with its morph targets and standard material, four
lights and no shadows. All draw by turns in one browser at 640x360: sixty channels and a pose move in every frame.
`--rounds N`, `--face NAME`.
"""

from __future__ import annotations

import argparse
import asyncio
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from playwright.async_api import Browser, Page, Route, async_playwright
from rich.console import Console
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.peers.frame_costs import LEVELS
from benchmarks.peers.three_head import ADDRESS, EXPORT, THREE
from benchmarks.stage import CHROMIUM, HEIGHT, WIDTH, moving_channels
from omote.server.headless.picture_renderer import serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from tools.browser import SENTENCE, find_browser

MOST = 1.8
"""Of a head's frame, that a full figure's may cost."""
PEER = Path(__file__).resolve().parent / "peers" / "three_figure.html"
SHOTS = {"head": "", "full": "&shot=full"}
TURN = """async ({ face, channels, frames }) => {
    const gl = document.querySelector("canvas").getContext("webgl2");
    const times = [];
    for (window.number ??= 0; times.length < frames; window.number++) {
        const time = window.number / 30;
        const weights = Object.fromEntries(channels.map((name, n) => [name, 0.06 * (1.2 + Math.sin(2.5 * time + n))]));
        const part = 0.5 + 0.5 * Math.sin(time);
        const figure = { poses: { wave: part, bow: 1 - part }, regions: {}, bodies: { own: 1 } };
        const begun = performance.now();
        if (window.threeFigure) window.threeFigure.hold({ channels: weights, time });
        else {
            const head = [0.3 * part, 0, 0];
            await window.omoteStage.hold({ faces: { [face]: 1 }, channels: weights, head, figure });
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        times.push(performance.now() - begun);
    }
    return times;
}"""
FRAMES = 8


async def open_stage(browser: Browser, url: str, query: str) -> Page:
    """A stage that draws only what it is told to. query: of its address."""
    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.goto(f"{url}/stage?{query}")
    await page.wait_for_function("() => Boolean(window.omoteStage)", polling=100)
    await page.evaluate("window.omoteStage.rest()")
    return page


async def open_peer(browser: Browser, file: Path) -> Page:
    """The page of three.js with the figure of a file; an error where that is not skinned."""

    async def answer(route: Route) -> None:
        name = route.request.url.removeprefix(ADDRESS).partition("?")[0]
        if name.startswith("/three/"):
            await route.fulfill(path=THREE / name.removeprefix("/three/"))
        else:
            await route.fulfill(path=file if name == "/figure.glb" else PEER)

    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.route("**/*", answer)
    await page.goto(ADDRESS)
    await page.wait_for_function("() => Boolean(window.threeFigure)", polling=100)
    if await page.evaluate("window.threeFigure.skinned") == 0:
        raise RuntimeError("the exported figure has no SkinnedMesh")
    return page


async def measure(face: str, rounds: int) -> dict[str, list[float]]:
    """The median milliseconds of each round, by what is drawn."""
    channels = moving_channels()
    asked: dict[str, Any] = {"face": face, "channels": channels, "frames": FRAMES}
    costs: dict[str, list[float]] = {}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "figure.glb"
        words = [*EXPORT, face, "--figure", "--output", str(file), "--expressions", ",".join(channels)]
        subprocess.run(words, check=True, capture_output=True)
        path = find_browser()
        if path is None:
            sys.exit(SENTENCE)
        async with serve_pages(built_in_documents(), read_pages()) as url, async_playwright() as playwright:
            browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
            pages = {"three.js": await open_peer(browser, file)}
            for level in LEVELS:
                for shot, query in SHOTS.items():
                    pages[f"{level} {shot}"] = await open_stage(browser, url, f"quality={level}{query}")
            for page in pages.values():
                await page.evaluate(TURN, asked | {"frames": 2})  # shaders are compiled, compounds loaded
            for _ in range(rounds):
                for name, page in pages.items():
                    costs.setdefault(name, []).append(float(np.median(await page.evaluate(TURN, asked))))
            await browser.close()
    return costs


def main(words: Sequence[str] | None = None) -> int:
    """Prints the ratios; 1 where one is above its bar."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--face", default="kaori")
    asked = parser.parse_args(words)
    costs = asyncio.run(measure(asked.face, asked.rounds))
    table = Table("level", "ms of a head", "ms of a figure", f"of a head's, at most {MOST}", "of three.js's, below 1")
    missed = False
    for level in LEVELS:
        head, full, peer = (np.array(costs[name]) for name in (f"{level} head", f"{level} full", "three.js"))
        beside_head = float(np.median(full / head))
        beside_peer = float(np.median(full / peer))
        missed |= beside_head > MOST
        table.add_row(
            level, f"{np.median(head):.1f}", f"{np.median(full):.1f}", f"{beside_head:.2f}", f"{beside_peer:.2f}"
        )
    Console().print(table, f"three.js: {np.median(costs['three.js']):.1f} ms")
    return int(missed)


if __name__ == "__main__":
    sys.exit(main())
