"""Cameras of photographs."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.model.fitting.photographs.photograph import PhotographCamera


def camera(yaw: float = 0.0) -> PhotographCamera:
    return PhotographCamera(Rotation.from_rotvec([0, yaw, 0]).as_matrix(), np.array([0, 0, -1.0]), 500.0, 400, 300)


def test_the_axis_of_sight_is_the_middle_of_the_picture_and_up_is_up() -> None:
    seen = camera().view(np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0]]))
    assert camera().project(seen) == pytest.approx(np.array([[200.0, 150.0], [250.0, 150.0], [200.0, 100.0]]))


def test_what_is_nearer_is_larger() -> None:
    seen = camera().view(np.array([[0.1, 0.0, 0.5]]))
    assert camera().project(seen) == pytest.approx(np.array([[300.0, 150.0]]))


@pytest.mark.parametrize("yaw", [-1.2, -0.3, 0.0, 0.7])
def test_yaw_is_the_turn_of_the_head(yaw: float) -> None:
    assert camera(yaw).yaw == pytest.approx(yaw)


def test_moves_turn_about_the_head_then_shift_and_zoom() -> None:
    moved = camera(0.4).move(np.array([0.0, 0.2, 0.0]), np.array([0.01, 0.02, 0.03]), np.log(2.0))
    assert moved.yaw == pytest.approx(0.6)
    assert moved.shift == pytest.approx(np.array([0.01, 0.02, -0.97]))
    assert moved.focal == pytest.approx(1000.0)
