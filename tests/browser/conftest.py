"""A real show and a real browser for these tests; pages that report errors fail the test that opened them."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, CDPSession, Error, Page, expect, sync_playwright

from tests.browser.browser_devices import DEVICES, FAKE_MIDI
from tests.browser.console_at_rest import bring_to_rest
from tests.browser.waiting import PATIENCE, draw_on_demand, wait_until
from tools.browser import SENTENCE, find_browser

ROOT = Path(__file__).resolve().parent.parent.parent
# llvmpipe instead of SwiftShader, which blocks the page's main thread.
RENDERER = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
# Pages are put together by the processor: llvmpipe does the same work slower.
PAGES = ["--disable-gpu-compositing", "--disable-gpu-rasterization"]
# As stages run: a busy machine must not make Chromium kill its GPU process, nor refuse pictures after that.
KIOSK = ["--disable-gpu-watchdog", "--disable-gpu-process-crash-limit", "--disable-domain-blocking-for-3d-apis"]
QUIET = [
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]

BEATS = 30.0
"""States a second: half of what a show sends. Shows and pages share two cores with the browser that draws them."""

# The standby, but a page that a busy machine loads anew slowly keeps its seat's leases; for how long they are kept is
# asked in `tests/show/ownership`. The face holds still until a test moves it; that it does not at first is asked in
# `tests/server/persistence/test_restore.py`.
PATIENT_STANDBY = f"""
import sys
from functools import partial
import omote.server.persistence.restore as restore
import omote.server.supervision.show_process as show_process
import omote.show.ownership.ownership_table as ownership_table
from omote.server.supervision.standby import main
ownership_table.AWAY_SECONDS = {PATIENCE}
restore.FIRST_LIVELINESS = 0.0
show_process.run_ticks = partial(show_process.run_ticks, rate={BEATS})
sys.exit(main())
"""

# `omote`, but a server that a busy machine holds up is not taken for one that hangs.
PATIENT = f"""
import sys
import omote.server.supervision.supervisor as supervisor
from omote.cli import main
supervisor.HANG_SECONDS = supervisor.START_SECONDS = {PATIENCE}
supervisor.PROGRAM = (sys.executable, "-c", {PATIENT_STANDBY!r})
main()
"""

NO_PICTURES = """{
    const other = (get) => function (kind, ...as) { return kind === "webgl2" ? null : get.call(this, kind, ...as); };
    const kinds = [HTMLCanvasElement, OffscreenCanvas];
    for (const { prototype } of kinds) prototype.getContext = other(prototype.getContext);
}"""

KEEP = "for (const [key, text] of %s) localStorage.getItem(key) ?? localStorage.setItem(key, text);"

OpenPage = Callable[..., Page]

COARSE = 0.5
"""Pixels of a screen for each of a page's: an editor whose test looks at no pixel draws a quarter of them."""

expect.set_options(timeout=1000 * PATIENCE)


@pytest.fixture(scope="session")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a show with a file of its own."""
    yield from playing(tmp_path_factory.mktemp("show") / "test.omote")


def replaying(file: Path) -> Iterator[str]:
    """The address of a replay of what was recorded beside a show file, until it is closed."""
    program = "from omote.cli import main; main()"
    command = [sys.executable, "-c", program, "replay", str(file), "--no-open", "--port", "0"]
    with subprocess.Popen(command, cwd=ROOT, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        told = next(line for line in process.stderr if "http://" in line)
        yield re.findall(r"http://\S+?(?=/replay)", told)[0]
        process.terminate()


def playing(file: Path, *options: str) -> Iterator[str]:
    """The address of a show that plays from a file, until it is closed; options: more of `omote show`."""
    command = [sys.executable, "-c", PATIENT, "show", str(file), "--no-open", "--no-announce", "--port", "0", *options]
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONUNBUFFERED": "1"}
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield _address(process)
        finally:
            process.terminate()
            process.communicate(timeout=PATIENCE)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Chromium without a window."""
    path = find_browser()
    if path is None:
        pytest.fail(SENTENCE)
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(
            executable_path=str(path), chromium_sandbox=False, args=[*RENDERER, *PAGES, *KIOSK, *QUIET]
        )
        yield chromium
        chromium.close()


