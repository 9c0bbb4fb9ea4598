"""Ramps: their ends, their middle, level where they begin and end."""

import numpy as np

from omote.geometry.ramp import clamp_unit, smooth_ramp


def test_what_lies_beyond_ends_at_the_ends() -> None:
    np.testing.assert_array_equal(clamp_unit(np.array([-1.0, 0.0, 0.25, 1.0, 7.0])), [0.0, 0.0, 0.25, 1.0, 1.0])


def test_a_smooth_ramp_is_point_symmetric_and_rises() -> None:
    away = np.linspace(0.0, 3.0, 50)
    up = smooth_ramp(-1.0, 2.0, 0.5 + away)
    down = smooth_ramp(-1.0, 2.0, 0.5 - away)
    np.testing.assert_allclose(up + down, 1.0)
    assert (np.diff(up) >= 0.0).all()
    np.testing.assert_array_equal(smooth_ramp(-1.0, 2.0, np.array([-5.0, -1.0, 0.5, 2.0, 9.0])), [0, 0, 0.5, 1, 1])


def test_it_is_level_at_both_ends() -> None:
    step = 1e-5
    ends = smooth_ramp(0.0, 1.0, np.array([step, 1.0 - step]))
    np.testing.assert_allclose(ends, [0.0, 1.0], atol=1e-9)
