"""Rotations and weights of other programs, against independent mathematics."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.interchange.clips.clip_names import gaze_weights, quaternions_of
from omote.model.cast import Cast
from omote.perform.channels import gaze_channels
from omote.perform.frame import Gaze


def test_rotations_are_those_of_yaw_then_pitch_then_roll() -> None:
    turns = np.random.default_rng(1).uniform(-1.2, 1.2, (50, 3))
    wanted = Rotation.from_euler("YXZ", turns * [1.0, -1.0, -1.0]).as_quat(canonical=True)
    found = quaternions_of(turns)
    assert found * np.sign(found[:, 3:]) == pytest.approx(wanted, abs=1e-12)
    flat = quaternions_of(turns[:, :2])
    assert flat == pytest.approx(quaternions_of(turns * [1.0, 1.0, 0.0]), abs=1e-12)


def test_a_gaze_turns_both_eyes_by_the_units_of_the_cast(cast: Cast) -> None:
    gaze = np.array([[0.2, -0.1], [0.0, 0.0]])
    weights = gaze_weights(cast.expressions, gaze)
    assert {name: values[0] for name, values in weights.items()} == gaze_channels(cast.expressions, Gaze(0.2, -0.1))
    assert all(values[1] == 0.0 for values in weights.values())
