"""What a face worth looking at costs: Chromium on llvmpipe at 640x360 (issue 4, items 1 and 2).

* Frames at the lowest level with everything on stage: sixty channels move, faces fade, lights are called (median).
* Milliseconds a frame at every level, and the ratio to the plain look of "A face performs": the pages of that commit,
  built and measured in the same run, by turns (skipped where git has no such commit).
* From the address to the first picture in full on loopback, in a browser that knows nothing; the bytes on the wire.
* The wheel.

`--runs N` for other than three rounds.
"""

from __future__ import annotations

import argparse
import asyncio
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import aiohttp
import numpy as np
from playwright.async_api import Browser, async_playwright
from rich.console import Console
from rich.table import Table

from benchmarks.pace import measure_waiting_pace
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.link import Hello
from omote.show.objects.pictures import CallLight

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.stage import (
    CHANNELS,
    CHROMIUM,
    COMMAND,
    HEIGHT,
    READY,
    WIDTH,
    Player,
    during,
    intervals,
    moving_channels,
    read_address,
)
from omote.server.headless.picture_renderer import serve_pages
from omote.server.http.cast_documents import built_in_documents
from omote.server.http.static_pages import PAGES, Page, read_pages
from tools.browser import SENTENCE, find_browser

ROOT = Path(__file__).resolve().parent.parent
PLAIN = "fbb58a1"
"""The last commit with the plain look."""
LEVELS = ("lowest", "low", "medium", "good", "high")
# Chromium rounds its time stamps to 0.1 ms: every second of a display's 60 frames a second are 29.9 by them.
ROUNDED = 0.1
LEAST_FPS = 30.0
MOST_SECONDS = 2.0
"""Where the pace is 1 (benchmarks/pace.py)."""
MOST_WIRE = 10.0
MOST_WHEEL = 25.0
SECONDS = 3.0
DRAWN = "() => Boolean(window.omoteStage?.counters().drawn)"
SETTLED = "() => Boolean(window.omoteStage?.settled())"
ARRIVED = """() => {
    const loads = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")];
    return [performance.now() / 1000, loads.reduce((sum, load) => sum + load.transferSize, 0) / 1e6];
}"""
# Two faces wear sixty moving channels; the median of the milliseconds from a pose to its picture, waited for by reading
# a pixel back, so that all of a frame's work is in it and nothing of the display's rate.
FRAME_COST = """async ({ channels, seconds }) => {
    const stage = window.omoteStage;
    const gl = document.querySelector("canvas").getContext("webgl2");
    const pose = (time) => ({
        faces: { kaori: 0.6 + 0.3 * Math.sin(time), old: 0.4 - 0.3 * Math.sin(time) },
        channels: Object.fromEntries(channels.map((name, n) => [name, 0.06 * (1.2 + Math.sin(2.5 * time + n))])),
        head: [0.4 * Math.sin(0.7 * time), 0, 0],
    });
    const times = [];
    const end = performance.now() + 1000 * seconds;
    for (let frame = -5; frame < 5 || performance.now() < end; frame++) {
        const begun = performance.now();
        await stage.hold(pose(frame / 60));
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        if (frame >= 0) times.push(performance.now() - begun);
    }
    return times.sort((a, b) => a - b)[times.length >> 1];
}"""


@dataclass(frozen=True)
class Row:
    """A figure and its bar; `least`: the bar is the least, not the most. No bar: a ratio to read."""

    name: str
    value: float
    unit: str
    bar: float | None = None
    least: bool = False

    @property
    def holds(self) -> bool:
        """Whether the bar is kept."""
        return self.bar is None or (self.value >= self.bar - ROUNDED if self.least else self.value <= self.bar)


def build_pages(commit: str, folder: Path) -> dict[str, Page] | None:
    """The pages of a commit, built in a folder; None where git has no such commit."""
    archive = subprocess.run(["git", "-C", str(ROOT), "archive", commit, "web"], capture_output=True, check=False)
    if archive.returncode:
        return None
    subprocess.run(["tar", "-x", "-C", str(folder)], input=archive.stdout, check=True)
    (folder / "web" / "node_modules").symlink_to(ROOT / "web" / "node_modules")
    build = [sys.executable, str(ROOT / "tools" / "node.py"), str(folder / "web")]
    subprocess.run([*build, "npm", "run", "--silent", "build", "--", "--logLevel", "error"], check=True)
    built = folder / "src" / "omote" / "server" / "web"
    for name in PAGES.values():
        if not (folder / "web" / name).exists():  # pages that came later: no former way has them
            (built / name).touch()
    return read_pages(built)


async def frame_cost(browser: Browser, url: str, channels: Sequence[str]) -> float:
    """Milliseconds a frame on a fresh stage (median)."""
    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.goto(url)
    await page.wait_for_function("() => Boolean(window.omoteStage)")
    cost = await page.evaluate(FRAME_COST, {"channels": list(channels), "seconds": SECONDS})
    await page.close()
    return float(cost)


