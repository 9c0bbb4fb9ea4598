"""Normal textures: as steep as the stage's relief, level where a look has none, and folds where the cast folds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.interchange.relief_texture import STEEPEST, Folds, encode_normals, paint_folds, paint_relief, tangents_of
from omote.interchange.skin_texture import Canvas, load_canvas, paint_skin

CAST = load_cast()


@pytest.fixture(scope="module")
def canvas() -> Canvas:
    return load_canvas(CAST.space)


def folds_of(canvas: Canvas, face: str) -> Folds:
    return paint_folds(canvas, CAST.looks[face])


def steepness(relief: NDArray[np.uint8]) -> NDArray[np.float64]:
    normals = relief.astype(np.float64) / 127.5 - 1.0
    return np.hypot(normals[..., 0], normals[..., 1]) / normals[..., 2]


def test_a_surface_that_rises_leans_away_and_a_level_one_is_blue() -> None:
    level, right, down = encode_normals(np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]))[0].astype(int)
    assert level.tolist() == [128, 128, 255]
    assert right[0] < 50 < 128 == right[1]
    assert down[0] == 128 < 200 < down[1]  # the texture's rows go down, y goes up


def test_tangents_go_along_the_columns_and_their_third_axis_up_the_rows() -> None:
    points = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    normals = np.array([[0.0, 0.0, 1.0]] * 3)
    corners = np.array([[0, 1, 2]], np.int32)
    upright = np.array([[0.0, 1.0], [1.0, 1.0], [0.0, 0.0]])  # the texture's rows go down
    mirrored = upright * [-1.0, 1.0] + [1.0, 0.0]
    assert tangents_of(points, normals, upright, corners).tolist() == [[1.0, 0.0, 0.0, 1.0]] * 3
    assert tangents_of(points, normals, mirrored, corners).tolist() == [[-1.0, 0.0, 0.0, -1.0]] * 3


def test_lines_of_age_are_deeper_on_the_old_and_lacquer_is_smooth(canvas: Canvas) -> None:
    look = CAST.looks["old"]
    old, young, doll = (
        steepness(paint_relief(canvas, changed))
        for changed in (look, replace(look, age=0.0), replace(look, lacquer=1.0))
    )
    assert old.mean() > 1.2 * young.mean()
    assert doll.max() < 0.01
    assert old.max() <= 2.0 * STEEPEST * np.sqrt(2.0) + STEEPEST * np.sqrt(2.0)


def test_folds_are_those_of_age_on_the_skin_s_own_colour(canvas: Canvas) -> None:
    old, child = (folds_of(canvas, face) for face in ("old", "child"))
    assert old.depth.sum() > 2.0 * child.depth.sum() > 0.0
    skin = paint_skin(canvas, CAST.looks["old"]).astype(int)
    seen = old.picture[..., 3] > 0
    assert (old.picture[seen, :3] <= skin[seen] + 1).all()
    assert 0.02 < seen.mean() < 0.5
    assert not folds_of(canvas, "noh").picture[..., 3].any()
