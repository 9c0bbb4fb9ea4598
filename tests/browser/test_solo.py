"""The page of one person in a real browser: what it says of black, sources and devices, and that nothing moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import playing
from tests.browser.test_console import driving
from tests.browser.test_pads import CUT, SOLO, at, looks, press
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]

SIZES = [(1180, 820, False), (1024, 768, True), (390, 844, True), (844, 390, True)]
PLACES = """() => {
    // upright the bar has as many lines as it needs
    const keys = innerWidth > innerHeight ? ", omote-liveliness, omote-black-key, .show" : "";
    const root = document.querySelector('omote-solo').shadowRoot;
    const played = "omote-blend-pad, omote-pad, omote-next-cue, omote-memories, .panic";
    return [...root.querySelectorAll(played + keys)].map((one) => {
        const { x, y, width, height } = one.getBoundingClientRect();
        return [x, y, width, height].map(Math.round);
    });
}"""


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show of its own: it is black, recorded and bound."""
    yield from playing(tmp_path_factory.mktemp("solo") / "solo.omote")


@pytest.fixture
def solo(open_page: OpenPage) -> Callable[..., Page]:
    """Opens the page of one person; options: as of `open_page`."""

    def open_one(**options: Any) -> Page:
        page = open_page("/solo", pictures=False, **{"width": 1180, "height": 820} | options)
        ready = f"{SOLO}.state && {SOLO}.newest('pad_list') && {SOLO}.manifest && {SOLO}.online"
        wait_until(page, f"document.querySelector('omote-solo')?.store && {ready}")
        expect(page.locator("omote-blend-pad .look").first).to_be_visible()
        return page

    return open_one


def test_black_is_said_from_the_press_on_until_the_next(solo: Callable[..., Page]) -> None:
    page = solo()
    badge = page.locator("span.air")
    expect(badge).to_contain_text("ON AIR")
    page.get_by_role("button", name="Black", exact=True).click()
    expect(badge).to_contain_text("BLACK")
    page.get_by_role("button", name="Black", exact=True).click()
    expect(badge).to_contain_text("ON AIR")


def test_what_is_chosen_to_show_covers_no_key_that_plays(solo: Callable[..., Page]) -> None:
    page = solo()
    chosen = page.get_by_role("group", name="What this page shows")

    def choose() -> None:
        page.get_by_role("button", name="Show ▾").click()
        expect(chosen).to_be_visible()

    choose()
    chosen.get_by_label("Looks").click()
    chosen.get_by_label("Looks").click()
    expect(chosen).to_be_visible()  # one may choose several
    press(page, *at(page, "mouth", 0.0, 0.0))
    page.mouse.up()
    expect(chosen).to_be_hidden()
    for key in ("f", "1", "Shift+Space"):
        choose()
        page.keyboard.press(key)
        expect(chosen).to_be_hidden()
    page.evaluate(
        "addEventListener('click', (event) => event.composedPath()[0].matches('a') && event.preventDefault())"
    )
    for entry in ("Console", "Cues"):
        choose()
        chosen.get_by_role("link", name=entry).click()
        expect(chosen).to_be_hidden()
    choose()
    page.get_by_role("button", name="Show ▾").click()
    expect(chosen).to_be_hidden()


@pytest.mark.parametrize(("width", "height", "touch"), SIZES)
def test_nothing_that_is_played_on_moves_for_words(
    solo: Callable[..., Page], width: int, height: int, touch: bool
) -> None:
    page = solo(width=width, height=height, has_touch=touch)
    before = page.evaluate(PLACES)
    page.evaluate(f"""{SOLO}.ask({{ type: 'record_clip', character: 'one', name: 'line', lane: 'a', start: null,
        parts: ['brows', 'eyes', 'rest', 'gaze'], sound: '', speed: 1 }})""")
    expect(page.locator("omote-record-light button")).to_be_visible()
    assert page.evaluate(PLACES) == before
    page.evaluate(f"{SOLO}.say('A long sentence that must be read, '.repeat(6))")
    expect(page.locator(".notice")).to_contain_text("must be read")
    assert page.evaluate(PLACES) == before
    assert page.evaluate(CUT, "omote-solo") == []
    page.evaluate(f"{SOLO}.ask({{ type: 'keep_pass', character: 'one', keep: false }})")
    expect(page.locator("omote-record-light button")).to_be_hidden()
    assert page.evaluate(PLACES) == before


def test_a_pad_says_who_covers_it(solo: Callable[..., Page], show: str) -> None:
    page = solo()
    mouth, moods = (page.locator(f"[data-pad={name}]") for name in ("mouth", "moods"))
    for pad, look in (("moods", "Laugh"), ("mouth", "Funnel")):
        press(page, *at(page, pad, *looks(page, pad, SOLO)[look]))
        page.mouse.up()
    expect(mouth.locator(".read")).to_contain_text("Funnel")
    expect(mouth.locator(".dot")).to_have_class("carrier dot air")
    with driving(show, jawOpen=0.6):
        expect(mouth.locator(".read")).to_contain_text("covered by")
        expect(mouth.locator(".dot")).to_have_class("carrier dot")
        expect(moods.locator(".read")).to_contain_text("mouth covered by")
        expect(moods.locator(".read")).to_contain_text("Laugh")
        expect(moods.locator(".dot")).to_have_class("carrier dot air")
        expect(page.locator("omote-source-line")).to_contain_text("all parts")
    expect(mouth.locator(".read")).to_contain_text("Funnel")
    expect(mouth.locator(".dot")).to_have_class("carrier dot air")
    expect(page.locator("omote-source-line")).to_be_hidden()


def test_the_key_of_a_device_that_is_panic_stands_on_it(solo: Callable[..., Page]) -> None:
    page = solo()
    page.evaluate(f"""{SOLO}.ask({{ type: 'bind', replaces: null, binding: {{ device: 'Pad', control: 'button9',
        to: '/omote/one/panic', axis: '', arguments: [], low: null, high: null, curve: 1, pick_up: true, button: '',
        relative: '', step: 0.01, bank: '', dead_zone: 0 }} }})""")
    wait_until(
        page,
        "mark && panic.left <= mark.left && mark.right <= panic.right && mark.bottom <= panic.bottom",
        given="""const root = document.querySelector('omote-solo').shadowRoot;
            const chips = root.querySelector('omote-binding-marks').shadowRoot.querySelectorAll('.chip');
            const chip = [...chips].find(({ textContent }) => textContent === 'b9');
            const [panic, mark] = [root.querySelector('.panic'), chip].map((one) => one?.getBoundingClientRect())""",
        told="[panic, mark]",
    )


def test_the_names_of_the_lowest_looks_of_a_small_pad_stay_free(solo: Callable[..., Page]) -> None:
    page = solo(width=360, height=740, has_touch=True)
    press(page, *at(page, "moods", *looks(page, "moods", SOLO)["Sad"]))
    page.mouse.up()
    pad = page.locator("[data-pad=moods]")
    expect(pad.locator(".read")).to_contain_text("Sad")
    read = pad.locator(".read").bounding_box()
    names = [name.bounding_box() for name in pad.locator(".look span").all()]
    assert read
    assert max(box["y"] + box["height"] for box in names if box) <= read["y"] + 1
