"""The page of clips, in a real browser: passes are recorded by keys and clicks, played, muted, shifted and replaced."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from omote.perform.clips.clip_parts import CLIP_PARTS
from tests.browser.conftest import playing
from tests.browser.cut_off import cut_off
from tests.browser.pictures import picture
from tests.browser.waiting import wait_until
from tests.inputs.sounds.test_sound_file import wav

OpenPage = Callable[..., Page]

CLIPS = "document.querySelector('omote-clips-page').clips"
DESK = "document.querySelector('omote-console').context.store"
SIZES = [(1440, 900, False), (1024, 768, True), (768, 1024, True), (390, 844, True)]
SEEN = ("omote-clips-page", "button, input, a, select, time")


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show of its own: others know no clip."""
    yield from playing(tmp_path_factory.mktemp("clips") / "clips.omote")


def clip_page(open_page: OpenPage, **options: Any) -> Page:
    """The page of clips, once it has heard the show."""
    page = open_page("/clips", pictures=False, **options)
    wait_until(page, f"document.querySelector('omote-clips-page')?.clips.show.online && {CLIPS}.show.state")
    return page


def play_channel(page: Page, name: str, value: float) -> None:
    """Sets a channel as a fader does, and waits until the pass has it for a while."""
    message = f"{{ type: 'set_channel', character: 'one', name: {name!r}, value: {value} }}"
    page.evaluate(f"{CLIPS}.show.put({name!r}, {message})")
    wait_until(page, f"({CLIPS}.show.state.characters.one.channels[{name!r}] ?? 0) === {value}")
    page.evaluate(f"window.since = {CLIPS}.show.state.time")
    wait_until(page, f"{CLIPS}.show.state.time > since + 0.6")


def begin_clip(page: Page, name: str) -> None:
    """Begins a clip by keys, without a count."""
    if page.evaluate(f"{CLIPS}.countsIn"):  # what a page before has chosen is kept
        page.keyboard.press("c")
    page.keyboard.press("n")
    page.keyboard.type(name)
    page.keyboard.press("Enter")


def moved_most(page: Page, lane: int) -> Any:
    """What the page draws first of a lane."""
    return page.evaluate(f"Object.keys({CLIPS}.lanes[{lane}].moves)[0]")


def armed(page: Page) -> list[str | None]:
    """The parts that are armed, as the page shows it."""
    pressed = page.locator("omote-clip-transport .arm[aria-pressed=true]").all()
    return [button.get_attribute("data-part") for button in pressed]


def record_two_passes(page: Page, name: str) -> None:
    """The mouth by keys, then the brows by clicks."""
    begin_clip(page, name)
    page.keyboard.press("a")
    assert len(armed(page)) == len(CLIP_PARTS)
    page.keyboard.press("3")
    assert armed(page) == ["mouth"]
    page.keyboard.press("r")
    wait_until(page, f"{CLIPS}.pass !== null")
    play_channel(page, "jawOpen", 0.75)
    play_channel(page, "jawOpen", 0.0)
    page.keyboard.press("k")
    wait_until(page, f"{CLIPS}.lanes.length === 1")
    page.locator("omote-clip-transport .arm[data-part=brows]").click()
    assert armed(page) == ["brows"]
    page.get_by_role("button", name="Record", exact=True).click()
    wait_until(page, f"{CLIPS}.pass?.parts.join() === 'brows'")
    play_channel(page, "browInnerUp", 0.75)
    play_channel(page, "browInnerUp", 0.0)
    page.get_by_role("button", name="Keep", exact=True).click()
    wait_until(page, f"{CLIPS}.lanes.length === 2")


