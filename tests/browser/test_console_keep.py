"""Keeping what is on air from the console: one press makes a face or an expression that plays at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page, expect

import omote
from tests.browser.console_at_rest import DESK, wait_for
from tests.browser.pictures import picture
from tests.browser.test_console import choose, console, region, state, tile
from tests.browser.waiting import draw_on_demand, floats, wait_until

__all__ = ["console"]

OpenPage = Callable[..., Page]
Console = Callable[..., Page]

SAME = 2e-5
"""Metres between a mix of two faces and the face kept of it: compounds and positions are kept as float32."""


@pytest.fixture
def stage(open_page: OpenPage) -> Page:
    """A stage at its lowest quality that draws."""
    page = open_page("/stage?quality=lowest", width=480, height=480)
    wait_until(page, "window.omoteStage?.settled() === true")
    draw_on_demand(page)
    return page


def keep(page: Page, axis: str) -> dict[str, str]:
    """Keeps what is on air by its button; the document of the new tile."""
    of = "faces" if axis == "face" else "expressions"
    before = page.evaluate(f"{DESK}.{of}.length")
    page.locator(f"[data-keep='{axis}']").click()
    expect(page.locator(".notice")).to_contain_text("Kept as On air")
    wait_for(page, f"desk.{of}.length === {before + 1}")
    label = page.locator(".notice").inner_text().split("Kept as ")[1].split(" under Own.")[0]
    found = page.evaluate(f"{DESK}.{of}.find((one) => one.label === {label!r})")
    return dict(found)


def drop_a_text(page: Page) -> None:
    """Drops a file with words on a page, which must not leave for it."""
    assert page.evaluate("""() => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File(["dear diary"], "notes.doc"));
        return !document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }""")


def held(stage: Page, **pose: Any) -> tuple[NDArray[np.float64], NDArray[np.int16]]:
    """What a stage shows of a pose: positions (rows, 3) metres, and a picture."""
    stage.evaluate(f"window.omoteStage.hold({msgspec.json.encode(pose).decode()})")
    wait_until(stage, "window.omoteStage.settled()")
    return floats(stage, "window.omoteStage.readPositions()").reshape(-1, 3), picture(stage)


def test_a_face_kept_half_way_between_two_is_their_mix_and_plays_at_once(console: Console, stage: Page) -> None:
    page = console()
    choose(page, "face", "0")
    tile(page, "cat").click()
    wait_for(page, "state.faces.cat === 1")
    choose(page, "face", "hand")
    tile(page, "dog").click()
    wait_for(page, "state.face_call?.target === 'dog'")
    page.evaluate(f"() => {{ const bar = {DESK}.bar('face'); bar.nudge(0.5); }}")
    wait_for(page, "Math.abs((state.faces.dog ?? 0) - 0.5) < 1e-6")
    mixed, before = held(stage, faces={"cat": 0.5, "dog": 0.5})
    kept = keep(page, "face")
    own = tile(page, kept["name"])
    expect(own).to_have_class("tile own")
    choose(page, "face", "0")
    own.click()
    wait_for(page, f"state.faces[{kept['name']!r}] === 1")
    alone, after = held(stage, faces={kept["name"]: 1.0})
    assert np.abs(alone - mixed).max() < SAME
    assert np.abs(after - before).mean() < 1.0
    assert np.quantile(np.abs(after - before), 0.99) <= 8


def test_an_expression_kept_from_a_mix_and_channels_is_worn_by_the_dog(console: Console, stage: Page) -> None:
    page = console()
    choose(page, "expression", "hand")
    tile(page, "smile").click()
    wait_for(page, "state.expression_call?.target === 'smile'")
    page.evaluate(f"() => {DESK}.bar('expression').nudge(0.5)")
    region(page, "brows")
    page.evaluate(f"() => {DESK}.channel('browInnerUp').nudge(0.8)")
    wait_for(page, "state.channels.browInnerUp === 0.8 && Math.abs((state.expressions.smile ?? 0) - 0.5) < 1e-6")
    mixed, _ = held(
        stage, faces={"dog": 1.0}, expressions={"smile": 0.5, "neutral": 0.5}, channels={"browInnerUp": 0.8}
    )
    rest, calm = held(stage, faces={"dog": 1.0})
    kept = keep(page, "expression")
    expect(tile(page, kept["name"])).to_be_visible()
    page.locator("[data-kind='own']").click()
    expect(tile(page, kept["name"])).to_be_visible()
    choose(page, "expression", "0")
    page.evaluate(f"() => {DESK}.clearChannels(['browInnerUp'])")
    tile(page, kept["name"]).click()
    wait_for(page, f"state.expressions[{kept['name']!r}] === 1")
    worn, shown = held(stage, faces={"dog": 1.0}, expressions={kept["name"]: 1.0})
    off = np.abs(worn - mixed).max(axis=1) / np.abs(mixed - rest).max()
    inside = omote.load_cast().space.inner.vertices  # of the mouth: kept behind the skin in each compound for itself
    assert np.delete(off, inside).max() < 0.05
    assert off.max() < 0.1
    assert np.abs(shown - calm).max() > 40


def test_keys_keep_too_and_the_notice_leads_to_the_editor(console: Console) -> None:
    page = console()
    for key, kind, of in (("n", "face", "faces"), ("m", "expression", "expressions")):
        known = page.evaluate(f"{DESK}.{of}.map(({{ name }}) => name)")
        page.locator("body").press(key)
        page.keyboard.type("qwert")  # meant for a name: plays nothing
        page.keyboard.press("Escape")
        assert (state(page)["expression_call"], state(page)["expressions"]) == (None, {"neutral": 1})
        wait_for(page, f"desk.{of}.length === {len(known) + 1}")
        (name,) = set(page.evaluate(f"{DESK}.{of}.map(({{ name }}) => name)")) - set(known)
        expect(page.locator(".notice a")).to_have_attribute("href", f"/editor?kind={kind}&name={name}")
    with page.context.expect_page() as opened:
        page.locator(".notice a").click()
    wait_until(opened.value, f"document.querySelector('omote-editor')?.context?.store.item?.name === {name!r}")
    expect(page.locator(".notice")).to_contain_text("under Own")
    drop_a_text(opened.value)
    expect(opened.value.locator("omote-notices")).to_contain_text("notes.doc was not taken in")
    page.bring_to_front()
    page.locator("body").press("Control+z")  # the last keep
    expect(page.locator(".notice")).to_contain_text("Undone: keep")
    wait_for(page, f"!desk.expressions.some((one) => one.name === {name!r})")
    page.locator("body").press("Control+y")
    wait_for(page, f"desk.expressions.some((one) => one.name === {name!r})")
    page.get_by_role("button", name="Undo", exact=True).first.click()
    page.locator("body").press("Control+z")  # the one before
    wait_for(page, "desk.history.next('undo') === null")
    drop_a_text(page)
    expect(page.locator(".notice")).to_contain_text("'notes.doc' cannot be taken in as an expression")


def test_the_field_of_a_name_waits_for_a_letter_only_from_when_the_face_is_kept(console: Console) -> None:
    page = console()
    page.evaluate("""() => {
        const { items } = document.querySelector("omote-console").context;
        const begin = window.setTimeout;
        const kept = () => items.naming?.item?.label ?? null;
        window.waits = [];
        window.setTimeout = (act, after, ...rest) =>
            after >= 5000 && items.naming !== null ? window.waits.push(kept()) : begin(act, after, ...rest);
    }""")
    page.locator("body").press("n")
    expect(page.locator(".notice")).to_contain_text("Kept as On air")
    wait_until(page, "window.waits.length > 0")
    assert all(page.evaluate("window.waits")), "the field goes away while the face is still being kept"
    page.keyboard.type("Early")
    page.keyboard.press("Enter")
    expect(page.locator(".tile.own .name", has_text="Early")).to_be_visible()


def test_the_menu_of_an_own_tile_edits_renames_and_deletes_and_calls_nothing(console: Console) -> None:
    page = console()
    known = page.evaluate(f"{DESK}.faces.map(({{ name }}) => name)")
    page.locator("[data-keep='face']").click()
    page.locator("omote-name-field input").fill("Catdog")
    page.keyboard.press("Enter")
    wait_for(page, f"desk.faces.length === {len(known) + 1} && desk.faces.some(({{ label }}) => label === 'Catdog')")
    kept = page.evaluate(f"{DESK}.faces.find(({{ label }}) => label === 'Catdog')")
    own = tile(page, kept["name"])
    expect(own.locator(".name")).to_have_text("Catdog")
    more = page.get_by_label("Menu of Catdog", exact=True)
    box = more.bounding_box()
    assert box is not None
    assert min(box["width"], box["height"]) >= 24  # WCAG 2.2, 2.5.8
    more.focus()
    more.press("Enter")
    page.keyboard.press("2")  # the menu has the keys
    with page.context.expect_page() as opened:
        page.get_by_role("menuitem", name="Edit in the editor").click()
    wait_until(opened.value, f"document.querySelector('omote-editor')?.context?.store.item?.name === {kept['name']!r}")
    opened.value.close()
    own.focus()
    own.press("F2")
    page.keyboard.type("Dogcat")
    page.keyboard.press("Enter")
    expect(own.locator(".name")).to_have_text("Dogcat")
    own.click(button="right")
    page.get_by_role("menuitem", name="Delete").click()
    expect(page.locator(".notice")).to_contain_text("Deleted Dogcat")
    expect(own).to_have_count(0)
    page.locator("body").press("Control+z")
    page.locator("body").press("Control+z")
    expect(own.locator(".name")).to_have_text("Catdog")
    assert page.evaluate(f"{DESK}.air.face_call") is None
    assert page.evaluate(f"{DESK}.air.faces") == {"generic": 1}
    page.get_by_role("button", name="Log").click()
    expect(page.locator("omote-message-log")).to_contain_text("Deleted Dogcat")
    page.locator("body").press("Control+z")  # not through a dialog
    expect(page.locator("omote-message-log").get_by_role("button", name="Undo: rename On air")).to_be_visible()
    assert page.evaluate(f"{DESK}.history.next('undo').what").startswith("rename On air")


def test_a_tap_on_an_own_tile_calls_wherever_it_falls_and_a_held_finger_opens_its_menu(
    console: Console,
) -> None:
    page = console(width=390, height=800, has_touch=True)
    kept = keep(page, "face")
    own = tile(page, kept["name"])
    own.scroll_into_view_if_needed()
    box = own.bounding_box()
    assert box is not None
    pages = len(page.context.pages)
    choose(page, "face", "hand")
    page.touchscreen.tap(box["x"] + box["width"] - 12, box["y"] + 12)  # where a mouse finds the menu
    wait_for(page, f"state.face_call?.target === {kept['name']!r}")
    tile(page, "dog").tap()
    wait_for(page, "state.face_call?.target === 'dog'")
    own.scroll_into_view_if_needed()
    box = own.bounding_box()
    assert box is not None
    session = page.context.new_cdp_session(page)
    points = [{"x": box["x"] + box["width"] / 2, "y": box["y"] + box["height"] / 2, "id": 0}]
    session.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": points})
    expect(page.locator("omote-tile-menu b")).to_have_text(kept["label"])
    session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    assert len(page.context.pages) == pages
    with page.context.expect_page() as opened:
        page.get_by_role("menuitem", name="Edit in the editor").tap()
    wait_until(opened.value, f"document.querySelector('omote-editor')?.context?.store.item?.name === {kept['name']!r}")
    assert state(page)["face_call"]["target"] == "dog"


def test_own_faces_are_at_hand_and_hot_keys_stay_where_they_are(console: Console) -> None:
    page = console()
    kept = keep(page, "face")
    page.get_by_role("button", name="Own", exact=True).click()
    expect(tile(page, kept["name"])).to_be_in_viewport()
    expect(tile(page, "dog")).to_have_count(0)
    choose(page, "face", "0")
    page.locator("body").press("2")
    wait_for(page, "state.faces.kaori === 1")
    page.get_by_role("button", name="Own", exact=True).click()
    expect(tile(page, "kaori").locator(".key")).to_have_text("2")


def test_own_things_are_found_by_word_and_named_apart(console: Console) -> None:
    page = console(pictures=True)
    kept = keep(page, "face")
    page.get_by_label("Search faces").fill("own air")
    expect(tile(page, kept["name"])).to_be_visible()
    expect(tile(page, "dog")).to_have_count(0)
    canvas = tile(page, kept["name"]).locator("canvas")
    expect(canvas).to_have_attribute("data-drawn", f"{kept['source']} neutral")
