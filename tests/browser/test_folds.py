"""Skin that answers on stage: strains as Python finds them; folds, blood and water where they belong, nowhere else."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from playwright.sync_api import Page
from scipy.ndimage import gaussian_filter

import omote
from omote.geometry.strain import fans_of, vertex_strain
from omote.model.cast import Cast
from omote.perform.frame import Frame
from omote.stage_data.pose_parser import pose_of
from tests.browser.conftest import OpenPage
from tests.browser.pictures import picture
from tests.browser.waiting import floats

pytestmark = pytest.mark.long

Floats = NDArray[np.float64]
FACES = ("generic", "kaori", "man", "old", "child", "baby", "heavy", "goblin", "dog", "cat")
PLACED = 5e-6
"""How far from the evaluator's the page's positions may lie, metres: correctives end on rounding of their own."""
EMOTIONS = ("angry", "sad", "cry", "joy", "disgust", "surprise", "fear")


@pytest.fixture(scope="module")
def cast() -> Cast:
    return omote.load_cast()


@pytest.fixture
def stage(held_stage: OpenPage) -> Callable[[str], Page]:
    return lambda level: held_stage(f"?quality={level}", width=320, height=360)


def hold(page: Page, pose: dict[str, Any]) -> None:
    page.evaluate("pose => window.omoteStage.hold(pose)", pose)


def seen(page: Page, **pose: Any) -> Floats:
    """The picture of a pose, what it leaves out at rest."""
    hold(page, pose)
    return picture(page)[..., :3].astype(float)


def strains(page: Page, cast: Cast) -> Floats:
    """How far the skin is pressed by the GPU (V, 3)."""
    return floats(page, "window.omoteStage.readStrains()").reshape(-1, 3)[: cast.space.vertex_count]


def expected(cast: Cast, frame: Frame, worn: Floats) -> Floats:
    """The same by Python. worn: positions of the skin (V, 3) under the frame."""
    assert cast.folding is not None
    rest = omote.evaluate(cast, Frame(frame.faces, {"neutral": 1.0})).astype(np.float64)
    triangles = fans_of(cast.space.triangles, cast.folding > 0)
    return vertex_strain(rest, worn, triangles)


def unsure(cast: Cast, frame: Frame, apart: Floats) -> Floats:
    """By how much strains can differ where positions do (V,): much at a nostril, whose triangles are 45 um high.

    A corner's move, apart (V,) metres, turns the gradient by its share of the opposite side over twice the area; the
    symmetric root of a matrix changes by at most the square root of 2 of what it does (Araki, Yamagami 1981).
    """
    assert cast.folding is not None
    rest = omote.evaluate(cast, Frame(frame.faces, {"neutral": 1.0})).astype(np.float64)
    triangles = fans_of(cast.space.triangles, cast.folding > 0)
    sides = np.stack([rest[triangles[:, k - 1]] - rest[triangles[:, k - 2]] for k in range(3)], axis=1)
    moves = (apart[triangles] * np.linalg.norm(sides, axis=2)).sum(axis=1)
    doubled = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    totals = [np.bincount(triangles.ravel(), np.repeat(values, 3), len(rest)) for values in (moves, doubled)]
    found: Floats = np.sqrt(2.0) * totals[0] / np.maximum(totals[1], 1e-20)
    return found


@pytest.mark.parametrize("face", FACES)
def test_strain_is_that_of_the_evaluator(stage: Callable[[str], Page], cast: Cast, face: str) -> None:
    page = stage("medium")
    for emotion in EMOTIONS:
        frame = Frame({face: 1.0}, {emotion: 1.0}, channels={"jawOpen": 0.3, "browInnerUp": 0.4})
        hold(page, pose_of(cast, frame))
        found = strains(page, cast)
        drawn = floats(page, "window.omoteStage.readPositions()").reshape(-1, 3)[: cast.space.vertex_count]
        assert found == pytest.approx(expected(cast, frame, drawn), abs=0.0005), emotion
        own = omote.evaluate(cast, frame).astype(np.float64)
        assert np.abs(drawn - own).max() < PLACED, emotion
        off = np.abs(found - expected(cast, frame, own)).max(axis=1)
        assert (off < 0.0005 + unsure(cast, frame, np.linalg.norm(drawn - own, axis=1))).all(), emotion


def test_a_mix_of_faces_is_rest_and_blinks_and_looks_press_nothing(stage: Callable[[str], Page], cast: Cast) -> None:
    page = stage("medium")
    faces = {"kaori": 0.6, "dog": 0.4}
    lids = {"eyeBlinkLeft": 0.7, "eyeLookDownRight": 0.8, "eyeBlinkRight": 0.4}
    hold(page, pose_of(cast, Frame(faces, {"neutral": 1.0}, channels={"browDownLeft": 0.001})))
    assert np.abs(strains(page, cast)).max() < 0.001
    hold(page, pose_of(cast, Frame(faces, {"neutral": 1.0}, channels={"browDownLeft": 1.0})))
    before = strains(page, cast)
    hold(page, pose_of(cast, Frame(faces, {"neutral": 1.0}, channels={"browDownLeft": 1.0, **lids})))
    crow = np.abs(np.abs(cast.space.points[:, 0]) - 0.055) < 0.006
    crow &= np.abs(cast.space.points[:, 1]) < 0.012
    assert np.abs(strains(page, cast) - before)[crow].max() < 0.12


@pytest.mark.parametrize("level", ["lowest", "low", "medium"])
def test_blood_reddens_what_is_meant_and_a_mask_stays_white(stage: Callable[[str], Page], level: str) -> None:
    page = stage(level)
    for face, reddens in (("kaori", True), ("noh", False)):
        rest = seen(page, faces={face: 1.0}, complexion=[])
        flushed = seen(page, faces={face: 1.0}, complexion=[0.0, 0.0, 1.0])
        change = flushed - rest
        forehead, chin = change[100:125, 140:180], change[255:270, 150:170]
        if reddens:
            assert forehead[..., 1].mean() < -15.0
            assert forehead[..., 1].mean() < 3.0 * forehead[..., 0].mean() - 5.0
            assert np.abs(chin).mean() < 1.0
        else:
            assert np.abs(change).max() <= 1.0


def test_folds_are_deeper_with_age_and_go_with_their_fader(stage: Callable[[str], Page]) -> None:
    page = stage("medium")

    def folded(face: str, folds: float) -> float:
        """How much folds change between the brows, of 255."""
        pose = {"faces": {face: 1.0}, "expressions": {"angry": 1.0}, "complexion": []}
        change = seen(page, **pose, folds=folds) - seen(page, **pose, folds=0.0)
        return float(np.abs(change[120:165, 140:180]).mean())

    young = [folded(face, 1.0) for face in ("kaori", "child")]
    assert folded("old", 1.0) > 1.3 * max(young)
    assert min(young) > 0.5
    assert folded("old", 0.0) == 0.0
    assert folded("old", 0.5) < folded("old", 1.0)


def test_neutral_is_as_without_any_of_it(stage: Callable[[str], Page]) -> None:
    page = stage("medium")
    for face in ("kaori", "old", "dog"):
        rest = seen(page, faces={face: 1.0})
        assert np.array_equal(rest, seen(page, faces={face: 1.0}, folds=0.0, complexion=[]))


@pytest.mark.parametrize("level", ["low", "medium"])
def test_sweat_shines_beads_and_runs_on_skin_alone(stage: Callable[[str], Page], level: str) -> None:
    page = stage(level)

    def change(face: str, sweat: float, drops: float, before: float = 0.0) -> Floats:
        dry = seen(page, faces={face: 1.0}, complexion=[0.0] * 6 + [before])
        return np.abs(seen(page, faces={face: 1.0}, complexion=[0.0] * 6 + [sweat, drops]) - dry)

    for face in ("noh", "dog", "cat"):
        assert change(face, 1.0, 0.02).max() == 0.0
    if level == "low":
        assert change("man", 1.0, 0.02).max() == 0.0
        return
    film, beads, ran = change("man", 0.2, 0.0), change("man", 1.0, 0.0), change("man", 1.0, 0.02, before=1.0)
    forehead = (slice(85, 125), slice(130, 190))
    assert 0.5 < film[forehead].mean() < beads[forehead].mean()
    assert beads[:, 60:260].max() > 25.0
    assert ran.max() > 12.0  # the same beads, but those that run
    assert (ran > 0.0).mean() < 0.3 * (beads > 0.0).mean()


def test_a_flush_is_mottled_and_sweat_leaves_no_pits(stage: Callable[[str], Page]) -> None:
    """A flush that was even was a wash of paint; beads hid the sheen around them, and were darker than dry skin."""
    page = stage("medium")
    forehead, brow = (slice(60, 125), slice(100, 220)), (slice(95, 125), slice(135, 185))
    for face in ("man", "old", "heavy"):
        dry = seen(page, faces={face: 1.0}, complexion=[])
        flushed = np.log((seen(page, faces={face: 1.0}, complexion=[0.0, 0.0, 1.0]) + 1.0) / (dry + 1.0))[brow][..., 1]
        assert (flushed - gaussian_filter(flushed, 6.0)).std() > 0.08 * abs(flushed.mean())
        wet = (seen(page, faces={face: 1.0}, complexion=[0.0] * 6 + [1.0]) - dry).mean(axis=2)[forehead]
        assert wet.min() > -15.0
        assert wet.max() > 40.0


def test_tears_run_and_dry_eyes_have_none(stage: Callable[[str], Page]) -> None:
    page = stage("medium")

    def weeping(tears: float, drops: float) -> Floats:
        return seen(page, faces={"man": 1.0}, complexion=[0.0, 0.0, 0.0, 0.0, 0.0, tears, 0.0, drops])

    dry, wet, later = weeping(0.0, 0.0), weeping(1.0, 0.0), weeping(1.0, 0.01)
    assert np.abs(wet - dry)[190:260].max() > 8.0
    assert np.abs(later - wet)[190:260].max() > 8.0
    assert np.array_equal(later, weeping(1.0, 0.01))
    assert np.array_equal(dry, weeping(0.0, 0.01))
