"""Figures on the stage: what the GPU skins, and what is seen of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page

import omote
from omote.arrays import Floats, Mask
from omote.model.body.pose_regions import POSE_REGIONS
from omote.model.cast import Cast
from omote.perform.figures.figure_axes import FACES_OWN
from omote.perform.frame import FigureFrame, Frame, Head
from tests.browser.conftest import OpenPage
from tests.browser.pictures import picture
from tests.browser.waiting import floats

pytestmark = pytest.mark.long

TOLERANCE = 5e-5
"""Metres."""
FRAMES = 6
FACES = ("kaori", "heavy", "child", "dog")
"""A few, so that the smile is worked out once for each."""


@pytest.fixture(scope="module")
def cast() -> Cast:
    return omote.load_cast()


@pytest.fixture
def stage(held_stage: OpenPage) -> Callable[..., Page]:
    """Opens a stage that draws what it is to hold."""

    def open_one(query: str, *, width: int = 160, height: int = 240) -> Page:
        return held_stage(query, width=width, height=height)

    return open_one


def hold(page: Page, pose: Mapping[str, Any]) -> None:
    page.evaluate("pose => window.omoteStage.hold(pose)", pose)


def drawn_mix(names: list[str], count: int, rng: np.random.Generator) -> dict[str, float]:
    """Weights of some names, which sum to one."""
    shares = rng.dirichlet(np.ones(count)).tolist()
    return dict(zip(rng.permutation(names)[:count].tolist(), shares, strict=True))


def bare_rows(cast: Cast) -> Mask:
    """The rows that no suit spans: those of neither trunk, hips nor toes, and those that follow the head."""
    assert cast.figures is not None
    space = cast.figures.space
    spanned = [name.startswith(("root", "spine", "pelvis", "upperleg01", "toes")) for name in space.skeleton.names]
    bare = (np.where(np.array(spanned)[space.bones], space.weights, 0.0) == 0.0).all(axis=1)
    bare[: space.head_rows] = True
    bare[space.head_rows + space.joined] = True
    return np.asarray(bare)


@pytest.mark.parametrize("level", ["lowest", "medium"])
def test_figures_equal_the_python_of_bodies_poses_and_skinning(
    stage: Callable[..., Page], cast: Cast, level: str
) -> None:
    """Mixes of faces, bodies, poses, regions that go their own way, an expression, a turned head, idle motion, and limb
    fields: those that are called, and those that bent elbows and breath drive."""
    page = stage(f"?quality={level}&shot=full")
    rng = np.random.default_rng(34)
    bare = bare_rows(cast)
    assert bare.mean() > 0.6
    for _ in range(FRAMES):
        faces = drawn_mix(list(FACES), 2, rng)
        own = rng.uniform()
        bodies = {FACES_OWN: own} | {
            name: (1.0 - own) * share for name, share in drawn_mix(list(cast.bodies), 2, rng).items()
        }
        poses = drawn_mix(list(cast.poses), 3, rng)
        regions = {region: drawn_mix(list(cast.poses), 2, rng) for region in rng.permutation(POSE_REGIONS)[:2].tolist()}
        head = rng.uniform(-0.6, 0.6, 3).tolist()
        expressions = {"smile": 0.5, "neutral": 0.5}
        figure: Mapping[str, Any] = {"poses": poses, "regions": regions, "bodies": bodies}
        idle = rng.uniform((0.0, -1.0, -1.0), 1.0).tolist()
        channels = {"calfLeft": rng.uniform(0.2, 1.4), "puffedSleeves": rng.uniform(0.2, 1.0)}
        told = {"faces": faces, "expressions": expressions, "channels": channels, "head": head, "figure": figure}
        hold(page, told | {"idle": idle})
        drawn = floats(page, "window.omoteStage.readFigure()").reshape(-1, 3)
        wrong = np.linalg.norm(drawn - expected(cast, told, {**figure, "idle": idle}), axis=1)
        assert wrong[bare].max() < TOLERANCE, (figure, wrong.argmax())


def expected(cast: Cast, told: Mapping[str, Any], figure: Mapping[str, Any]) -> Floats:
    """The rows of a figure as Python has them. told: as a stage is."""
    on = FigureFrame(figure["poses"], figure["regions"], figure["bodies"], None, {}, None, 0.0)
    faces, expressions, channels = (told[what] for what in ("faces", "expressions", "channels"))
    frame = Frame(faces, expressions, channels, Head(*told["head"]), figure=on, idle=figure["idle"])
    return omote.evaluate_figure(cast, frame)


def test_a_figure_stands_in_the_picture_and_moves_as_it_is_told(stage: Callable[..., Page]) -> None:
    """From its hair to its soles; an arm that waves is beside the head; a head alone is what it was."""
    page = stage("?quality=medium&shot=full&background=green", width=180, height=320)

    def figure_columns(pose: str) -> Mask:
        hold(page, {"faces": {"kaori": 1.0}, "figure": {"poses": {pose: 1.0}, "regions": {}, "bodies": {"own": 1.0}}})
        seen = picture(page)[..., :3].astype(int)
        return np.asarray(np.abs(seen - seen[0, 0]).max(axis=2) > 40)

    standing, waving = figure_columns("stand"), figure_columns("wave")
    rows = np.flatnonzero(standing.any(axis=1))
    assert rows[0] < 25
    assert 295 < rows[-1] < 320
    columns = standing.any(axis=0)
    assert 0.15 < columns.mean() < 0.6
    assert abs(np.flatnonzero(columns).mean() - 89.5) < 6.0
    assert waving[:100].sum() > standing[:100].sum() + 150


def hold_scene(page: Page, framing: Mapping[str, float]) -> NDArray[np.int16]:
    """The picture of one character in a framing."""
    character = {
        "faces": {"kaori": 1.0},
        "figure": {"poses": {"bow": 0.5, "wave": 0.5}, "regions": {}, "bodies": {"own": 1.0}},
    }
    page.evaluate("scene => window.omoteStage.holdScene(scene)", {"characters": {"one": character}, "framing": framing})
    return picture(page)


def test_a_framing_brings_figures_into_a_picture_of_heads_and_takes_them_out(stage: Callable[..., Page]) -> None:
    """A picture is of what is held alone, drawn once or again, whatever was shown before it."""
    page = stage("?quality=medium")
    alone = hold_scene(page, {"*": 1.0})
    full = hold_scene(page, {"*:full": 1.0})
    assert np.array_equal(full, hold_scene(page, {"*:full": 1.0}))  # nothing of the figure was to be drawn anew
    between = hold_scene(page, {"*:full": 0.5, "*": 0.5})
    assert np.array_equal(alone, hold_scene(page, {"*": 1.0}))
    assert np.array_equal(full, hold_scene(stage("?quality=medium&shot=full"), {"*": 1.0}))

    sizes = [np.count_nonzero(seen[..., 0] - seen[..., 2] > 40) for seen in (full, between, alone)]
    assert sizes[0] < sizes[1] < sizes[2], "the face grows as the camera comes nearer"
