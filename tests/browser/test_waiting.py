"""What the browser tests open and wait with, in a real browser."""

from __future__ import annotations

from collections.abc import Callable

from playwright.sync_api import Page

from tests.browser.waiting import wait_until


def test_a_page_that_goes_elsewhere_is_waited_for_there(open_page: Callable[..., Page]) -> None:
    page = open_page("/nothing", pictures=False)
    wait_until(page, "location.search === '?there' || (location.assign('?there'), false)")


def test_a_page_without_pictures_finds_no_webgl_and_keeps_what_an_earlier_visit_kept(
    open_page: Callable[..., Page],
) -> None:
    """Else every page of these tests draws faces, and half of what a console costs nobody looks at."""
    for pictures, found in ((False, None), (True, "WebGL2RenderingContext")):
        page = open_page("/nothing", pictures=pictures, kept={"k": [1]})
        assert page.evaluate("document.createElement('canvas').getContext('webgl2')?.constructor.name") == found
        assert page.evaluate("localStorage.getItem('k')") == "[1]"
