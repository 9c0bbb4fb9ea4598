"""Devices at a browser: MIDI (a fake of the standard's interface) and gamepads, from the hand to the picture."""

from __future__ import annotations

import socket
from collections.abc import Callable

import numpy as np
from playwright.sync_api import Locator, Page, expect

from tests.browser.browser_devices import DEVICE_STORE, TURN, connect
from tests.browser.console_at_rest import DESK, wait_for
from tests.browser.pictures import picture
from tests.browser.test_console import TWO_FRAMES
from tests.browser.waiting import wait_until
from tests.inputs.trackers.packets import live_link_face

OpenPage = Callable[..., Page]

BINDINGS = f"{DEVICE_STORE}.bindings"
SHOWN_LEFT = "(each) => (each.isConnected && !each.hidden ? each.getBoundingClientRect().left : null)"


def bound(page: Page, count: int) -> None:
    """Waits until so many controls are bound to the first character; presets bind pads to all."""
    learned = f"{BINDINGS}.filter(({{ to }}) => to.startsWith('/omote/one/'))"
    wait_until(page, f"{learned}.length === {count}", told=learned)


def test_a_tracker_is_switched_on_heard_and_off_again(open_page: OpenPage) -> None:
    """What is typed for a phone stands at the page, and its picture; what a receiver hears is counted."""
    page = open_page("/devices", pictures=False)
    trackers = page.locator("omote-trackers")
    receivers = page.locator("omote-receivers")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as phone:
        phone.bind(("127.0.0.1", 0))
        phone.settimeout(20.0)
        free = phone.getsockname()[1]
        trackers.get_by_label("Tracker").select_option("livelink")
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
        trackers.get_by_label("Port").fill(str(port))
        trackers.get_by_role("button", name="Switch on").click()
        expect(trackers.locator("[data-tracker=livelink]")).to_contain_text(f"port {port}")
        expect(trackers.locator(".alone")).to_contain_text("listens on this machine alone")
        expect(trackers.get_by_role("img", name="QR code")).to_have_count(0)
        phone.sendto(live_link_face([0.5] * 61), ("127.0.0.1", port))
        source = page.locator("omote-sources [data-device='Live Link Face']")
        expect(source).to_contain_text("1 heard")
        mixer = open_page("/console", pictures=False)
        wait_for(mixer, "desk.online && desk.faces.length > 0")
        mixer.keyboard.press(";")
        settings = mixer.locator("omote-source-settings", has_text="Live Link Face")
        one = settings.locator("[data-drives=one]")
        part = settings.locator("[data-part=mouth]")
        marks = mixer.get_by_role("img", name="1 source plays nobody")
        expect(part).to_have_attribute("aria-pressed", "true")
        expect(marks).to_have_count(0)
        one.click()
        expect(part).to_have_attribute("aria-pressed", "false")
        expect(part).to_be_disabled()
        expect(marks).to_have_count(1)
        one.click()
        expect(part).to_be_enabled()
        expect(marks).to_have_count(0)
        receivers.get_by_label("Way").select_option("livelink")
        receivers.get_by_label("Address of the program").fill("127.0.0.1")
        receivers.get_by_label("Port").fill(str(free))
        receivers.get_by_role("button", name="Send").click()
        assert phone.recv(2000).startswith(b"\x06")
        receivers.locator("li").get_by_role("button", name="Stop").click()
        expect(receivers.locator("li")).to_have_count(0)
    trackers.locator("[data-off=livelink]").click()
    expect(trackers.locator("[data-tracker=livelink]")).to_have_count(0)


def spot(page: Page, name: str) -> Locator:
    """What marks a control of the page that can be bound."""
    return page.get_by_role("button", name=f"Learn {name}").first


def lean(page: Page, *values: float) -> None:
    """The stick of the pad goes through these places, each of which the page sees."""
    for value in values:
        page.evaluate("(value) => { pad.axes[0] = value; }", value)
        page.evaluate(TWO_FRAMES)


