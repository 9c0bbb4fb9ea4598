"""What a stage's frames cost beside three.js, in the same run, at 640x360 (issues 2 and 13).

The peer is three.js with its own morph targets and MeshStandardMaterial on our own exported head, smooth edges and five
lights as on the stage, without shadows and with them. Both move the same sixty expressions of one face.

* Milliseconds of a frame at every level of quality, by turns with the peer: `lowest` at most a sixth of it, `low` a
  third, and no level more than four times the one below. With a graphics processor each level has a budget too.
* Frames of `omote show` as they are shown while a face and an expression are called twice a second (median), and while
  sixty channels move and faces fade (95th percentile): a third of the peer's, for both wait for the display.
* From a fader moved on a console to the first frame of the stage whose pixels have changed: two frames of the peer.

Figures and ratios are medians. `--rounds N`, `--runs N` of the show, `--face NAME`.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import aiohttp
import numpy as np
from playwright.async_api import Browser, Page, async_playwright

from omote.show.declaration import ClientMessage
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace, Panic
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.peers.frame_costs import PEER, frame_costs, renderer_of
from benchmarks.peers.peer_ratios import Comparison, level_comparisons, verdict
from benchmarks.peers.three_head import Head, export_head, open_three
from omote.builtin import load_cast
from omote.server.headless.picture_renderer import serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import read_pages
from omote.show.wire import encode
from tools.browser import SENTENCE, find_browser

WIDTH = 640
HEIGHT = 360
FACES = ("kaori", "old", "round", "child")
CHANNELS = 60
SHOWN_SHARE = 1 / 3
LATENCY_FRAMES = 2.0
SECONDS = 6.0
MOVES = 30
CHROMIUM = (
    "--use-gl=angle --use-angle=gl-egl --ignore-gpu-blocklist --disable-quic --no-first-run "
    "--disable-background-networking --disable-component-update --disable-sync"
).split()
COMMAND = (sys.executable, "-c", "from omote.cli import main; main()", "show")

READY = "() => Boolean(window.omoteStage?.settled() && window.omoteStage.counters().received > 60)"
INTERVALS = """seconds => new Promise((done) => {
    const times = [];
    const look = (now) => {
        times.push(now);
        if (now - times[0] < 1000 * seconds) requestAnimationFrame(look);
        else done(times.slice(1).map((time, index) => time - times[index]));
    };
    requestAnimationFrame(look);
})"""
# Resolves with the page's clock (ms) when the mouth's pixels are no longer those of now: of a frame that the stage
# draws (what it does not draw again reads as nothing) while its pose stands still. Pixels are read back only from the
# frame on in which the stage draws another pose, because reading waits for the renderer and would slow every frame.
FIRST_CHANGE = """() => {
    const gl = document.querySelector("canvas").getContext("webgl2");
    const read = () => {
        const pixels = new Uint8Array(4 * 96 * 96);
        const [left, bottom] = [gl.drawingBufferWidth / 2 - 48, gl.drawingBufferHeight / 4];
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(left, bottom, 96, 96, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return pixels;
    };
    const posed = () => JSON.stringify(window.omoteStage.pose());
    return new Promise((ready) => {
        let pose = "";
        const begin = () => {
            const [before, pixels] = [pose, read()];
            pose = posed();
            if (pose !== before || pixels[3] === 0) return requestAnimationFrame(begin);
            window.changed = new Promise((done) => {
                const look = () => {
                    if (posed() !== pose && read().some((value, at) => value !== pixels[at])) done(performance.now());
                    else requestAnimationFrame(look);
                };
                requestAnimationFrame(look);
            });
            ready();
        };
        requestAnimationFrame(begin);
    });
}"""

Play = Callable[[], Awaitable[None]]


@dataclass(frozen=True)
class Figures:
    """One run: frames as shown under calls (median) and under sixty channels (95th percentile), latency; ms."""

    called: float
    crowded: float
    latency: float


class Player:
    """A console that plays by the wire."""

    def __init__(self, socket: aiohttp.ClientWebSocketResponse, channels: list[str]) -> None:
        self.socket = socket
        self.channels = channels
        self._calls = 0

    async def send(self, message: ClientMessage) -> None:
        """Sends a message."""
        await self.socket.send_bytes(encode(message))

    async def listen(self) -> None:
        """Takes what the server says, as a console does; without it the server would cut this link."""
        async for _ in self.socket:
            pass

    async def call(self, seconds: float, expressions: tuple[str, ...] = ("smile", "angry", "surprise", "cry")) -> None:
        """Calls the next face and the next expression."""
        n = self._calls = self._calls + 1
        await self.send(CallFace("one", f"{os.getpid()} face {n}", FACES[n % len(FACES)], seconds, "smooth"))
        if expressions:
            name = expressions[n % len(expressions)]
            await self.send(CallExpression("one", f"{os.getpid()} expression {n}", name, seconds, "smooth"))

    async def calling(self) -> None:
        """A face and an expression twice a second, for ever."""
        while True:
            await self.call(0.5)
            await asyncio.sleep(0.5)

    async def sixty(self) -> None:
        """Sixty channels move, each fifteen times a second, and a face fades all the time, for ever."""
        for tick in range(sys.maxsize):
            if tick % 15 == 0:
                await self.call(2.0, ())
            levels = 0.06 * (1.2 + np.sin(tick / 2.5 + np.arange(CHANNELS)))
            for name, level in zip(self.channels, levels.tolist(), strict=True):
                await self.send(SetChannel("one", name, level))
            await asyncio.sleep(1 / 15)

    async def rest(self) -> None:
        """Everything stands still."""
        await self.send(Panic("one"))
        await asyncio.sleep(1.5)


@asynccontextmanager
async def during(play: Awaitable[None]) -> AsyncIterator[None]:
    """Plays beside what is measured."""
    task = asyncio.ensure_future(play)
    try:
        yield
    finally:
        task.cancel()
        with suppress(asyncio.CancelledError):
            await task


async def intervals(page: Page, play: Awaitable[None]) -> list[float]:
    """Milliseconds between animation frames while something plays, once its compounds have come."""
    async with during(play):
        await asyncio.sleep(2.5)
        return list(await page.evaluate(INTERVALS, SECONDS))


async def clock_ahead(page: Page) -> float:
    """Milliseconds that the page's clock is ahead of ours, by the shortest of many round trips."""
    trips = []
    for _ in range(50):
        sent = time.monotonic()
        theirs = await page.evaluate("performance.now()")
        received = time.monotonic()
        trips.append((received - sent, theirs - 500 * (sent + received)))
    return float(min(trips)[1])


async def latency(page: Page, player: Player) -> float:
    """The median of the milliseconds from a fader moved to the first changed frame."""
    rng = np.random.default_rng(7)
    waits = []
    ahead = await clock_ahead(page)
    for move in range(MOVES):
        await page.evaluate(FIRST_CHANGE)
        await asyncio.sleep(0.25 + float(rng.uniform(0, 1 / 60)))  # at any phase of the server's beat
        sent = time.monotonic()
        await player.send(SetChannel("one", "jawOpen", 0.5 if move % 2 == 0 else 0.1))
        waits.append(await page.evaluate("window.changed") - 1000 * sent - ahead)
        await asyncio.sleep(0.25)
    return float(np.median(waits))


async def play_stage(browser: Browser, url: str, player: Player) -> Figures:
    """All three figures on a fresh stage, which chooses its level itself."""
    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.goto(f"{url}/stage")
    while not await page.evaluate(READY):
        await asyncio.sleep(0.1)
    called = await intervals(page, player.calling())
    crowded = await intervals(page, player.sixty())
    await player.rest()
    waited = await latency(page, player)
    await player.rest()
    await page.close()
    return Figures(float(np.median(called)), float(np.percentile(crowded, 95)), waited)


async def play_peer(browser: Browser, head: Head) -> tuple[float, float]:
    """The peer's frames as they are shown: median and 95th percentile, ms."""
    page = await open_three(browser, head, "", (WIDTH, HEIGHT))
    await page.evaluate("channels => window.threeHead.play(channels)", list(head.channels))
    times = await page.evaluate(INTERVALS, SECONDS)
    await page.context.close()
    return float(np.median(times)), float(np.percentile(times, 95))


async def shown(browser: Browser, url: str, head: Head, runs: int, frame: float) -> list[Comparison]:
    """A show on a stage, by turns with the peer; `frame`: milliseconds of one of the peer's."""
    async with aiohttp.ClientSession() as http, http.ws_connect(url + LINK_PATH, max_msg_size=0) as socket:
        player = Player(socket, list(head.channels))
        await player.send(Hello("console", PROTOCOL_VERSION))
        async with during(player.listen()):
            both = [(await play_stage(browser, url, player), await play_peer(browser, head)) for _ in range(runs)]
    called, crowded, waits = np.array([[each.called, each.crowded, each.latency] for each, _ in both]).T
    medians, slow = np.array([each for _, each in both]).T
    return [
        Comparison("frames as shown, calls twice a second", called, PEER, medians, SHOWN_SHARE),
        Comparison(f"frames as shown, {CHANNELS} at once (95th percentile)", crowded, PEER, slow, SHOWN_SHARE),
        Comparison("fader to changed frame", waits, PEER, np.array([frame]), LATENCY_FRAMES),
    ]


def moving_channels() -> list[str]:
    """The last `CHANNELS` channels of the cast that move heads."""
    return [name for name, title in load_cast().titles.items() if title.kind not in ("neutral", "limb")][-CHANNELS:]


async def measure(url: str, face: str, rounds: int, runs: int, folder: Path) -> tuple[str, list[Comparison]]:
    """The renderer's name and all figures, in one browser."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    head = export_head(face, moving_channels(), folder)
    async with serve_pages(built_in_documents(), read_pages()) as pages, async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
        renderer = await renderer_of(browser)
        costs = await frame_costs(browser, pages, head, (WIDTH, HEIGHT), rounds)
        rows = [
            *level_comparisons(costs, renderer),
            *await shown(browser, url, head, runs, float(np.median(costs[PEER]))),
        ]
        await browser.close()
    return renderer, rows


def read_address(process: subprocess.Popen[str]) -> str:
    """The address of the show, once it says where it is."""
    assert process.stdout is not None
    for line in process.stdout:
        if found := re.search(r"(http://\S+)/stage", line):
            return found[1]
    raise RuntimeError("the show did not open")


def main() -> int:
    """Runs the show, plays it, prints; exit status 1 when a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--face", default=FACES[0])
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        command = [*COMMAND, str(Path(folder) / "show.omote"), "--port", "0", "--no-open"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        try:
            run = measure(read_address(process), given.face, given.rounds, given.runs, Path(folder))
            renderer, rows = asyncio.run(run)
        finally:
            process.terminate()
            process.wait(20.0)
    return 0 if verdict(f"a stage beside three.js, {WIDTH}x{HEIGHT}, {given.face}, drawn by {renderer}", rows) else 1


if __name__ == "__main__":
    sys.exit(main())
