"""The preview, in real browsers: a look is built up at a console, seen on no stage of the house, and taken on air."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import playing
from tests.browser.pictures import picture
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]

CONSOLE = "document.querySelector('omote-console').context.store"
CUES = "document.querySelector('omote-cues-page').cues"
SHOWN = "Object.keys(window.omoteStage.pose()?.faces ?? {}).join()"
WORDS = re.compile("^PREVIEW . not on air$")
STRIP = 30  # pixels


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show of its own: what one test builds up is no other's."""
    yield from playing(tmp_path_factory.mktemp("preview") / "preview.omote")


def call(page: Page, message: dict[str, Any], store: str = CONSOLE) -> None:
    """Asks the show for something, as this page."""
    page.evaluate(f"{store}.ask({json.dumps(message)})")


def console(open_page: OpenPage, query: str = "", **options: Any) -> Page:
    """A console that has heard the show."""
    page = open_page(f"/console{query}", pictures=False, **options)
    wait_until(page, f"document.querySelector('omote-console')?.context.store.state && {CONSOLE}.online")
    return page


def stage(open_page: OpenPage, query: str = "") -> Page:
    page = open_page(f"/stage{query}", width=320, height=240)
    wait_until(page, "window.omoteStage?.counters().drawn > 0")
    return page


def shows(page: Page, face: str) -> None:
    """Waits until a stage has drawn a face alone, and all of it."""
    wait_until(page, f"{SHOWN} === {face!r}", told=SHOWN)
    wait_until(page, "window.omoteStage.settled()")


def test_what_is_built_up_is_on_no_stage_of_the_house_until_it_is_taken(open_page: OpenPage) -> None:
    air, unseen = stage(open_page), stage(open_page, "?bus=preview")
    expect(unseen.locator("#preview")).to_have_text(WORDS)
    expect(air.locator("#preview")).to_have_count(0)
    page = console(open_page, "?bus=preview")
    bar = page.locator("omote-preview-bar")
    expect(bar.get_by_role("status")).to_have_text(WORDS)
    call(page, {"type": "set_motion", "character": "one", "liveliness": 0})
    call(page, {"type": "call_face", "character": "one", "name": "dog", "seconds": 0, "easing": "smooth"})
    shows(unseen, "dog")
    shows(air, "generic")
    house, desk = picture(air), picture(unseen)
    assert np.abs(house[:-STRIP] - desk[:-STRIP]).mean() > 5  # another face, above the strip
    assert desk[-STRIP:, :, :3].std(axis=(0, 1)).min() > 5  # the strip, beside the face and not over it

    page.keyboard.press("Shift+Enter")  # take, in the seconds beside the button
    expect(page.locator("omote-status")).to_contain_text("Taken on air in 2 s.")
    shows(air, "dog")
    page.keyboard.press("Shift+P")
    wait_until(page, f"document.querySelector('omote-console')?.context.store.bus === 'air' && {CONSOLE}.state")
    expect(bar).to_have_count(0)
    assert page.evaluate("location.search") == ""


def test_panic_of_a_console_in_preview_stops_the_air_and_is_heard(open_page: OpenPage) -> None:
    on_air, unseen = console(open_page), console(open_page, "?bus=preview")
    call(on_air, {"type": "call_face", "character": "one", "name": "dog", "seconds": 0, "easing": "smooth"})
    joy = {"type": "call_expression", "character": "one", "name": "joy", "seconds": 0, "easing": "smooth"}
    for page in (on_air, unseen):
        call(page, joy)
        wait_until(page, f"{CONSOLE}.state.characters.one.expressions.joy === 1")
    unseen.keyboard.press("Shift+Backspace")
    wait_until(on_air, f"{CONSOLE}.state.characters.one.expressions.neutral === 1")
    expect(unseen.locator("omote-status .panic").last).to_contain_text("HOME FACE")
    assert unseen.evaluate(f"{CONSOLE}.state.characters.one.expressions.joy") == 1


def test_a_cue_is_changed_in_preview_while_another_runs(open_page: OpenPage) -> None:
    cues = open_page("/cues", pictures=False)
    wait_until(cues, f"document.querySelector('omote-cues-page')?.cues.show.online && {CUES}.show.state")
    for number, face in (("1", "old"), ("2", "cat")):
        call(cues, {"type": "put_cue", "number": number}, f"{CUES}.show")
        wait_until(cues, f"{CUES}.list.at(-1)?.number === {number!r}")
        identity = cues.evaluate(f"{CUES}.list.at(-1).identity")
        move = {"type": "put_move", "cue": identity, "part": "one/face", "goal": {face: 1}, "seconds": 0}
        call(cues, move, f"{CUES}.show")
        wait_until(cues, f"{CUES}.list.at(-1)?.moves['one/face'] !== undefined")
    call(cues, {"type": "go_to_cue", "cue": "2", "cue_list": "main"}, f"{CUES}.show")
    wait_until(cues, f"{CUES}.show.state.characters.one.faces.cat === 1")
    cues.keyboard.press("e")
    cues.locator("omote-cue-list li").first.click()
    cues.locator("omote-cue-editor .tools").get_by_role("button", name="Preview").click()

    unseen = console(open_page, "?bus=preview")
    bar = unseen.locator("omote-preview-bar")
    expect(bar).to_contain_text("Cue 1")
    wait_until(unseen, f"{CONSOLE}.state.characters.one.faces.old === 1")
    call(unseen, {"type": "call_face", "character": "one", "name": "doll", "seconds": 0, "easing": "smooth"})
    wait_until(unseen, f"{CONSOLE}.state.characters.one.faces.doll === 1")
    bar.get_by_role("button", name="Update 1").click()
    wait_until(cues, f"{CUES}.list[0].moves['one/face'].goal.doll === 1")
    assert cues.evaluate(f"Object.keys({CUES}.list[0].moves).join()") == "one/face"
    assert cues.evaluate(f"{CUES}.show.state.characters.one.faces.cat") == 1


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1024, 768), (390, 844)])
def test_the_bar_covers_nothing_that_is_played_on(open_page: OpenPage, width: int, height: int) -> None:
    for path, element in (("/console", "omote-console"), ("/cues", "omote-cues-page")):
        page = open_page(f"{path}?bus=preview", pictures=False, width=width, height=height)
        wait_until(page, "document.querySelector('omote-preview-bar')?.shadowRoot.querySelector('.take')")
        below, top = page.evaluate(
            f"[document.querySelector({element!r}).getBoundingClientRect().bottom,"
            " document.querySelector('omote-preview-bar').getBoundingClientRect().top]"
        )
        assert below <= top
        cut = page.evaluate(
            "[...document.querySelector('omote-preview-bar').shadowRoot.querySelectorAll('button, input, a, strong')]"
            ".filter((one) => one.getBoundingClientRect().right > innerWidth || one.getBoundingClientRect().left < 0)"
            ".map((one) => one.className || one.localName)"
        )
        assert cut == []
