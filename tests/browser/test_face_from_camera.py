"""A turn of the head before the webcam: the best picture of each direction is taken, fitted, and plays as a face.

The camera is a film of ours that Chromium plays (`--use-file-for-fake-video-capture`), or a canvas of the test.
"""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, FilePayload, Page, expect

from tests.browser.conftest import KIOSK, PAGES, QUIET, RENDERER
from tests.browser.test_camera import CAMERA
from tests.browser.test_editor import editor, wait_for
from tests.browser.test_face_from_photographs import RECORD
from tests.browser.waiting import PATIENCE, draw_on_demand, wait_until
from tools.browser import find_browser

__all__ = ["editor"]

Editor = Callable[..., Page]
pytestmark = pytest.mark.long

WIDTH = 960
HEIGHT = 720
"""More than the model looks at: what is taken has all of it."""
WANTED = (-40, -20, 0, 20, 40)
BETWEEN = (-30, -10, 10, 30)
TURN = (0, 10, 20, 30, 40, 30, 20, 10, 0, -10, -20, -30, -40, -30, -20, -10)
"""Degrees to the person's own left, over and over."""
MARKS = ["Left", "Half left", "Front", "Half right", "Right"]
KEEP_STREAMS = """(() => {
    const own = MediaDevices.prototype.getUserMedia;
    window.streams = [];
    MediaDevices.prototype.getUserMedia = async function (asked) {
        window.asked = asked;
        const stream = await own.call(this, asked);
        window.streams.push(stream);
        return stream;
    };
})()"""
LIVE = "window.streams.flatMap((stream) => stream.getTracks()).filter((track) => track.readyState === 'live').length"
OWN_CAMERA = """() => {
    const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
    const brush = canvas.getContext("2d");
    let [picture, share, light] = [null, 1, 1];
    setInterval(() => {
        brush.fillRect(0, 0, canvas.width, canvas.height);
        if (picture === null) return;
        brush.filter = `brightness(${light})`;
        const [width, height] = [share * canvas.width, share * canvas.height];
        brush.drawImage(picture, (canvas.width - width) / 2, (canvas.height - height) / 2, width, height);
        brush.filter = "none";
    }, 30);
    window.streams = [];
    navigator.mediaDevices.getUserMedia = async () => {
        window.streams.push(canvas.captureStream());
        return window.streams.at(-1);
    };
    window.showCamera = async (address, size = 1, brightness = 1) => {
        const next = address === null ? null : Object.assign(new Image(), { src: address });
        await next?.decode();
        [picture, share, light] = [next, size, brightness];
    };
}""".replace("WIDTH", str(WIDTH)).replace("HEIGHT", str(HEIGHT))


@pytest.fixture(scope="module")
def stills(browser: Browser, show: str) -> dict[int | str, bytes]:
    """Somebody of the cast in each direction, and with mouth open and eyes shut (JPEG)."""
    page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
    page.goto(f"{show}/stage?quality=low")
    wait_until(page, "stage && stage.counters().drawn > 0", "const stage = window.omoteStage")
    draw_on_demand(page)
    poses: dict[int | str, Any] = {yaw: {"head": [np.radians(yaw), 0.0, 0.0]} for yaw in sorted({*WANTED, *BETWEEN})}
    poses["open"] = {"channels": {"jawOpen": 0.5}}
    poses["shut"] = {"channels": {"eyeBlinkLeft": 1.0, "eyeBlinkRight": 1.0}}
    pictures = {}
    for name, pose in poses.items():
        page.evaluate("pose => window.omoteStage.hold(pose)", {"faces": {"man": 1}, **pose})
        pictures[name] = page.screenshot(type="jpeg", quality=90)
    page.close()
    return pictures


@pytest.fixture(scope="module")
def filmed(
    browser: Browser, stills: dict[int | str, bytes], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Page]:
    """A page of a browser whose camera shows the head as it turns slowly left and right, thirty pictures a second."""
    film = tmp_path_factory.mktemp("film") / "turn.mjpeg"
    film.write_bytes(b"".join((30 if yaw in WANTED else 6) * stills[yaw] for yaw in TURN))
    chromium = browser.browser_type.launch(
        executable_path=str(find_browser()),
        chromium_sandbox=False,
        args=[*RENDERER, *PAGES, *KIOSK, *QUIET, *CAMERA, f"--use-file-for-fake-video-capture={film}"],
    )
    context = chromium.new_context(permissions=["camera"], viewport={"width": 1280, "height": 800})
    context.set_default_timeout(1000 * PATIENCE)
    yield context.new_page()
    chromium.close()


