"""The console page, played as an operator plays it: by mouse, by fingers, by keyboard, and two at once."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from threading import Event
from typing import Any

import msgspec
import numpy as np
import pytest
from playwright.sync_api import Locator, Page, Route, WebSocketRoute, expect

import omote
from tests.browser.console_at_rest import DESK, bring_to_rest, wait_for
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]
Console = Callable[..., Page]

POSE_TILES = """(name => [...document.querySelectorAll("omote-console")].flatMap((page) => [...page.shadowRoot
    .querySelectorAll("omote-palette")]).map((palette) => palette.shadowRoot.querySelector("omote-pose-tiles"))
    .find(Boolean)?.shadowRoot.querySelector(`.tile[data-name="${name}"] canvas`))"""
"""The picture of a pose, by its name."""
PIXELS = "((canvas) => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.join())"

TWO_FRAMES = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"


@pytest.fixture
def console(open_page: OpenPage) -> Console:
    """Opens a console on a show at rest, with `pictures` or without; later ones join it as it is."""
    opened: list[Page] = []

    def open_one(*, pictures: bool = False, **options: Any) -> Page:
        page = open_page("/console", pictures=pictures, **options)
        wait_for(page, "desk.online && state !== null && desk.faces.length > 0")
        if not opened:
            bring_to_rest(page)
        opened.append(page)
        return page

    return open_one


def state(page: Page) -> dict[str, Any]:
    """The newest state this console has heard, and in it what the character has on air that it plays."""
    return dict(page.evaluate(f"({{...{DESK}.state, ...{DESK}.air}})"))


def tile(page: Page, name: str) -> Locator:
    return page.locator(f".tile[data-name='{name}']")


def fader(page: Page, channel: str) -> Locator:
    return page.locator(f"[data-channel='{channel}']")


def region(page: Page, name: str) -> None:
    page.locator(f"[data-tab='{name}']").click()


def bar(page: Page, axis: str) -> Locator:
    return page.get_by_role("slider", name=f"{axis} T-bar")


def choose(page: Page, axis: str, seconds: str) -> None:
    page.locator(f".{axis}s omote-timing [data-seconds='{seconds}']").locator("visible=true").click()


def drag(page: Page, control: Locator, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Drags with the mouse from one place of a control to another, both in parts of its box."""
    box = control.bounding_box()
    assert box is not None
    points = [(box["x"] + x * box["width"], box["y"] + y * box["height"]) for x, y in (start, end)]
    page.mouse.move(*points[0])
    page.mouse.down()
    page.mouse.move(*points[1], steps=6)
    page.mouse.up()


# --- calls ------------------------------------------------------------------------------------------------------------


def test_a_click_brings_a_face_on_air_in_the_chosen_time(console: Console) -> None:
    page = console()
    choose(page, "face", "4")
    assert page.evaluate(f"{DESK}.timing.face.seconds") == 4
    tile(page, "old").click()
    wait_for(page, "state.faces.old === 1 && state.face_call === null")
    expect(tile(page, "old")).to_have_class("tile air")
    expect(tile(page, "generic")).to_have_class("tile")
    page.evaluate(f"{DESK}.setTiming('face', {{ seconds: 600 }})")
    tile(page, "child").click()
    wait_for(page, "state.face_call?.target === 'child' && 4 < state.face_call.remaining")
    assert state(page)["face_call"]["remaining"] <= 600
    expect(tile(page, "child")).to_have_class("tile coming")


def test_a_cut_needs_no_time(console: Console) -> None:
    page = console()
    choose(page, "expression", "0")
    tile(page, "smile").click()
    wait_for(page, "state.expressions.smile === 1 && state.expression_call === null")


def test_typed_seconds_and_the_easing_go_with_the_call(console: Console) -> None:
    page = console()
    entry = page.get_by_label("Other seconds (expression)")
    entry.fill("300")
    entry.press("Enter")
    page.locator(".expressions [data-easing='late']").click()
    tile(page, "sad").click()
    wait_for(page, "state.expression_call?.target === 'sad' && state.expression_call.remaining > 30")
    assert page.evaluate(f"{DESK}.timing.expression.easing") == "late"
    expect(entry).not_to_be_focused()
    entry.fill("soon")
    entry.press("Enter")
    expect(page.locator(".notice")).to_contain_text('"soon" is not a duration')
    expect(page.locator(".notice")).to_contain_text("Calls go on taking 300 s")
    assert page.evaluate(f"{DESK}.timing.expression.seconds") == 300
    entry.press("3")  # over what is selected
    assert page.evaluate(f"{DESK}.timing.expression.seconds") == 300  # typed, not yet meant
    tile(page, "joy").click()
    wait_for(page, "state.expression_call?.target === 'joy' && state.expression_call.remaining <= 3")
    expect(entry).to_have_value("3")
    expect(page.locator(".notice")).to_have_text("")
    entry.click()
    page.keyboard.type("12")
    page.keyboard.press("Enter")
    assert page.evaluate(f"{DESK}.timing.expression.seconds") == 12
    entry.fill("never")
    tile(page, "sad").click()
    expect(entry).to_have_value("12")  # what counts is what is read


def test_what_is_on_air_and_what_is_coming_is_told_by_name(console: Console) -> None:
    page = console()
    choose(page, "face", "hand")
    tile(page, "child").click()
    mix = page.locator("omote-mix").first
    expect(mix.locator(".coming")).to_contain_text("Child")
    expect(mix.locator(".coming")).to_contain_text("by hand")
    expect(mix.locator(".row").first).to_contain_text("Generic")
    expect(mix.locator(".row").first).to_contain_text("100")


