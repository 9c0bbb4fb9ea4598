"""Eyeballs: a scan's own are found exactly, others rest under their lids; lids leave the ball."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.fitting.fitted_eyes import find_balls, fit_sphere, place_balls, seat_lids
from omote.model.fitting.scan_surface import sample_mesh
from omote.model.space.eye_socket import ball_heights, radius_of
from tests.model.fitting.test_scan_surface import ball

SPACE = omote.load_cast().space
EYES = {name: part.points for name, part in SPACE.parts.items() if part.eye}
AWAY = np.array([0.001, -0.002, 0.003])
BOX = np.stack([SPACE.points.min(axis=0), SPACE.points.max(axis=0)])


def test_a_sphere_is_found_in_spite_of_points_off_it() -> None:
    points, _ = ball(0.012)
    centre = np.array([0.03, 0.0, 0.12])
    spoiled = np.vstack([points, np.random.default_rng(0).normal(0.004, 0.002, size=(200, 3))]) + centre
    middle, radius = fit_sphere(spoiled)
    assert middle == pytest.approx(centre, abs=1e-4)
    assert radius == pytest.approx(0.012, abs=1e-4)


def test_balls_of_a_scan_are_seen_and_the_eyes_go_there() -> None:
    points, triangles = ball(0.014)
    middles = {name: eye.mean(axis=0) + AWAY for name, eye in EYES.items()}
    every = [SPACE.points, *(points + middle for middle in middles.values())]
    starts = np.cumsum([0, *map(len, every)])
    corners = [SPACE.triangles, *(triangles + start for start in starts[1:3])]
    seen = find_balls(sample_mesh(np.vstack(every), np.vstack(corners), BOX, 0.01), EYES)
    placed = place_balls(SPACE, EYES, SPACE.points, seen)
    for name, middle in middles.items():
        assert placed[name].mean(axis=0) == pytest.approx(middle, abs=2e-4)
        assert radius_of(placed[name]) == pytest.approx(0.014, abs=2e-4)


def test_without_balls_none_are_seen_and_eyes_stay_under_lids_that_stay() -> None:
    assert find_balls(sample_mesh(SPACE.points, SPACE.triangles, BOX, 0.01), EYES) == {}
    for name, placed in place_balls(SPACE, EYES, SPACE.points, {}).items():
        assert np.allclose(placed, EYES[name], atol=1e-6)


def test_eyes_follow_their_lids() -> None:
    away = np.array([0.0, 0.0, 0.002])
    for name, placed in place_balls(SPACE, EYES, SPACE.points + away, {}).items():
        moved = (placed - EYES[name]).mean(axis=0)
        assert 0.0005 < moved[2] < 0.0025


def test_seated_lids_leave_a_larger_ball_and_stay_where_they_are_out_of_it() -> None:
    larger = {name: eye.mean(axis=0) + 1.06 * (eye - eye.mean(axis=0)) for name, eye in EYES.items()}
    seated = seat_lids(SPACE, SPACE.points, larger)
    for name, eye in larger.items():
        rest = ball_heights(SPACE.points, EYES[name])
        now = ball_heights(seated, eye)
        lids = SPACE.on_sheet & (rest < 1.1)
        assert (now[lids] > np.minimum(rest[lids], 1.0) - 0.02).all()
    assert np.allclose(seat_lids(SPACE, SPACE.points, EYES), SPACE.points, atol=1e-9)
