"""Photographs dropped on the editor: a face is found in each, fitted, corrected by a handle, taken, and played."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import FilePayload, Locator, Page, expect

from tests.browser.test_console import console
from tests.browser.test_editor import editor
from tests.browser.test_face_from_scan import drop, views
from tests.interchange.scans.scan_samples import HEIC
from tools.photographs.photographer import photograph
from tools.photographs.sculpted_people import model_of, random_sculpted
from tools.photographs.views import camera_at
from tools.tracking.picture import random_setting

__all__ = ["console", "editor"]

Editor = Callable[..., Page]
pytestmark = pytest.mark.long

SIDE = 480
MAKER = 271
"""The field of EXIF that names who made the camera."""
SECRET = "the maker of a camera"
RECORD = """() => {
    const own = window.fetch;
    window.sent = [];
    window.fetch = async (address, options) => {
        const files = options?.body instanceof FormData ? options.body.getAll("file") : [];
        for (const file of files) window.sent.push([file.name, await file.text()]);
        return own(address, options);
    };
}"""


@cache
def portrait(yaw: float) -> bytes:
    """Somebody whom nobody knows, turned by an angle (JPEG, with what cameras write into their files)."""
    draw = np.random.default_rng(11)
    person = random_sculpted(draw, 1.0)
    camera = camera_at(draw, yaw, 0.0, 0.0, 1.6, SIDE)
    pixels, _ = photograph(camera, model_of(person, {}, (0.0, 0.0)), random_setting(draw), draw)
    exif = Image.Exif()
    exif[MAKER] = SECRET
    return jpeg(pixels, exif=exif)


def jpeg(pixels: np.ndarray, **options: object) -> bytes:
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=92, **options)
    return file.getvalue()


def wall() -> bytes:
    """A photograph of nobody."""
    return jpeg(np.full((SIDE, SIDE, 3), 140, np.uint8))


def payload(name: str, data: bytes) -> FilePayload:
    return FilePayload(name=name, mimeType="image/jpeg", buffer=data)


def choose(page: Page, *files: FilePayload) -> None:
    """Chooses photographs by the button among the faces."""
    page.get_by_role("tab", name="Faces").click()
    page.get_by_label("A face from photographs").first.set_input_files(list(files))


def test_photographs_become_a_face_that_is_corrected_taken_and_plays(editor: Editor, console: Editor) -> None:
    page = editor()
    page.evaluate(RECORD)
    assert SECRET.encode() in portrait(0.0)
    files = {"anna front.jpg": portrait(0.0), "wall.jpg": wall(), "anna side.jpg": portrait(0.6)}
    choose(page, *(payload(name, data) for name, data in files.items()))
    dialog = page.get_by_role("dialog", name="A face from photographs")
    expect(dialog.get_by_role("progressbar")).to_be_visible()
    verdict = page.locator("omote-photographs .verdict")
    expect(verdict).to_contain_text(re.compile(r"The photographs show \d+ % of the skin"))
    expect(verdict).to_contain_text("No face was found in wall.jpg: it is left out.")
    expect(verdict).to_contain_text("No photograph shows the head from its")

    photographed = views(page)
    page.get_by_label("From the photographs to the plain face").fill("1")
    assert np.abs(views(page) - photographed).max() > 40, "colours of the photographs, and then none"
    page.get_by_role("button", name="Seen", exact=True).click()
    seen = views(page)
    assert 0.2 < (seen[..., 2] > seen[..., 0] + 15)[seen.max(axis=2) > 40].mean() < 0.98, "blue is seen, grey is not"

    page.get_by_role("button", name="Photograph 1").click()
    sent = dict(page.evaluate("window.sent"))
    assert set(sent) == {"1.jpg", "3.jpg", "landmarks.json"}, "what has no face stays on the desk"
    assert not any(SECRET in text for text in sent.values()), "what is sent has no metadata"
    nose = page.get_by_role("button", name="Tip of the nose")
    before = centre(nose)
    chin = centre(page.get_by_role("button", name="Chin"))
    page.mouse.move(*before)
    page.mouse.down()
    page.mouse.move(before[0] + 12, before[1] + 4, steps=3)
    page.mouse.up()
    moved = centre(nose)
    assert np.allclose(np.subtract(moved, before), [12, 4], atol=1.5)
    assert np.allclose(centre(page.get_by_role("button", name="Chin")), chin, atol=0.1)
    page.keyboard.press("Shift+ArrowLeft")
    assert np.allclose(np.subtract(centre(nose), moved), [-10, 0], atol=1.5)
    before = centre(nose)
    touch(page, before, (before[0] - 8, before[1] + 8))
    assert np.allclose(np.subtract(centre(nose), before), [-8, 8], atol=1.5), "a finger moves it too"
    expect(dialog.get_by_role("button", name=re.compile("Take it"))).to_be_disabled()
    dialog.get_by_role("button", name="Undo").click()
    dialog.get_by_role("button", name="Fit again").click()
    expect(dialog.get_by_role("button", name="Fit again")).to_have_count(0)
    expect(dialog.get_by_role("button", name=re.compile("Take it"))).to_be_enabled()

    page.keyboard.press("Escape")
    expect(dialog).to_contain_text("Throw the photographs and their points away?")
    dialog.get_by_role("button", name="Keep looking").click()
    page.get_by_label("Name", exact=True).fill("Anna P")
    dialog.get_by_role("button", name=re.compile("Take it")).click()
    expect(dialog).to_have_count(0)
    page.get_by_role("button", name="Open it here").click()
    expect(page.locator("omote-heading input").first).to_have_value("Anna P")
    page.get_by_role("tab", name="History").click()
    expect(page.locator("omote-panels")).to_contain_text("from 2 photographs (anna front.jpg, anna side.jpg); ")
    expect(console().locator("omote-palette .tile[data-name='anna_p']")).to_be_visible()


def touch(page: Page, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Draws a finger over the page."""
    tools = page.context.new_cdp_session(page)
    for kind, points in (("touchStart", [start]), ("touchMove", [end]), ("touchEnd", [])):
        places = [{"x": x, "y": y} for x, y in points]
        tools.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})
    tools.detach()