def test_units_are_found_by_their_region(console: Console) -> None:
    page = console()
    page.get_by_role("tab", name="ARKit").click()
    expect(page.locator(".expressions .tile")).to_have_count(52)
    page.get_by_label("Search expressions").fill("jaw")
    expect(tile(page, "jawOpen")).to_be_visible()
    expect(tile(page, "browInnerUp")).to_have_count(0)
    tile(page, "jawOpen").click()
    wait_for(page, "state.expressions.jawOpen > 0")
    page.keyboard.press("Space")  # the tile has not kept the focus
    search = page.get_by_label("Search expressions")
    search.fill("surpr")
    search.press("Enter")
    wait_for(page, "state.expressions.surprise > 0")
    search.press("ArrowDown")
    expect(tile(page, "surprise")).to_be_focused()


# --- T-bars ----------------------------------------------------------------------------------------------------------


def test_a_t_bar_moves_a_call_by_hand_to_its_end_and_the_next_one_back(console: Console) -> None:
    page = console()
    choose(page, "face", "hand")
    tile(page, "round").click()
    wait_for(page, "state.face_call?.by_hand")
    drag(page, bar(page, "Face"), (0.5, 1.0), (0.5, 0.5))
    wait_for(page, "Math.abs(state.faces.round - 0.5) < 0.02")
    expect(page.locator(".facebar .mode")).to_have_text("by hand")
    drag(page, bar(page, "Face"), (0.5, 0.5), (0.5, -0.1))
    wait_for(page, "state.faces.round === 1 && state.face_fader === 1")
    tile(page, "generic").click()
    wait_for(page, "state.face_call?.target === 'generic'")
    drag(page, bar(page, "Face"), (0.5, 0.0), (0.5, 0.75))
    wait_for(page, "Math.abs(state.faces.generic - 0.75) < 0.02")


def test_a_t_bar_under_a_hand_waits_until_it_meets_the_value_of_a_new_call(console: Console) -> None:
    page = console()
    choose(page, "expression", "hand")
    box = bar(page, "Expression").bounding_box()
    assert box is not None
    x = box["x"] + box["width"] / 2
    low = box["y"] + box["height"]
    page.mouse.move(x, low)
    page.mouse.down()
    page.mouse.move(x, low - 0.4 * box["height"], steps=4)
    wait_for(page, "Math.abs(state.expression_fader - 0.4) < 0.02")
    page.keyboard.press("w")
    wait_for(page, "state.expression_call?.target === 'smile'")
    expect(page.locator(".exprbar .mode")).to_contain_text("pick up")
    expect(page.locator(".exprbar .hand")).to_have_class("carrier hand ghost")
    page.mouse.move(x, low - 0.7 * box["height"], steps=4)
    wait_for(page, "Math.abs(state.expression_fader - 0.7) < 0.02")
    assert state(page)["expression_call"]["progress"] == 0
    page.mouse.move(x, low, steps=4)
    page.mouse.move(x, low - 0.5 * box["height"], steps=4)
    page.mouse.up()
    wait_for(page, "Math.abs(state.expressions.smile - 0.5) < 0.02")
    expect(page.locator(".exprbar .release")).to_be_disabled()


def test_a_t_bar_that_was_left_in_the_middle_is_at_its_rest_for_the_next_call(console: Console) -> None:
    page = console()
    choose(page, "expression", "hand")
    for name, where in (("smile", 0.4), ("sad", 0.7), ("joy", 0.3)):
        tile(page, name).click()
        wait_for(page, f"state.expression_call?.target === {name!r} && [0, 1].includes(state.expression_fader)")
        assert state(page)["expression_call"]["progress"] == 0
        low = 1.0 - state(page)["expression_fader"]
        drag(page, bar(page, "Expression"), (0.5, low), (0.5, abs(low - where)))
        wait_for(page, f"Math.abs(state.expressions[{name!r}] - {where}) < 0.05")


def test_a_released_t_bar_lets_a_timed_call_run_on(console: Console) -> None:
    page = console()
    page.evaluate(f"{DESK}.setTiming('face', {{ seconds: 30 }})")
    tile(page, "old").click()
    drag(page, bar(page, "Face"), (0.5, 1.0), (0.5, 0.2))
    wait_for(page, "state.face_call?.by_hand && state.face_call.progress > 0.75")
    page.locator(".facebar").get_by_role("button", name="Release").click()
    wait_for(page, "state.faces.old === 1")


# --- channels, head and gaze ------------------------------------------------------------------------------------------


def test_a_fader_moves_its_channel_and_stands_out(console: Console) -> None:
    page = console()
    region(page, "jaw")
    jaw = fader(page, "jawOpen")
    places = "tabs => tabs.map(tab => tab.getBoundingClientRect().left)"
    before = page.locator("omote-bank [data-tab]").evaluate_all(places)
    drag(page, jaw, (0.5, 0.75), (0.5, 0.5))
    wait_for(page, "state.channels.jawOpen > 0.4 && state.channels.jawOpen < 0.6")
    expect(page.locator("[data-tab='touched'] .count")).to_have_text("1")
    assert page.locator("omote-bank [data-tab]").evaluate_all(places) == before, "tabs stay under the hand"
    jaw.dblclick()
    wait_for(page, "!('jawOpen' in state.channels)")


@contextmanager
def driving(show: str, **channels: float) -> Iterator[None]:
    """A program drives the playback of the first character by 30 frames a second."""
    over = Event()

    def drive() -> None:
        with omote.connect(show, name="robot") as connected:
            while not over.wait(1 / 30):
                connected["one"].drive(channels)

    with ThreadPoolExecutor(1) as program:
        running = program.submit(drive)
        try:
            yield
        finally:
            over.set()
            running.result()


