"""The cylinder: there and back, and what it refuses."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.geometry.cylinder import Cylinder, wrap

metres = st.floats(-1, 1)


@given(metres, metres, st.lists(st.tuples(metres, metres, metres), min_size=1, max_size=20))
def test_unroll_and_roll_are_inverse(x: float, z: float, points: list[tuple[float, float, float]]) -> None:
    cylinder = Cylinder(x, z)
    there = np.array(points)
    assert np.allclose(cylinder.roll(*cylinder.unroll(there)), there, atol=1e-12)


@given(st.floats(-100, 100))
def test_wrap_keeps_the_direction_and_lands_in_one_turn(angle: float) -> None:
    wrapped = float(wrap(np.array(angle)))
    assert -np.pi <= wrapped < np.pi
    assert np.isclose(np.cos(wrapped), np.cos(angle), atol=1e-9)
    assert np.isclose(np.sin(wrapped), np.sin(angle), atol=1e-9)


def test_theta_is_zero_ahead_and_positive_to_the_characters_left() -> None:
    theta, h, r = Cylinder(0.0, 0.02).unroll(np.array([[0.0, 0.3, 0.12], [0.1, 0.3, 0.02], [-0.1, 0.3, 0.02]]))
    assert np.allclose(theta, [0.0, np.pi / 2, -np.pi / 2])
    assert np.allclose(h, 0.3)
    assert np.allclose(r, 0.1)


def test_an_axis_that_is_nowhere_is_refused() -> None:
    with pytest.raises(ValueError, match=r"x = nan.*finite"):
        Cylinder(float("nan"), 0.0)


@given(metres, metres, st.lists(st.tuples(metres, metres, metres), min_size=1, max_size=20))
def test_outward_is_level_and_leads_from_the_axis(x: float, z: float, points: list[tuple[float, float, float]]) -> None:
    cylinder = Cylinder(x, z)
    there = np.array(points)
    theta, _, radius = cylinder.unroll(there)
    far = radius > 1e-6
    wanted = np.stack([np.sin(theta), np.zeros(len(theta)), np.cos(theta)], axis=1)
    assert np.allclose(cylinder.outward(there)[far], wanted[far], atol=1e-9)