def test_two_passes_are_recorded_played_muted_shifted_and_replaced(open_page: OpenPage) -> None:
    page = clip_page(open_page)
    record_two_passes(page, "line")
    assert [moved_most(page, lane) for lane in (0, 1)] == ["channel/jawOpen", "channel/browInnerUp"]
    expect(page.locator("omote-clip-timeline .block path")).not_to_have_count(0)
    expect(page.locator("[role=status].notice")).to_contain_text("lane brows, is a lane now")

    page.reload()
    wait_until(page, f"document.querySelector('omote-clips-page')?.clips.lanes.length === 2 && {CLIPS}.show.state")
    assert page.evaluate(f"[{CLIPS}.name, {CLIPS}.lane, {CLIPS}.countsIn]") == ["line", 1, False]
    assert armed(page) == ["brows"]

    # Both lanes play, from the start, and the line moves.
    page.keyboard.press("Home")
    page.keyboard.press("Space")
    one = f"{CLIPS}.show.state.characters.one.channels"
    wait_until(page, f"{one}.jawOpen > 0.7 && {one}.browInnerUp > 0")
    wait_until(page, f"{CLIPS}.playing === null")

    # Muted, shifted by the key and by the field, and taken back.
    page.keyboard.press("ArrowUp")
    page.keyboard.press("m")
    wait_until(page, f"{CLIPS}.lanes[0].muted")
    expect(page.get_by_role("button", name="Mute lane 1")).to_have_attribute("aria-pressed", "true")
    page.keyboard.press("Alt+Shift+ArrowRight")
    wait_until(page, f"{CLIPS}.lanes[0].shift === 0.1")
    page.get_by_role("textbox", name="Shift of lane 2, seconds").fill("0,25")
    page.get_by_role("textbox", name="Shift of lane 2, seconds").press("Enter")
    wait_until(page, f"{CLIPS}.lanes[1].shift === 0.25")
    page.keyboard.press("Escape")
    page.keyboard.press("Control+z")
    wait_until(page, f"{CLIPS}.lanes[1].shift === 0")

    # A span of the first lane shows the second, which is no lane any more until that is taken back.
    body = page.locator("omote-clip-timeline .lane .body").first
    box = body.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 30, box["y"] + 60)
    page.mouse.down()
    page.mouse.move(box["x"] + 110, box["y"] + 60, steps=4)
    page.mouse.up()
    assert page.evaluate(f"[{CLIPS}.lane, {CLIPS}.span.from > 0]") == [0, True]
    expect(page.get_by_role("button", name="Into the span")).to_have_count(0)  # the lanes have no part in common
    page.get_by_role("group", name="Parts of lane 2").get_by_role("button", name="mouth").click()
    wait_until(page, f"{CLIPS}.lanes[1].parts.includes('mouth')")
    page.keyboard.press("ArrowUp")
    page.get_by_role("button", name="Into the span").click()
    wait_until(page, f"{CLIPS}.lanes.length === 1 && {CLIPS}.lanes[0].spans.length === 1")
    page.get_by_role("button", name="Undo", exact=True).click()
    wait_until(page, f"{CLIPS}.lanes.length === 2 && {CLIPS}.lanes[0].spans.length === 0")


def test_a_span_is_recorded_again_and_every_console_has_the_light(open_page: OpenPage) -> None:
    page = clip_page(open_page)
    record_two_passes(page, "second")
    desk = open_page("/console", pictures=False, width=390, height=844)
    wait_until(desk, f"document.querySelector('omote-console')?.context.store.online && {DESK}.manifest")

    # The span alone is another, and the pass no lane of its own.
    page.keyboard.press("ArrowUp")
    page.evaluate(f"{CLIPS}.select({{ from: 0.2, to: 0.8 }})")
    page.keyboard.press("g")
    wait_until(page, f"{CLIPS}.pass === null && {CLIPS}.lanes[0].spans.length === 1", told=f"{CLIPS}.lanes")
    assert page.evaluate(f"{CLIPS}.lanes.length") == 2

    # What is recorded here is seen and kept there; a tile plays the clip, and ends it.
    page.keyboard.press("r")
    light = desk.locator("omote-record-light button")
    expect(light).to_have_attribute("aria-label", re.compile("records brows of"))
    desk.set_viewport_size({"width": 1440, "height": 900})
    words = light.locator(".words")
    expect(words).to_have_text(re.compile("^brows of .*, second · console"))
    assert words.evaluate("words => words.scrollWidth <= words.clientWidth")
    desk.keyboard.press("Shift+Backspace")
    expect(page.locator("[role=status].notice")).to_contain_text("the pass goes on")
    desk.evaluate(f"{DESK}.say('Faders and pads are cleared.', 'done', [{{ label: 'Undo', act: () => undefined }}])")
    said = desk.locator("omote-status .notice > span").first
    expect(said).to_contain_text("cleared")
    assert said.evaluate("said => said.scrollHeight <= said.clientHeight && said.clientWidth > 150")
    desk.set_viewport_size({"width": 390, "height": 844})
    red = picture(desk)
    assert np.count_nonzero((red[..., 0] > 180) & (red[..., 1] < 40)) > 1500
    light.click()
    desk.locator("omote-passes").get_by_role("button", name="Keep").click()
    wait_until(page, f"{CLIPS}.pass === null && {CLIPS}.lanes.length === 3")
    expect(light).to_have_count(0)
    desk.evaluate(f"{DESK}.arrange({{ kind: 'clips', view: 'palettes' }})")
    tile = desk.locator("omote-clip-tiles [data-name='second']")
    tile.click()
    expect(tile).to_have_attribute("aria-pressed", "true")
    tile.click()
    expect(tile).to_have_attribute("aria-pressed", "false")

    # The key of the hand that records keeps the pass from the console too.
    page.keyboard.press("r")
    expect(light).to_have_attribute("aria-label", re.compile("records brows of"))
    wait_until(page, f"{CLIPS}.position > 0.2")
    desk.keyboard.press("k")
    expect(desk.locator("omote-status")).to_contain_text("Kept in second")
    wait_until(page, f"{CLIPS}.pass === null && {CLIPS}.lanes.length === 4")


