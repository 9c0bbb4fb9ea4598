"""The template: of the face in front and the skull, made once, shaped by modes as the modes are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_identity_modes
from omote.model.fitting.head_template import MODES, make_template
from tests.model.fitting.placed_heads import CAST

FOUND = load_identity_modes()
TEMPLATE = make_template(CAST.space, FOUND)


def test_it_is_made_once() -> None:
    assert make_template(CAST.space, FOUND) is TEMPLATE


def test_its_shape_is_that_of_the_modes() -> None:
    weights = np.random.default_rng(1).normal(size=MODES)
    whole = np.zeros(len(FOUND.moves))
    whole[:MODES] = weights
    assert np.allclose(TEMPLATE.shape(TEMPLATE.matched, weights), FOUND.shape_skin(whole)[TEMPLATE.matched])
    assert np.array_equal(TEMPLATE.shape(TEMPLATE.face, np.zeros(0)), TEMPLATE.points[TEMPLATE.face])


def test_the_face_is_outer_skin_about_the_seven_landmarks() -> None:
    assert CAST.space.on_sheet[TEMPLATE.face].all()
    low = TEMPLATE.points[TEMPLATE.face].min(axis=0)
    high = TEMPLATE.points[TEMPLATE.face].max(axis=0)
    marks = TEMPLATE.points[TEMPLATE.marks]
    assert (marks > low).all()
    assert (marks[:, :2] < high[:2]).all()
    assert TEMPLATE.normals[TEMPLATE.face, 2].mean() > 0.5


def test_its_nose_points_forward() -> None:
    assert len(TEMPLATE.nose.points) == 1
    assert TEMPLATE.nose.frames[0, 2, 2] > 0.9


def test_modes_of_another_head_are_rejected() -> None:
    with pytest.raises(ValueError, match="identity modes are of"):
        make_template(CAST.space, replace(FOUND, skin=FOUND.skin[1:]))
