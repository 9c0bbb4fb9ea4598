"""A real show and a real browser for these tests; pages that report errors fail the test that opened them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect, sync_playwright

from tests.browser.waiting import PATIENCE
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

# `omote`, but a server that a busy machine holds up is not taken for one that hangs.
PATIENT = f"""
import omote.server.supervision.supervisor as supervisor
from omote.cli import main
supervisor.HANG_SECONDS = supervisor.START_SECONDS = {PATIENCE}
main()
"""

NO_PICTURES = """
const other = (get) => function (kind, ...rest) { return kind === "webgl2" ? null : get.call(this, kind, ...rest); };
for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) prototype.getContext = other(prototype.getContext);
"""

KEEP = "for (const [key, text] of %s) localStorage.getItem(key) ?? localStorage.setItem(key, text);"

OpenPage = Callable[..., Page]

expect.set_options(timeout=1000 * PATIENCE)


@pytest.fixture(scope="session")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a show with a file of its own."""
    yield from playing(tmp_path_factory.mktemp("show") / "test.omote")


def playing(file: Path) -> Iterator[str]:
    """The address of a show that plays from a file, until it is closed."""
    command = [sys.executable, "-c", PATIENT, "show", str(file), "--no-open", "--port", "0"]
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


class Windows:
    """Windows of one browser, each with a store of its own: to open one costs more than most pages."""

    def __init__(self, browser: Browser) -> None:
        self.browser = browser
        self.free: list[BrowserContext] = []

    def take(self) -> BrowserContext:
        """A window that nobody has, with nothing in its store; a blank page keeps it open."""
        if self.free:
            return self.free.pop()
        context = self.browser.new_context()
        context.new_page()
        return context

    def give_back(self, context: BrowserContext, show: str) -> None:
        """Closes what was opened and empties the store."""
        blank, *opened = context.pages
        for page in opened:
            page.close()
        tools = context.new_cdp_session(blank)
        tools.send("Storage.clearDataForOrigin", {"origin": show, "storageTypes": "local_storage"})
        tools.detach()
        self.free.append(context)


@pytest.fixture(scope="session")
def windows(browser: Browser) -> Windows:
    """The windows that tests take in turn."""
    return Windows(browser)


@pytest.fixture
def open_page(show: str, windows: Windows) -> Iterator[OpenPage]:
    """Opens a page of the show, each one somebody else's: `open_page("/console", width=1280, height=800)`.

    One that is opened without `pictures` finds no WebGL2 and draws no face, which is most of what a console costs.
    `kept` is what its browser keeps from an earlier visit, JSON by key.
    More options (`has_touch`) are those of a context of Playwright.
    """
    taken: list[BrowserContext] = []
    made: list[BrowserContext] = []
    errors: list[str] = []

    def open_one(
        path: str,
        *,
        width: int = 1280,
        height: int = 800,
        pictures: bool = True,
        kept: dict[str, Any] | None = None,
        **options: Any,
    ) -> Page:
        context = windows.browser.new_context(**options) if options else windows.take()
        (made if options else taken).append(context)
        context.set_default_timeout(1000 * PATIENCE)
        page = context.new_page()
        page.set_viewport_size({"width": width, "height": height})
        if not pictures:
            page.add_init_script(NO_PICTURES)
        if kept:
            texts = [(key, json.dumps(value)) for key, value in kept.items()]
            page.add_init_script(f"if (location.origin === {show!r}) {KEEP % json.dumps(texts)}")
        page.on("pageerror", lambda error: errors.append(f"{path}: {error}"))
        page.goto(show + path)
        return page

    yield open_one
    for context in made:
        context.close()
    for context in taken:
        windows.give_back(context, show)
    assert not errors, errors


def _address(process: subprocess.Popen[str]) -> str:
    """The address that a starting show prints."""
    assert process.stdout is not None
    lines = []
    for line in process.stdout:
        lines.append(line)
        if "http://" in line:
            return line.split()[-1].removesuffix("/stage").removesuffix("/console")
    pytest.fail(f"the show ended before it opened: {''.join(lines)}")
