"""Membranes fill a hole with its own vertices, once."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.geometry.membrane import close_loop


def star(radii: list[float]) -> np.ndarray:
    """A polygon around the origin, simple by construction."""
    turns = 2 * np.pi * np.arange(len(radii)) / len(radii)
    return np.stack([radii * np.cos(turns), radii * np.sin(turns)], axis=1)


def area(polygon: np.ndarray) -> float:
    after = np.roll(polygon, -1, axis=0)
    return float((polygon[:, 0] * after[:, 1] - polygon[:, 1] * after[:, 0]).sum() / 2)


@given(st.lists(st.floats(0.2, 2.0), min_size=3, max_size=60))
def test_a_simple_polygon_is_filled_exactly_once(radii: list[float]) -> None:
    polygon = star(radii)
    triangles = close_loop(polygon)
    assert len(triangles) == len(polygon) - 2
    pieces = [area(polygon[triangle]) for triangle in triangles]
    assert min(pieces) > 0
    assert np.isclose(sum(pieces), area(polygon))


def test_a_slit_gets_rungs_from_one_side_to_the_other() -> None:
    # Lids: twelve points below, twelve above, a millimetre apart; every triangle must touch both.
    below = np.stack([np.arange(12.0), np.zeros(12)], axis=1)
    above = np.stack([np.arange(12.0)[::-1], np.full(12, 0.1)], axis=1)
    triangles = close_loop(np.concatenate([below, above]))
    assert all(len({corner < 12 for corner in triangle}) == 2 for triangle in triangles.tolist())


def test_a_polygon_that_runs_the_other_way_stays_open() -> None:
    assert len(close_loop(star([1.0] * 5)[::-1])) == 0