@dataclass
class Tab:
    """A tab in a window of its own, which tests take in turn: to open one costs more than most pages.

    Its process keeps the compiled scripts of the pages that were open in it: one that opens again costs half.
    """

    page: Page
    tools: CDPSession
    scale: float = 1.0
    scripts: list[str] = field(default_factory=list)
    """What runs before the page's own scripts, as Chromium names it."""

    def run_before(self, script: str) -> None:
        """Runs a script before those of each page that this tab opens, until it is cleared."""
        added = self.tools.send("Page.addScriptToEvaluateOnNewDocument", {"source": script})
        self.scripts.append(added["identifier"])

    def clear(self, show: str) -> None:
        """Leaves the page and empties its store; nothing of the test stays."""
        self.page.unroute_all(behavior="ignoreErrors")
        for script in self.scripts:
            self.tools.send("Page.removeScriptToEvaluateOnNewDocument", {"identifier": script})
        self.scripts.clear()
        self.page.goto(f"{show}/nothing")  # of the same server, so that the process stays
        self.page.evaluate("sessionStorage.clear()")
        self.tools.send("Storage.clearDataForOrigin", {"origin": show, "storageTypes": "local_storage"})
        for page in self.page.context.pages:
            if page is not self.page:
                page.close()


class Tabs:
    """The tabs of one browser."""

    def __init__(self, browser: Browser) -> None:
        self.browser = browser
        self.free: list[Tab] = []

    def take(self, scale: float) -> Tab:
        """A tab that nobody has, with nothing in its store. scale: pixels of its screen for each of a page's."""
        for place, tab in enumerate(self.free):
            if tab.scale == scale:
                return self.free.pop(place)
        return self.open(scale)

    def open(self, scale: float, **options: Any) -> Tab:
        """A new tab; scale: as of `take`; options: those of a context of Playwright."""
        context = self.browser.new_context(device_scale_factor=scale, **options)
        context.set_default_timeout(1000 * PATIENCE)
        page = context.new_page()
        tools = context.new_cdp_session(page)
        tools.send("Page.enable")  # scripts that run before a page's own would else not run
        return Tab(page, tools, scale)

    def give_back(self, tab: Tab, show: str) -> None:
        """Clears a tab for the next test; closes one that its test has closed, or that cannot leave its page."""
        try:
            tab.clear(show)
        except Error:
            tab.page.context.close()
        else:
            self.free.append(tab)


@pytest.fixture(scope="session")
def tabs(browser: Browser) -> Tabs:
    """The tabs that tests take in turn."""
    return Tabs(browser)


@pytest.fixture
def open_page(show: str, tabs: Tabs) -> Iterator[OpenPage]:
    """Opens a page of the show, each one somebody else's: `open_page("/console", width=1280, height=800)`.

    One that is opened without `pictures` finds no WebGL2 and draws no face, which is most of what a console costs.
    `kept` is what its browser keeps from an earlier visit, JSON by key.
    A `disposable` one is in no tab that another test takes: for a test that routes web sockets or adds scripts.
    One that is opened `over` another page of the test takes its place in its tab. An editor that is not `fine` draws
    coarsely.
    More options (`has_touch`) are those of a context of Playwright.
    """
    taken: list[Tab] = []
    made: list[Tab] = []
    errors: list[str] = []

    def open_one(
        path: str,
        *,
        width: int = 1280,
        height: int = 800,
        pictures: bool = True,
        fine: bool = False,
        kept: dict[str, Any] | None = None,
        disposable: bool = False,
        over: Page | None = None,
        **options: Any,
    ) -> Page:
        if over is not None:
            tab = next(tab for tab in (*taken, *made) if tab.page is over)
        else:
            scale = COARSE if path.startswith("/editor") and not fine else 1.0
            tab = tabs.open(scale, **options) if options or disposable else tabs.take(scale)
            (made if options or disposable else taken).append(tab)
        page = tab.page
        page.set_viewport_size({"width": width, "height": height})
        if not pictures:
            tab.run_before(NO_PICTURES)
        if kept:
            texts = [(key, json.dumps(value)) for key, value in kept.items()]
            tab.run_before(f"if (location.origin === {show!r}) {KEEP % json.dumps(texts)}")
        page.on("pageerror", lambda error: errors.append(f"{path}: {error}"))
        page.goto(show + path)
        return page

    yield open_one
    reported = list(errors)  # what a page reports because it is left is not asked
    for tab in made:
        tab.page.context.close()
    for tab in taken:
        tabs.give_back(tab, show)
    assert not reported, reported


