"""The table of landmarks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_identity_modes, load_landmark_table
from omote.inputs.camera.landmark_groups import CORNERS, MOUTH_CORNERS
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.photographs.landmark_table import ON_SKIN, refuse_other_space

TABLE = load_landmark_table()
SPACE = load_cast().space


def test_named_points_lie_where_the_space_names_them() -> None:
    places = TABLE.places(SPACE.points)
    rows = find_landmarks(SPACE)
    points = {
        "left_eye_inner": CORNERS["Left"][0], "left_eye_outer": CORNERS["Left"][1],
        "right_eye_inner": CORNERS["Right"][0], "right_eye_outer": CORNERS["Right"][1],
        "mouth_left": MOUTH_CORNERS[0], "mouth_right": MOUTH_CORNERS[1], "nose_tip": 4,
    }  # fmt: skip
    for name, point in points.items():
        assert np.linalg.norm(places[point] - SPACE.points[rows[name]]) < 0.008, name


def test_places_follow_every_skin_of_a_stack() -> None:
    modes = load_identity_modes()
    moved = TABLE.places(modes.moves[:3])
    assert moved.shape == (3, ON_SKIN, 3)
    assert moved[1] == pytest.approx(TABLE.places(modes.skin + modes.moves[1]) - TABLE.places(modes.skin), abs=1e-9)


def test_errors_at_a_node_are_the_nodes_and_between_two_half_of_both() -> None:
    first, second = TABLE.nodes[2:4]
    middle = TABLE.error_at(float(first + second) / 2)
    ends = TABLE.error_at(float(first)), TABLE.error_at(float(second))
    for name in ("mean", "slopes", "person", "shared", "alone"):
        assert getattr(middle, name) == pytest.approx((getattr(ends[0], name) + getattr(ends[1], name)) / 2)
    beyond = TABLE.error_at(9.0)
    assert beyond.mean == pytest.approx(TABLE.error_at(float(TABLE.nodes[-1])).mean)


def test_weighing_is_the_inverse_of_the_covariance() -> None:
    law = TABLE.error_at(0.3)
    trust = np.random.default_rng(1).uniform(0.1, 1.0, len(law.alone))
    covariance = law.basis @ law.shared @ law.basis.T + np.diag(law.alone / trust)
    assert law.weigh(covariance, trust) == pytest.approx(np.eye(len(trust)), abs=1e-6)
    whole = law.basis @ law.shared @ law.basis.T + np.diag(law.alone)
    assert law.variance == pytest.approx(np.diag(whole))


def test_a_landmark_model_draws_faces_towards_what_it_knows() -> None:
    """Across the face, a head that is wider by modes is seen less wide by some."""
    moves = TABLE.places(load_identity_modes().moves)[:, :, :2].reshape(len(TABLE.slopes[0].T), -1)
    gain = (TABLE.error_at(0.0).slopes.T * moves).sum() / (moves**2).sum()
    assert -1.0 < gain < 0.0


def test_a_table_of_another_head_is_refused() -> None:
    other = replace(TABLE, corners=TABLE.corners + SPACE.vertex_count)
    with pytest.raises(ValueError, match="expected the built-in cast's space"):
        refuse_other_space(SPACE, other)