def test_a_turn_before_the_camera_becomes_a_face_that_plays(filmed: Page, show: str) -> None:
    page = filmed
    errors = list[str]()
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.add_init_script(KEEP_STREAMS)
    page.goto(f"{show}/editor")
    wait_for(page, "bench.online && bench.library !== null && canvas !== undefined")
    page.evaluate(RECORD)
    page.get_by_role("tab", name="Faces").click()
    page.get_by_label("A face from the camera").first.click()
    dialog = page.get_by_role("dialog", name="A face from photographs")
    expect(dialog).to_contain_text("Nothing of the camera leaves this browser but the pictures in the rings")
    expect(dialog.get_by_label("Directions").get_by_role("listitem")).to_have_text(MARKS)
    expect(dialog.get_by_role("listitem", name=re.compile("taken")).first).to_be_visible()
    video = page.evaluate("window.asked.video")
    assert (video["width"]["ideal"], video["height"]["ideal"]) >= (1280, 720)

    verdict = page.locator("omote-photographs .verdict")  # all directions are gathered without a hand
    expect(verdict).to_contain_text(re.compile(r"The photographs show \d+ % of the skin"))
    assert page.evaluate(LIVE) == 0, "the camera's light goes off before the fit"
    expect(verdict).not_to_contain_text("No photograph shows")
    expect(verdict).not_to_contain_text("No face was found")
    sent = dict(page.evaluate("window.sent"))
    assert set(sent) == {"1.jpg", "2.jpg", "3.jpg", "4.jpg", "5.jpg", "landmarks.json"}
    photographs = json.loads(sent["landmarks.json"])
    names = ["turned left.png", "turned half left.png", "front.png", "turned half right.png", "turned right.png"]
    assert [(each["name"], each["width"], each["height"]) for each in photographs] == [
        (name, WIDTH, HEIGHT) for name in names
    ]
    noses = [each["points"][4][0] - (each["points"][234][0] + each["points"][454][0]) / 2 for each in photographs]
    assert np.all(np.diff(noses) < -0.01), "from the person's own left, at the right of a picture, to their right"

    expect(page.get_by_label("Name", exact=True)).to_have_value("Face from the camera")
    page.get_by_label("Name", exact=True).fill("Cam")
    dialog.get_by_role("button", name=re.compile("Take it")).click()
    expect(dialog).to_have_count(0)
    page.get_by_role("button", name="Open it here").click()
    expect(page.locator("omote-heading input").first).to_have_value("Cam")
    page.get_by_role("tab", name="History").click()
    expect(page.locator("omote-panels")).to_contain_text("from 5 photographs (")
    assert errors == []


def show_camera(page: Page, picture: bytes | None, share: float = 1.0, light: float = 1.0) -> None:
    """What the camera of the test sees from now on; share: of the picture's size, light: of its light."""
    address = None if picture is None else "data:image/jpeg;base64," + base64.b64encode(picture).decode()
    page.evaluate("([address, share, light]) => window.showCamera(address, share, light)", [address, share, light])


def test_the_page_says_what_is_wrong_and_ends_early_by_touch_and_by_key(
    editor: Editor, stills: dict[int | str, bytes]
) -> None:
    page = editor(disposable=True, width=390, height=844, has_touch=True)
    page.evaluate(OWN_CAMERA)
    show_camera(page, None)
    page.get_by_role("tab", name="Faces").tap()
    page.get_by_label("A face from the camera").first.tap()
    dialog = page.get_by_role("dialog", name="A face from photographs")
    told = page.locator("omote-turn .sentence")
    use = dialog.get_by_role("button", name="Use these")
    expect(told).to_contain_text("It is dark")
    for picture, share, light, sentence in (
        (stills[0], 0.5, 1.0, "Too far: come nearer."),
        (stills[0], 1.0, 0.2, "Too dark."),
        (stills["open"], 1.0, 1.0, "Close your mouth."),
        (stills["shut"], 1.0, 1.0, "Open your eyes."),
    ):
        show_camera(page, picture, share, light)
        expect(told).to_contain_text(sentence)
    expect(use).to_be_disabled()
    expect(dialog.get_by_role("listitem", name=re.compile("wanted"))).to_have_count(len(MARKS))

    page.keyboard.press("Escape")
    expect(dialog).to_have_count(0)
    assert page.evaluate(LIVE) == 0, "the camera's light goes off"

    page.get_by_label("A face from the camera").first.press("Enter")
    for yaw, mark, wish in ((0, "Front", "slowly to your left"), (40, "Left", "slowly to your right")):
        show_camera(page, stills[yaw])
        expect(dialog.get_by_role("listitem", name=f"{mark}: taken", exact=True)).to_be_visible()
        expect(told).to_contain_text(re.compile(wish, re.IGNORECASE))
    expect(dialog.get_by_role("listitem", name=re.compile("wanted"))).to_have_count(3)
    use.tap()
    verdict = page.locator("omote-photographs .verdict")
    expect(verdict).to_contain_text("No photograph shows the head from its left")
    assert page.evaluate(LIVE) == 0
    expect(dialog.get_by_role("button", name=re.compile(r"Photograph \d"))).to_have_count(2)
    dialog.get_by_role("button", name="Throw away").tap()
    page.get_by_role("alertdialog").get_by_role("button", name="Throw away").tap()
    expect(dialog).to_have_count(0)


def test_who_has_no_camera_is_told_what_to_do_and_keys_stay_in_the_dialog(editor: Editor) -> None:
    page = editor()
    page.get_by_role("tab", name="Faces").click()
    page.get_by_label("A face from the camera").first.click()
    dialog = page.get_by_role("dialog", name="A face from photographs")
    trouble = dialog.get_by_role("alert")
    expect(trouble).to_contain_text(re.compile("There is no camera|The browser may not use the camera"))
    expect(trouble.get_by_role("button", name="Try again")).to_be_visible()
    focused = set()
    for _ in range(8):
        page.keyboard.press("Tab")
        focused.add(page.evaluate(FOCUSED))
    assert focused == {"Try again", "A face from photographs", "Cancel"}, "Tab goes round in the dialog"
    wall = FilePayload(name="wall.png", mimeType="image/png", buffer=b"no picture")
    trouble.get_by_label("A face from photographs").set_input_files([wall])  # instead
    expect(dialog.get_by_role("alert")).to_contain_text("wall.png: the file is no picture, but text")
    dialog.get_by_role("button", name="Close").click()
    page.get_by_label("A face from the camera").first.click()
    dialog.get_by_role("button", name="Cancel").click()
    expect(dialog).to_have_count(0)


FOCUSED = """() => {
    let one = document.activeElement;
    while (one?.shadowRoot?.activeElement) one = one.shadowRoot.activeElement;
    return one?.ariaLabel ?? one?.textContent.trim();
}"""