def test_what_a_program_drives_is_seen_on_faders_and_mixed_by_layers(console: Console, show: str) -> None:
    page = console()
    region(page, "jaw")
    choose(page, "expression", "0")
    tile(page, "smile").click()
    jaw = fader(page, "jawOpen")
    number = page.locator("omote-fader", has=fader(page, "jawOpen")).locator(".number")
    with driving(show, jawOpen=0.6):
        wait_for(page, "Math.abs(state.channels.jawOpen - 0.6) < 0.01 && state.regions.mouth?.neutral > 0.99")
        expect(number).to_have_text(".60")  # on air; no hand is on it
        expect(number).to_have_class("number driven")
        expect(jaw).to_have_attribute("aria-valuenow", "0.00")
        jaw.press("PageUp")
        jaw.press("PageUp")
        wait_for(page, "Math.abs(state.channels.jawOpen - 1) < 0.01")
        expect(jaw).to_have_attribute("aria-valuenow", "1.00")
        jaw.press("Home")
        wait_for(page, "Math.abs(state.channels.jawOpen - 0.6) < 0.01")
        page.keyboard.press(";")
        strip = page.locator("omote-layer-panel .strip[data-layer=playback]")
        expect(strip.locator(".feed")).to_have_text("robot playback one")
        expect(strip.locator(".bar").first).to_have_text(page.evaluate(f"{DESK}.label('expression', 'jawOpen')"))
        influence = strip.get_by_role("slider")
        influence.press("PageDown")
        influence.press("PageDown")
        wait_for(
            page, "!(state.channels.jawOpen > 0.01) && !(state.regions.mouth?.neutral > 0.01)"
        )  # the smile is back
        assert state(page)["expressions"] == {"smile": 1}
        influence.press("Home")
        wait_for(page, "Math.abs(state.channels.jawOpen - 0.6) < 0.01")
        strip.locator(".on").click()
        wait_for(page, "!(state.channels.jawOpen > 0.01) && !state.layers.playback.on")
        page.keyboard.press("Control+z")
        wait_for(page, "state.layers.playback.on")
    wait_for(page, "!('playback' in state.layers) && state.held === null")  # the program has gone, without a trace


def test_a_tracker_that_is_lost_and_comes_back_is_told(console: Console, show: str) -> None:
    page = console()
    trusted = f"{DESK}.air.layers.tracker?.trust > 0.9995"
    with omote.connect(show, name="Mira") as program:
        for told in ("is lost.", "is back."):
            while not page.evaluate(trusted):
                program["one"].drive({"jawOpen": 0.6}, layer="tracker")
            if told == "is lost.":
                wait_for(page, "state.layers.tracker?.trust === 0")
            expect(page.locator("omote-status .notice")).to_contain_text(told)
    page.get_by_role("button", name="Log").click()
    expect(page.locator("omote-message-log")).to_contain_text("tracker of One) is lost.")
    wait_for(page, "!('tracker' in state.layers)")


def group(page: Page, name: str) -> Locator:
    """Shows a group of the mixer; its head."""
    head = page.locator(f"omote-group-heads [data-group={name}]")
    head.click()
    expect(head).to_have_attribute("aria-selected", "true")
    return head


def test_a_line_is_spoken_by_the_voice_that_is_chosen_and_one_that_cannot_be_is_said(console: Console) -> None:
    page = console()
    page.keyboard.press(";")
    group(page, "speech")
    page.get_by_role("combobox", name="Voice").select_option("voice de")
    line = page.get_by_label("A line to say")
    line.fill("Guten Abend, meine Damen und Herren. " * 20)
    line.press("Enter")
    wait_for(page, "state.speech?.sound && state.speech.seconds > 30")
    page.get_by_role("button", name="Stop", exact=True).click()
    wait_for(page, "state.speech === null")
    line.fill("...")
    line.press("Enter")
    expect(page.locator("omote-status .notice")).to_contain_text("this voice finds nothing to speak in this text")


def test_liveliness_moves_the_face_by_itself_until_panic(console: Console) -> None:
    page = console()
    page.keyboard.press(";")
    head = group(page, "motion")
    slider = page.get_by_role("slider", name="Liveliness")
    expect(head).to_contain_text("holds still")
    expect(slider).to_have_value("0")
    slider.focus()
    for _ in range(10):
        slider.press("ArrowRight")
    wait_for(page, "state.motion?.liveliness === 0.5 && state.layers.gaze.source === 'automatic'")
    expect(page.locator("omote-motion-settings .number").first).to_have_text("50")
    expect(head).to_contain_text("liveliness 50")
    strip = page.locator("omote-layer-panel .strip[data-layer=blink]")
    expect(strip.locator(".feed")).to_contain_text("automatic")
    wait_for(page, "Math.abs(state.gaze[0]) > 0.02 && state.channels.browInnerUp !== undefined")
    page.keyboard.press("Shift+Backspace")
    wait_for(page, "state.motion.liveliness === 0 && Object.keys(state.layers).length === 0")
    expect(slider).to_have_value("0")
    page.get_by_role("button", name="Sources on again").click()
    wait_for(page, "state.motion.liveliness === 0.5")
    expect(page.get_by_role("button", name="Sources on again")).to_have_count(0)
    page.get_by_role("button", name="Undo", exact=True).first.click()
    wait_for(page, "state.motion.liveliness === 0")
    still = page.get_by_role("button", name="Still", exact=True)
    expect(still).to_have_attribute("aria-pressed", "true")
    still.click()
    wait_for(page, "state.motion.liveliness === 0.5")
    expect(still).to_have_attribute("aria-pressed", "false")
    page.keyboard.press("'")
    wait_for(page, "state.motion.liveliness === 0")


