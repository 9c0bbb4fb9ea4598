"""The skin on stage: its layers arrive, and nothing of it pops while faces mix."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page

from tests.browser.conftest import OpenPage
from tests.browser.pictures import picture

pytestmark = pytest.mark.long

WHOLE = 5.0  # of 255: what neighbouring pixels of the forehead differ by at most where nothing is painted on it


def look(page: Page, faces: dict[str, float]) -> NDArray[np.int16]:
    """A mix of faces, at rest."""
    page.evaluate("faces => window.omoteStage.hold({ faces })", faces)
    return picture(page)[..., :3]


@pytest.fixture
def stage(held_stage: OpenPage) -> Page:
    return held_stage("?quality=medium", width=320, height=320)


def test_fur_shows_strands_where_lacquer_is_even(stage: Page) -> None:
    def grain(face: str) -> float:
        cheek = look(stage, {face: 1.0})[170:190, 110:135].astype(float)
        return float(np.abs(np.diff(cheek, axis=1)).mean())

    assert grain("noh") < WHOLE / 2
    assert grain("cat") > 2 * grain("noh")


def test_no_shadow_ends_on_a_bald_forehead(stage: Page) -> None:
    for face in ("baby", "alien"):  # it turns away from the lamp, and nothing stands in its light
        temple = look(stage, {face: 1.0})[64:112, 150:214].reshape(6, 8, 16, 4, 3).mean(axis=(1, 3))
        assert np.abs(np.diff(temple, 2, axis=1)).max() < WHOLE


def test_between_skin_and_fur_nothing_pops(stage: Page) -> None:
    shares = np.linspace(0.0, 1.0, 9)
    seen = [
        look(stage, {"man": 1.0 - share, "dog": share} if 0 < share < 1 else {"dog" if share else "man": 1.0})
        for share in shares
    ]
    steps = [np.abs(after - before).mean() for before, after in pairwise(seen)]
    assert min(steps) > 0.0
    assert max(steps) < 3.0 * np.mean(steps)


def test_fur_has_an_outline_of_strands_where_a_mask_is_cut_clean(held_stage: OpenPage) -> None:
    page = held_stage("?quality=medium&transparent", width=320, height=320)

    def fringe(face: str) -> float:
        """Pixels that a head covers in part, for each row that it is in, above the collar."""
        page.evaluate("faces => window.omoteStage.hold({ faces })", {face: 1.0})
        alpha = picture(page)[:230, :, 3]
        return float(((alpha > 8) & (alpha < 230)).sum() / (alpha > 127).any(axis=1).sum())

    clean = fringe("noh")
    assert min(fringe("dog"), fringe("cat")) > 1.8 * clean
    assert fringe("noh") == clean
