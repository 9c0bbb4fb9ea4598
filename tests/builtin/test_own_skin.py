"""The built-in head's skin as photographs are compared with it."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast, load_landmark_table
from omote.builtin.own_skin import load_skin_samples


def test_units_move_the_skin_as_they_move_landmarks_on_it() -> None:
    table = load_landmark_table()
    samples = load_skin_samples()
    assert samples.units.shape == (len(table.units), load_cast().space.vertex_count, 3)
    for name, moves in zip(table.units, samples.units, strict=True):
        assert table.places(moves) == pytest.approx(table.units[name], abs=2e-5)


def test_layers_are_shares_and_lie_alike_on_both_sides() -> None:
    layers = load_skin_samples().layers
    places = load_skin_samples().on(load_cast().space.points)
    assert layers.min() >= 0.0
    assert layers.max() <= 1.0
    left, right = (layers[np.sign(places[:, 0]) == side].mean(axis=0) for side in (1.0, -1.0))
    assert left == pytest.approx(right, rel=0.1)
