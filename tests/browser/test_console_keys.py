"""Whom a key press is for: what is open, the field that is typed in, panic, or the page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.browser.console_at_rest import DESK, wait_for
from tests.browser.test_console import bar, choose, console, fader, region, state, tile

__all__ = ["console"]

Console = Callable[..., Page]

SHORTCUTS = ["2", "w", "a", "d", "]", "x", "n", "c", "?", "/", "p", "Control+z", "ArrowUp", "Home"]
"""Keys that do something on the page."""
PANIC = "Shift+Backspace"


def still(page: Page) -> dict[str, Any]:
    """All that keys could change."""
    now = state(page)
    kept = page.evaluate(f"[{DESK}.faces.length, {DESK}.arrangement, {DESK}.notice, {DESK}.region]")
    return {name: now[name] for name in ("faces", "expressions", "channels", "head", "panics")} | {"kept": kept}


def with_joy(page: Page) -> None:
    """Joy on air, a channel on its fader, which has the focus."""
    tile(page, "joy").click()
    region(page, "jaw")
    fader(page, "jawOpen").focus()
    page.keyboard.press("PageUp")
    wait_for(page, "state.expressions.joy === 1 && state.channels.jawOpen === 0.5")


@pytest.mark.parametrize(("button", "name"), [("Keys", "Keys"), ("Set-up", "Set-up")])
def test_escape_closes_a_dialog_alone_and_no_shortcut_works_through_it(
    console: Console, button: str, name: str
) -> None:
    page = console()
    with_joy(page)
    dialog = page.get_by_role("dialog", name=name)
    page.get_by_role("button", name=button).click()
    expect(dialog).to_be_visible()
    before = still(page)
    for where in ("inside", "nowhere"):
        if where == "nowhere":
            page.evaluate("document.activeElement.blur()")
        for key in SHORTCUTS:
            page.keyboard.press(key)
    page.keyboard.press("Escape")
    expect(dialog).to_have_count(0)
    page.keyboard.press("Escape")  # nothing is open: it does nothing at all
    fader(page, "jawForward").press("ArrowUp")
    wait_for(page, "state.channels.jawForward > 0")  # a later command has arrived, the keys before would have too
    assert still(page) == before | {"channels": {"jawOpen": 0.5, "jawForward": state(page)["channels"]["jawForward"]}}


def test_the_panic_key_works_over_a_dialog_which_stays(console: Console) -> None:
    page = console()
    with_joy(page)
    page.get_by_role("button", name="Set-up").click()
    page.keyboard.press(PANIC)
    wait_for(page, "state.expressions.neutral === 1 && Object.keys(state.channels).length === 0")
    expect(page.get_by_role("dialog")).to_be_visible()
    page.locator(".panic").click()  # the button is not behind it
    wait_for(page, "state.panics >= 2")


def test_a_field_has_its_keys_and_escape_leaves_it_alone(console: Console) -> None:
    page = console()
    with_joy(page)
    before = still(page)
    entry = page.get_by_label("Other seconds (face)")
    entry.click()
    for key in ("3", "1", "w", PANIC, "Control+z", "?"):
        page.keyboard.press(key)
    page.keyboard.press("Escape")
    expect(entry).not_to_be_focused()
    expect(entry).to_have_value("")  # as it was before it was typed in
    search = page.get_by_label("Search expressions")
    page.keyboard.press("/")
    page.keyboard.type("sad2")
    page.keyboard.press("Escape")
    expect(search).not_to_be_focused()
    expect(search).to_have_value("")
    expect(tile(page, "smile")).to_be_visible()  # the filter went with the word
    fader(page, "jawForward").press("ArrowUp")
    wait_for(page, "state.channels.jawForward > 0")
    assert still(page) | {"channels": {}} == before | {"channels": {}}


# --- panic ------------------------------------------------------------------------------------------------------------


def press_panic(page: Page, way: str) -> None:
    """Presses it once."""
    if way == "key":
        page.keyboard.press(PANIC)
    else:
        page.locator(".panic").tap()


@pytest.mark.parametrize("way", ["key", "touch"])
def test_panic_holds_the_face_and_a_second_one_brings_the_home_face(console: Console, way: str) -> None:
    page = console(**({"has_touch": True} if way == "touch" else {}))
    page.evaluate(f"() => {DESK}.setHome('kaori', 0.5)")
    tile(page, "cat").click()
    wait_for(page, "state.faces.cat === 1 && state.home_face === 'kaori'")
    choose(page, "face", "hand")
    tile(page, "goblin").click()
    wait_for(page, "state.face_call?.by_hand")
    page.evaluate(f"() => {DESK}.bar('face').nudge(0.48)")
    page.evaluate(f"() => {DESK}.setTiming('expression', {{ seconds: 600 }})")
    tile(page, "laugh").click()
    page.evaluate(f"() => {{ {DESK}.channel('jawOpen').nudge(0.5); {DESK}.head('pitch').nudge(0.2); }}")
    wait_for(page, "Math.abs((state.faces.goblin ?? 0) - 0.48) < 1e-6 && state.channels.jawOpen && state.head[1] > 0")
    panics = state(page)["panics"]
    press_panic(page, way)
    wait_for(
        page,
        "state.expressions.neutral === 1 && state.expression_call === null && state.face_call === null"
        " && Object.keys(state.channels).length === 0 && [...state.head, ...state.gaze].every((angle) => angle === 0)",
    )
    held = state(page)
    assert held["panics"] == panics + 1
    assert held["faces"] == {"cat": pytest.approx(0.52), "goblin": pytest.approx(0.48)}
    assert (held["face_fader"], held["expression_fader"]) == (0, 0)
    expect(bar(page, "Face")).to_have_attribute("aria-valuenow", "0.00")
    expect(page.locator(".panic")).to_contain_text("HOME FACE")
    expect(page.locator(".panic")).to_contain_text("Kaori in .5 s")
    press_panic(page, way)
    wait_for(page, "state.faces.kaori === 1 && state.face_call === null")
    expect(page.locator(".panic")).to_contain_text("PANIC")


def test_panic_at_one_console_takes_the_hands_off_at_another(console: Console) -> None:
    first = console()
    second = console()
    region(second, "jaw")
    box = fader(second, "jawOpen").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + 0.75 * box["height"]
    second.mouse.move(x, y)
    second.mouse.down()
    second.mouse.move(x, y - 20, steps=3)
    wait_for(second, "state.channels.jawOpen > 0")
    panics = state(first)["panics"]
    first.keyboard.press(PANIC)
    wait_for(second, f"state.panics > {panics} && !('jawOpen' in state.channels)")
    second.mouse.move(x, y - 40, steps=3)
    fader(second, "jawForward").press("ArrowUp")
    wait_for(first, "state.channels.jawForward > 0")
    assert "jawOpen" not in state(first)["channels"]
    second.mouse.up()
