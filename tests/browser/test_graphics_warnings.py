"""A stage tells its browser's console nothing: what WebGL warns of is not drawn, and nobody on a show reads it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page

from tests.browser.waiting import wait_until
from tools.browser import find_browser

pytestmark = pytest.mark.long

# SwiftShader keeps all that a shader reads, as most drivers do; llvmpipe drops what is not used before WebGL looks.
SWIFTSHADER = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
LIGHTS = ("flat", "portrait", "theatre")


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """A page of a browser that draws with SwiftShader."""
    path = str(find_browser())
    chromium = browser.browser_type.launch(executable_path=path, chromium_sandbox=False, args=SWIFTSHADER)
    yield chromium.new_page(viewport={"width": 160, "height": 160})
    chromium.close()


@pytest.mark.parametrize("level", ["lowest", "high"])
def test_a_stage_warns_of_nothing(show: str, page: Page, level: str) -> None:
    """Levels between have the shaders of the one and the passes of the other."""
    told: list[ConsoleMessage] = []
    page.on("console", lambda one: told.append(one))
    page.goto(f"{show}/stage?quality={level}")
    wait_until(page, "window.omoteStage?.settled()")
    for side in (200, 120):
        page.set_viewport_size({"width": side, "height": side})
        wait_until(page, f"document.querySelector('canvas').width === {side}")
        for light in LIGHTS:
            page.evaluate("light => window.omoteStage.hold({ light: { [light]: 1 }, faces: { kaori: 1 } })", light)
    assert [one.text for one in told if one.type in ("warning", "error")] == []
