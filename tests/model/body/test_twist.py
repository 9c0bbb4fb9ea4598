"""Twists: angles about an axis, and upper arms that spread theirs."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import omote
from omote.model.body.posed_bones import place_bones, pose_bones
from omote.model.body.skeleton import SIDES
from omote.model.body.twist import SPREAD, spread_twist, twist_about
from omote.perform.figures.figure import resting_figure

CAST = omote.load_cast()
FIGURES = CAST.figures
assert FIGURES is not None
SKELETON = FIGURES.space.skeleton
RESTING = resting_figure(FIGURES, {"heavy": 1.0}, CAST.faces["heavy"].positions.astype(np.float64))
vectors = st.tuples(*[st.floats(-1.0, 1.0)] * 3).map(np.array)


@given(st.floats(-3.1, 3.1), st.floats(-3.0, 3.0), st.floats(0.0, 6.2))
def test_the_twist_of_a_rotation_is_what_is_left_without_its_swing(twist: float, swing: float, way: float) -> None:
    axis = np.array([0.0, 0.6, 0.8])
    aside = np.cos(way) * np.array([1.0, 0.0, 0.0]) + np.sin(way) * np.array([0.0, 0.8, -0.6])
    turn = (Rotation.from_rotvec(swing * aside) * Rotation.from_rotvec(twist * axis)).as_matrix()
    assert twist_about(turn, axis) == pytest.approx(twist, abs=1e-6)


@given(vectors, vectors)
def test_an_upper_arm_spreads_its_twist_and_nothing_beyond_it_moves(arm: np.ndarray, shoulder: np.ndarray) -> None:
    turns = np.zeros((len(SKELETON.names), 3))
    for side in SIDES:
        turns[SKELETON.places[f"upperarm01.{side}"]] = arm
        turns[SKELETON.places[f"clavicle.{side}"]] = 0.3 * shoulder
    before = pose_bones(SKELETON, RESTING.joints, RESTING.stand, turns, np.zeros(3))
    frames = spread_twist(SKELETON, RESTING.joints, RESTING.stand, before.frames)
    after = place_bones(SKELETON, RESTING.joints, RESTING.stand, frames, np.zeros(3))
    np.testing.assert_allclose(after.joints, before.joints, atol=1e-9)
    for side in SIDES:
        parent, first, second = (
            SKELETON.places[f"{bone}.{side}"] for bone in ("shoulder01", "upperarm01", "upperarm02")
        )
        along = RESTING.joints[second] - RESTING.joints[first]
        along /= np.linalg.norm(along)
        twists = [twist_about(bones.turns[parent].T @ bones.turns[first], along) for bones in (before, after)]
        assert twists[1] == pytest.approx((1.0 - SPREAD) * twists[0], abs=1e-6)
    others = [place for place, name in enumerate(SKELETON.names) if not name.startswith("upperarm01")]
    np.testing.assert_array_equal(after.frames[others], before.frames[others])
