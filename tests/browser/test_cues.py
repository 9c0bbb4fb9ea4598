"""The cue page, in real browsers: a list is recorded, played by two people, taken back and changed; nothing is cut."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import playing
from tests.browser.cut_off import cut_off
from tests.browser.pictures import picture
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]

CUES = "document.querySelector('omote-cues-page').cues"
ONE = f"{CUES}.show.state.characters.one"
NUMBERS = f"{CUES}.list.map(({{ number }}) => number).join()"
STANDBY = f"{CUES}.way.standby?.number"
SIZES = [("near", 1440, 900, ""), ("tablet", 1024, 768, ""), ("phone", 390, 844, ""), ("far", 1280, 800, "?far")]
SEEN = ("omote-cues-page", "button, input, a, .number, .clock, .next .label")


@pytest.fixture(scope="module")
def show(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A show of its own: others know no cue."""
    yield from playing(tmp_path_factory.mktemp("cues") / "cues.omote")


def cue_page(open_page: OpenPage, query: str = "", **options: Any) -> Page:
    """The cue page, once it has heard the show and read the list."""
    page = open_page(f"/cues{query}", pictures=False, **options)
    wait_until(page, f"document.querySelector('omote-cues-page')?.cues.show.online && {CUES}.show.state")
    wait_until(page, f"({CUES}.show.state.cues?.edits ?? 0) === 0 || {CUES}.list.length > 0")
    return page


def call(page: Page, message: dict[str, Any]) -> None:
    """Asks the show for something, as the console of this page."""
    page.evaluate(f"{CUES}.show.ask({json.dumps(message)})")


def linear_light(page: Page) -> float:
    """The mean light of a page, of that of a white one."""
    colours = picture(page)[..., :3] / 255
    linear = np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    return float((linear @ [0.2126, 0.7152, 0.0722]).mean())


def stands_by(page: Page, number: str) -> None:
    """Waits until the cue of a number stands by, and longer than a second GO in a row is ignored for."""
    wait_until(page, f"{STANDBY} === {number!r}", told=STANDBY)
    page.evaluate("new Promise((done) => setTimeout(done, 300))")


