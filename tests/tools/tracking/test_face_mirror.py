"""The mirror turns features round as it turns faces."""

import numpy as np
import pytest

from omote.inputs.camera.face_features import measures, pose_row, pose_terms
from omote.inputs.camera.head_pose import HeadPose
from omote.inputs.camera.landmark_map import load_landmark_map
from tests.inputs.camera.heads import mean_face, rotation
from tools.tracking.face_mirror import find_mirror, mirror_face, mirror_measures, mirror_pose


def crooked_face() -> np.ndarray:
    return mean_face() + np.random.default_rng(2).normal(0.0, 0.02, (478, 3))


def test_every_point_has_one_partner() -> None:
    pairs = find_mirror(mean_face())
    assert (pairs[pairs] == np.arange(478)).all()
    assert mirror_face(mean_face(), pairs) == pytest.approx(mean_face(), abs=0.01)


def test_measures_of_a_mirrored_face_are_the_mirrored_measures() -> None:
    face = crooked_face()
    (rows, signs) = mirror_measures()
    assert measures(mirror_face(face, find_mirror(mean_face()))) == pytest.approx(measures(face)[rows] * signs)


def test_a_pose_turns_round() -> None:
    row = pose_row(HeadPose(0.2, rotation((0.3, 0.2, 0.1)), np.array([0.1, 0.2, 0.0])))
    other = pose_row(HeadPose(0.2, rotation((-0.3, 0.2, -0.1)), np.array([-0.1, 0.2, 0.0])))
    assert pose_terms(other) == pytest.approx(pose_terms(row) * mirror_pose())


def test_the_built_in_map_reads_a_mirrored_face_as_the_mirrored_one() -> None:
    general = load_landmark_map()
    face = crooked_face()
    rest = mean_face()
    pairs = find_mirror(rest)
    row = pose_row(HeadPose(0.12, rotation((0.3, 0.1, 0.0)), np.zeros(3)))
    turned = pose_row(HeadPose(0.12, rotation((-0.3, 0.1, 0.0)), np.zeros(3)))
    seen = general.compression.features(face, rest, row)
    other = general.compression.features(mirror_face(face, pairs), mirror_face(rest, pairs), turned)
    assert other == pytest.approx(seen[general.order] * general.sign, abs=0.02)
