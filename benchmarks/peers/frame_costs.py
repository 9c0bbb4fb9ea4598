"""Milliseconds of a frame at every level of a stage's quality and of three.js, by turns in one browser.

A frame is the time from a pose to its pixels, which are waited for by reading one back: all of its work is in it, and
nothing of a display's rate. All pages stay open and draw in turns, so that what else a machine does falls on all alike.
"""

from __future__ import annotations

import typing

import numpy as np
from playwright.async_api import Browser, Page

from benchmarks.peers.three_head import Head, open_three
from omote.show.objects.stages import Level

LEVELS: tuple[str, ...] = typing.get_args(Level)
PEER = "three.js"
SHADED = "three.js, shadows"
ROUGH = "three.js, one sample a pixel"
PEERS = {PEER: "", SHADED: "shadows=1", ROUGH: "rough=1"}
SLOT = 0.6
FEWEST = 4
"""Seconds of a turn, and its frames at least."""

RENDERER = """() => {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    return names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "unknown";
}"""
# The expressions move like waves, each at another phase, and the head turns; every frame is another pose.
TURN = """async ({ face, channels, seconds, fewest }) => {
    const head = window.omoteStage ?? window.threeHead;
    const gl = document.querySelector("canvas").getContext("webgl2");
    const times = [];
    const end = performance.now() + 1000 * seconds;
    for (window.number ??= 0; times.length < fewest || performance.now() < end; window.number++) {
        const time = window.number / 30;
        const weights = channels.map((name, n) => [name, 0.06 * (1.2 + Math.sin(2.5 * time + n))]);
        const yaw = 0.3 * Math.sin(time);
        const pose = { faces: { [face]: 1 }, channels: Object.fromEntries(weights), head: [yaw, 0, 0] };
        const begun = performance.now();
        await head.hold(pose);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        times.push(performance.now() - begun);
    }
    return times;
}"""


async def renderer_of(browser: Browser) -> str:
    """What a browser draws with, as its driver calls itself."""
    page = await browser.new_page()
    name = await page.evaluate(RENDERER)
    await page.close()
    return str(name)


async def open_level(browser: Browser, url: str, level: str, size: tuple[int, int]) -> Page:
    """A stage at a fixed level that draws only what it is told to."""
    context = await browser.new_context(viewport={"width": size[0], "height": size[1]})
    page = await context.new_page()
    await page.goto(f"{url}/stage?quality={level}")
    await page.wait_for_function("() => Boolean(window.omoteStage)", polling=100)
    await page.evaluate("window.omoteStage.rest()")
    return page


async def turn(page: Page, head: Head, seconds: float = SLOT) -> float:
    """The median of the milliseconds of a page's frames."""
    asked = {"face": head.face, "channels": list(head.channels), "seconds": seconds, "fewest": FEWEST}
    return float(np.median(await page.evaluate(TURN, asked)))


async def frame_costs(
    browser: Browser, url: str, head: Head, size: tuple[int, int], rounds: int
) -> dict[str, list[float]]:
    """By level and peer: a median for each round."""
    pages = {name: await open_three(browser, head, query, size) for name, query in PEERS.items()}
    pages |= {level: await open_level(browser, url, level, size) for level in LEVELS}
    for page in pages.values():
        await turn(page, head, 0.0)  # shaders are compiled, compounds loaded
    costs: dict[str, list[float]] = {name: [] for name in pages}
    for _ in range(rounds):
        for name, page in pages.items():
            costs[name].append(await turn(page, head))
    for page in pages.values():
        await page.context.close()
    return costs
