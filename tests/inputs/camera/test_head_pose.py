"""A head's turn is found and undone, whatever its face does."""

import numpy as np
import pytest

from omote.inputs.camera.head_pose import fit_pose, metric_points, normal_face
from omote.inputs.camera.landmark_frame import LandmarkFrame
from omote.inputs.camera.landmark_groups import MOUTH_CORNERS, STEADY
from tests.inputs.camera.heads import frame_of, mean_face


@pytest.mark.parametrize("head", [(0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (-0.3, 0.25, 0.0), (0.2, -0.2, 0.35)])
def test_a_turned_head_is_found_in_our_signs(head: tuple[float, float, float]) -> None:
    face = mean_face()
    pose = fit_pose(metric_points(frame_of(face, head, place=(0.1, -0.05))), face)
    assert pose.angles == pytest.approx(head, abs=1e-3)
    assert pose.scale == pytest.approx(0.12, rel=1e-3)
    assert pose.place[:2] == pytest.approx((0.1, -0.05), abs=1e-3)


def test_what_is_undone_is_the_face_again() -> None:
    face = mean_face()
    points = metric_points(frame_of(face, (0.4, -0.2, 0.1)))
    assert fit_pose(points, face).undo(points) == pytest.approx(face, abs=1e-3)


def test_a_mouth_that_moves_turns_no_head() -> None:
    face = mean_face()
    moved = face.copy()
    moved[list(MOUTH_CORNERS), 1] += 0.2
    pose = fit_pose(metric_points(frame_of(moved, (0.3, 0.1, 0.0))), face)
    assert pose.angles == pytest.approx((0.3, 0.1, 0.0), abs=2e-3)


def test_a_wide_picture_shows_the_same_face() -> None:
    face = mean_face()
    wide, square = (metric_points(frame_of(face, width=800, height=height)) for height in (450, 800))
    assert wide == pytest.approx(square, abs=1e-6)


def test_a_normal_face_has_size_one_about_its_middle() -> None:
    face = normal_face(3.0 * mean_face() + [1.0, 2.0, 3.0])
    assert face[STEADY].mean(axis=0) == pytest.approx(np.zeros(3), abs=1e-9)
    assert np.sqrt((face[STEADY] ** 2).sum(axis=1).mean()) == pytest.approx(1.0)


def test_a_frame_without_a_face_has_no_points() -> None:
    with pytest.raises(ValueError, match="ask `found` first"):
        metric_points(LandmarkFrame(None, 640, 480, 0.0))
