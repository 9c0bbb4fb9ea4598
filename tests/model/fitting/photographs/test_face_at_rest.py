"""What a face does in a photograph that shows it otherwise than at rest."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.fitting.photographs.face_at_rest import (
    CHIN,
    FOREHEAD,
    LEFT_EYE,
    LOWER_LIP,
    RIGHT_EYE,
    UPPER_LIP,
    describe_unrest,
)
from omote.model.fitting.photographs.photograph import Photograph


def landmarks(mouth: float = 0.01, lids: float = 0.3) -> np.ndarray:
    """A face 100 pixels tall with eyes 20 wide; mouth, lids: their gaps, of that."""
    points = np.full((478, 2), 50.0)
    points[FOREHEAD, 1], points[CHIN, 1] = 0.0, 100.0
    points[LOWER_LIP, 1] = points[UPPER_LIP, 1] + 100.0 * mouth
    for outer, inner, upper, lower in (RIGHT_EYE, LEFT_EYE):
        points[outer, 0], points[inner, 0] = 20.0, 40.0
        points[lower, 1] = points[upper, 1] + 20.0 * lids
    return points


@pytest.mark.parametrize(
    ("mouth", "lids", "smile", "said"),
    [
        (0.02, 0.25, 0.2, []),
        (0.06, 0.25, 0.2, ["its mouth open"]),
        (0.02, 0.1, 0.2, ["its eyes shut"]),
        (0.02, 0.25, 0.5, ["a smile"]),
        (0.06, 0.1, 0.5, ["its mouth open", "a smile", "its eyes shut"]),
    ],
)
def test_a_photograph_that_is_not_at_rest_is_said_to_be_what_it_is(
    mouth: float, lids: float, smile: float, said: list[str]
) -> None:
    view = Photograph(landmarks(mouth, lids), 500, 500)
    assert describe_unrest(view, 0.0, {"mouthSmileLeft": smile, "mouthSmileRight": smile}) == said


def test_the_farther_eye_of_a_turned_head_is_not_taken_for_shut() -> None:
    points = landmarks()
    points[LEFT_EYE[3]] = points[LEFT_EYE[2]]
    assert describe_unrest(Photograph(points, 500, 500), 0.5, {}) == []
    assert describe_unrest(Photograph(points, 500, 500), 0.0, {}) == ["its eyes shut"]
    assert describe_unrest(Photograph(points, 500, 500), -0.5, {}) == ["its eyes shut"]


def test_any_other_face_that_is_not_at_rest_is_told_too() -> None:
    view = Photograph(landmarks(), 500, 500)
    assert describe_unrest(view, 0.0, {"browInnerUp": 0.8}) == ["a face that is not at rest"]
