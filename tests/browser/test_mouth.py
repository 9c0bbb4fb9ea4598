"""What stands in the openings of a face on stage: teeth and flesh between lips, catchlights between lids."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page

from omote.builtin import load_cast
from tests.browser.conftest import OpenPage
from tests.browser.pictures import picture

YAW = 0.52  # radians: the inner sides of the far teeth show
DARK = 30  # of 255: what nothing is lit in


def within(page: Page, line: str, height: int, width: int) -> NDArray[np.bool_]:
    """The pixels (height, width) within a line of the face as drawn last: from there a ray crosses it oddly often."""
    loop = next(each.loop for each in load_cast().space.lines if each.name == line).tolist()
    points = np.array(page.evaluate("rows => window.omoteStage.places(rows)", loop))[:, :2] * (width, height)
    y, x = np.mgrid[:height, :width] + 0.5
    crossed = np.zeros((height, width), bool)
    for (ax, ay), (bx, by) in zip(points, np.roll(points, -1, axis=0), strict=True):
        if ay != by:
            crossed ^= ((ay > y) != (by > y)) & (x < (bx - ax) * (y - ay) / (by - ay) + ax)
    return crossed


def inside(page: Page, face: str) -> NDArray[np.float64]:
    """Colours (n, 3) between the lips of a face with an open jaw, its head turned."""
    pose = {"faces": {face: 1.0}, "channels": {"jawOpen": 1.0}, "head": [YAW, 0.0, 0.0]}
    page.evaluate("pose => window.omoteStage.hold(pose)", pose)
    pixels = picture(page)[..., :3]
    return pixels[within(page, "lips", *pixels.shape[:2])].astype(float)


@pytest.fixture
def stage(held_stage: OpenPage) -> Page:
    """The lower right of a wall, where mouths are of heads that are turned."""
    return held_stage("?quality=medium&tile=1,1&of=2x2", width=260, height=300)


@pytest.mark.parametrize("face", ["kaori", "dog"])
def test_an_open_mouth_shows_warm_teeth_and_wet_flesh_around_them(stage: Page, face: str) -> None:
    colours = inside(stage, face)
    red, green, _ = colours.T
    grey = (green > 0.88 * red) & (red > DARK)  # backs of plates; light on enamel has been on flesh before
    teeth = (green > 0.62 * red) & (red > 2 * DARK)
    flesh = (green < 0.6 * red) & (red > DARK)
    assert grey.mean() < 0.02
    assert teeth.mean() > 0.08
    assert flesh.mean() > 0.6


@pytest.mark.parametrize("face", ["child", "dog", "cat"])
def test_both_eyes_of_a_turned_head_have_a_small_catchlight(held_stage: OpenPage, face: str) -> None:
    page = held_stage("?quality=medium", width=500, height=560)
    pose = {"faces": {face: 1.0}, "expressions": {"joy": 1.0}, "head": [0.6, 0.0, 0.0]}
    page.evaluate("pose => window.omoteStage.hold(pose)", pose)
    pixels = picture(page)[..., :3].astype(float)
    for lids in ("lid_left", "lid_right"):
        eye = within(page, lids, *pixels.shape[:2])
        bright = eye & (pixels.min(axis=-1) > 225)
        assert 0.01 < bright.sum() / eye.sum() < 0.05