def test_two_people_record_play_and_change_a_list(open_page: OpenPage) -> None:
    page = cue_page(open_page)
    expect(page.locator("omote-cue-list")).to_contain_text("No cue yet")

    # Two cues are recorded from what shows.
    page.keyboard.press("e")
    form = page.locator("omote-cue-form")
    page.get_by_role("button", name="Record").click()
    for number, face, label in (("1", "dog", "The dog"), ("2", "cat", "The cat")):
        call(page, {"type": "call_face", "character": "one", "name": face, "seconds": 0, "easing": "smooth"})
        wait_until(page, f"{ONE}.faces.{face} === 1")
        form.get_by_label("Label").fill(label)
        form.get_by_label("Seconds").fill("0.2")
        form.get_by_role("button", name="Record").click()
        wait_until(page, f"{NUMBERS}.split(',').includes({number!r})", told=NUMBERS)
    editor = page.locator("omote-cue-editor")
    expect(editor).to_contain_text("Cue 2")
    page.keyboard.press("Escape")
    expect(form).to_have_count(0)

    # A field keeps what is wrong, with the reason; what is right is everybody's.
    numbered = editor.get_by_label("Number")
    numbered.fill("two")
    numbered.press("Enter")
    expect(editor.get_by_role("alert")).to_contain_text("cannot be numbered 'two'")
    expect(numbered).to_have_value("two")
    numbered.fill("2.5")
    numbered.press("Enter")
    expect(editor.get_by_role("alert")).to_have_count(0)
    goal = editor.locator("[data-part='one/face']").get_by_label("Goes to")
    expect(goal).to_have_value("cat")
    goal.fill("cat = 0.5")
    goal.press("Enter")
    expect(editor.get_by_role("alert")).to_contain_text("must sum to 1")
    goal.fill("dgo")  # may come with another show file: it is marked, in the list too
    goal.press("Enter")
    expect(editor.locator("[data-part='one/face']")).to_contain_text("no face dgo")
    expect(page.locator("omote-cue-list .missing")).to_have_text("⚠ no face dgo")
    goal.fill("doll")
    goal.press("Enter")
    expect(page.locator("omote-cue-list .missing")).to_have_count(0)
    wait_until(page, f"{CUES}.list[1].moves['one/face'].goal.doll === 1")

    # What it sends is checked where it is typed, and stands in the list.
    adder = editor.locator("omote-cue-actions .add")
    adder.get_by_label("Host:port").fill("10.0.0.2")
    adder.get_by_label("Address and arguments").fill("/cue/12/start 1")
    adder.get_by_label("Address and arguments").press("Enter")
    expect(adder.get_by_role("alert")).to_contain_text("give a host and a port")
    adder.get_by_label("Host:port").fill("127.0.0.1:9")
    adder.get_by_label("Host:port").press("Enter")
    wait_until(page, f"{CUES}.list[1].actions[0]?.what === '/cue/12/start 1'")
    expect(adder.get_by_label("Address and arguments")).to_have_value("")
    expect(page.locator("omote-cue-list")).to_contain_text("osc 127.0.0.1:9 /cue/12/start 1")
    expect(page.locator("omote-cue-list .does")).to_have_text("⇢ osc")
    editor.get_by_label("Delete action 1").click()
    wait_until(page, f"{CUES}.list[1].actions.length === 0")
    goal.press("Space")  # in a field it is a letter
    expect(page.locator("omote-cue-go .go")).to_contain_text("Space types in a field: Esc")
    goal.press("Escape")
    expect(page.locator("omote-cue-go .go")).not_to_contain_text("Space types")
    page.keyboard.press("Escape")
    expect(editor).to_have_count(0)

    # GO by the space bar calls what stands by; the other page sees it, and the picture is that.
    other = cue_page(open_page)
    call(page, {"type": "set_standby", "cue": "1"})
    stands_by(page, "1")
    assert page.evaluate(f"{CUES}.way.current") is None, "Space in a field was no GO"
    page.keyboard.press("Space")
    wait_until(page, f"{ONE}.faces.dog === 1 && {STANDBY} === '2.5'", told=f"{ONE}.faces")
    stands_by(other, "2.5")
    expect(other.locator("omote-cue-go .go")).to_contain_text("2.5")
    expect(other.locator("omote-cue-air")).to_contain_text("The dog")

    # Two press at once: one call, and both read why the other was none.
    identity = page.evaluate(f"{CUES}.way.standby.identity")
    page.keyboard.press("Space")
    call(other, {"type": "go", "seen": identity})
    for each in (page, other):
        expect(each.locator("omote-cue-go .ignored")).to_contain_text("GO for 2.5 of")
        expect(each.locator("omote-cue-go .ignored")).to_contain_text("no cue stands by")
        wait_until(each, f"{CUES}.way.current.number === '2.5' && {ONE}.faces.doll === 1")
    expect(page.locator("omote-cue-go .go")).to_contain_text("END")

    # Back, arrows, and an edit that is taken back by the other.
    page.evaluate("new Promise((done) => setTimeout(done, 300))")
    page.keyboard.press("Shift+Space")
    wait_until(page, f"{ONE}.faces.dog === 1 && {STANDBY} === '2.5'", told=f"{ONE}.faces")
    page.keyboard.press("ArrowUp")
    stands_by(other, "1")
    assert page.evaluate(f"{ONE}.faces.dog") == 1
    page.keyboard.press("e")
    page.locator("omote-cue-list li", has_text="The cat").click()
    page.keyboard.press("Alt+ArrowUp")
    wait_until(other, f"{NUMBERS} === '2.5,1'", told=NUMBERS)
    other.keyboard.press("e")
    other.get_by_role("button", name="Undo: move cue 2.5").click()
    wait_until(page, f"{NUMBERS} === '1,2.5'", told=NUMBERS)

    # A cue is dragged by its handle; Update and Assert have keys.
    page.locator("omote-cue-list li", has_text="The dog").get_by_label("Drag cue 1").hover()
    page.mouse.down()
    below = page.locator("omote-cue-list li", has_text="The cat").bounding_box()
    assert below is not None
    page.mouse.move(below["x"] + 20, below["y"] + below["height"] - 2, steps=4)
    page.mouse.up()
    wait_until(other, f"{NUMBERS} === '2.5,1'", told=NUMBERS)
    other.get_by_role("button", name="Undo: move cue 1").click()
    wait_until(page, f"{NUMBERS} === '1,2.5'", told=NUMBERS)
    page.locator("omote-cue-list li", has_text="The dog").click()
    call(page, {"type": "call_face", "character": "one", "name": "old", "seconds": 0, "easing": "smooth"})
    wait_until(page, f"{ONE}.faces.old === 1")
    page.keyboard.press("Alt+u")
    wait_until(page, f"{CUES}.list[0].moves['one/face'].goal.old === 1")
    other.get_by_role("button", name="Undo: update cue 1").click()
    wait_until(page, f"{CUES}.list[0].moves['one/face'].goal.dog === 1")
    page.keyboard.press("Escape")
    page.keyboard.press("a")
    wait_until(page, f"{ONE}.faces.dog === 1", told=f"{ONE}.faces")

    # A list is renamed, and goes on as it was.
    page.keyboard.press("e")
    page.get_by_role("button", name="Rename").click()
    form.get_by_role("textbox", name="Name").fill("evening")
    form.get_by_role("button", name="Rename").click()
    wait_until(other, f"{CUES}.name === 'evening' && {STANDBY} === '1'", told=f"{CUES}.name")
    page.keyboard.press("Escape")

    # Also the last cue that is deleted comes back.
    for each in page.evaluate(f"{CUES}.list.map((cue) => cue.identity)"):
        call(page, {"type": "drop_cue", "cue": each})
    wait_until(other, f"{CUES}.list.length === 0")
    for taken_back in ("2.5", "1"):
        other.get_by_role("button", name=f"Undo: delete cue {taken_back}").click()
    wait_until(page, f"{NUMBERS} === '1,2.5'", told=NUMBERS)

    # In show mode nobody edits, and everybody reads so.
    other.get_by_role("button", name="Show mode").click()
    expect(page.locator("omote-cue-editor")).to_have_count(0)
    expect(page.get_by_role("button", name="Locked")).to_be_disabled()
    other.get_by_role("button", name="Show mode").click()
    expect(page.get_by_role("button", name="Edit")).to_be_enabled()

    # A page that is not heard says so before anybody presses.
    page.evaluate(f"{CUES}.show.setOnline(false)")
    expect(page.locator("omote-cue-go .deaf").first).to_contain_text("Link lost")


