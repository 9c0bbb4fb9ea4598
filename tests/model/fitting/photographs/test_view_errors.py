"""How far landmarks lie from a head, and how that changes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.model.fitting.photographs.bundle_problem import POSE, change_by_places, change_by_pose, measure_errors
from omote.model.fitting.photographs.photograph import PhotographCamera

DRAW = np.random.default_rng(3)
PLACES = DRAW.uniform(-0.1, 0.1, (20, 3))
TURN = Rotation.from_rotvec([0.2, -0.5, 0.1]).as_matrix()
CAMERA = PhotographCamera(TURN, np.array([0.02, 0.01, -0.7]), 600, 400, 500)
SMALL = 1e-6


def in_front(places: np.ndarray, camera: PhotographCamera = CAMERA) -> np.ndarray:
    return camera.project(camera.view(places))


def test_a_point_seen_beside_its_place_is_off_by_metres_at_its_depth() -> None:
    shift = np.array([0.003, -0.002, 0.0])
    moved = CAMERA.project(CAMERA.view(PLACES) + shift)
    assert measure_errors(moved, CAMERA, PLACES) == pytest.approx(np.tile(shift[:2], len(PLACES)))


def test_changes_by_places_are_the_slopes_of_the_errors() -> None:
    moves = DRAW.normal(size=(2, *PLACES.shape))
    slopes = change_by_places(CAMERA, PLACES, moves)
    for each in range(2):
        off = measure_errors(in_front(PLACES), CAMERA, PLACES + SMALL * moves[each])
        assert off / SMALL == pytest.approx(slopes[:, each], abs=1e-4)


def test_changes_by_pose_are_the_slopes_of_the_errors() -> None:
    slopes = change_by_pose(CAMERA, PLACES)
    for each in range(POSE):
        step = SMALL * np.eye(POSE)[each]
        moved = CAMERA.move(step[:3], step[3:6], step[6])
        off = measure_errors(in_front(PLACES), moved, PLACES)
        assert off / SMALL == pytest.approx(slopes[:, each], abs=1e-4)
