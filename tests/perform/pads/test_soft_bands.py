"""The kernel of soft bands: the same bits in whatever order it is asked, and nothing of a place that is not used."""

from __future__ import annotations

import numpy as np

from omote.perform.pads.soft_bands import soft_bands


def test_a_dimension_that_is_not_used_changes_no_bit() -> None:
    rng = np.random.default_rng(0)
    for _ in range(100):
        places = np.zeros((7, 3))
        places[:, :2] = rng.uniform(-1.0, 1.0, (7, 2))
        x, y = rng.uniform(-1.0, 1.0, 2).tolist()
        flat, turned = np.empty(7), np.empty(7)
        soft_bands(places, x, y, 0.0, flat)
        soft_bands(np.ascontiguousarray(places[:, [2, 0, 1]]), 0.0, x, y, turned)
        assert flat.tobytes() == turned.tobytes()


def test_halfway_between_two_places_each_weighs_a_half_wherever_they_are() -> None:
    out = np.empty(2)
    soft_bands(np.array([[-1.0, 0.5, 0.0], [1.0, 0.5, 0.0]]), 0.0, -0.75, 0.0, out)
    assert out.tolist() == [0.5, 0.5]
