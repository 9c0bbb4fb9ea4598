"""Groups of points lie where their names say."""

import numpy as np
import pytest

from omote.inputs.camera.landmark_groups import BROWS, CORNERS, IRISES, LIDS, LIPS_APART, MOUTH_CORNERS, STEADY
from tests.inputs.camera.heads import mean_face


@pytest.mark.parametrize(("side", "sign"), [("Left", 1.0), ("Right", -1.0)])
def test_sides_are_the_performers_own(side: str, sign: float) -> None:
    face = mean_face()
    rows = np.concatenate([*LIDS[side], CORNERS[side], IRISES[side], BROWS[side]])
    assert (sign * face[rows, 0] > 0).all()


@pytest.mark.parametrize("side", ["Left", "Right"])
def test_an_eye_is_built_as_an_eye(side: str) -> None:
    face = mean_face()
    (upper, lower) = LIDS[side]
    (inner, outer) = CORNERS[side]
    assert (face[upper, 1] > face[lower, 1]).all()
    assert abs(face[inner, 0]) < abs(face[outer, 0])
    assert (np.diff(np.abs(face[upper, 0])) > 0).all()
    middle = face[IRISES[side]].mean(axis=0)
    assert face[lower, 1].min() < middle[1] < face[upper, 1].max()
    assert face[BROWS[side], 1].min() > face[upper, 1].max()


def test_lips_are_one_above_the_other_between_their_corners() -> None:
    face = mean_face()
    (left, right) = MOUTH_CORNERS
    assert face[left, 0] > 0 > face[right, 0]
    for upper, lower in LIPS_APART:
        assert face[upper, 1] >= face[lower, 1]
        assert face[right, 0] < face[upper, 0] < face[left, 0]


def test_steady_points_are_none_of_lids_and_lips() -> None:
    moving = {int(row) for side in LIDS for line in LIDS[side] for row in line} | {
        row for pair in LIPS_APART for row in pair
    }
    assert not moving & set(STEADY.tolist())
