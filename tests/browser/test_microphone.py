"""The microphone page in Chromium, whose microphone plays a file: the mouth opens on the vowel, shuts in the pause."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect
from scipy.io import wavfile

from tests.browser.conftest import PAGES, QUIET, playing
from tests.browser.waiting import PATIENCE, wait_until
from tests.inputs.microphone.voices import pause, pcm, vowel
from tools.browser import find_browser

RATE = 48000
SIZES = [(1440, 900), (1024, 768), (390, 844)]
LOSE_THE_CHOICE = """() => {
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function (data) {
        if (!new TextDecoder().decode(data).includes("speak")) return send.call(this, data);
        WebSocket.prototype.send = send;
        this.close();
    };
}"""
STATUS = "document.querySelector('omote-microphone-page').shadowRoot.querySelector('.status')"


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    yield from playing(tmp_path_factory.mktemp("microphone") / "test.omote")


@pytest.fixture(scope="module")
def hearing(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """A browser whose microphone plays a vowel and a pause, for ever."""
    file = tmp_path_factory.mktemp("sound") / "vowel.wav"
    sound = np.concatenate([pause(1.5, rate=RATE), vowel(1.0, rate=RATE), pause(1.5, rate=RATE)])
    wavfile.write(file, RATE, np.frombuffer(pcm(sound), "<i2"))
    fake = ["--use-fake-device-for-media-stream", f"--use-file-for-fake-audio-capture={file}"]
    executable = str(find_browser())
    opened = browser.browser_type.launch(executable_path=executable, args=[*PAGES, *QUIET, *fake, "--disable-gpu"])
    yield opened
    opened.close()


@pytest.fixture
def page(hearing: Browser, address: str) -> Iterator[Page]:
    """The page, at a browser that may hear; what it reports as an error fails the test."""
    context = hearing.new_context(permissions=["microphone"], viewport={"width": 1024, "height": 768})
    opened = context.new_page()
    errors: list[str] = []
    opened.on("pageerror", lambda error: errors.append(str(error)))
    opened.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    opened.goto(f"{address.rstrip('/')}/microphone")
    yield opened
    context.close()
    assert not errors


def start(page: Page) -> None:
    page.get_by_role("button", name="Start the microphone").click()
    expect(page.get_by_role("button", name="Stop")).to_be_visible()


def test_the_mouth_opens_on_the_vowel_and_shuts_in_the_pause(page: Page, address: str, hearing: Browser) -> None:
    start(page)
    console = hearing.new_page()
    console.goto(f"{address.rstrip('/')}/devices")
    store = "document.querySelector('omote-devices-page')?.context.store.state"
    wait_until(console, store)
    jaw = f"({store}.characters.one.channels.jawOpen ?? 0)"
    for _ in range(2):
        wait_until(page, f"{STATUS}.textContent === 'Speaks.'")
        wait_until(console, f"{jaw} > 0.1", told=jaw)
        wait_until(page, f"{STATUS}.textContent === 'Silent.'")
        wait_until(console, f"{jaw} < 0.02", told=jaw)
    assert console.evaluate(f"{store}.characters.one.layers.lips.source") == "Microphone"
    console.close()


def test_mute_and_push_to_talk_send_nothing(page: Page) -> None:
    start(page)
    wait_until(page, f"{STATUS}.textContent === 'Speaks.'")
    page.get_by_role("button", name="Mute").click()
    expect(page.get_by_text("Muted: nothing is sent.")).to_be_visible()
    page.get_by_role("button", name="Mute").click()
    page.get_by_role("radio", name="Push to talk").click()
    expect(page.get_by_text("Hold the button or the space bar, and speak.")).to_be_visible()
    page.keyboard.down("Space")
    wait_until(page, f"{STATUS}.textContent === 'Speaks.'")
    page.keyboard.up("Space")
    expect(page.get_by_text("Hold the button or the space bar, and speak.")).to_be_visible()
    talk = page.get_by_role("button", name="Hold to talk")
    talk.hover()
    page.mouse.down()
    wait_until(page, f"{STATUS}.textContent === 'Speaks.'")
    page.mouse.up()
    page.get_by_role("radio", name="Always open").click()
    page.get_by_role("button", name="Stop").click()
    expect(page.get_by_text("The microphone is off.")).to_be_visible()


def test_a_sentence_measures_the_voice_and_is_remembered(page: Page) -> None:
    start(page)
    wait_until(page, f"{STATUS}.textContent === 'Speaks.'")
    page.get_by_role("button", name="Measure my voice").click()
    expect(page.get_by_role("button", name="Read now")).to_be_visible()
    expect(page.get_by_text("The voice is measured")).to_be_visible(timeout=1000 * PATIENCE)
    page.reload()
    expect(page.get_by_text("Measured.")).to_be_visible()
    page.get_by_role("button", name="Forget it").click()
    expect(page.get_by_text("The measure is forgotten.")).to_be_visible()


def test_the_character_is_chosen_also_while_the_link_is_lost(page: Page) -> None:
    start(page)
    choice = page.locator("[data-field=character]")
    expect(choice).to_have_value("one")
    page.evaluate(LOSE_THE_CHOICE)
    choice.select_option("")
    wait_until(page, f"{STATUS}.textContent.startsWith('Speaks, through nobody')")
    choice.select_option("one")
    wait_until(page, f"{STATUS}.textContent === 'Speaks.'")


def test_a_browser_that_may_not_hear_says_what_to_do(hearing: Browser, address: str) -> None:
    context = hearing.new_context(permissions=[])
    denied = context.new_page()
    denied.goto(f"{address.rstrip('/')}/microphone")
    denied.get_by_role("button", name="Start the microphone").click()
    expect(denied.get_by_text("This page may not use the microphone.")).to_be_visible()
    context.close()


@pytest.mark.parametrize("size", SIZES)
def test_nothing_is_cut_off(page: Page, size: tuple[int, int]) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    expect(page.get_by_role("button", name="Start the microphone")).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
