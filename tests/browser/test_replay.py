"""The replay page, in a real browser: what was on air shows again, where the line of time is pressed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect

import omote
from tests.browser.conftest import playing, replaying
from tests.browser.pictures import picture
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]
PAGE = "document.querySelector('omote-replay-page')"
STAGE = f"{PAGE}.shadowRoot.querySelector('iframe').contentWindow.omoteStage"


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A show that was played: first the dog, marked, then the old man."""
    path = tmp_path_factory.mktemp("replay") / "played.omote"
    for _ in _played(path):
        pass
    return path


def _played(path: Path) -> Iterator[str]:
    for address in playing(path):
        with omote.connect(address, name="ana") as show:
            one = show["one"]
            one.set_motion(liveliness=0.0)
            for face in ("dog", "old"):
                one.call_face(face, seconds=0.0)
                show.mark_moment(face)
                begun = show.wait().time
                while show.wait().time < begun + 2.0:
                    pass
        yield address


@pytest.fixture(scope="module")
def show(recorded: Path) -> Iterator[str]:
    """The address of its replay."""
    yield from replaying(recorded)


def test_what_was_on_air_shows_again_where_the_line_is_pressed(open_page: OpenPage) -> None:
    page = open_page("/replay")
    wait_until(page, f"{PAGE}?.now && {PAGE}.moments.length >= 2 && {STAGE}?.settled()")
    page.keyboard.press("Space")
    wait_until(page, f"!{PAGE}.now.playing")
    line = page.locator(".line")
    box = line.bounding_box()
    assert box is not None
    dog, old = (page.evaluate(f"{PAGE}.moments.find(({{ name }}) => name === '{name}').at") for name in ("dog", "old"))
    seconds = page.evaluate(f"{PAGE}.now.seconds")
    pictures = []
    for at in (dog, old):
        line.click(position={"x": (at + 1.0) / seconds * box["width"], "y": 20.0})
        wait_until(page, f"Math.abs({PAGE}.now.position - {at + 1.0}) < 0.1")
        face = "dog" if at == dog else "old"
        wait_until(page, f"{STAGE}.scene().characters.one.faces.{face} === 1 && {STAGE}.settled()")
        pictures.append(picture(page))
    assert np.abs(pictures[0] - pictures[1]).mean() > 5.0
    page.keyboard.press("Comma")
    wait_until(page, f"Math.abs({PAGE}.now.position - {old}) < 0.1")
    expect(page.locator(".said")).to_contain_text("marked old (ana)")
    page.keyboard.press("i")
    page.keyboard.press("End")
    wait_until(page, f"{PAGE}.now.loop.length === 2")
    page.keyboard.press("Space")
    wait_until(page, f"{PAGE}.now.position < {PAGE}.now.seconds - 0.3 && {PAGE}.now.playing")
    assert page.evaluate(f"{PAGE}.now.different") is None
