"""Draws the pictures of the tutorials with the real pages: `python -m tools.website.screenshots`, or some by name.

A show of its own starts on a free port; Chromium opens its pages as people do. docs/pictures/tutorial-*.jpg.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from playwright.sync_api import Browser, Page, sync_playwright

from tools.browser import SENTENCE, find_browser
from tools.website.pages import ROOT

PICTURES = ROOT / "docs" / "pictures"
MOST_BYTES = 200_000
RENDERER = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--disable-gpu-watchdog"]
PATIENCE = 120_000
"""Milliseconds that a busy machine may take for one state."""
CORNER = """() => {
    const store = document.querySelector("omote-editor").context.store;
    const rows = window.omoteEditor.positions(store.work);
    const lips = [...store.library.lines.get("lips")];
    const corner = lips.reduce((best, row) => (rows[3 * row] > rows[3 * best] ? row : best));
    const place = [0, 1, 2].map((axis) => rows[3 * corner + axis]);
    const away = (one) => Math.hypot(...place.map((value, axis) => rows[3 * one.row + axis] - value));
    return window.omoteEditor.needles().sort((a, b) => away(a) - away(b))[0];
}"""
"""The needle at the left corner of the mouth."""
PORTRAYED = """(() => {
    const list = document.querySelector("omote-editor").renderRoot.querySelector("omote-item-list").renderRoot;
    const seen = [...list.querySelectorAll("canvas")].filter((one) => one.getBoundingClientRect().top < innerHeight);
    return seen.every((one) => one.dataset.drawn && !one.style.opacity);
})()"""
"""Whether every picture in sight of the editor's list has come."""


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition holds in a page, looking in every frame; its rules forbid Playwright's own wait."""
    page.set_default_timeout(PATIENCE)
    page.evaluate(f"""() => new Promise((done, fail) => {{
        const tooLate = performance.now() + {PATIENCE};
        const look = () => {{
            if ({condition}) done();
            else if (performance.now() < tooLate) requestAnimationFrame(look);
            else fail(new Error("never came: " + {condition!r}));
        }};
        look();
    }})""")


def console(browser: Browser, address: str) -> Page:
    """The console half-way from one face to another, with a smile, all portraits drawn."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(f"{address}/console")
    store = "document.querySelector('omote-console')?.context?.store"
    wait_for(page, f"{store}?.online && {store}.faces.length > 0")
    page.locator(".tile[data-name='smile']").click()
    page.locator(".tile[data-name='old']").click()
    wait_for(page, f"{store}.air.faces.old === 1 && {store}.air.expressions.smile === 1")
    page.locator(".faces omote-timing [data-seconds='4']").click()
    page.get_by_role("slider", name="face T-bar").scroll_into_view_if_needed()
    page.locator(".tile[data-name='child']").click()
    page.get_by_role("slider", name="face T-bar").focus()
    wait_for(page, f"{store}.air.faces.child > 0.2")
    return page


def editor(browser: Browser, address: str) -> Page:
    """The editor with a crooked smile dragged at one corner of the mouth, worn by all others."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(f"{address}/editor")
    store = "document.querySelector('omote-editor')?.context?.store"
    settled = f"{store}.draft !== null && window.omoteEditor.settled()"
    wait_for(page, f"{store}?.online && {store}.library !== null && window.omoteEditor !== undefined")
    page.locator("[data-new]").click()
    form = page.get_by_role("form", name="New expression")
    form.get_by_label("Name").fill("Crooked smile")
    form.get_by_role("button", name="Create").click()
    wait_for(page, f"{settled} && window.omoteEditor.needles().length > 50")
    box = page.locator("omote-editor main .work canvas").first.bounding_box()
    assert box is not None
    x, y = np.add((box["x"], box["y"]), page.evaluate(CORNER)["head"])
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 12, y - 22, steps=8)
    page.mouse.up()
    wait_for(page, f"{store}.draft.undo === 1 && {settled} && window.omoteEditor.refined()")
    wait_for(page, PORTRAYED)
    return page


def green(browser: Browser, address: str) -> Page:
    """A stage for a keyer: lit from everywhere, before a green that is the same in every pixel."""
    page = browser.new_page(viewport={"width": 960, "height": 540})
    page.goto(f"{address}/stage?light=flat&quality=medium")
    wait_for(page, "window.omoteStage?.counters().drawn > 0")
    page.evaluate("window.omoteStage.hold({faces: {child: 1}, expressions: {smile: 1}})")
    wait_for(page, "window.omoteStage.settled()")
    return page


BROWS = {
    "name": "brows",
    "targets": [
        {"to": "channel/browInnerUp", "high": 1.0, "curve": [(0, 0), (0.35, 0.12), (1, 1)], "rise": 0.1, "fall": 0.3},
        {
            "to": "head/pitch",
            "high": 0.2,
            "curve": [(0, 0), (0.6, 0.8), (1, 1)],
            "below": {"high": -0.3, "curve": [(0, 0), (1, 1)]},
        },
    ],
}
"""A macro whose brows come late, and whose head goes both ways."""


def mappings(browser: Browser, address: str) -> Page:
    """The curves of a macro, with a hand two thirds up."""
    page = browser.new_page(viewport={"width": 1100, "height": 600})
    page.goto(f"{address}/devices#mappings")
    store = "document.querySelector('omote-devices-page')?.context?.store"
    wait_for(page, f"{store}?.online && {store}.expressions.length > 0 && {store}.state")
    page.evaluate(f"(mapping) => {store}.ask({{ type: 'set_mapping', character: 'one', mapping }})", BROWS)
    wait_for(page, f"'brows' in {store}.air.macros")
    page.evaluate(f"{store}.macro('brows').nudge(0.65)")
    page.evaluate(f"{store}.ask({{ type: 'keep_setup', name: 'one pair of hands' }})")
    wait_for(page, f"{store}.air.macros.brows.value === 0.65 && {store}.newest('setup_list')?.called")
    wait_for(page, f"Math.abs({store}.air.head[1] - 0.2 * 0.84) < 0.02")
    return page


PAGES: dict[str, Callable[[Browser, str], Page]] = {
    "console": console,
    "green": green,
    "editor": editor,
    "mappings": mappings,
}


@contextmanager
def show(folder: Path) -> Iterator[str]:
    """The address of a show that ends with this block."""
    command = [str(Path(sys.executable).with_name("omote")), "show", str(folder / "tutorial.omote"), "--port", "0"]
    with subprocess.Popen([*command, "--no-open"], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield next(found[0] for line in process.stdout if (found := re.search(r"http://127\.0\.0\.1:\d+", line)))
        finally:
            process.terminate()


def keep(page: Page, name: str) -> Path:
    """The picture of a page in docs/pictures, as good as its size allows."""
    target = PICTURES / f"tutorial-{name}.jpg"
    for quality in (85, 70, 55, 40):
        page.screenshot(path=target, type="jpeg", quality=quality)
        if target.stat().st_size <= MOST_BYTES:
            break
    return target


def main(names: list[str]) -> int:
    """Draws the pictures, or those of the names given; the exit status."""
    path = find_browser()
    if path is None or not set(names) <= PAGES.keys():
        print(SENTENCE if path is None else f"expected some of {', '.join(PAGES)}")
        return 1
    with tempfile.TemporaryDirectory() as folder, show(Path(folder)) as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=RENDERER)
        for name in names or PAGES:
            page = PAGES[name](browser, address)
            target = keep(page, name)
            page.close()
            print(f"docs/pictures/{target.name}: {target.stat().st_size // 1000} kB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