def centre(handle: Locator) -> tuple[float, float]:
    """The middle of a handle, pixels of the page."""
    box = handle.locator("path").last.bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def test_one_photograph_says_what_it_cannot_know_and_none_with_a_face_is_said(editor: Editor) -> None:
    page = editor()
    dialog = page.get_by_role("dialog", name="A face from photographs")
    choose(page, payload("wall.jpg", wall()))
    expect(dialog.get_by_role("alert")).to_contain_text("No face was found in wall.jpg")
    dialog.get_by_role("button", name="Close").click()
    drop(page, "dusk.heic", HEIC)  # the picture of every telephone is read, and looked through
    expect(dialog.get_by_role("alert")).to_contain_text("No face was found in dusk.heic")
    dialog.get_by_role("button", name="Close").click()
    choose(page, payload("words.jpg", b"words"))
    expect(dialog.get_by_role("alert")).to_contain_text("words.jpg: the file is no picture, but text")
    dialog.get_by_role("button", name="Close").click()
    choose(page, payload("anna.jpg", portrait(0.0)))
    page.keyboard.press("Escape")  # while it is looked at
    expect(dialog).to_have_count(0)
    choose(page, *(payload(f"{number}.jpg", b"") for number in range(9)))
    expect(dialog.get_by_role("alert")).to_contain_text("9 pictures came; bring at most 8 of one person.")
    dialog.get_by_role("button", name="Close").click()
    choose(page, payload("anna.jpg", portrait(0.0)))
    verdict = page.locator("omote-photographs .verdict")
    expect(verdict).to_contain_text("it cannot know the profile")
    expect(verdict).to_contain_text("One photograph shows how wide and tall a face is")
    dialog.get_by_role("button", name="Throw away").click()
    page.get_by_role("alertdialog").get_by_role("button", name="Throw away").click()
    expect(dialog).to_have_count(0)
