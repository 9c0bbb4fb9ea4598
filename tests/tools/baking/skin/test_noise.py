"""Noise in space."""

import numpy as np

from tools.baking.skin.noise import cell_noise, cloud_noise, strand_noise, value_noise

RNG = np.random.default_rng(5)
PLACES = RNG.uniform(-0.1, 0.1, (4000, 3))
X, Y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def test_it_is_the_same_again_and_another_with_another_seed() -> None:
    np.testing.assert_array_equal(value_noise(PLACES, 0.01, seed=1), value_noise(PLACES, 0.01, seed=1))
    assert np.abs(value_noise(PLACES, 0.01, seed=1) - value_noise(PLACES, 0.01, seed=2)).mean() > 0.1


def test_it_fills_its_range_evenly_and_never_leaves_it() -> None:
    for found in (value_noise(PLACES, 0.004, seed=3), cloud_noise(PLACES, 0.008, seed=3)):
        assert (found.min() >= 0.0, found.max() <= 1.0) == (True, True)
        assert abs(found.mean() - 0.5) < 0.02


def test_it_is_smooth_across_the_cells_of_its_lattice() -> None:
    step = 1e-7
    for axis in np.eye(3):
        for found in (value_noise, cloud_noise):
            change = found(PLACES + step * axis, 0.01, seed=4) - found(PLACES, 0.01, seed=4)
            assert np.abs(change).max() < 1e3 * step


def test_cells_are_balls_around_points_that_the_second_never_beats() -> None:
    first, second, own = cell_noise(PLACES, 0.01, seed=6)
    assert (first <= second).all()
    assert first.max() < np.sqrt(3.0)
    nudged, _, same = cell_noise(PLACES + 1e-6 * X, 0.01, seed=6)
    assert np.abs(nudged - first).max() <= 1e-4 + 1e-9  # a distance never changes faster than the place
    assert (own == same).mean() > 0.999


def test_strands_change_across_and_hardly_along() -> None:
    flow = np.broadcast_to([0.01, 0.0, 0.0], PLACES.shape)
    here = strand_noise(PLACES, flow, 0.001, seed=7)
    along = strand_noise(PLACES + 0.001 * X, flow, 0.001, seed=7)
    across = strand_noise(PLACES + 0.001 * Y, flow, 0.001, seed=7)
    assert np.abs(along - here).mean() < 0.5 * np.abs(across - here).mean()