def test_what_is_typed_while_editing_plays_nothing(open_page: OpenPage) -> None:
    """New puts the cursor into the label; letters that miss a field play nothing until keys are let play."""
    page = cue_page(open_page)
    call(page, {"type": "add_cue_list", "cue_list": "typed"})
    wait_until(page, f"{CUES}.names.includes('typed')")
    page.evaluate(f"{CUES}.choose('typed')")
    call(page, {"type": "put_cue", "number": "1", "label": "One", "cue_list": "typed"})
    wait_until(page, f"{STANDBY} === '1'", told=STANDBY)
    page.keyboard.press("e")
    page.get_by_role("button", name="New", exact=True).click()
    editor = page.locator("omote-cue-editor")
    label = editor.get_by_label("Label")
    expect(label).to_be_focused()
    page.keyboard.type("Rex looks up (new)")
    page.keyboard.press("Enter")
    wait_until(page, f"{CUES}.list[1]?.label === 'Rex looks up (new)'")
    expect(label).to_be_focused()
    call(page, {"type": "put_cue", "cue": "", "number": "9", "label": "Another's", "cue_list": "typed"})
    wait_until(page, f"{NUMBERS} === '1,2,9'", told=NUMBERS)
    expect(label).to_be_focused()
    page.keyboard.press("Escape")
    go = page.locator("omote-cue-go .go")
    expect(go).not_to_contain_text("Space types")
    page.keyboard.type("Rex up a pea")
    expect(editor).to_contain_text("Cue 2")
    assert page.evaluate(f"[{CUES}.way.current, {CUES}.paused, {CUES}.list[1].moves]") == [None, False, {}]
    armed = page.locator("omote-cue-go .arm")
    armed.click()
    expect(armed).to_contain_text("ON")
    page.keyboard.press("Space")
    wait_until(page, f"{CUES}.way.current?.number === '1'")
    label.click()
    expect(armed).to_contain_text("off")


