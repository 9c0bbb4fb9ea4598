"""What a frame of a drag in the editor costs, beside the pages of a former commit in the same run (issue 10).

Builds the pages of `--before` (a commit) into a temporary folder and lets one browser show them and the present ones in
turn, on the same server, which the former ones greet in today's versions: both drag the same needles, with ten faces
beside the work, without a graphics processor. For every frame while the needle is led:

* `commands`: milliseconds in which the page gives commands to WebGL, from the first to the last of a frame;
* `frame`: until the renderer has drawn them too;
* `interval`: from one finished frame to the next, all that the page computes included;
* `processor`: milliseconds of processor time that the page and the renderer took for a frame together, whoever else
  used the machine meanwhile: CPU and draw time in one.

The bar: a frame takes at most 1.15 times the former one's processor time (median of the drags).
`--renderer swiftshader` for the other software renderer of browsers; `--runs N`, `--faces N`.
"""

from __future__ import annotations

import argparse
import asyncio
import io
import re
import subprocess
import sys
import tarfile
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from playwright.async_api import Browser, CDPSession, Page, Route, async_playwright
from rich.console import Console
from rich.table import Table

from omote.show.messages import PROTOCOL_VERSION

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks import editor
from omote.edit.protocol.messages import EDITING_VERSION
from tools import node
from tools.browser import SENTENCE, find_browser

