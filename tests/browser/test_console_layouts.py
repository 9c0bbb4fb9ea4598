"""What an operator sets up is theirs; a layout is saved by name and chosen, on any console of the show."""

from __future__ import annotations

from collections.abc import Callable

from playwright.sync_api import Page, expect

from tests.browser.console_at_rest import DESK, wait_for
from tests.browser.test_console import choose, console, fader, region, tile

__all__ = ["console"]

OpenPage = Callable[..., Page]
Console = Callable[..., Page]

FIRST = {
    "timing": {
        "face": {"seconds": 2, "easing": "smooth", "byHand": False},
        "expression": {"seconds": 0.5, "easing": "smooth", "byHand": False},
    },
    "kind": "performed",
    "ownFaces": False,
    "tab": "brows",
    "alone": False,
    "linked": True,
    "springs": {"head": True, "gaze": True},
    "view": "palettes",
    "mixer": "strips",
    "pads": ["mouth", "moods"],
    "solo": {"looks": True, "lines": True, "head": True},
}


def set_up(page: Page) -> dict[str, object]:
    """Sets a console up in its own way; its layout."""
    choose(page, "face", "4")
    choose(page, "face", "hand")
    region(page, "mouth")
    page.locator("[data-kind='arkit']").click()
    page.get_by_role("button", name="Link R L").click()
    page.locator("omote-pad").first.get_by_role("button", name="Spring").click()
    page.get_by_role("button", name="Own", exact=True).click()
    return dict(page.evaluate(f"{DESK}.arrangement"))


def test_a_fresh_console_asks_for_nothing_that_is_not_there(open_page: OpenPage) -> None:
    page = open_page("/console?layout=new", pictures=False)
    answers: list[int] = []
    page.on("response", lambda answer: answers.append(answer.status))
    page.reload()
    wait_for(page, "desk.online && desk.faces.length > 0")
    assert 204 in answers
    assert [status for status in answers if status >= 400] == []


def test_a_fresh_console_inherits_nothing_and_a_reload_keeps_everything(open_page: OpenPage, console: Console) -> None:
    page = console()
    arranged = set_up(page)
    fresh = console()
    assert fresh.evaluate(f"{DESK}.arrangement") == FIRST
    expect(tile(fresh, "dog")).to_be_visible()
    page.reload()
    wait_for(page, "desk.online && desk.faces.length > 0")
    assert page.evaluate(f"{DESK}.arrangement") == arranged
    expect(fader(page, "mouthFunnel")).to_be_visible()
    choose(page, "face", "hand")  # pressed again: the seconds of before
    assert page.evaluate(f"{DESK}.callSeconds('face')") == 4


def test_a_layout_is_saved_by_name_and_chosen_renamed_and_deleted_at_another_console(console: Console) -> None:
    page = console()
    other = console()
    arranged = set_up(page)
    said = other.locator(".said")
    page.get_by_role("button", name="Set-up").click()
    page.get_by_label("Name of the layout").fill("mouths")
    page.get_by_role("button", name="Save as").click()
    expect(page.locator(".said")).to_contain_text("Saved as mouths")
    assert other.evaluate(f"{DESK}.arrangement") == FIRST
    other.get_by_role("button", name="Set-up").click()
    other.get_by_role("button", name="mouths").click()
    wait_for(other, "desk.arrangement.kind === 'arkit'")
    assert other.evaluate(f"{DESK}.arrangement") == arranged
    other.get_by_role("button", name="Back to how it was").click()
    assert other.evaluate(f"{DESK}.arrangement") == FIRST
    other.get_by_label("Name of the layout").fill("  ")
    other.get_by_role("button", name="Save as").click()
    expect(said).to_contain_text("type a name")
    other.get_by_label("Name of the layout").fill("MOUTHS")
    other.get_by_role("button", name="Save as").click()
    expect(said).to_contain_text("has a layout mouths")
    other.get_by_label("Name of the layout").fill("lips")
    other.get_by_role("button", name="Rename mouths to lips").click()
    page.locator("[data-layout='lips']").click()
    expect(page.locator("[data-layout='mouths']")).to_have_count(0)
    wait_for(page, "desk.arrangement.kind === 'arkit'")  # nothing was replaced
    other.get_by_role("button", name="Delete lips").click()
    expect(page.locator("[data-layout='lips']")).to_have_count(0)
    said.get_by_role("button", name="Undo").click()
    page.locator("[data-layout='lips']").click()
    expect(page.locator(".said")).to_contain_text("Laid out as lips")
    assert page.evaluate(f"{DESK}.arrangement") == arranged
    page.get_by_role("button", name="Default").click()
    wait_for(page, "desk.arrangement.kind === 'performed'")
    assert page.evaluate(f"{DESK}.arrangement") == FIRST
    page.get_by_role("button", name="lips", exact=True).click()
    page.get_by_role("button", name="Delete lips").click()
    expect(other.locator("[data-layout='lips']")).to_have_count(0)


def test_the_home_face_is_chosen_for_every_console(console: Console) -> None:
    page = console()
    other = console()
    page.get_by_role("button", name="Set-up").click()
    page.get_by_label("Home face", exact=True).select_option("kaori")
    wait_for(other, "state.home_face === 'kaori'")
    page.get_by_label("Seconds to the home face").select_option("0.5")
    wait_for(other, "state.home_face === 'kaori' && state.home_seconds === 0.5")
    page.get_by_label("Home face", exact=True).select_option("generic")  # as the other files of this show expect it
    wait_for(other, "state.home_face === 'generic'")


def test_a_layout_that_cannot_be_read_is_told_and_ignored(open_page: OpenPage) -> None:
    page = open_page("/console?layout=broken", pictures=False)
    wait_for(page, "desk.online && desk.faces.length > 0")
    page.route("**/layouts/broken", lambda route: route.fulfill(status=200, body="{not json"))
    page.evaluate("localStorage.clear()")
    page.reload()
    wait_for(page, "desk.online && desk.faces.length > 0")
    expect(page.locator(".notice")).to_contain_text("cannot be read")
    assert page.evaluate(f"{DESK}.arrangement") == FIRST
