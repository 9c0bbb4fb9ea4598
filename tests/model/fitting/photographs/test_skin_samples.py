"""What is known of skin before it is photographed."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.builtin.own_skin import load_skin_samples
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.photographs.skin_evidence import BROWS, EVEN, LIPS

SPACE = load_cast().space
SAMPLES = load_skin_samples()


def test_points_lie_on_the_face_and_stand_for_its_area() -> None:
    assert head_zones(SPACE).face[SAMPLES.corners].all()
    assert SAMPLES.areas.mean() == pytest.approx(1.0)
    assert SAMPLES.on(SPACE.points) == pytest.approx(SPACE.points[SAMPLES.corners].mean(axis=1))


def test_brows_and_the_border_of_the_lips_are_known_less_than_skin() -> None:
    bare = SAMPLES.layers[:, :2].max(axis=1) == 0.0
    assert SAMPLES.spread[bare] == pytest.approx(EVEN)
    assert SAMPLES.spread[SAMPLES.layers[:, BROWS] > 0.3].min() > 1.2 * EVEN
    border = np.abs(SAMPLES.layers[:, LIPS] - 0.5) < 0.2
    assert SAMPLES.spread[border].min() > 1.2 * EVEN


def test_lips_lie_below_brows() -> None:
    height = SAMPLES.on(SPACE.points)[:, 1]
    lips = SAMPLES.layers[:, LIPS] > 0.9
    brows = SAMPLES.layers[:, BROWS] > 0.5
    assert height[lips].max() < height[brows].min()
