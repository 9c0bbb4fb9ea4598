"""Waiting for what a page comes to, and large arrays out of it: no test here depends on how fast a machine is."""

from __future__ import annotations

import base64
import time

import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Error, Frame, Page

PATIENCE = 360.0
"""Seconds after which a test has failed; nothing waits for them."""

LEFT = "Execution context was destroyed"
"""What Playwright says where a page went elsewhere while it was asked."""

WAIT = """([patience]) => new Promise((done, fail) => {
    const tooLate = performance.now() + 1000 * patience;
    const holds = () => { %(given)s; return Boolean(%(condition)s); };
    const look = () => {
        try {
            if (holds()) done();
            else if (performance.now() < tooLate) setTimeout(look, 15);
            else fail(new Error("never came"));
        } catch (error) {
            fail(error);
        }
    };
    look();
})"""

ENCODE = """() => {
    const bytes = new Uint8Array(Float64Array.from(%s).buffer);
    let text = "";
    for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
    return btoa(text);
}"""

NO_FRAMES = "() => { window.requestAnimationFrame = () => 0; }"


def wait_until(page: Page | Frame, condition: str, given: str = "", told: str = "null") -> None:
    """Waits until a JavaScript condition holds in the page; AssertionError after `PATIENCE`. A page that goes
    elsewhere meanwhile is waited for there.

    given: statements before the condition, which name what it speaks of; told: an expression that the error shows.
    Written out because Playwright's own wait evaluates strings in the page, which its content security policy forbids.
    """
    wait = WAIT % {"given": given, "condition": condition}
    too_late = time.monotonic() + PATIENCE
    while True:
        try:
            page.evaluate(wait, [too_late - time.monotonic()])
        except Error as error:
            if LEFT in error.message and time.monotonic() < too_late:
                continue  # the page that is waited for has just come in place of the one that was asked
            found = page.evaluate(f"() => {{ {given}; return JSON.stringify({told}); }}")
            raise AssertionError(f"{condition} never came; there is {found}") from error
        return


def floats(page: Page, expression: str) -> NDArray[np.float64]:
    """The numbers of an array in the page, in one string: Playwright itself passes numbers one by one."""
    return np.frombuffer(base64.b64decode(page.evaluate(ENCODE % expression)), np.float64)


def draw_on_demand(page: Page) -> None:
    """Has a stage draw only what its probe is told to `hold` from now on.

    It would draw the same picture sixty times a second; on llvmpipe that takes both cores, and what it has yet to draw
    holds up every page after it.
    """
    page.evaluate(NO_FRAMES)