def test_what_is_learned_by_touch_plays_to_the_picture_and_waits_for_its_device(
    open_with_devices: Callable[..., Page], open_page: OpenPage
) -> None:
    page = open_with_devices("/console")
    page.evaluate(f"{DESK}.arrange({{ tab: 'jaw', kind: 'performed' }})")
    connect(page)
    page.keyboard.press("z")
    page.locator(".spot[data-to='/omote/one/channel/jawOpen']").click()
    page.evaluate(TURN, [100, 110, 120])
    bound(page, 1)
    spot(page, "expression Joy").click()
    page.evaluate("dial.emit([0x90, 60, 100, 0x80, 60, 0])")
    bound(page, 2)
    page.keyboard.press("Escape")
    expect(page.locator("omote-learn-mode")).to_have_count(0)
    chip = page.locator("omote-binding-marks .chip").get_by_text("cc7", exact=True)
    expect(chip).to_have_class("chip")

    stage = open_page("/stage", width=320, height=180)
    wait_until(stage, "window.omoteStage?.settled()")
    shut = picture(stage)
    page.evaluate(TURN, [0, 127])  # across the value on air, which picks it up
    wait_for(page, "state.channels.jawOpen === 1")
    wait_until(stage, "window.omoteStage.scene().characters.one.channels.jawOpen === 1 && window.omoteStage.settled()")
    assert np.abs(picture(stage) - shut).max() > 50
    stage.goto("about:blank")
    page.evaluate("dial.emit([0x90, 60, 100])")
    wait_for(page, "state.expression_call?.target === 'joy' || state.expressions.joy === 1")

    page.evaluate("dial.disconnect(); other.connect()")
    expect(chip).to_have_class("chip gone")
    page.evaluate("for (const value of [127, 0, 64]) other.emit([0xb0, 7, value])")  # another's: it plays nothing
    page.evaluate("dial.connect()")
    expect(chip).to_have_class("chip")
    page.evaluate(TURN, [127, 64])  # it waited: at the value on air it is picked up again
    wait_for(page, "Math.abs(state.channels.jawOpen - 64 / 127) < 1e-6")

    page.evaluate("pads[0] = pad")
    page.evaluate(TWO_FRAMES)
    page.keyboard.press("z")
    spot(page, "head yaw of One").click()
    lean(page, 0.3, 0.6, 0.9)
    bound(page, 3)
    lean(page, 1.0)
    wait_for(page, "Math.abs(state.head[0]) > 0.5")
    page.evaluate(f"for (let step = 0; step < 4; step += 1) {DESK}.undo()")  # the preset of the pad is one
    bound(page, 0)


def test_the_devices_page_shows_edits_and_takes_back(open_with_devices: Callable[..., Page]) -> None:
    page = open_with_devices("/devices", width=390, height=844)
    connect(page)
    source = page.locator("article[data-device='Dial']")
    page.evaluate(TURN, [127])
    bar = source.locator(".bar[data-control='1/cc7']")
    expect(bar.locator("i")).to_have_css("transform", "matrix(1, 0, 0, 1, 0, 0)")
    expect(page.locator("omote-input-lines li").first).to_contain_text("1/cc7")

    bar.click()
    page.locator("input[name=to]").fill("/omote/one/nonsense")
    page.get_by_role("button", name="Bind", exact=True).click()
    expect(page.get_by_role("status")).to_contain_text("nonsense")
    bar.click()
    page.locator("input[name=to]").fill("/omote/one/channel/jawOpen")
    page.get_by_label("High").fill("0.5")
    page.get_by_role("button", name="Bind", exact=True).click()
    row = page.locator("tr[data-binding='Dial|1/cc7']")
    expect(row).to_contain_text("0.5")
    row.get_by_role("button", name="Edit").click()
    page.get_by_label("Curve").fill("2")
    page.locator("omote-binding-form").get_by_role("button", name="Keep").click()
    expect(row.locator("[data-says=curve]")).to_have_text("2")
    row.get_by_role("button", name="Delete").click()
    expect(row).to_have_count(0)
    page.keyboard.press("Control+z")
    expect(row.locator("[data-says=curve]")).to_have_text("2")
    page.keyboard.press("Control+z")
    expect(row.locator("[data-says=curve]")).to_have_text("1")
    page.keyboard.press("Control+z")
    expect(row).to_have_count(0)
    for width, height in ((390, 844), (768, 1024), (1024, 768), (1440, 900)):
        page.set_viewport_size({"width": width, "height": height})
        assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_the_name_of_a_dial_covers_none_of_the_degrees_of_a_pad(open_with_devices: Callable[..., Page]) -> None:
    page = open_with_devices("/console")
    page.evaluate("dial.connect()")
    page.keyboard.press("z")
    spot(page, "head yaw of One").click()
    page.evaluate(TURN, [60, 80, 120])
    bound(page, 1)
    page.keyboard.press("Escape")
    chip = page.locator("omote-binding-marks .chip").get_by_text("cc7", exact=True)
    degrees = page.locator(".hands omote-pad .read").first.evaluate("(each) => each.getBoundingClientRect().right")
    while (left := chip.evaluate(SHOWN_LEFT)) is None:  # marks are made anew as their controls are searched again
        pass
    assert left >= degrees
    page.evaluate(f"{DESK}.undo()")
    bound(page, 0)