class HeldStages:
    """The stages of a module that draw what they are told to hold: their shaders are compiled once."""

    def __init__(self, tabs: Tabs, show: str) -> None:
        self.tabs = tabs
        self.show = show
        self.opened: dict[tuple[str, int, int], Tab] = {}
        self.errors: list[str] = []

    def open(self, query: str = "", *, width: int = 320, height: int = 240) -> Page:
        """A stage with a query and a size, as the last test left it; a new one where there is none."""
        key = (query, width, height)
        if key not in self.opened:
            tab = self.opened[key] = self.tabs.take(1.0)
            tab.page.set_viewport_size({"width": width, "height": height})
            tab.page.on("pageerror", lambda error: self.errors.append(f"/stage{query}: {error}"))
            tab.page.goto(f"{self.show}/stage{query}")
            wait_until(tab.page, "window.omoteStage?.counters().drawn")
            draw_on_demand(tab.page)
        return self.opened[key].page


@pytest.fixture(scope="module")
def held_stages(tabs: Tabs, show: str) -> Iterator[HeldStages]:
    """The stages that tests of a module share."""
    stages = HeldStages(tabs, show)
    yield stages
    for tab in stages.opened.values():
        tabs.give_back(tab, show)


@pytest.fixture
def held_stage(held_stages: HeldStages) -> Iterator[OpenPage]:
    """Opens a stage that draws only what it is told to hold: `held_stage("?quality=low", width=320, height=240)`.

    Tests of a module share those of the same query and size, since a picture is of what is held alone.
    """
    yield held_stages.open
    reported = list(held_stages.errors)
    held_stages.errors.clear()
    assert not reported, reported


@pytest.fixture
def open_with_devices(open_page: OpenPage) -> Callable[..., Page]:
    """Opens a page of the show at a browser with devices, which it has been allowed to hear before; a console brings
    the show to rest."""

    def open_one(path: str, **options: Any) -> Page:
        page = open_page("/nothing", pictures=False, disposable=True, **options)
        page.add_init_script(FAKE_MIDI.read_text() + DEVICES)
        page.evaluate("localStorage.setItem('omote devices', JSON.stringify({ midi: true }))")
        blocked: list[str] = []
        page.on("console", lambda message: blocked.append(message.text) if "Security Policy" in message.text else None)
        page.goto(page.url.replace("/nothing", path))
        wait_until(page, "document.querySelector('omote-console, omote-devices-page')?.context.store.state")
        wait_until(page, "document.querySelector('omote-console, omote-devices-page').context.store.manifest")
        wait_until(page, "document.querySelector('omote-console, omote-devices-page').context.store.online")
        assert not blocked
        if path == "/console":
            bring_to_rest(page)
        return page

    return open_one


def _address(process: subprocess.Popen[str]) -> str:
    """The address that a starting show prints."""
    assert process.stdout is not None
    lines = []
    for line in process.stdout:
        lines.append(line)
        if "http://" in line:
            return line.split()[-1].removesuffix("/stage").removesuffix("/console")
    pytest.fail(f"the show ended before it opened: {''.join(lines)}")