def test_a_whole_look_is_kept_by_a_press_and_called_by_a_key(console: Console) -> None:
    page = console()
    memory = page.locator("omote-memories [data-memory='1']")
    page.locator("omote-palette.faces [data-name=old]").click()
    wait_for(page, "state.face_call === null && state.faces.old === 1")
    page.locator("omote-lights [data-light=flat]").click()
    wait_for(page, "desk.state.light.flat === 1")
    expect(memory).to_have_attribute("aria-label", "Memory 1, empty")
    page.get_by_role("button", name="Keep a memory").click()
    memory.click()
    expect(memory).to_have_attribute("aria-label", "Memory 1")
    expect(memory.locator("canvas")).to_have_attribute("data-drawn", re.compile("^old "))
    page.locator("omote-palette.faces [data-name=dog]").click()
    page.locator("omote-lights [data-light=theatre]").click()
    wait_for(page, "state.face_call === null && state.faces.dog === 1 && desk.state.light.theatre === 1")
    page.keyboard.press("Shift+1")
    wait_for(page, "state.faces.old === 1 && desk.state.light.flat === 1")
    page.get_by_role("button", name="Delete a memory").click()
    memory.click()
    expect(memory).to_have_attribute("aria-label", "Memory 1, empty")
    page.get_by_role("button", name="Undo", exact=True).first.click()
    expect(memory).to_have_attribute("aria-label", "Memory 1")


def test_the_picture_says_on_air_where_a_face_shows(console: Console) -> None:
    page = console(pictures=True, disposable=True)
    held: list[Route] = []
    page.route("**/manifest", lambda route: held.append(route))
    page.reload()
    expect(page.locator("omote-monitor [role=status]")).to_have_text("The face on air is loading …")
    expect(page.locator("omote-monitor .tally")).to_have_count(0)
    for route in held:
        route.continue_()
    page.unroute("**/manifest")
    expect(page.locator("omote-monitor .tally")).to_have_text("ON AIR")


def test_eyes_look_at_a_camera_and_at_a_point_that_is_named_and_deleted(console: Console) -> None:
    page = console()
    page.keyboard.press(";")
    head = group(page, "gaze")
    targets = page.locator("omote-gaze-target-settings")
    targets.get_by_role("button", name="Camera").click()
    wait_for(page, "state.motion?.target.kind === 'stage'")
    targets.get_by_role("button", name="Point …").click()
    across = targets.get_by_role("slider", name="Across")
    across.focus()
    for _ in range(20):
        across.press("ArrowRight")
    wait_for(page, "state.motion.target.kind === 'point' && state.gaze[0] + state.head[0] > 0.4")
    targets.get_by_label("Name of the point").fill("front row")
    targets.get_by_role("button", name="Keep").click()
    wait_for(page, "state.motion.target.name === 'front row'")
    expect(head).to_contain_text("front row")
    targets.get_by_role("button", name="Delete the point front row").click()
    wait_for(page, "state.motion.target.kind === 'ahead'")
    page.get_by_role("button", name="Undo", exact=True).first.click()
    expect(targets.get_by_role("button", name="front row", exact=True)).to_have_attribute("aria-pressed", "true")
    idles = page.get_by_role("button", name="Idles")
    expect(group(page, "motion")).to_contain_text("holds still")
    idles.click()
    wait_for(page, "state.motion.idle")
    page.keyboard.press("Shift+Backspace")
    wait_for(page, "state.motion.target.kind === 'ahead' && Object.keys(state.layers).length === 0")
    page.get_by_role("button", name="Sources on again").click()
    wait_for(page, "state.motion.target.name === 'front row'")
    group(page, "gaze")
    targets.get_by_role("button", name="Delete the point front row").click()
    wait_for(page, "state.motion.target.kind === 'ahead'")
    group(page, "motion")
    idles.click()
    wait_for(page, "!state.motion.idle")  # the show goes on with other files: a lost tracker would move its face


def test_a_second_panic_offers_the_faces_of_before(console: Console) -> None:
    page = console()
    choose(page, "face", "0")
    tile(page, "dog").click()
    wait_for(page, "state.faces.dog === 1")
    page.evaluate(f"{DESK}.motion('liveliness').nudge(0.5)")
    wait_for(page, "state.motion?.liveliness === 0.5")
    page.keyboard.press("Shift+Backspace")
    wait_for(page, "state.home_next")
    page.keyboard.press("Shift+Backspace")
    expect(page.get_by_role("button", name="Faces of before")).to_be_visible()
    page.get_by_role("button", name="Sources on again").click()
    wait_for(page, "state.motion.liveliness === 0.5")
    expect(page.locator("omote-status .notice")).to_contain_text("Sources are on again.")
    page.get_by_role("button", name="Faces of before").click()  # beside the notice that says so
    wait_for(page, "state.faces.dog === 1 && state.face_call === null")
    page.get_by_role("button", name="Log").click()
    expect(page.locator("omote-message-log")).to_contain_text("Home face: ")


def test_strips_of_layers_keep_their_widths_when_a_source_starts(console: Console, show: str) -> None:
    page = console()
    page.keyboard.press(";")
    strips = page.locator("omote-layer-panel .strip")
    read = "(strips) => strips.map((strip) => strip.getBoundingClientRect().left)"
    expect(page.locator(".strip[data-layer=playback]")).to_have_class("strip idle")
    before = strips.evaluate_all(read)
    with driving(show, jawOpen=0.6):
        expect(page.locator(".strip[data-layer=playback]")).to_have_class("strip")
        assert strips.evaluate_all(read) == before
    wait_for(page, "!('playback' in state.layers) && state.held === null")