def test_a_sound_is_added_drawn_moved_and_recorded_along_with(open_page: OpenPage) -> None:
    page = clip_page(open_page)
    begin_clip(page, "Monologue")
    page.get_by_label("Add a sound").set_input_files(
        {"name": "line 1.wav", "mimeType": "audio/wav", "buffer": wav(3.0)}
    )
    wait_until(page, f"{CLIPS}.namedSound?.name === 'line 1'")
    expect(page.get_by_label("Sound of the clip")).to_have_value("line 1")
    page.keyboard.press("r")
    wait_until(page, f"{CLIPS}.show.state.characters.one.speech?.sound === {CLIPS}.namedSound.sound")
    play_channel(page, "jawOpen", 0.5)
    page.get_by_role("button", name="Keep", exact=True).click()
    wait_until(page, f"{CLIPS}.outline?.sound === 'line 1' && {CLIPS}.outline.lanes.length === 1")
    expect(page.locator("path.wave")).to_have_attribute("d", re.compile("^M0.0 "))
    began = page.evaluate(f"{CLIPS}.outline.sound_at")
    page.get_by_label("The sound begins", exact=True).press("ArrowRight")
    wait_until(page, f"Math.abs({CLIPS}.outline.sound_at - {began} - 0.1) < 0.002")
    page.get_by_label("Name of the sound").fill("Opening")
    page.get_by_label("Name of the sound").press("Enter")
    wait_until(page, f"{CLIPS}.namedSound?.name === 'Opening' && {CLIPS}.outline.sound === 'line 1'")
    page.get_by_label("Add a sound").set_input_files({"name": "a.txt", "mimeType": "text/plain", "buffer": b"no sound"})
    expect(page.locator("[role=status].notice")).to_contain_text("send one of these")


def test_nothing_is_cut_and_fingers_have_room(open_page: OpenPage) -> None:
    record_two_passes(clip_page(open_page), "third")
    for width, height, touch in SIZES:
        fingers = {"has_touch": True, "is_mobile": True} if touch else {}
        sized = clip_page(open_page, width=width, height=height, **fingers)
        wait_until(sized, f"{CLIPS}.lanes.length > 0")
        assert cut_off(sized, *SEEN) == [], (width, height)


def test_nothing_moves_on_an_upright_tablet_when_a_pass_begins(open_page: OpenPage) -> None:
    record_two_passes(clip_page(open_page), "fourth")
    page = clip_page(open_page, width=768, height=1024, has_touch=True, is_mobile=True)
    wait_until(page, f"{CLIPS}.lanes.length > 0")
    page.evaluate(f"{CLIPS}.choose('fourth')")
    wait_until(page, f"{CLIPS}.outline?.name === 'fourth'")
    tops = "['omote-clip-list', 'omote-clip-timeline'].map(name => Math.round(" + (
        "document.querySelector('omote-clips-page').shadowRoot.querySelector(name).getBoundingClientRect().top))"
    )
    page.evaluate(f"{CLIPS}.show.say(null)")
    before = page.evaluate(tops)
    page.get_by_role("button", name="Record", exact=True).click()
    row = page.locator("omote-clip-timeline .recorded")
    expect(row).to_be_in_viewport()
    page.evaluate(f"{CLIPS}.show.say('A pass is recorded, and there is much to say of it.')")
    expect(page.locator("[role=status].notice")).to_contain_text("much to say")
    assert page.evaluate(tops) == before
    page.get_by_role("button", name="Discard", exact=True).click()
    expect(row).to_have_count(0)
