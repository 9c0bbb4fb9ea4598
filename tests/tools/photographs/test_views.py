"""Cameras as people hold them."""

from __future__ import annotations

import numpy as np
import pytest

from tools.photographs.views import FOCALS, MIDDLE, camera_at, random_focal

SIDE = 400


def test_focal_lengths_lie_between_their_ends() -> None:
    draw = np.random.default_rng(5)
    drawn = np.array([random_focal(draw) for _ in range(500)])
    assert drawn.min() >= FOCALS[0]
    assert drawn.max() <= FOCALS[1]
    assert np.ptp(np.log(drawn)) > 0.9 * np.ptp(np.log(FOCALS))


def test_a_head_is_in_the_picture_before_the_camera_and_turned_as_asked() -> None:
    draw = np.random.default_rng(6)
    for _ in range(100):
        yaw = float(draw.uniform(-1.3, 1.3))
        focal = random_focal(draw)
        camera = camera_at(draw, yaw, 0.0, 0.0, focal, SIDE)
        seen = camera.view(MIDDLE[None])
        assert camera.yaw == pytest.approx(yaw)
        assert camera.focal == focal * SIDE
        assert -seen[0, 2] > 0.3  # nobody holds a lens to the skin
        assert np.abs(camera.project(seen) - SIDE / 2).max() < SIDE / 2


def test_pitch_lifts_the_nose_and_roll_leans_the_head() -> None:
    nose = np.array([[0.0, -0.02, 0.16]])
    straight = camera_at(np.random.default_rng(1), 0.0, 0.0, 0.0, 1.0, SIDE)
    up, leaning = (camera_at(np.random.default_rng(1), 0.0, *angles, 1.0, SIDE) for angles in ((0.3, 0.0), (0.0, 0.3)))
    crown = np.array([[0.0, 0.12, 0.06]])
    assert up.project(up.view(nose))[0, 1] < straight.project(straight.view(nose))[0, 1]
    assert leaning.project(leaning.view(crown))[0, 0] > straight.project(straight.view(crown))[0, 0]