def test_a_page_that_opens_late_shows_the_cue_that_stands_by(open_page: OpenPage) -> None:
    """The row is in sight, *Go to* has its number, and a recorded cue leaves an empty form."""
    page = cue_page(open_page)
    call(page, {"type": "add_cue_list", "cue_list": "long"})
    wait_until(page, f"{CUES}.names.includes('long')")
    for number in range(1, 41):
        call(page, {"type": "put_cue", "number": str(number), "cue_list": "long"})
    call(page, {"type": "set_standby", "cue": "36", "cue_list": "long"})
    late = cue_page(open_page, "?list=long")
    wait_until(late, f"{CUES}.list.length === 40 && {STANDBY} === '36'", told=STANDBY)
    expect(late.locator("omote-cue-list li.standby")).to_be_in_viewport()
    late.get_by_role("button", name="Go to…").click()
    form = late.locator("omote-cue-form")
    expect(form.get_by_label("Number")).to_have_value("36")
    expect(form.get_by_role("checkbox")).to_be_checked()
    form.get_by_role("button", name="Go to").click()
    wait_until(late, f"{CUES}.way.current?.number === '36'")
    late.keyboard.press("Escape")
    late.keyboard.press("e")
    late.get_by_role("button", name="Record").click()
    form.get_by_label("Label").fill("Later")
    form.get_by_role("checkbox", name="One").check()
    form.get_by_role("button", name="Record").click()
    wait_until(late, f"{CUES}.list.some(({{ label }}) => label === 'Later')")
    expect(form.get_by_label("Label")).to_have_value("")
    expect(form.get_by_role("checkbox", name="One")).not_to_be_checked()


