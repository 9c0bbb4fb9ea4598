"""The light in a real browser: exact colours for keyers, and a change without a jump."""

from __future__ import annotations

import numpy as np

from tests.browser.conftest import OpenPage
from tests.browser.pictures import picture
from tests.browser.waiting import wait_until

HOLD = "pose => window.omoteStage.hold(pose)"
GREEN = (0, 0xB1, 0x40, 255)


def test_a_keyer_finds_exactly_the_colour_it_was_told(open_page: OpenPage) -> None:
    page = None
    for query, colour in (("light=flat", GREEN), ("background=%231a2b3c", (0x1A, 0x2B, 0x3C, 255))):
        page = open_page(f"/stage?quality=lowest&{query}", width=200, height=120, over=page)
        wait_until(page, "window.omoteStage?.settled()")  # it has come up from black
        pixels = picture(page)
        assert (pixels[:60, :40] == colour).all()
        assert (pixels[:60, -40:] == colour).all()


def test_a_light_changes_as_smoothly_as_its_weights(held_stage: OpenPage) -> None:
    page = held_stage("?quality=lowest", width=160, height=160)
    shown = []
    for weight in np.linspace(0.0, 1.0, 17):
        page.evaluate(HOLD, {"light": {"theatre": 1.0 - float(weight), "portrait": float(weight)}})
        shown.append(picture(page)[..., :3].mean(axis=(0, 1)))
    steps = np.abs(np.diff(shown, axis=0))
    whole = np.abs(shown[-1] - shown[0])
    assert (steps <= 4.0 * whole / len(steps) + 0.5).all()
