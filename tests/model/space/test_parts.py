"""Parts: placed by similarity, moved by their bindings, eyeballs by angles."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.model.space.parts import (
    Part,
    bind_to_head,
    bind_to_jaw,
    bind_to_skin,
    eye_angles,
    eye_rotation,
    place,
)
from omote.model.transfer.compound import predict_part
from tests.synthetic import space

BALL = np.array([[0.01, 0, 0], [0, 0.01, 0], [0, 0, 0.01], [-0.01, -0.01, -0.01]]) + np.array([0.03, 0.03, 0.06])
FACES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
angles = st.floats(-1.0, 1.0)


@given(angles, angles)
def test_the_angles_of_a_turned_ball_are_read_back(yaw: float, pitch: float) -> None:
    centre = BALL.mean(axis=0)
    turned = (BALL - centre) @ eye_rotation(yaw, pitch).T + centre
    assert np.allclose(eye_angles(BALL, turned), (yaw, pitch), atol=1e-9)


def test_a_gaze_to_the_characters_left_looks_to_plus_x_and_up_to_plus_y() -> None:
    ahead = np.array([0.0, 0.0, 1.0])
    assert (eye_rotation(0.3, 0.0) @ ahead)[0] > 0
    assert (eye_rotation(0.0, 0.3) @ ahead)[1] > 0
    assert np.allclose(eye_rotation(0.4, -0.2) @ eye_rotation(0.4, -0.2).T, np.eye(3))


def test_bindings_follow_the_skin_as_they_say() -> None:
    sheet = np.flatnonzero(space().on_sheet).astype(np.int32)
    skin = space().points
    chin = sheet[:10]
    bound = space().with_parts(
        bind_to_head("still", BALL, FACES, skin, candidates=sheet),
        bind_to_jaw("jaw", BALL, FACES, skin, candidates=sheet, chin=chin),
        bind_to_skin("stuck", BALL, FACES, skin, candidates=sheet),
    )
    shift = np.tile([0.0, -0.01, 0.002], (len(skin), 1))
    assert (predict_part(bound, "still", shift) == 0).all()
    for name in ("jaw", "stuck"):
        assert np.allclose(predict_part(bound, name, shift), shift[0])
    only_chin = np.zeros_like(skin)
    only_chin[chin] = [0.0, -0.02, 0.0]
    assert np.allclose(predict_part(bound, "jaw", only_chin), [0.0, -0.02, 0.0])


def test_a_part_is_placed_by_the_similarity_of_its_ring() -> None:
    part = space().parts["eye_left"]
    moved = space().points * 0.8 + [0.0, 0.05, 0.0]
    assert np.allclose(place(part, space().points, moved), part.points * 0.8 + [0.0, 0.05, 0.0], atol=1e-9)


def test_parts_are_refused() -> None:
    ring = np.arange(5, dtype=np.int32)
    none = np.zeros((4, 1))
    with pytest.raises(ValueError, match="ring of 2 skin vertices"):
        Part("a", BALL, FACES, ring[:2], none.astype(np.int32), none)
    with pytest.raises(ValueError, match="expected one row each for its 4 vertices"):
        Part("a", BALL, FACES, ring, np.zeros((3, 1), np.int32), np.zeros((3, 1)))
    with pytest.raises(ValueError, match="is the 'third' eye"):
        Part("a", BALL, FACES, ring, none.astype(np.int32), none, eye="third")
    with pytest.raises(ValueError, match="indices from 0 to 3"):
        Part("a", BALL, FACES + 2, ring, none.astype(np.int32), none)
