"""The camera page in a real browser, a film of ours as its camera, under the page's own content security."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import KIOSK, PAGES, QUIET, RENDERER
from tests.browser.waiting import PATIENCE, draw_on_demand, wait_until
from tools.browser import find_browser

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
REST = {"faces": {"man": 1}}
JAW = {"faces": {"man": 1}, "channels": {"jawOpen": 0.9}}
SECONDS = ((REST, 4.0), (JAW, 0.7), (REST, 1.0), (None, 1.5))
"""What the film shows, and how long: mostly a face at rest, so that a start anywhere finds it; at its end nobody."""
CAMERA = "--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"
SESSION = "const session = document.querySelector('omote-camera-page').session; const status = session.status"
TOLD = "[session.trouble, session.model, session.notice, session.health, session.status]"


@pytest.fixture(scope="module")
def film(browser: Browser, show: str, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A film of ours: thirty pictures a second of what a stage draws, as motion JPEG."""
    page = browser.new_page(viewport={"width": 480, "height": 360})
    page.goto(f"{show}/stage?quality=low")
    wait_until(page, "stage && stage.counters().drawn > 0", "const stage = window.omoteStage")
    draw_on_demand(page)
    pictures = b""
    for pose, seconds in SECONDS:
        if pose is None:
            page.goto("about:blank")
        else:
            page.evaluate("pose => window.omoteStage.hold(pose)", pose)
        pictures += round(30 * seconds) * page.screenshot(type="jpeg", quality=85)
    page.close()
    path = tmp_path_factory.mktemp("film") / "face.mjpeg"
    path.write_bytes(pictures)
    return path


@pytest.fixture(scope="module")
def filmed(browser: Browser, film: Path) -> Iterator[Browser]:
    """A browser whose camera shows the film."""
    camera = f"--use-file-for-fake-video-capture={film}"
    chromium = browser.browser_type.launch(
        executable_path=str(find_browser()),
        chromium_sandbox=False,
        args=[*RENDERER, *PAGES, *KIOSK, *QUIET, *CAMERA, camera],
    )
    yield chromium
    chromium.close()


def open_filmed(filmed: Browser) -> Page:
    """A page of that browser, which may use the camera."""
    context = filmed.new_context(permissions=["camera"])
    context.set_default_timeout(1000 * PATIENCE)
    return context.new_page()


def wait_for(page: Page, condition: str) -> None:
    """Waits until a condition on the page's session and the show's status holds."""
    wait_until(page, condition, SESSION, TOLD)


def test_a_face_before_the_camera_moves_a_face_on_the_stage(filmed: Browser, show: str, open_page: OpenPage) -> None:
    page = open_filmed(filmed)
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("console", lambda message: errors.append(message.text) if "Content Security" in message.text else None)
    page.goto(f"{show}/camera")
    page.get_by_role("combobox", name="Performer").fill("Ada")
    page.keyboard.press("Enter")
    wait_for(page, "status?.performer === 'Ada' && session.model.kind === 'ready'")
    wait_for(page, "status.calibrated === 'rest' && 'jawOpen' in status.weights")  # it is a source from now on
    one = page.get_by_role("region", name="Characters").get_by_role("button").first
    if one.get_attribute("aria-pressed") != "true":
        one.click()
    expect(one).to_have_attribute("aria-pressed", "true")
    stage = open_page("/stage?quality=lowest", width=160, height=120)
    jaw = "const jaw = window.omoteStage?.pose()?.channels.jawOpen ?? 0"
    wait_until(stage, "jaw > 0.25", jaw, "jaw")
    wait_until(stage, "jaw < 0.12", jaw, "jaw")
    wait_for(page, "!status.found && session.health.some(({ what }) => what === 'No face')")
    wait_for(page, "status.found && session.health.some(({ what }) => what === 'Face found')")
    assert errors == []
    page.context.close()


def test_the_guided_minute_begins_shows_its_step_and_is_cancelled_by_a_key(filmed: Browser, show: str) -> None:
    page = open_filmed(filmed)
    page.goto(f"{show}/camera")
    name = page.get_by_role("combobox", name="Performer")
    assert name.input_value() != "", "a name that comes later gets into what is typed"
    name.fill("Bo")
    page.keyboard.press("Enter")
    wait_for(page, "status?.performer === 'Bo' && status.calibrated === 'rest'")
    page.get_by_role("button", name="Guided minute").press("Enter")
    guide = page.locator("omote-guide")
    expect(guide).to_contain_text("Look straight ahead")
    expect(guide).to_contain_text("1 of 15")
    page.keyboard.press("Escape")  # before a face is made
    expect(page.locator("omote-camera-page")).to_contain_text("The guided minute is stopped: no face was made")
    page.get_by_role("button", name="Guided minute").click()
    expect(page.locator("omote-camera-page")).not_to_contain_text("The guided minute is stopped")
    wait_for(page, "status.guide?.step === 'shut'")
    guide.get_by_role("button", name="The last one again").click()
    wait_for(page, "status.guide?.step === 'neutral'")
    page.keyboard.press("Escape")
    wait_for(page, "status.guide === null && status.calibrated === 'rest'")
    expect(guide).to_contain_text("1 of 15 faces made")
    guide.get_by_role("button", name="Go on at 2").click()
    wait_for(page, "status.guide?.step === 'shut'")
    guide.get_by_role("button", name="Stop").click()
    page.get_by_role("combobox", name="Performer").fill("Bea")
    page.get_by_role("button", name="Rename Bo to Bea").click()
    wait_for(page, "status.performer === 'Bea' && status.unused && !status.performers.includes('Bo')")
    page.get_by_role("button", name="Undo").click()
    wait_for(page, "status.performer === 'Bo' && status.unused")
    page.get_by_role("button", name="Forget this face").click()
    wait_for(page, "status.calibrated === 'no' && !status.performers.includes('Bo')")
    page.get_by_role("button", name="Undo").click()
    wait_for(page, "status.calibrated === 'rest' && status.performers.includes('Bo')")
    page.context.close()


def test_a_page_that_may_not_use_the_camera_says_what_to_do(open_page: OpenPage) -> None:
    page = open_page("/camera", disposable=True)
    expect(page.get_by_role("alert").filter(has_text="camera")).to_contain_text("Try again")
    assert page.evaluate("document.querySelector('omote-camera-page').session.trouble.title") in (
        "The browser may not use the camera",
        "There is no camera",  # a machine that has none says so first
    )
    expect(page.get_by_role("status").filter(has_text="No camera")).to_be_visible()
    for name in ("Guided minute", "At rest now"):
        expect(page.get_by_role("button", name=name)).to_be_disabled()
    expect(page.get_by_role("list", name="Health")).not_to_contain_text("ms")
