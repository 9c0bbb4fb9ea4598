"""Shapes that are no expressions are told why."""

import numpy as np

import omote
from omote.model.fitting.take_expressions import explain_unfit

SPACE = omote.load_cast().space
SEEN = np.ones(SPACE.vertex_count)
STILL = np.zeros((SPACE.vertex_count, 3))


def test_each_reason_and_none() -> None:
    assert explain_unfit(SPACE, SEEN, STILL, {}) == "moves nothing of the face"
    assert "by 87 cm" in explain_unfit(SPACE, SEEN, np.full_like(STILL, 0.5), {})
    assert "another head" in explain_unfit(SPACE, SEEN, 0.05 * SPACE.points, {})
    assert explain_unfit(SPACE, SEEN, STILL, {"tongue": np.array([[0.0, 0.0, 0.01]])}) == ""
