"""Samples: on the surface, by area, the same each time."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_surface import measure_spacing, sample_surface, thin_out
from tests.model.fitting.placed_heads import ball


def _square(size: float, at: float) -> tuple[np.ndarray, np.ndarray]:
    corners = np.array([(0, 0, at), (size, 0, at), (size, size, at), (0, size, at)])
    return np.concatenate([corners, np.tile(corners[:1], (60, 1))]), np.array([(0, 1, 2), (0, 2, 3)])


def test_samples_lie_on_the_triangles_as_many_as_their_share_of_the_area() -> None:
    (small, one) = _square(1.0, 0.0)
    (large, other) = _square(3.0, 5.0)
    scan = Scan(np.concatenate([small, large]), np.concatenate([one, other + len(small)]))
    points = sample_surface(scan, count=10_000)
    assert len(points) == 10_000
    assert set(points[:, 2]) == {0.0, 5.0}
    assert np.isclose((points[:, 2] == 0.0).mean(), 0.1, atol=1e-3)
    assert np.array_equal(points, sample_surface(scan, count=10_000))


def test_chosen_points_are_all_that_is_sampled() -> None:
    scan = ball((1.0, 1.0, 1.0))
    points = sample_surface(scan, chosen=scan.positions[:, 0] > 0.5, count=2000)
    assert points[:, 0].min() > 0.3


def test_a_cloud_is_its_own_samples() -> None:
    cloud = np.random.default_rng(1).normal(size=(500, 3))
    assert np.array_equal(sample_surface(Scan(cloud)), cloud)
    some = sample_surface(Scan(cloud), count=200)
    assert len(some) == 200
    assert set(map(tuple, some)) <= set(map(tuple, cloud))


def test_thinned_points_are_means_of_their_cubes_so_none_is_lost() -> None:
    points = np.random.default_rng(2).uniform(size=(4000, 3))
    thin = thin_out(points, 0.25)
    assert len(thin) == 64
    assert cKDTree(thin).query(points)[0].max() < 0.25 * np.sqrt(3)
    assert np.allclose(thin_out(points, 100.0), points.mean(axis=0))


def test_spacing_does_not_see_doubled_points() -> None:
    lattice = np.stack(np.meshgrid(np.arange(40.0), np.arange(40.0), [0.0]), axis=-1).reshape(-1, 3)
    spacing = measure_spacing(lattice, cKDTree(lattice))
    twice = np.tile(lattice, (2, 1))
    assert np.isclose(spacing, 0.5)
    assert np.isclose(measure_spacing(twice, cKDTree(twice)), spacing)
