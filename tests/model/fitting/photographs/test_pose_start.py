"""First guesses of cameras."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast, load_landmark_table
from omote.model.fitting.photographs.bundle import start_camera, usual_focal
from omote.model.fitting.photographs.photograph import FILM, Photograph, PhotographCamera
from tools.tracking.picture import turn

PLACES = load_landmark_table().places(load_cast().space.points)


def photograph(yaw: float, *, depth: bool) -> Photograph:
    camera = PhotographCamera(turn("z", 0.1) @ turn("y", yaw), np.array([0.05, 0.02, -1.5]), 1800.0, 900, 1200)
    seen = camera.view(PLACES)
    points = np.zeros((478, 3))
    points[: len(PLACES), :2] = camera.project(seen)
    points[: len(PLACES), 2] = -seen[:, 2] * camera.focal / 1.5
    return Photograph(points if depth else points[:, :2], 900, 1200)


@pytest.mark.parametrize("yaw", [0.0, 0.6, -0.9])
def test_with_depth_the_turn_is_nearly_known(yaw: float) -> None:
    found = start_camera(photograph(yaw, depth=True), PLACES)
    assert abs(found.yaw - yaw) < np.radians(5.0)
    off = found.project(found.view(PLACES)) - photograph(yaw, depth=True).landmarks[: len(PLACES), :2]
    assert np.abs(off).mean() < 20.0  # as if from afar: perspective is not known yet


@pytest.mark.parametrize("yaw", [0.5, -0.5])
def test_without_depth_the_head_turns_to_the_right_side(yaw: float) -> None:
    assert start_camera(photograph(yaw, depth=False), PLACES).yaw * yaw > 0.0


def test_a_file_that_tells_the_focal_length_is_believed() -> None:
    plain = photograph(0.0, depth=True)
    told = Photograph(plain.landmarks, 900, 1200, focal=2 * FILM)
    assert usual_focal(told) == 2400.0
    assert usual_focal(plain) != usual_focal(told)