@pytest.mark.parametrize(("view", "width", "height", "query"), SIZES, ids=[view for view, *_ in SIZES])
def test_nothing_is_cut_on_any_screen(open_page: OpenPage, view: str, width: int, height: int, query: str) -> None:
    touch = {"has_touch": True} if view in ("tablet", "phone") else {}
    page = cue_page(open_page, query, width=width, height=height, **touch)
    if not page.evaluate(f"{CUES}.list.length"):
        call(page, {"type": "put_cue", "number": "12.5", "label": "Everybody leaves but the dog", "note": "Slowly"})
    wait_until(page, f"{STANDBY} !== undefined && {CUES}.list.length > 0")
    assert cut_off(page, *SEEN) == []
    if view == "far":
        sizes = [("number", 210), ("label", 80)]
        for name, size in sizes:
            shown = page.locator(f"omote-cues-far .next .{name}").evaluate("(each) => getComputedStyle(each).fontSize")
            assert shown == f"{size}px"
        assert linear_light(page) < 0.1
    else:
        go = page.locator("omote-cue-go .go").bounding_box()
        assert go is not None
        assert min(go["width"], go["height"]) >= 110
        page.keyboard.press("e")
        expect(page.locator("omote-cue-editor .closer")).to_be_visible()
        assert cut_off(page, *SEEN) == []


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1024, 768)])
def test_the_console_shows_the_cues_and_presses_go(open_page: OpenPage, width: int, height: int) -> None:
    """GO of the console's bar bears the number that it plays; its key is beside the digits; PANIC keeps its place."""
    cues = cue_page(open_page)
    for number, label in (("801", "Everybody leaves but the dog"), ("802", "Night")):
        if number not in cues.evaluate(NUMBERS).split(","):
            call(cues, {"type": "put_cue", "number": number, "label": label})
            wait_until(cues, f"{NUMBERS}.split(',').includes({number!r})")
    call(cues, {"type": "set_standby", "cue": "801"})
    stands_by(cues, "801")
    touch = {"has_touch": True} if width < 1100 else {}
    page = open_page("/console", pictures=False, width=width, height=height, **touch)
    bar = page.locator("omote-status")
    go = bar.locator("omote-cue-line button")
    expect(go).to_have_text("GO 801")
    panic = bar.locator(".panic").last.bounding_box()
    box = go.bounding_box()
    assert panic is not None
    assert box is not None
    assert panic["x"] + panic["width"] <= width
    assert box["x"] + box["width"] <= panic["x"]
    assert bar.evaluate("(each) => each.scrollWidth <= each.clientWidth")
    page.keyboard.press("Backquote")
    wait_until(cues, f"{CUES}.way.current?.number === '801'")
    expect(go).to_have_text("GO 802")
    stands_by(cues, "802")
    go.click()
    wait_until(cues, f"{CUES}.way.current?.number === '802'")
    expect(go).to_have_text("GO ")


def test_a_cue_says_how_it_plays_a_clip(open_page: OpenPage) -> None:
    page = cue_page(open_page)
    call(page, {"type": "record_clip", "character": "one", "name": "line1"})
    call(page, {"type": "add_cue_list", "cue_list": "with clips"})
    wait_until(page, f"{CUES}.names.includes('with clips')")
    page.evaluate(f"{CUES}.choose('with clips')")
    call(page, {"type": "keep_pass", "character": "one"})
    wait_until(page, f"{CUES}.clips.includes('line1')")
    call(page, {"type": "put_cue", "number": "1", "cue_list": "with clips"})
    wait_until(page, f"{NUMBERS} === '1'", told=NUMBERS)
    page.keyboard.press("e")
    page.locator("omote-cue-list li").first.click()
    editor = page.locator("omote-cue-editor")
    editor.get_by_label("Another part").select_option("one/clip")
    adder = editor.get_by_label("goes to (Enter adds it)")
    adder.fill("line1")
    adder.press("Enter")
    goal = f"JSON.stringify({CUES}.list[0].moves['one/clip']?.goal)"

    def goes_to(**settings: float) -> None:
        wanted = {"line1": 1, **{f":{name}": value for name, value in settings.items()}}
        wait_until(page, f"{goal} === '{json.dumps(wanted, separators=(',', ':'))}'", told=goal)

    goes_to()
    move = editor.locator("[data-part='one/clip']")
    move.get_by_label("From, s").fill("0,5")
    move.get_by_label("Speed").fill("fast")
    move.get_by_label("Speed").press("Enter")
    goes_to(start=0.5)
    move.get_by_label("It plays").select_option("again and again")
    expect(move.get_by_role("alert")).to_contain_text('"fast" is no speed')
    goes_to(start=0.5, loop=1)
    parts = ["brows", "eyes", "mouth", "rest", "head", "gaze"]
    for part in ("brows", "eyes", "rest", "head"):
        move.get_by_label(part).click()
        parts.remove(part)
        goes_to(start=0.5, loop=1, **dict.fromkeys(parts, 1))
    expect(page.locator("omote-cue-list")).not_to_contain_text("no clip")
