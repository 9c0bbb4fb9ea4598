"""A hand before the camera page in a real browser: found in a worker, read as it was calibrated, on the stage, lost."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import KIOSK, PAGES, QUIET, RENDERER
from tests.browser.waiting import PATIENCE, wait_until
from tools.browser import ROOT, find_browser

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
CAMERA = "--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"
SESSION = "const session = document.querySelector('omote-camera-page').session; const { status, hand } = session"
TOLD = "[session.trouble, hand.model, hand.reading, session.notice, status]"
NUMBERS = 132
"""That the map of a hand reads: of its shape, and its turns."""


def flat(*offsets: float) -> dict[str, object]:
    """A map that reads the same of every hand."""
    zeros = [0.0] * NUMBERS
    nothing = [[0.0]] * len(offsets)
    return {"means": zeros, "scales": zeros, "supports": [zeros], "offsets": offsets, "weights": nothing}


PALM = [1, 0, 0, 0, 1, 0, 0, 0, 1]
CALIBRATION = {
    "version": 2, "made": 0, "camera": "", "side": "right", "place": [0.4, 0.5], "delay": 0.2, "palms": [PALM, PALM],
    "map": flat(0.6, -0.5, 0.0, 0.0, 0.0, 0.0), "fit": [1.0] * 6, "rate": 20.0,
}  # fmt: skip
"""A mouth open by .6 and brows half up, whatever the hand does: how hands are read is tested without a browser."""


@pytest.fixture(scope="module")
def filmed(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """A browser whose camera shows the hand that the model warms up with, and now and then nobody."""
    hand = (ROOT / "web" / "src" / "hands" / "warm_up_hand.jpg").read_bytes()
    empty = BytesIO()
    Image.new("RGB", (640, 480), (90, 90, 110)).save(empty, "JPEG")
    film = tmp_path_factory.mktemp("film") / "hand.mjpeg"
    film.write_bytes(180 * hand + 90 * empty.getvalue())
    chromium = browser.browser_type.launch(
        executable_path=str(find_browser()),
        chromium_sandbox=False,
        args=[*RENDERER, *PAGES, *KIOSK, *QUIET, *CAMERA, f"--use-file-for-fake-video-capture={film}"],
    )
    yield chromium
    chromium.close()


def test_a_hand_before_the_camera_plays_a_face_and_is_lost_and_found(
    filmed: Browser, show: str, open_page: OpenPage
) -> None:
    context = filmed.new_context(permissions=["camera"])
    context.set_default_timeout(1000 * PATIENCE)
    page = context.new_page()
    wrong: list[str] = []
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda message: wrong.append(message.text) if "Content Security" in message.text else None)
    page.on("request", lambda request: None if request.url.startswith((show, "blob:")) else wrong.append(request.url))
    kept = {"omote.camera.tracked": "hand", "omote.performer": "Hana", "omote.hand.calibration.Hana": CALIBRATION}
    texts = {name: value if isinstance(value, str) else json.dumps(value) for name, value in kept.items()}
    page.add_init_script(f"Object.assign(localStorage, {json.dumps(texts)})")
    page.goto(f"{show}/camera")

    def wait_for(condition: str) -> None:
        wait_until(page, condition, SESSION, TOLD)

    wait_for("hand.model?.kind === 'ready' && status?.hand.heard > 0")
    panel = page.locator("omote-hand")
    expect(panel).to_contain_text("your right hand, 200 ms behind the drawn one")
    expect(panel).to_contain_text("days old")
    one = panel.get_by_role("region", name="Hand plays").get_by_role("button").first
    if one.get_attribute("aria-pressed") != "true":
        one.click()
    expect(one).to_have_attribute("aria-pressed", "true")
    stage = open_page("/stage?quality=lowest", width=160, height=120)
    shown = "const shown = window.omoteStage?.pose()?.channels ?? {}"
    wait_until(stage, "shown.jawOpen > 0.55 && shown.browInnerUp > 0.4", shown, "shown")
    wait_until(stage, "!(shown.jawOpen > 0.1)", shown, "shown")
    wait_until(stage, "shown.jawOpen > 0.55", shown, "shown")
    page.get_by_role("combobox", name="Takes").select_option(label="head alone")
    wait_until(stage, "!(shown.jawOpen > 0.05)", shown, "shown")
    panel.get_by_role("button", name="Guided minute again").click()
    guide = page.get_by_role("region", name="Guided minute of the hand")
    expect(guide).to_contain_text("Hand in profile, thumb against fingers")
    page.keyboard.press("Escape")
    expect(guide).to_be_hidden()
    assert wrong == []
    context.close()


def test_on_a_phone_the_guide_is_seen_and_a_film_of_it_is_saved_after_consent(
    filmed: Browser, show: str, tmp_path: Path
) -> None:
    context = filmed.new_context(permissions=["camera"], viewport={"width": 390, "height": 844}, has_touch=True)
    context.set_default_timeout(1000 * PATIENCE)
    page = context.new_page()
    page.add_init_script("localStorage['omote.camera.tracked'] = 'hand'")
    page.goto(f"{show}/camera")
    wait_until(page, "hand.reading !== null", SESSION, TOLD)
    film = page.get_by_role("region", name="Film", exact=True)
    film.get_by_role("button", name="Save a film").tap()
    expect(film).to_contain_text("Omote sends it to nobody")
    with page.expect_download() as saved:
        film.get_by_role("button", name="We agree").tap()
        expect(film).to_contain_text("is being taken")
        page.get_by_role("button", name="Guided minute of the hand").tap()
        film.get_by_role("button", name="End it and save").dispatch_event("click")  # a tap would scroll to it
    expect(page.get_by_role("region", name="Guided minute of the hand")).to_be_in_viewport(ratio=1)
    expect(page.locator("video")).to_be_in_viewport(ratio=1)
    name = saved.value.suggested_filename
    assert re.fullmatch(r"omote-hand-[\dT-]+-minute-at-[\d.]+s\.webm", name)
    expect(film).to_contain_text(name)
    saved.value.save_as(tmp_path / name)
    assert (tmp_path / name).read_bytes()[:4] == b"\x1a\x45\xdf\xa3"
    context.close()
