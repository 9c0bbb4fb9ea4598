"""Macros and their mappings on pages: learned by touch, bent by their knots, and kept as set-ups."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
from playwright.sync_api import Page, expect

from omote.perform.mappings.mapping import MacroMapping
from tests.browser.browser_devices import TURN, connect
from tests.browser.console_at_rest import DESK, wait_for
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]

MAPPINGS = "document.querySelector('omote-console, omote-devices-page').context.mappings"
STORE = f"{MAPPINGS}.store"
CURVE = "omote-target-curve[half=above]"


def mapping(page: Page) -> MacroMapping:
    """The chosen macro as the show tells it."""
    told: Any = page.evaluate(f"{STORE}.newest('mapping_list').mappings.one.find(({{ name }}) => name === 'mouth')")
    return msgspec.convert(told, MacroMapping)


def settled(page: Page) -> None:
    """Waits until the show tells what the page shows."""
    told = f"{STORE}.newest('mapping_list')?.mappings.one"
    wait_until(page, f"JSON.stringify({told}) === JSON.stringify({MAPPINGS}.list)", told=told)


def drag_knot(page: Page, number: int, to: tuple[float, float]) -> None:
    """Drags a knot of the first target by the mouse; to: parts of the picture from its left and its bottom."""
    knot = page.locator(f"{CURVE} [data-knot='{number}']").first.bounding_box()
    plot = page.locator(f"{CURVE} .plot").first.bounding_box()
    assert knot is not None
    assert plot is not None
    page.mouse.move(knot["x"] + knot["width"] / 2, knot["y"] + knot["height"] / 2)
    page.mouse.down()
    page.mouse.move(plot["x"] + to[0] * plot["width"], plot["y"] + (1.0 - to[1]) * plot["height"], steps=8)
    page.mouse.up()


def test_a_macro_learned_by_touch_plays_by_its_dial_and_along_a_curve_that_is_bent(
    open_with_devices: Callable[..., Page],
) -> None:
    """What is on air is what the engine makes of the curve that the page shows; undo takes all of it back."""
    page = open_with_devices("/console")
    page.evaluate(f"{DESK}.arrange({{ tab: 'jaw', view: 'faders' }})")
    connect(page)
    page.get_by_role("button", name="Set-up").click()
    page.locator("[data-open=mappings]").click()
    page.get_by_label("Name of a new macro").fill("mouth")
    page.get_by_role("button", name="Learn by touch").click()
    bar = page.get_by_role("region", name="Learn a macro")
    expect(bar).to_contain_text("Move the dial")
    page.evaluate(TURN, [100, 110, 120])
    expect(bar).to_contain_text("by Dial 1/cc7")
    page.locator(".slot[data-channel=jawOpen]").press("PageUp")
    expect(bar.locator("[data-touched='channel/jawOpen']")).to_contain_text("50%")
    bar.get_by_role("button", name="Done").click()
    wait_for(page, "state.macros.mouth?.value === 1 && state.held.channels.jawOpen === undefined")
    wait_for(page, "Math.abs(state.channels.jawOpen - 0.5) < 1e-6")

    page.evaluate(TURN, [127, 64])  # across the value on air, which picks it up
    wait_for(page, "Math.abs(state.macros.mouth.value - 64 / 127) < 1e-6")
    page.locator("[data-add]").click()
    expect(page.locator(f"{CURVE} .knot")).to_have_count(3)
    drag_knot(page, 1, (0.7, 0.2))
    settled(page)
    [target] = mapping(page).targets
    assert abs(target.curve[1][0] - 0.7) < 0.02
    assert abs(target.curve[1][1] - 0.2) < 0.02
    gives = target.value_at(64 / 127)
    wait_for(page, f"Math.abs(state.channels.jawOpen - {gives}) < 1e-6")
    expect(page.locator(CURVE).first).to_have_attribute("data-gives", f"{gives:.3f}")

    for _ in range(4):  # the knot dragged, the knot added, the mapping learned, the dial bound
        page.evaluate(f"{DESK}.undo()")
    wait_for(page, "state.macros.mouth === undefined && (state.channels.jawOpen ?? 0) === 0")
    expect(page.locator("omote-mappings [data-macro]")).to_have_count(0)


def test_a_phone_bends_a_curve_by_keys_and_changes_set_ups_in_one_press(open_page: OpenPage) -> None:
    page = open_page("/devices#mappings", pictures=False, width=390, height=844)
    wait_until(page, f"{STORE}.online && {STORE}.manifest && {STORE}.state")
    page.get_by_label("Name of a new macro").fill("mouth")
    page.get_by_label("Begin with").select_option("channel/jawOpen")
    settled(page)
    page.get_by_label("Name of the set-up").fill("left-handed")
    page.locator("omote-setups").get_by_role("button", name="Keep").click()
    setup = page.locator("[data-setup='left-handed']")
    expect(setup).to_have_attribute("aria-pressed", "true")

    for _ in range(4):
        page.locator("omote-macro-fader [role=slider]").press("PageUp")
    wait_until(page, f"{STORE}.state.characters.one.macros.mouth?.value === 1")  # shown at the curve's right edge
    page.locator("[data-add]").click()
    settled(page)
    page.locator(f"{CURVE} [data-knot='1']").press("ArrowDown")
    settled(page)
    [target] = mapping(page).targets
    assert target.curve[1][1] == 0.48
    expect(setup).to_have_attribute("aria-pressed", "false")
    high = page.get_by_label("at 100")
    high.fill("500")
    high.press("Enter")
    expect(page.locator("omote-target-editor").get_by_role("alert")).to_contain_text("give -50 to 150")
    assert page.evaluate("document.documentElement.scrollWidth") <= 390

    setup.click()
    expect(setup).to_have_attribute("aria-pressed", "true")
    expect(page.locator(f"{CURVE} .knot")).to_have_count(2)
    page.keyboard.press("Control+z")
    expect(page.locator(f"{CURVE} .knot")).to_have_count(3)
    page.get_by_role("button", name="Delete the set-up left-handed").click()
    expect(setup).to_have_count(0)
    page.locator("omote-mapping-editor [data-delete]").click()
    expect(page.locator("omote-mappings [data-macro]")).to_have_count(0)
    page.keyboard.press("Control+z")
    expect(page.locator(f"{CURVE} .knot")).to_have_count(3)
    page.keyboard.press("Control+y")
    expect(page.locator("omote-mappings [data-macro]")).to_have_count(0)