ROOT = Path(__file__).resolve().parent.parent
FORMER = "080db77c"
"""The last commit whose editor had painters of its own."""
BAR = 1.15
RENDERERS = {
    "llvmpipe": editor.CHROMIUM,
    "swiftshader": [*editor.CHROMIUM[3:], "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
}
# A page that did not come over the network may not open a socket, for all that Chromium knows.
UNCHECKED = "--disable-features=LocalNetworkAccessChecks"
MEASURES = ("commands", "frame", "interval", "processor")
TYPES = {".html": "text/html", ".js": "text/javascript", ".css": "text/css"}
# Notes when the canvas gives its first command of a frame, the fence after its last one, and when that is reached.
WATCH_FRAMES = """() => {
    const { prototype } = WebGL2RenderingContext;
    let begun = null;
    let given = null;
    let fence = null;
    window.frameCosts = [];
    const wrap = (name, look) => {
        const call = prototype[name];
        prototype[name] = function (...given) {
            const ask = () => call.apply(this, given);
            return this.canvas.isConnected ? look(ask, given) : ask();
        };
    };
    for (const name of ["bindFramebuffer", "bindTexture", "useProgram", "viewport"])
        wrap(name, (call) => {
            if (fence === null) begun ??= performance.now();
            return call();
        });
    wrap("fenceSync", (call) => {
        fence = call();
        given = performance.now();
        return fence;
    });
    wrap("getSyncParameter", (call, [asked]) => {
        const answer = call();
        if (asked === fence && answer === WebGL2RenderingContext.SIGNALED) {
            window.frameCosts.push([given - begun, performance.now() - begun]);
            begun = fence = null;
        }
        return answer;
    });
}"""


@dataclass
class Costs:
    """Milliseconds of the frames of one run's drags; `processor`: the mean of each drag."""

    commands: list[float] = field(default_factory=list)
    processor: list[float] = field(default_factory=list)
    frame: list[float] = field(default_factory=list)
    interval: list[float] = field(default_factory=list)

    def medians(self) -> dict[str, float]:
        """The median of each."""
        return {name: float(np.median(getattr(self, name))) for name in MEASURES}


def build_pages(commit: str, folder: Path) -> Path:
    """The pages of a commit, built with the packages that are here; RuntimeError where they cannot be."""
    packed = subprocess.run(["git", "archive", commit, "web"], cwd=ROOT, capture_output=True, check=True).stdout
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        archive.extractall(folder, filter="data")
    speak_today(folder / "web" / "src" / "link")
    (folder / "web" / "node_modules").symlink_to(ROOT / "web" / "node_modules")
    pages = folder / "pages"
    if node.main(str(folder / "web"), "npx", "vite", "build", "--logLevel", "error", "--outDir", str(pages)):
        raise RuntimeError(f"the pages of {commit} cannot be built")
    return pages


def speak_today(link: Path) -> None:
    """Gives former pages today's versions of the protocols, which have only been added to since; else the server asks
    them to be reloaded. RuntimeError where a version is not said where it was."""
    for name, constant, version in (
        ("messages.ts", "PROTOCOL_VERSION", PROTOCOL_VERSION),
        ("editing_messages.ts", "EDITING_VERSION", EDITING_VERSION),
    ):
        text, found = re.subn(rf"(?<=export const {constant} = )\d+", str(version), (link / name).read_text())
        if found != 1:
            raise RuntimeError(f"the former pages' {name} does not say {constant} once")
        (link / name).write_text(text)


async def show_pages(page: Page, pages: Path) -> None:
    """Lets a page of the editor come from a folder instead of the server."""

    async def answer(route: Route) -> None:
        asked = route.request.url.split("?")[0].split("/", 3)[3]
        file = pages / ("editor.html" if asked == "editor" else asked)
        await route.fulfill(body=file.read_bytes(), content_type=TYPES.get(file.suffix, "application/octet-stream"))

    await page.route("**/editor", answer)
    await page.route("**/static/**", answer)


async def processor_time(session: CDPSession) -> float:
    """Milliseconds of processor time that pages and renderer have taken since the browser began."""
    found = await session.send("SystemInfo.getProcessInfo")
    taken = [float(each["cpuTime"]) for each in found["processInfo"] if each["type"] in ("GPU", "renderer")]
    return 1000.0 * sum(taken)


async def drag(page: Page, session: CDPSession, goal: tuple[float, float, float], costs: Costs) -> None:
    """One drag, with what its frames cost added."""
    start = await editor.needle_at(page, goal)
    await page.mouse.move(*start)
    await asyncio.sleep(1.5)  # until nothing is drawn better any more
    before = await editor.counters(page)
    await page.mouse.down()
    await page.evaluate("window.frameCosts.length = 0")
    taken = await processor_time(session)
    await editor.lead(page, start)
    frames = await page.evaluate("window.frameCosts")
    costs.processor.append((await processor_time(session) - taken) / len(frames))
    during = await editor.counters(page)
    costs.interval.extend(during["intervals"][len(before["intervals"]) :])
    costs.commands.extend(each[0] for each in frames)
    costs.frame.extend(each[1] for each in frames)
    await page.mouse.up()
    await editor.until(page, editor.WORN)


async def run_once(browser: Browser, url: str, pages: Path | None, faces: tuple[str, ...]) -> Costs:
    """The drags of one fresh editor: the pages of a folder, or the server's own."""
    costs = Costs()
    context = await browser.new_context(viewport={"width": editor.WIDTH, "height": editor.HEIGHT})
    page = await context.new_page()
    await page.add_init_script(f"({WATCH_FRAMES})()")
    if pages is not None:
        await show_pages(page, pages)
    await page.goto(f"{url}/editor")
    await editor.until(page, editor.READY)
    await page.evaluate(editor.BEGIN, list(faces))
    await editor.until(page, editor.WORN)
    await asyncio.sleep(3.0)  # thumbnails
    session = await browser.new_browser_cdp_session()
    for goal in editor.GRABBED:
        await drag(page, session, goal, costs)
    await context.close()
    return costs


async def measure(
    url: str, pages: Path, arguments: argparse.Namespace
) -> tuple[list[Costs], list[Costs]]:  # fmt: skip
    """Former and present runs, in turn."""
    path = find_browser()
    if path is None:
        raise SystemExit(SENTENCE)
    former = []
    present = []
    faces = editor.FACES[: arguments.faces]
    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(
            executable_path=str(path), chromium_sandbox=False, args=[*RENDERERS[arguments.renderer], UNCHECKED]
        )
        for _ in range(arguments.runs):
            former.append(await run_once(browser, url, pages, faces))
            present.append(await run_once(browser, url, None, faces))
        await browser.close()
    return former, present


def verdict(former: list[Costs], present: list[Costs], title: str) -> bool:
    """Prints medians (of each run's median) and 95th percentiles; whether the median frame holds the bar."""
    table = Table(title=title, title_justify="left")
    for column in ("milliseconds", "former", "present", "ratio", "former, 95 %", "present, 95 %"):
        table.add_column(column)
    ratios = {}
    for name in MEASURES:
        before, after = (float(np.median([each.medians()[name] for each in runs])) for runs in (former, present))
        slow = [np.percentile([ms for each in runs for ms in getattr(each, name)], 95) for runs in (former, present)]
        ratios[name] = after / before
        table.add_row(name, f"{before:.1f}", f"{after:.1f}", f"{ratios[name]:.2f}", *(f"{each:.1f}" for each in slow))
    Console().print(table)
    holds = ratios["processor"] <= BAR
    print(f"a frame costs {ratios['processor']:.2f} times the former one's (bar: {BAR:g}): {'yes' if holds else 'NO'}")
    return holds


def main() -> int:
    """Builds the former pages, drags in both, prints; exit status 1 when the bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--before", default=FORMER)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--faces", type=int, default=len(editor.FACES))
    parser.add_argument("--renderer", choices=list(RENDERERS), default="llvmpipe")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        pages = build_pages(arguments.before, Path(folder))
        command = [*editor.COMMAND, str(Path(folder) / "show.omote"), "--port", "0", "--no-open"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        try:
            former, present = asyncio.run(measure(editor.read_address(process), pages, arguments))
        finally:
            process.terminate()
            process.wait(20.0)
    title = f"a frame of a drag on {arguments.renderer}, {arguments.faces} faces beside the work, {arguments.runs} runs"
    return 0 if verdict(former, present, title) else 1


if __name__ == "__main__":
    sys.exit(main())
