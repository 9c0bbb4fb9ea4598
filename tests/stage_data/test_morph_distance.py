"""How far faces are apart: all moved alike are as far apart as they were moved, whatever their inner skin does."""

from __future__ import annotations

import numpy as np
import pytest

from omote.stage_data.morph_distance import measure_distance
from tests import synthetic


def test_a_face_that_is_moved_is_as_far_away_as_it_was_moved() -> None:
    space = synthetic.space()
    moved = space.points + np.where(space.on_sheet[:, None], [0.0, 0.003, 0.004], [1.0, 1.0, 1.0])
    assert measure_distance(space, space.points, moved) == pytest.approx(5.0)
    assert measure_distance(space, space.points, space.points) == 0.0
