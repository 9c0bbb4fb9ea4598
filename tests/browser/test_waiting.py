"""What the browser tests wait with, in a real browser."""

from __future__ import annotations

from collections.abc import Callable

from playwright.sync_api import Page

from tests.browser.waiting import wait_until


def test_a_page_that_goes_elsewhere_is_waited_for_there(open_page: Callable[..., Page]) -> None:
    page = open_page("/nothing", pictures=False)
    wait_until(page, "location.search === '?there' || (location.assign('?there'), false)")
