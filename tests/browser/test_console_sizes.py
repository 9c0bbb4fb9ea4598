"""The console on the four sizes that it is made for, played by fingers: everything at hand, nothing cut off."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.browser.test_console import bar, console, fader, region, state, tile, wait_for

__all__ = ["console"]

Console = Callable[..., Page]

SIZES = [(1440, 900), (1024, 768), (768, 1024), (390, 844)]
FINGER = 40

CONTROLS = """() => {
    const found = [];
    const clipped = (one, box) => {
        for (let up = one; up; up = up.assignedSlot ?? up.parentElement ?? up.getRootNode().host) {
            if (up !== one && getComputedStyle(up).overflow !== "visible") {
                const edge = up.getBoundingClientRect();
                if (box.left < edge.left - 1 || box.right > edge.right + 1) return true;
                if (box.top < edge.top - 1 || box.bottom > edge.bottom + 1) return true;
            }
        }
        return false;
    };
    const walk = (root) => {
        for (const one of root.querySelectorAll("*")) {
            if (one.shadowRoot) walk(one.shadowRoot);
            const box = one.getBoundingClientRect();
            const active = one.matches("button, select, input, a[href], [role=slider]");
            if (!active || box.width === 0 || box.height === 0 || clipped(one, box)) continue;
            const text = one.matches("button") && one.scrollWidth > one.clientWidth + 1;
            found.push({
                name: one.getAttribute("aria-label") || one.textContent.trim().replace(/\\s+/g, " ") || one.className,
                left: box.left, top: box.top, right: box.right, bottom: box.bottom, cut: text,
                pencil: one.matches(".edit"),
            });
        }
    };
    walk(document.querySelector("omote-console").shadowRoot);
    return found;
}"""


def controls(page: Page) -> list[dict[str, Any]]:
    """The controls that are seen in full, with their boxes."""
    return list(page.evaluate(CONTROLS))


def overlap(one: dict[str, Any], other: dict[str, Any]) -> bool:
    """Whether two boxes share more than a border."""
    across = min(one["right"], other["right"]) - max(one["left"], other["left"])
    down = min(one["bottom"], other["bottom"]) - max(one["top"], other["top"])
    return bool(across > 1.5 and down > 1.5)


def check_surface(page: Page, width: int, height: int) -> None:
    """Checks that a finger can hit everything and that nothing is cut off, hidden or under something else."""
    assert page.evaluate("document.scrollingElement.scrollWidth") <= width
    assert page.evaluate("document.scrollingElement.scrollHeight") <= height
    expect(page.locator(".panic")).to_be_in_viewport(ratio=1)
    seen = controls(page)
    small = [
        (one["name"], one["right"] - one["left"], one["bottom"] - one["top"])
        for one in seen
        if min(one["right"] - one["left"], one["bottom"] - one["top"]) < FINGER - 0.5
    ]
    assert small == []
    assert [one["name"] for one in seen if one["cut"]] == []
    apart = [one for one in seen if not one["pencil"]]
    over = [
        (one["name"], other["name"]) for at, one in enumerate(apart) for other in apart[at + 1 :] if overlap(one, other)
    ]
    assert over == []


def slide(page: Page, control: Locator, start: float, end: float) -> None:
    """Draws a finger up a control, from one height to another in parts of its box, 0 its lower edge."""
    box = control.bounding_box()
    assert box is not None
    x, low = box["x"] + box["width"] / 2, box["y"] + box["height"]
    session = page.context.new_cdp_session(page)

    def touch(kind: str, at: float) -> None:
        points = [] if kind == "touchEnd" else [{"x": x, "y": low - at * box["height"], "id": 0}]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    touch("touchStart", start)
    for step in range(1, 6):
        touch("touchMove", start + (end - start) * step / 5)
    touch("touchEnd", end)
    session.detach()


def view(page: Page, name: str) -> None:
    """Brings something up where not everything has room."""
    button = page.locator(f".views [data-view='{name}']")
    if button.is_visible():
        button.tap()
        expect(button).to_have_attribute("aria-selected", "true")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_console_is_played_by_fingers(console: Console, width: int, height: int) -> None:
    page = console(width=width, height=height, has_touch=True)
    check_surface(page, width, height)
    for name in ("generic", "child", "neutral", "angry"):
        expect(tile(page, name)).to_be_in_viewport()
    tile(page, "kaori").tap()
    tile(page, "smile").tap()
    wait_for(page, "state.faces.kaori === 1 && state.expressions.smile === 1")
    view(page, "faders")
    region(page, "jaw")
    check_surface(page, width, height)
    slide(page, fader(page, "jawOpen"), 0.25, 0.5)
    wait_for(page, "Math.abs(state.channels.jawOpen - 0.5) < 0.1")
    view(page, "pads")
    check_surface(page, width, height)
    slide(page, page.get_by_role("slider", name="Gaze: as you see"), 0.5, 0.9)
    wait_for(page, "state.gaze[1] === 0")
    view(page, "palettes")
    page.locator(".faces .lists [data-seconds='hand']").tap()
    tile(page, "child").tap()
    wait_for(page, "state.face_call?.by_hand")
    slide(page, bar(page, "Face"), 0.0, 0.5)
    wait_for(page, "Math.abs(state.faces.child - 0.5) < 0.05")
    expect(page.locator(".facebar .percent")).to_be_in_viewport(ratio=1)
    page.locator(".panic").tap()
    wait_for(page, "state.expressions.neutral === 1 && !('jawOpen' in state.channels) && state.home_next")
    assert set(state(page)["faces"]) == {"kaori", "child"}
    check_surface(page, width, height)
    page.locator(".panic").tap()
    wait_for(page, f"state.face_call?.target === '{state(page)['home_face']}'")


STRONG = """(face) => {
    const store = document.querySelector("omote-console").context.store;
    const gains = [["brows", 1.6, null], ["mouth", 2, "angry"], ["ears", 1.5, null]].map(
        ([region, value, expression]) => ({ region, value, expression }));
    const faces = store.manifest.faces.map((one) => (one.name === face ? { ...one, gains } : one));
    store.setManifest({ ...store.manifest, faces });
}"""


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_gains_of_a_face_have_their_place_and_all_are_listed(console: Console, width: int, height: int) -> None:
    page = console(width=width, height=height, has_touch=True)
    page.evaluate(STRONG, "kaori")
    expect(page.locator("omote-answers button")).to_have_count(0)
    tile(page, "kaori").tap()
    gains = page.locator("omote-answers button")
    expect(gains).to_have_attribute("title", re.compile("^Kaori answers: brows .1.6, mouth in angry .2.0, ears .1.5$"))
    check_surface(page, width, height)
    gains.tap()
    answers = page.get_by_role("dialog", name="How Kaori answers")
    expect(answers).to_be_in_viewport(ratio=1)
    tile(page, "child").tap()
    expect(answers).to_have_count(0)
    expect(gains).to_have_count(0)


@pytest.mark.parametrize(("width", "height"), [(1024, 768), (1440, 900), (1920, 1080)])
def test_by_mouse_nothing_is_cut_off_and_nothing_scrolls(console: Console, width: int, height: int) -> None:
    page = console(width=width, height=height)
    assert page.evaluate("document.scrollingElement.scrollHeight") <= height
    assert page.evaluate("document.scrollingElement.scrollWidth") <= width
    assert [one["name"] for one in controls(page) if one["cut"]] == []
    for control in (page.locator(".panic"), bar(page, "Face"), bar(page, "Expression"), page.locator("omote-bank")):
        expect(control).to_be_in_viewport(ratio=1)
