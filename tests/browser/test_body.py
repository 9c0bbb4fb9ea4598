"""A body before the camera page in a real browser: found in a worker, read by the show, worn by a figure, lost."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from io import BytesIO

import pytest
from PIL import Image
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import KIOSK, PAGES, QUIET, RENDERER
from tests.browser.waiting import PATIENCE, wait_until
from tools.browser import ROOT, find_browser

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
CAMERA = "--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"
SESSION = "const session = document.querySelector('omote-camera-page').session; const { status, body } = session"
TOLD = "[session.trouble, body.model, body.seen, session.notice, status]"


@pytest.fixture(scope="module")
def filmed(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """A browser whose camera shows one who waves, and now and then nobody."""
    body = (ROOT / "web" / "src" / "body" / "warm_up_body.jpg").read_bytes()
    empty = BytesIO()
    Image.new("RGB", (640, 480), (136, 140, 144)).save(empty, "JPEG")
    film = tmp_path_factory.mktemp("film") / "body.mjpeg"
    film.write_bytes(150 * body + 60 * empty.getvalue())
    chromium = browser.browser_type.launch(
        executable_path=str(find_browser()),
        chromium_sandbox=False,
        args=[*RENDERER, *PAGES, *KIOSK, *QUIET, *CAMERA, f"--use-file-for-fake-video-capture={film}"],
    )
    yield chromium
    chromium.close()


def test_a_body_before_the_camera_lifts_the_arm_of_a_figure(filmed: Browser, show: str) -> None:
    context = filmed.new_context(permissions=["camera"])
    context.set_default_timeout(1000 * PATIENCE)
    page = context.new_page()
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda message: wrong.append(message.text) if "Content Security" in message.text else None)
    page.on("request", lambda request: None if request.url.startswith((show, "blob:")) else wrong.append(request.url))
    kept = {"omote.camera.tracked": "body", "omote.performer": "Beda"}
    page.add_init_script(f"Object.assign(localStorage, {json.dumps(kept)})")
    page.goto(f"{show}/camera")

    def wait_for(condition: str) -> None:
        wait_until(page, condition, SESSION, TOLD)

    wait_for("body.model?.kind === 'ready' && status?.body.heard > 0")
    wait_for("status.body.known && status.body.shares.arm_right > 0.9")
    plays = page.get_by_role("region", name="Body plays").get_by_role("button").first
    if plays.get_attribute("aria-pressed") != "true":
        plays.click()
    expect(plays).to_have_attribute("aria-pressed", "true")
    wait_for("!(status.body.shares.arm_right > 0.1)")
    wait_for("status.body.shares.arm_right > 0.9")
    page.get_by_role("button", name="Face", exact=True).click()
    switch = page.get_by_role("switch", name="Body too")
    expect(switch).not_to_be_checked()
    assert page.get_by_role("region", name="Body", exact=True).count() == 0
    switch.check()
    wait_for("body.model !== null && session.tracksBody && session.tracksFace")
    assert wrong == []
    context.close()