async def costs(browser: Browser, plain: dict[str, Page] | None, channels: Sequence[str], runs: int) -> Iterator[Row]:
    """Every level beside the plain look, by turns; the least of the rounds."""
    found: dict[str, list[float]] = {}
    async with (
        serve_pages(built_in_documents(), read_pages()) as ours,
        serve_pages(built_in_documents(), plain or read_pages()) as theirs,
    ):
        looks = {level: f"{ours}/stage?quality={level}" for level in LEVELS}
        if plain is not None:
            looks |= {"plain, per vertex": f"{theirs}/stage?quality=low", "plain": f"{theirs}/stage?quality=high"}
        for _ in range(runs):
            for name, url in looks.items():
                found.setdefault(name, []).append(await frame_cost(browser, url, channels))
    return ratios({name: min(values) for name, values in found.items()})


def ratios(least: Mapping[str, float]) -> Iterator[Row]:
    """Milliseconds, and the ratio to the plain look that is lit in the same way."""
    for name, value in least.items():
        yield Row(f"a frame, {name}", value, "ms")
    for level in LEVELS:
        plain = "plain, per vertex" if level == "lowest" else "plain"
        if plain in least:
            yield Row(f"{level} / {plain}", least[level] / least[plain], "times")


async def crowded_fps(browser: Browser, url: str, channels: list[str]) -> Row:
    """Frames per second at the lowest level while everything moves."""
    page = await browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    await page.goto(f"{url}/stage?quality=lowest")
    while not await page.evaluate(READY):
        await asyncio.sleep(0.1)
    async with aiohttp.ClientSession() as http, http.ws_connect(url + LINK_PATH, max_msg_size=0) as socket:
        player = Player(socket, channels)
        await player.send(Hello("console", PROTOCOL_VERSION))
        async with during(player.listen()), during(call_lights(player)):
            waits = await intervals(page, player.sixty())
        await player.rest()
    await page.close()
    name = f"frames per second at the lowest level, {CHANNELS} channels, faces and lights moving (median)"
    return Row(name, 1000 / float(np.median(waits)), "fps", LEAST_FPS / measure_waiting_pace(), least=True)


async def call_lights(player: Player) -> None:
    """One light after the other, without a rest."""
    for turn in range(sys.maxsize):
        await player.send(CallLight(f"light {turn}", ("portrait", "flat", "theatre")[turn % 3], 1.0, "smooth"))
        await asyncio.sleep(1.0)


async def first_picture(browser: Browser, url: str) -> tuple[Row, Row]:
    """Seconds to the first picture in full, and megabytes, for a browser that knows nothing."""
    context = await browser.new_context(viewport={"width": WIDTH, "height": HEIGHT})
    page = await context.new_page()
    await page.goto(f"{url}/stage?quality=lowest", wait_until="commit")
    await page.wait_for_function(DRAWN)
    await page.wait_for_function(SETTLED)
    seconds, megabytes = await page.evaluate(ARRIVED)
    await context.close()
    return (
        Row(
            "from the address to the first picture in full",
            seconds,
            "s",
            MOST_SECONDS * measure_waiting_pace(),
        ),
        Row("bytes on the wire until then", megabytes, "MB", MOST_WIRE),
    )


def wheel(folder: Path) -> Row:
    """The size of the wheel, built here."""
    build = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(folder)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    return Row("the wheel", next(folder.glob("*.whl")).stat().st_size / 1e6, "MB", MOST_WHEEL)


async def measure(url: str, plain: dict[str, Page] | None, runs: int) -> list[Row]:
    """Everything a browser is needed for."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    channels = moving_channels()
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=CHROMIUM)
        pictures = [await first_picture(browser, url) for _ in range(runs)]
        crowds = [await crowded_fps(browser, url, channels) for _ in range(runs)]
        levels = list(await costs(browser, plain, channels, runs))
        await browser.close()
    best = [min((pair[part] for pair in pictures), key=lambda row: row.value) for part in (0, 1)]
    return [max(crowds, key=lambda row: row.value), *best, *levels]


def verdict(rows: Sequence[Row]) -> bool:
    """Prints the figures beside their bars; whether all hold."""
    table = Table(title=f"the look on llvmpipe, {WIDTH}x{HEIGHT}, best of the runs", title_justify="left")
    for column in ("what", "figure", "bar", "holds"):
        table.add_column(column)
    for row in rows:
        bar = "" if row.bar is None else f"{'>=' if row.least else '<='} {row.bar:g}"
        table.add_row(
            row.name, f"{row.value:.2f} {row.unit}", bar, "" if row.bar is None else "yes" if row.holds else "NO"
        )
    Console().print(table)
    return all(row.holds for row in rows)


def main() -> int:
    """Runs the show, measures, prints; exit status 1 when a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=3)
    runs = parser.parse_args().runs
    with tempfile.TemporaryDirectory() as folder:
        plain = build_pages(PLAIN, Path(folder))
        command = [*COMMAND, str(Path(folder) / "show.omote"), "--port", "0", "--no-open"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        try:
            rows = asyncio.run(measure(read_address(process), plain, runs))
        finally:
            process.terminate()
            process.wait(20.0)
        rows.append(wheel(Path(folder)))
    return 0 if verdict(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