def test_a_drag_with_shift_is_ten_times_finer(console: Console) -> None:
    page = console()
    region(page, "jaw")
    jaw = fader(page, "jawOpen")
    jaw.focus()
    for _ in range(10):
        page.keyboard.press("ArrowUp")
    wait_for(page, "state.channels.jawOpen === 0.5")
    page.keyboard.down("Shift")
    drag(page, jaw, (0.5, 0.5), (0.5, 0.25))
    page.keyboard.up("Shift")
    wait_for(page, "state.channels.jawOpen > 0.53 && state.channels.jawOpen < 0.57")


def test_left_and_right_move_together_while_they_are_linked(console: Console) -> None:
    page = console()
    region(page, "mouth")
    fader(page, "mouthSmileLeft").focus()
    page.keyboard.press("PageUp")
    wait_for(page, "state.channels.mouthSmileLeft === 0.5 && state.channels.mouthSmileRight === 0.5")
    page.get_by_role("button", name="Link R L").click()
    fader(page, "mouthSmileLeft").focus()
    page.keyboard.press("ArrowUp")
    wait_for(page, "state.channels.mouthSmileLeft === 0.55 && state.channels.mouthSmileRight === 0.5")
    page.locator("[data-clear='region']").click()
    wait_for(page, "Object.keys(state.channels).length === 0")


def test_every_channel_has_a_fader(console: Console) -> None:
    page = console()
    channels = set(page.evaluate(f"{DESK}.expressions.filter((one) => one.kind !== 'neutral').map((one) => one.name)"))
    found: set[str] = set()
    for tab in page.locator("omote-bank [role='tab']").all()[1:]:
        tab.click()
        expect(tab).to_have_attribute("aria-selected", "true")
        found |= set(page.locator("[data-channel]").evaluate_all("all => all.map((one) => one.dataset.channel)"))
    assert found == channels


def test_the_head_turns_to_where_the_dot_goes_as_the_operator_sees_it(console: Console) -> None:
    page = console()
    pad = page.get_by_role("slider", name="Head: as you see")
    page.locator("omote-pad").first.get_by_role("button", name="Spring").click()
    drag(page, pad, (0.5, 0.5), (0.75, 0.25))
    wait_for(page, "Math.abs(state.head[0] - 0.4) < 0.03 && Math.abs(state.head[1] - 0.25) < 0.03")
    tilt = page.get_by_role("slider", name="Head tilt")
    drag(page, tilt, (0.5, 0.5), (0.75, 0.5))
    wait_for(page, "Math.abs(state.head[2] - 0.25) < 0.03 && Math.abs(state.head[0] - 0.4) < 0.03")
    pad.dblclick(position={"x": 10, "y": 10})
    wait_for(page, "state.head.every((angle) => angle === 0)")


def test_a_gaze_pad_with_a_spring_comes_back(console: Console) -> None:
    page = console()
    pad = page.get_by_role("slider", name="Gaze: as you see")
    box = pad.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 0.2 * box["width"], box["y"] + 0.5 * box["height"])
    page.mouse.down()
    wait_for(page, "state.gaze[0] < -0.3")
    page.mouse.up()
    wait_for(page, "state.gaze[0] === 0 && state.gaze[1] === 0")


# --- together, by touch, by keyboard ----------------------------------------------------------------------------------


def test_two_consoles_stay_in_step_and_the_last_touch_wins(console: Console) -> None:
    first = console()
    second = console()
    for page in (first, second):
        region(page, "jaw")
    drag(first, fader(first, "jawOpen"), (0.5, 0.75), (0.5, 0.5))
    wait_for(first, "Math.abs(state.channels.jawOpen - 0.5) < 0.02")  # the drag's last step, no step on its way
    value = f"{state(first)['channels']['jawOpen']:.2f}"
    expect(fader(second, "jawOpen")).to_have_attribute("aria-valuenow", value)
    fader(second, "jawOpen").focus()
    second.keyboard.press("Home")
    expect(fader(first, "jawOpen")).to_have_attribute("aria-valuenow", "0.00")
    choose(first, "face", "hand")
    tile(first, "man").click()
    expect(tile(second, "man")).to_have_class("tile coming")
    drag(first, bar(first, "Face"), (0.5, 1.0), (0.5, 0.4))
    wait_for(second, "Math.abs(state.faces.man - 0.6) < 0.02")
    for page in (first, second):
        expect(bar(page, "Face")).to_have_attribute("aria-valuenow", "0.60")
    expect(second.locator(".item.consoles")).to_contain_text("2 consoles")
    jaw = f"{DESK}.channel('jawOpen')"
    second.evaluate(f"() => {{ window.moving = setInterval(() => {jaw}.nudge(Math.random()), 50); }}")
    mark = fader(first, "jawOpen").locator(".other")
    expect(mark).to_have_text(second.evaluate(f"{DESK}.name"))
    second.evaluate("() => clearInterval(window.moving)")
    expect(mark).to_be_empty()
    check_leases(first, second)


def check_leases(first: Page, second: Page) -> None:
    """With leases on the first touch wins: the other console reads whose it is, takes it over, a reload keeps it."""
    leases = DESK.replace(".store", ".leases")
    name, other = (page.evaluate(f"{DESK}.name") for page in (first, second))
    first.locator("body").press(",")
    first.get_by_role("switch", name="Leases off").click()
    try:
        expect(first.locator("omote-seat button")).to_have_attribute("aria-label", re.compile(f"{name}, stage manager"))
        first.keyboard.press("Escape")
        tile(first, "old").click()
        expect(second.get_by_role("button", name=f"{name}: take over the face of One").first).to_be_visible()
        tile(second, "dog").click()
        expect(second.locator(".notice")).to_contain_text(f"{name} holds the face of One.")
        expect(first.locator(".notice")).to_contain_text(f"{other} wants the face of One")
        second.get_by_role("button", name="Take over", exact=True).click()
        expect(first.locator(".notice")).to_contain_text(f"{other} has taken over the face of One.")
        second.reload()
        expect(second.get_by_role("button", name="You: release the face of One").first).to_be_visible()
        tile(second, "dog").click()
        wait_for(first, "state.faces.dog > 0 || state.face_call?.target === 'dog'")
    finally:
        first.evaluate(f"{leases}.switch(false)")
        first.wait_for_function(f"() => !{leases}.report.on")


