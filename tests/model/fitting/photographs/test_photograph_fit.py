"""Faces from photographs."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import omote
from omote.builtin import load_cast, load_identity_modes, load_landmark_table
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.photograph_fit import FOLDS, PhotographFit
from omote.model.fitting.skin_repair import find_folds
from tools.tracking.picture import turn

SPACE = load_cast().space
MODES = load_identity_modes()
TABLE = load_landmark_table()
SIDE = 500


def photograph(weights: np.ndarray, yaw: float, side: str | None = None) -> Photograph:
    """Landmarks of somebody as they are found on average."""
    camera = PhotographCamera(turn("y", yaw), np.array([0.0, 0.0, -0.8]), 700.0, SIDE, SIDE)
    law = TABLE.error_at(yaw)
    places = TABLE.places(MODES.shape_skin(weights))
    off = (law.mean + law.slopes @ weights).reshape(-1, 2)
    points = np.full((478, 2), SIDE / 2.0)
    points[: len(places)] = camera.project(camera.view(places) + np.column_stack([off, np.zeros(len(off))]))
    return Photograph(points, SIDE, SIDE, side=side)


@cache
def fitted(*yaws: float) -> PhotographFit:
    weights = 0.8 * np.random.default_rng(4).normal(size=len(MODES.moves))
    return omote.fit_photographs(SPACE, [photograph(weights, yaw) for yaw in yaws], name="kim")


def test_the_face_is_one_of_the_space_with_eyes_and_teeth_and_hardly_a_fold() -> None:
    face = fitted(0.0, 0.6, -0.6).face
    assert face.name == "kim"
    assert set(face.parts) == set(SPACE.parts)
    cast = load_cast().with_faces(face)  # refuses what does not fit
    assert cast.faces["kim"] is face
    assert len(find_folds(SPACE, SPACE.points, face.positions.astype(np.float64))) <= FOLDS  # more are told


def test_photographs_from_all_sides_leave_less_open_than_one() -> None:
    one = fitted(0.0)
    three = fitted(0.0, 0.6, -0.6)
    assert three.spread < one.spread
    assert three.doubts == ()
    assert len(one.doubts) == 1
    assert one.doubts[0].startswith("One photograph shows how wide and tall")


@pytest.mark.slow
def test_sides_that_no_photograph_shows_are_named() -> None:
    assert any("from its left" in doubt for doubt in fitted(0.0, 0.6).doubts) != any(
        "from its right" in doubt for doubt in fitted(0.0, 0.6).doubts
    )
    assert any("from the front" in doubt for doubt in fitted(0.6, 0.7).doubts)


def test_a_photograph_of_the_other_side_is_told() -> None:
    views = [photograph(np.zeros(len(MODES.moves)), yaw, side) for yaw, side in ((0.0, "front"), (0.6, "left"))]
    swapped = [photograph(np.zeros(len(MODES.moves)), yaw, side) for yaw, side in ((0.0, "front"), (0.6, "right"))]
    told = [any("shows the other side" in doubt for doubt in omote.fit_photographs(SPACE, each).doubts)
            for each in (views, swapped)]  # fmt: skip
    assert sorted(told) == [False, True]


def test_landmarks_that_fit_no_head_are_told() -> None:
    odd = photograph(np.zeros(len(MODES.moves)), 0.0)
    points = odd.landmarks + np.random.default_rng(2).normal(0.0, 40.0, odd.landmarks.shape)
    fit = omote.fit_photographs(SPACE, [Photograph(points, SIDE, SIDE)])
    assert any("does not fit" in doubt for doubt in fit.doubts)


def test_progress_is_told_and_photographs_are_needed() -> None:
    told: list[float] = []
    views = [photograph(np.zeros(len(MODES.moves)), 0.0)]
    omote.fit_photographs(SPACE, views, follow=lambda done, what: told.append(done))
    assert told == sorted(told)
    assert told[-1] == 1.0
    with pytest.raises(ValueError, match="there are no photographs"):
        omote.fit_photographs(SPACE, [])
