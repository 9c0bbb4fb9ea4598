"""Landmarks: named by lines and the midline, the same on both sides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import omote
from omote.model.fitting.landmarks import SEVEN, find_landmarks
from tests import synthetic

SPACE = omote.load_cast().space


def _at(row: int) -> np.ndarray:
    place: np.ndarray = SPACE.points[row]
    return place


def test_left_is_the_mirror_image_of_right_and_the_nose_is_between() -> None:
    rows = find_landmarks(SPACE)
    assert tuple(rows) == SEVEN
    for left, right in (("left_eye_outer", "right_eye_outer"), ("left_eye_inner", "right_eye_inner"),
                        ("mouth_left", "mouth_right")):  # fmt: skip
        assert _at(rows[left])[0] > 0
        assert np.allclose(_at(rows[left]) * (-1, 1, 1), _at(rows[right]), atol=1e-5)
    assert _at(rows["left_eye_outer"])[0] > _at(rows["left_eye_inner"])[0]
    assert np.isclose(_at(rows["nose_tip"])[0], 0.0, atol=1e-5)


def test_the_nose_tip_is_the_farthest_point_of_the_face() -> None:
    rows = find_landmarks(SPACE)
    assert SPACE.points[rows["nose_tip"], 2] == SPACE.points[SPACE.on_sheet, 2].max()
    assert _at(rows["mouth_left"])[1] < _at(rows["nose_tip"])[1] < _at(rows["left_eye_inner"])[1]


def test_corners_are_the_ends_of_their_lines() -> None:
    rows = set(find_landmarks(SPACE).values())
    for line in SPACE.lines:
        ends = {
            int(line.loop[np.argmin(SPACE.points[line.loop, 0])]),
            int(line.loop[SPACE.points[line.loop, 0].argmax()]),
        }
        assert ends <= rows


def test_a_space_without_lines_is_rejected_in_words() -> None:
    with pytest.raises(ValueError, match="names 0 pairs of lids and 0 pairs of lips; expected two and one"):
        find_landmarks(synthetic.space())


def test_a_space_without_a_nose_is_rejected_in_words() -> None:
    flat = replace(SPACE, on_sheet=np.zeros_like(SPACE.on_sheet))
    with pytest.raises(ValueError, match="expected a nose"):
        find_landmarks(flat)