def test_two_fingers_move_two_faders_at_once(console: Console) -> None:
    page = console(width=1024, height=768, has_touch=True)
    region(page, "jaw")
    boxes = [fader(page, name).bounding_box() for name in ("jawOpen", "jawForward")]
    assert all(boxes)
    starts = [(box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.75) for box in boxes if box]
    height = boxes[0]["height"] if boxes[0] else 0
    session = page.context.new_cdp_session(page)

    def touch(kind: str, rise: float) -> None:
        points = [] if kind == "touchEnd" else [{"x": x, "y": y - rise, "id": n} for n, (x, y) in enumerate(starts)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    touch("touchStart", 0)
    for step in range(1, 6):
        touch("touchMove", height * 0.05 * step)
    wait_for(page, "state.channels.jawOpen > 0.4 && state.channels.jawForward > 0.4")
    touch("touchEnd", 0)
    assert page.evaluate("window.scrollY") == 0


def test_a_finger_calls_and_panics(console: Console) -> None:
    page = console(width=1024, height=768, has_touch=True)
    tile(page, "kaori").tap()
    wait_for(page, "state.faces.kaori === 1")
    tile(page, "angry").tap()
    wait_for(page, "state.expressions.angry > 0")
    page.locator(".panic").tap()
    wait_for(page, "state.expressions.neutral === 1")


def test_the_keyboard_calls_chooses_times_and_reaches_the_controls(console: Console) -> None:
    page = console()
    faces = page.evaluate(f"{DESK}.faces.map((face) => face.name)")
    page.keyboard.press("2")
    wait_for(page, f"state.faces['{faces[1]}'] === 1")
    page.keyboard.press("w")
    wait_for(page, "state.expressions.smile === 1")
    page.keyboard.press("d")  # the brows alone, which show another expression until the whole face is called
    page.keyboard.press("e")
    wait_for(page, "state.regions.brows?.joy === 1 && state.expressions.smile === 1")
    expect(tile(page, "joy").locator(".where")).to_have_text("brows")
    expect(tile(page, "smile").locator(".where")).to_have_text("E M R")
    page.locator("omote-regions [data-region=whole]").click()
    page.keyboard.press("w")
    wait_for(page, "Object.keys(state.regions).length === 0")
    expect(tile(page, "smile").locator(".where")).to_have_text("")
    page.keyboard.press("]")
    assert page.evaluate(f"{DESK}.timing.face.seconds") == 0.25
    page.keyboard.press("a")
    assert page.evaluate(f"{DESK}.timing.face") == {"seconds": 0.25, "easing": "smooth", "byHand": True}
    page.keyboard.press("3")
    page.keyboard.press("f")
    expect(bar(page, "Face")).to_be_focused()
    page.keyboard.press("PageUp")
    wait_for(page, f"Math.abs(state.faces['{faces[2]}'] - 0.2) < 0.001")
    page.keyboard.press("h")
    page.keyboard.press("ArrowRight")
    wait_for(page, "Math.abs(state.head[0] - 0.05) < 0.001")
    page.keyboard.press("c")
    wait_for(page, "state.head[0] === 0")
    page.keyboard.press("Shift+B")
    cut = page.get_by_role("button", name="Cut to black")
    expect(cut).to_have_attribute("aria-pressed", "true")
    wait_for(page, "state.black === 1")
    expect(page.locator("omote-monitor .tally")).to_have_text("BLACK")
    page.keyboard.press("Shift+Backspace")  # brings no light
    wait_for(page, "state.expressions.neutral === 1")
    assert page.evaluate(f"{DESK}.state.black") == 1.0
    cut.click()
    wait_for(page, "state.black === 0")
    expect(page.locator("omote-monitor .tally")).to_have_text("ON AIR")
    page.keyboard.press("?")
    expect(page.get_by_role("dialog", name="Keys")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog", name="Keys")).to_have_count(0)


def test_arrows_walk_a_palette_and_units_have_their_keys_in_the_order_shown(console: Console) -> None:
    page = console()
    page.get_by_role("tab", name="MakeHuman").click()
    shown = page.locator(".expressions .tile")
    names = shown.evaluate_all("all => all.map((one) => one.dataset.name)")
    assert names[0].startswith("eyebrows")
    expect(shown.nth(1).locator(".key")).to_have_text("W")
    page.keyboard.press("w")
    wait_for(page, f"state.expressions['{names[1]}'] === 1")
    shown.first.focus()
    page.keyboard.press("ArrowRight")
    expect(shown.nth(1)).to_be_focused()
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("Enter")
    wait_for(page, f"state.expressions['{names[0]}'] === 1")


def test_keys_in_a_field_for_text_call_nobody(console: Console) -> None:
    page = console()
    page.keyboard.press("/")
    page.keyboard.type("w2")
    expect(page.get_by_label("Search expressions")).to_have_value("w2")
    fader(page, "browInnerUp").press("ArrowUp")
    wait_for(page, "state.channels.browInnerUp > 0")  # a later command has arrived, the keys before would have too
    assert state(page)["faces"] == {"generic": 1}
    assert state(page)["expressions"] == {"neutral": 1}


def test_a_drag_under_way_does_not_undo_panic(console: Console) -> None:
    page = console()
    region(page, "jaw")
    box = fader(page, "jawOpen").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.75
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - 30, steps=3)
    wait_for(page, "state.channels.jawOpen > 0")
    page.keyboard.press("Shift+Backspace")
    page.mouse.move(x, y - 60, steps=3)
    fader(page, "jawForward").press("ArrowUp")
    # the hand's last moves came before the nudge: what they undid would stand, while what panic found eases to rest
    wait_for(page, "state.channels.jawForward > 0 && state.channels.jawOpen === undefined")
    page.mouse.up()


# --- what is seen -----------------------------------------------------------------------------------------------------


def test_thumbnails_show_faces_and_they_differ(console: Console) -> None:
    page = console(pictures=True)
    drawn = "all.length > 0 && all.every((one) => one.dataset.drawn)"
    palettes = "[...document.querySelector('omote-console').shadowRoot.querySelectorAll('omote-palette')]"
    canvases = f"{palettes}.flatMap((one) => [...one.shadowRoot.querySelectorAll('canvas')])"
    wait_for(page, f"((all) => {drawn})({canvases})")
    pictures = {name: pixels(page, name) for name in ("generic", "old", "child", "smile", "surprise")}
    for name, picture in pictures.items():
        assert picture.std() > 20, f"{name} is blank"
    names = list(pictures)
    for index, name in enumerate(names):
        for other in names[index + 1 :]:
            difference = np.abs(pictures[name] - pictures[other]).mean()
            assert difference > 0.5, f"{name} and {other} look the same"


def pixels(page: Page, name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The colours of a thumbnail."""
    data = (
        tile(page, name)
        .locator("canvas")
        .evaluate("one => [...one.getContext('2d').getImageData(0, 0, one.width, one.height).data]")
    )
    return np.asarray(data, dtype=np.float64).reshape(-1, 4)[:, :3]


def test_a_t_bar_names_the_mix_that_it_fades_from(console: Console) -> None:
    page = console()
    tile(page, "cat").click()
    wait_for(page, "state.faces.cat === 1")
    choose(page, "face", "hand")
    tile(page, "goblin").click()
    wait_for(page, "state.face_call?.target === 'goblin'")
    page.evaluate(f"() => {DESK}.bar('face').nudge(0.25)")
    wait_for(page, "Math.abs((state.faces.goblin ?? 0) - 0.25) < 1e-6")
    tile(page, "old").click()
    wait_for(page, "state.face_call?.target === 'old'")
    top = page.locator(".facebar .end.top")
    bottom = page.locator(".facebar .end.bottom")
    expect(bottom).to_have_text("Cat 75\nGoblin 25")
    expect(top).to_have_text("Old")
    page.reload()  # what a page has not seen begin it names all the same
    expect(bottom).to_have_text("Cat 75\nGoblin 25")
    assert bar(page, "Face").get_attribute("aria-valuetext") == "from Cat 75, Goblin 25 to Old, 0 per cent"


def test_a_control_of_no_size_moves_nothing(console: Console) -> None:
    page = console()
    region(page, "jaw")
    box = fader(page, "jawOpen").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    fader(page, "jawOpen").evaluate("one => { one.style.height = '0'; one.style.alignSelf = 'start'; }")
    page.mouse.move(x, y - 40, steps=4)
    page.mouse.up()
    fader(page, "jawForward").press("ArrowUp")
    wait_for(page, "state.channels.jawForward > 0")  # a later command has arrived
    assert set(state(page)["channels"]) == {"jawForward"}
    expect(page.locator(".notice")).to_have_text("")


def test_names_are_text_whatever_they_hold(console: Console) -> None:
    page = console()
    label = "<img src=x onerror=\"document.title='broken'\">"

    def rename(route: Route) -> None:
        manifest = msgspec.msgpack.decode(route.fetch().body())
        manifest["faces"][0]["label"] = label
        route.fulfill(body=msgspec.msgpack.encode(manifest))

    page.route("**/manifest", rename)
    page.reload()
    expect(tile(page, "generic")).to_contain_text(label)
    expect(page.locator("omote-mix .row").first).to_contain_text(label)
    assert page.title() == "Omote console"
    assert page.locator("img").count() == 0


def test_a_lost_link_is_seen_nothing_is_pretended_and_it_comes_back(open_page: OpenPage, console: Console) -> None:
    console()
    page = open_page("/console", pictures=False, disposable=True)
    links: list[WebSocketRoute] = []
    away = [False]

    def carry(link: WebSocketRoute) -> None:
        if away[0]:
            link.close()
        else:
            link.connect_to_server()
            links.append(link)

    page.route_web_socket("**/link", carry)
    page.reload()
    wait_for(page, "desk.online && desk.faces.length > 0")
    region(page, "jaw")
    box = fader(page, "jawOpen").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.75
    page.mouse.move(x, y)
    page.mouse.down()
    away[0] = True
    links[-1].close()
    expect(page.locator(".lost[role='alert']")).to_contain_text("LINK LOST")
    panic = page.locator(".panic.unheard")
    expect(panic).to_contain_text("NOT HEARD: no link")
    page.mouse.move(x, y - 0.25 * box["height"])  # in one step, as a busy browser hands several on
    expect(page.locator(".notice")).to_contain_text("Not sent")
    expect(fader(page, "jawOpen")).to_have_attribute("aria-valuenow", "0.00")
    page.evaluate(TWO_FRAMES)  # what the hand has done is offered once a frame: all of it while the link is lost
    away[0] = False
    expect(page.locator(".item.link")).to_contain_text("live")
    expect(panic).to_have_count(0)
    page.mouse.move(x, y - 0.5 * box["height"], steps=4)  # the drag goes on from what the server says
    wait_for(page, "state.channels.jawOpen > 0.4 && state.channels.jawOpen < 0.6")
    page.mouse.up()


ONE_DARK = f"""() => {{
    const receive = {DESK}.receive.bind({DESK});
    const stages = [{{ name: "left", fps: 0, level: "low", dark: 12.4, awake: "", sound: "", sound_here: false }}];
    {DESK}.receive = (message) => receive(message.type === "crew" ? {{ ...message, stages }} : message);
    receive({{ ...{DESK}.crew, stages }});
}}"""


def test_who_may_only_look_reads_that_panic_is_not_heard_and_which_stage_is_dark(open_page: OpenPage) -> None:
    page = open_page("/console", pictures=False, disposable=True)
    looking = msgspec.msgpack.encode({"role": "view", "name": "Ada", "asked": True})
    page.route("**/access", lambda route: route.fulfill(body=looking))
    page.reload()
    wait_for(page, "desk.online && desk.crew !== null")
    expect(page.locator(".panic.unheard")).to_contain_text("not by this role")
    expect(page.locator("omote-note")).to_contain_text("Note")
    page.evaluate(ONE_DARK)
    expect(page.locator("omote-status .dark")).to_have_text("stage left is dark, 12 s")


def test_a_server_with_another_built_in_cast_reloads_the_page(open_page: OpenPage, console: Console) -> None:
    console()
    page = open_page("/console", pictures=False, disposable=True)
    other = [False]
    links: list[WebSocketRoute] = []

    def carry(link: WebSocketRoute) -> None:
        server = link.connect_to_server()
        links.append(link)

        def pass_on(data: bytes | str) -> None:
            assert isinstance(data, bytes)
            message = msgspec.msgpack.decode(data)
            if other[0] and message["type"] == "welcome":
                other[0] = False
                message["digest"] = "another"
            link.send(msgspec.msgpack.encode(message))

        server.on_message(pass_on)

    def rename(route: Route) -> None:
        manifest = msgspec.msgpack.decode(route.fetch().body())
        route.fulfill(body=msgspec.msgpack.encode(manifest | {"base": "another"}))

    page.route_web_socket("**/link", carry)
    page.reload()
    wait_for(page, "desk.online && desk.faces.length > 0")
    other[0] = True
    page.route("**/manifest", rename, times=1)
    with page.expect_event("load"):
        links[-1].close()
    wait_for(page, "desk.online && desk.faces.length > 0")


def test_a_second_character_is_added_played_alone_and_taken_back(console: Console) -> None:
    page = console()
    page.locator("omote-characters .add").click()
    wait_for(page, "state.characters.two?.presence === 1 && desk.played.lead === 'two'")
    tile(page, "old").click()
    wait_for(page, "state.characters.two.faces.old === 1 && state.characters.one.faces.generic === 1")
    page.locator("omote-characters .all").click()
    before = page.evaluate(f"Object.values({DESK}.state.characters).map((one) => one.panics)")
    page.keyboard.press("Shift+Backspace")
    after = "Object.values(state.characters).map((one) => one.panics).join()"
    wait_for(page, f"{after} === '{','.join(str(panics + 1) for panics in before)}'")
    page.locator("omote-characters [data-character=one]").click()
    page.keyboard.press("Control+z")
    wait_for(page, "!('two' in state.characters) && desk.played.lead === 'one'")
    assert page.locator("omote-characters [data-character]").count() == 0
    page.keyboard.press("Control+y")  # comes back with all that it had
    wait_for(page, "state.characters.two?.presence === 1 && state.characters.two.faces.old === 1")
    page.locator("omote-characters [data-character=two]").click()
    page.keyboard.press("p")
    page.locator("omote-place-controls input[type=number][name=turn]").fill("45")
    page.keyboard.press("Enter")
    wait_for(page, "Math.abs(state.characters.two.place.turn - Math.PI / 4) < 1e-9")
    page.locator("omote-scene-panel [data-character=two] .remove").click()
    wait_for(page, "!('two' in state.characters)")
    page.keyboard.press("Control+z")
    wait_for(page, "Math.abs(state.characters.two?.place.turn - Math.PI / 4) < 1e-9")
    for _ in range(2):
        page.keyboard.press("Control+z")
    wait_for(page, "!('two' in state.characters)")


def test_poses_are_called_from_their_pictures_of_the_whole_figure_or_a_region_and_bodies_apart(
    console: Console,
) -> None:
    page = console(pictures=True)
    page.get_by_role("tab", name="Poses", exact=True).click()
    wave = page.locator("omote-pose-tiles .tile[data-name='wave']")
    wave.click()
    wait_for(page, "state.figure?.poses.wave === 1")
    expect(wave).to_have_class("tile air")
    wait_until(page, "drawn?.dataset.drawn?.includes('posed wave')", f"const drawn = {POSE_TILES}('wave')")
    different = f"{PIXELS}({POSE_TILES}('wave')) !== {PIXELS}({POSE_TILES}('bow'))"
    wait_until(page, f"{POSE_TILES}('bow')?.dataset.drawn?.includes('posed bow') && {different}")

    page.get_by_label("Where poses are called").select_option("trunk")
    page.get_by_label("Search poses by name").fill("bow")
    page.get_by_label("Search poses by name").press("Enter")
    wait_for(page, "state.figure.regions.trunk?.bow === 1 && state.figure.poses.wave === 1")
    page.get_by_label("Body", exact=True).select_option("heavy")
    wait_for(page, "state.figure.bodies.heavy === 1")
    expect(page.get_by_label("Body", exact=True)).to_have_value("heavy")

    page.get_by_label("Body", exact=True).select_option("own")
    page.get_by_label("Where poses are called").select_option("whole")
    page.get_by_label("Search poses by name").fill("")
    page.locator("omote-pose-tiles .tile[data-name='stand']").click()
    wait_for(page, "state.figure === null")
    page.evaluate(f"{DESK}.arrange({{ kind: 'performed' }})")
