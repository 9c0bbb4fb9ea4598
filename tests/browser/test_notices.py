"""What the crew must know stands on consoles and editors until each has dismissed it: after a real `kill -9` too."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from omote.showfile.backup import back_up
from omote.showfile.changes import StoredDocument
from omote.showfile.show_file import open_show
from tests.browser.conftest import playing
from tests.browser.test_console import TWO_FRAMES
from tests.browser.waiting import wait_until

OpenPage = Callable[..., Page]
PLAYED = (
    "omote-palette, omote-tbar, omote-lights, omote-memories, omote-pad, omote-bank, omote-mix, .views, omote-monitor"
)
"""What is played on, and the picture."""
STORE = "document.querySelector('omote-console')?.context.store"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A show file whose first page is lost, with a whole backup beside it."""
    path = tmp_path_factory.mktemp("notices") / "premiere.omote"
    show = open_show(path)
    show.apply([StoredDocument("layout", "console-2", b"{}")])
    back_up(show)
    show.close()
    path.write_bytes(bytes(4096) + path.read_bytes()[4096:])
    return path


@pytest.fixture(scope="module")
def show(file: Path) -> Iterator[str]:
    """A show of this module alone, for its process is killed."""
    yield from playing(file)


def notice(page: Page) -> Locator:
    """The notice that a page shows: the newest, with how many more there are."""
    return page.locator("omote-show-notices [role=alert]")


def opened(page: Page) -> Page:
    """A console that has heard from the show."""
    wait_until(page, f"{STORE}?.online && {STORE}.state !== null && {STORE}.faces.length > 0")
    return page


def process_of(file: Path) -> int:
    """The process id of the server that plays: the child of its standby, which is named by the show file."""
    named = set[int]()
    parents = dict[int, int]()
    for entry in Path("/proc").iterdir():
        if not entry.name.isdecimal():
            continue
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
            parents[int(entry.name)] = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
        except OSError:  # it has ended meanwhile
            continue
        if str(file).encode() in words and b"--line" in words:  # to its supervisor
            named.add(int(entry.name))
    standbys = {pid for pid in named if parents[pid] not in named}  # and the copy of it, which has no children
    return max(pid for pid in named if parents[pid] in standbys)


def test_a_recovered_file_and_a_killed_process_are_told_until_they_are_dismissed(
    open_page: OpenPage, file: Path
) -> None:
    def open_young(path: str, **options: Any) -> Page:
        """Opens a page for which no notice is old, however slowly it loads: an old one comes to a page once."""
        page = open_page("/", disposable=True, **options)
        page.add_init_script("Date.now = () => 0;")
        page.goto(page.url + path)
        return page

    page = opened(open_young("console", width=1440, height=900))
    other = opened(open_young("console", pictures=False))
    damaged = f"{file} is damaged: its beginning is lost or overwritten. It is kept as {file}.corrupt-1; opened "
    expect(notice(page)).to_contain_text(damaged + "instead: its good copy of ")
    expect(notice(page).locator("small")).to_have_count(0)

    call = f"if ({STORE}.air.expression_call === null) {STORE}.call('expression', 'smile'); {STORE}.flush()"
    wait_until(page, f"{STORE}.air.expressions.smile === 1", given=call)  # again where the link was lost meanwhile
    epoch = page.evaluate(f"{STORE}.state.epoch")
    os.kill(process_of(file), signal.SIGKILL)
    wait_until(page, f"{STORE}.online && {epoch} < {STORE}.state.epoch && {STORE}.air.expressions.smile === 1")
    expect(notice(page)).to_contain_text("The show's process ended at ")
    expect(notice(page)).to_contain_text("what was on air went on.")
    expect(notice(page).locator("small")).to_have_text("1 more")

    page.reload()
    opened(page)
    expect(notice(page).locator("small")).to_have_text("1 more")
    page.keyboard.press("?")
    page.keyboard.press("Escape")  # closes help and nothing else
    expect(notice(page).locator("small")).to_have_text("1 more")
    notice(page).get_by_role("button", name="1 more").click()  # opens the log, where both have been read then
    log = page.locator("omote-message-log")
    expect(log).to_contain_text(damaged)
    expect(log).to_contain_text("The show's process ended at ")
    page.keyboard.press("Escape")
    expect(notice(page)).to_have_count(0)
    page.get_by_role("button", name="Log").click()
    expect(log).to_contain_text(damaged)
    page.keyboard.press("Escape")
    page.reload()
    opened(page)
    wait_until(page, f"{STORE}.crew !== null")  # it came after the notices
    expect(notice(page)).to_have_count(0)

    expect(notice(other).locator("small")).to_have_text("1 more")  # somebody else has not read them
    expect(notice(open_young("editor")).locator("small")).to_have_text("1 more")


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1280, 800), (1100, 700), (1024, 768), (390, 844)])
def test_a_notice_is_whole_beside_the_picture_on_every_screen_and_can_be_dismissed_by_a_finger(
    open_page: OpenPage, width: int, height: int
) -> None:
    page = opened(open_page("/console", width=width, height=height, pictures=False, has_touch=True))
    expect(notice(page)).to_be_visible()
    words = notice(page).locator("span")
    assert words.evaluate("(one) => one.clientHeight >= 2 * parseFloat(getComputedStyle(one).lineHeight)")
    assert words.evaluate("(one) => one.scrollWidth <= one.clientWidth") is True
    box = notice(page).bounding_box()
    assert box is not None
    assert box["height"] <= 70  # the picture gives it up
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= width
    assert box["y"] + box["height"] <= height
    covered = (
        f"(box) => [...document.querySelector('omote-console').shadowRoot.querySelectorAll({PLAYED!r})]"
        + """
        .map((one) => [one.tagName, one.getBoundingClientRect()]).filter(([, { left, top, right, bottom, width }]) =>
          width > 0 && left < box.x + box.width && box.x < right && top < box.y + box.height && box.y < bottom)
        .map(([name]) => name)"""
    )
    assert page.evaluate(covered, box) == []
    words_in_bar = "Not sent: the link to the show is lost. It is tried again and again."
    page.evaluate(f"(words) => {STORE}.say(words)", words_in_bar)
    expect(page.locator("omote-status .notice")).to_contain_text(words_in_bar)
    page.evaluate(TWO_FRAMES)
    header = page.locator("omote-status .notice").bounding_box()
    assert header is not None
    assert page.evaluate(covered, header) == []
    page.evaluate(f"{STORE}.say(null)")
    expect(notice(page)).to_be_visible()
    dismiss = notice(page).get_by_role("button", name="Dismiss")
    if width < 600:  # the words have the room; the log shows all
        notice(page).get_by_role("button", name="1 more").tap()
        expect(page.locator("omote-message-log")).to_be_visible()
        page.keyboard.press("Escape")
    else:
        button = dismiss.bounding_box()
        assert button is not None
        assert min(button["width"], button["height"]) >= 44
        dismiss.tap()
        expect(notice(page).locator("small")).to_have_count(0)
        dismiss.tap()
    expect(notice(page)).to_have_count(0)
