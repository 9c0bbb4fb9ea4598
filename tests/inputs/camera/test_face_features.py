"""Features say how far lids and lips are apart, whatever the face's size."""

import numpy as np
import pytest

from omote.inputs.camera.face_features import POSE_TERMS, lid_openings, measures, pose_row, pose_terms
from omote.inputs.camera.head_pose import HeadPose
from omote.inputs.camera.landmark_groups import IRISES, LIDS
from tests.inputs.camera.heads import mean_face


def test_lids_that_close_on_one_side_open_less_there_alone() -> None:
    face = mean_face()
    shut = face.copy()
    upper, lower = LIDS["Left"]
    shut[upper] = shut[lower]
    assert np.abs(lid_openings(shut, "Left")).max() == pytest.approx(0.0, abs=1e-12)
    assert lid_openings(shut, "Right").tolist() == lid_openings(face, "Right").tolist()


def test_lid_openings_are_over_the_width_of_the_eye() -> None:
    assert lid_openings(2.5 * mean_face(), "Left") == pytest.approx(lid_openings(mean_face(), "Left"))


def test_eyes_that_look_to_the_left_move_both_irises_the_same_way() -> None:
    face = mean_face()
    looking = face.copy()
    for rows in IRISES.values():
        looking[rows, 0] += 0.03
    change = measures(looking) - measures(face)
    assert change[7] > 0
    assert change[17] > 0
    assert np.count_nonzero(np.abs(change) > 1e-9) == 2


def test_many_faces_are_measured_at_once() -> None:
    faces = np.stack([mean_face(), 1.1 * mean_face()])
    assert measures(faces).tolist() == [measures(face).tolist() for face in faces]


def test_terms_of_a_pose_hold_angles_and_their_products() -> None:
    row = pose_row(HeadPose(2.0, np.eye(3), np.array([0.1, 0.2, 0.3])))
    assert row == pytest.approx([0.0, 0.0, 0.0, 0.1, 0.2, np.log(2.0)])
    terms = pose_terms(np.array([0.5, -0.2, 0.1, 0.0, 0.0, 0.0]))
    assert len(terms) == POSE_TERMS
    assert terms[6:] == pytest.approx([0.25, 0.04, 0.01, -0.1, 0.05, -0.02])
