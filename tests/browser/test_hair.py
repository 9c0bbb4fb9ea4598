"""Hair on stage comes and goes by length over a painted scalp, and leaves no chips; no part of a head comes first."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page, Route
from scipy import ndimage

from omote.builtin import load_cast, load_meshes
from omote.stage_data.assets import documents
from tests.browser.pictures import picture
from tests.browser.waiting import wait_until

pytestmark = pytest.mark.long

OpenPage = Callable[..., Page]
SIDE = 300
BROWS = 0.42  # of the picture, from the top: above there is nothing as dark as hair
DARK = 45
SHADE = 105  # 0..255: black hair, and stubble on the skin
SMALL = SIDE * SIDE / 400
STEEPEST = (
    2.2  # times the mean, of the steps of a morph: hair that the other style has not goes within a fifth of the way
)


@pytest.fixture(
    params=["lowest", *(pytest.param(level, marks=pytest.mark.slow) for level in ("medium", "good")), "high"]
)
def stage(request: pytest.FixtureRequest, held_stage: OpenPage) -> Page:
    """A stage at a level, without a backdrop, in even light; it draws what it is told to hold."""
    return held_stage(f"?quality={request.param}&light=flat&transparent", width=SIDE, height=SIDE)


def look(page: Page, faces: dict[str, float]) -> NDArray[np.int16]:
    """A mix of faces at rest (height, width, 4)."""
    page.evaluate(
        "faces => window.omoteStage.hold({ faces })", {name: part for name, part in faces.items() if part > 0}
    )
    return picture(page)


def darker(seen: NDArray[np.int16], than: int) -> NDArray[np.bool_]:
    """Where a picture is darker, above the brows."""
    above = seen[: int(BROWS * SIDE)]
    return np.asarray((above[..., :3].max(axis=2) < than) & (above[..., 3] > 127))


def chips(seen: NDArray[np.int16]) -> int:
    """Patches of black hair that nothing joins to the rest, not even stubble."""
    labels, count = ndimage.label(darker(seen, SHADE), np.ones((3, 3), int))
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    black = np.unique(labels[darker(seen, DARK)])
    return int((sizes[black[black > 0]] < SMALL).sum())


@pytest.mark.parametrize("bald", ["dog", "baby"])
def test_hair_that_comes_or_goes_leaves_no_chips_on_the_scalp(stage: Page, bald: str) -> None:
    ends = max(chips(look(stage, {face: 1.0})) for face in ("kaori", bald))
    for way in (0.1, 0.2, 0.25):
        assert chips(look(stage, {"kaori": way, bald: 1.0 - way})) <= ends + 1, way
    assert chips(look(stage, {"kaori": 0.5, bald: 0.5})) <= ends + 4  # thin ribbons as rows of dots were 13 and more


def test_between_two_styles_hair_is_between_them_and_nothing_pops(stage: Page) -> None:
    seen = [look(stage, {"kaori": 1.0 - part, "round": part}) for part in np.linspace(0.0, 1.0, 9)]
    areas = [((one[..., :3].max(axis=2) < DARK) & (one[..., 3] > 127))[: 2 * SIDE // 3].sum() for one in seen]
    assert areas[-1] < areas[4] < areas[0]
    assert areas == sorted(areas, reverse=True)
    steps = [np.abs(after - before).mean() for before, after in pairwise(seen)]
    assert max(steps) < STEEPEST * np.mean(steps), [step / np.mean(steps) for step in steps]


def test_half_a_dog_wears_her_hair_whole_and_in_between_its_colours(stage: Page) -> None:
    """A crop on half a dog was a toupee: hair is as long as hers until it is nearly of the colour of the fur."""
    hers, half = look(stage, {"kaori": 1.0}), look(stage, {"kaori": 0.5, "dog": 0.5})
    beside = (slice(SIDE // 2, 2 * SIDE // 3), slice(0, SIDE // 3))  # where a bob hangs, and no dog's ear
    covers = [int((seen[beside][..., 3] > 127).sum()) for seen in (hers, half)]
    assert covers[1] > 0.8 * covers[0]
    hair = [seen[beside][..., :3][seen[beside][..., 3] > 127].mean() for seen in (hers, half)]
    assert hair[1] > 1.15 * hair[0]


def test_a_fringe_of_broad_ribbons_shades_the_forehead_as_one_of_thin_ribbons_does(held_stage: OpenPage) -> None:
    seen = {}
    for level in ("low", "medium", "high"):  # no shadow, of broad ribbons, of thin ones
        page = held_stage(f"?quality={level}&light=theatre", width=SIDE, height=SIDE)
        seen[level] = look(page, {"kaori": 1.0})[: int(BROWS * SIDE), :, :3]
    forehead = seen["low"].max(axis=2) > 150
    assert forehead.sum() > SMALL
    without, broad = (np.abs(seen[level] - seen["high"])[forehead].mean() for level in ("low", "medium"))
    assert broad < 0.6 * without  # where its shadow was longer than the fringe: 0.76


def test_no_part_of_a_head_is_drawn_before_it_is_whole(open_page: OpenPage) -> None:
    hair = documents(load_cast(), load_meshes(), mask="").hair
    held: list[Route] = []
    page = open_page("/", width=SIDE, height=SIDE)
    page.route(lambda url: any(url.endswith(one) for one in hair), lambda route: held.append(route))
    page.goto(page.url.rstrip("/") + "/stage?quality=lowest&transparent")
    wait_until(page, "window.omoteStage?.counters().drawn > 5")
    while not held:
        page.wait_for_timeout(15)
    page.evaluate("() => { document.body.style.opacity = 1; }")  # nor below the black that a stage comes up from
    assert (picture(page)[..., 3] == 0).all()
    for route in held:
        route.continue_()
    wait_until(page, "window.omoteStage.settled()")
    assert (picture(page)[SIDE // 3 : SIDE // 2, SIDE // 3 : -SIDE // 3, 3] == 255).all()
