"""Points against a mesh: distances, rays and winding numbers on shapes where they are known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.geometry.proximity import (
    cast_level_rays,
    cast_rays,
    measure_outside,
    nearest_triangles,
    winding_numbers,
)

RNG = np.random.default_rng(75)


def cube() -> NDArray[np.float64]:
    """The unit cube's twelve triangles (12, 3, 3), facing outward."""
    square = np.array([[[0, 0, 1], [1, 0, 1], [1, 1, 1]], [[0, 0, 1], [1, 1, 1], [0, 1, 1]]], np.float64)
    turned = [np.roll(square, shift, axis=2) for shift in range(3)]
    return np.concatenate([*turned, *(1.0 - side[:, ::-1] for side in turned)])


def outside_of(points: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.linalg.norm(points - np.clip(points, 0.0, 1.0), axis=1))


def test_the_distance_to_a_cube_is_what_it_is_in_theory() -> None:
    points = RNG.uniform(-1.0, 2.0, (400, 3))
    inside = np.minimum(points, 1.0 - points).min(axis=1)
    found, triangles = nearest_triangles(cube(), points)
    assert np.allclose(found, np.where(inside > 0, inside, outside_of(points)), atol=1e-12)
    assert np.allclose(
        [nearest_triangles(cube()[t : t + 1], p[None])[0][0] for t, p in zip(triangles, points, strict=True)], found
    )


def test_within_a_reach_distances_are_the_same_and_beyond_it_no_triangle_is_named() -> None:
    points = RNG.uniform(-1.0, 2.0, (400, 3))
    far, triangles = nearest_triangles(cube(), points)
    found, named = nearest_triangles(cube(), points, 0.4)
    near = far < 0.4
    assert 0 < near.sum() < len(near)
    assert np.array_equal(found, np.where(near, far, 0.4))
    assert np.array_equal(named, np.where(near, triangles, -1))


def test_before_walls_that_meet_the_way_back_ends_on_them_and_behind_there_is_none() -> None:
    draw = np.random.default_rng(76)
    walls = cube()[(cube()[..., [0, 2]].min(axis=1) > 0.5).any(axis=1)]  # the sides x = 1 and z = 1
    points = np.column_stack([draw.uniform(0.8, 1.2, 400), draw.uniform(0.3, 0.7, 400), draw.uniform(0.8, 1.2, 400)])
    points = np.concatenate([points, [[1.1, 0.5, 1.1]]])  # before the edge itself
    away, back = measure_outside(walls, points, 1.0)
    assert np.allclose(away, outside_of(points), atol=1e-12)
    out = away > 0
    assert 0 < out.sum() < len(out)
    assert np.allclose(points + away[:, None] * back, np.clip(points, 0.0, 1.0), atol=1e-9)
    assert not back[~out].any()
    assert not measure_outside(walls, points, 0.1)[0][outside_of(points) > 0.1].any()


def test_a_patch_of_a_surface_tells_its_two_sides_apart_near_it() -> None:
    draw = np.random.default_rng(77)
    wall = cube()[cube()[..., 2].min(axis=1) > 0.5]  # the side z = 1
    points = np.column_stack([draw.uniform(0.1, 0.9, (200, 2)), 1.0 + draw.uniform(-0.1, 0.1, 200)])
    away, back = measure_outside(wall, points, 0.2)
    assert np.allclose(away, np.maximum(points[:, 2] - 1.0, 0.0), atol=1e-12)
    assert np.allclose(back[away > 0], [0.0, 0.0, -1.0])


def test_the_winding_number_says_what_is_inside() -> None:
    points = RNG.uniform(-1.0, 2.0, (400, 3))
    assert np.allclose(winding_numbers(cube(), points), (outside_of(points) == 0).astype(float), atol=1e-9)
    assert np.allclose(winding_numbers(cube()[:, ::-1], np.full((1, 3), 0.5)), -1.0)


def test_a_ray_from_the_middle_meets_the_cube_where_it_leaves_it() -> None:
    ways = RNG.normal(size=(200, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    origins = np.full((200, 3), 0.5)
    far, triangles, weights = cast_rays(cube(), origins, ways, 0.0)
    assert np.allclose(far, 0.5 / np.abs(ways).max(axis=1))
    met = (weights[..., None] * cube()[triangles]).sum(axis=1)
    assert np.allclose(met, origins + far[:, None] * ways, atol=1e-9)


def test_a_level_ray_meets_what_any_ray_meets() -> None:
    points = cube().reshape(-1, 3)
    triangles = np.arange(36, dtype=np.int32).reshape(-1, 3)
    ways = RNG.normal(size=(200, 3)) * [1.0, 0.0, 1.0]
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    origins = RNG.uniform(-0.5, 1.5, (200, 3))
    far, at = cast_level_rays(points, triangles, origins, ways)
    wanted, which, _ = cast_rays(cube(), origins, ways, 0.0)
    met = np.isfinite(wanted)
    assert 0.2 < met.mean() < 0.9
    assert np.array_equal(met, np.isfinite(far))
    assert np.allclose(far[met], wanted[met], atol=1e-12)
    assert np.array_equal(at[met], which[met])


def test_a_ray_that_meets_nothing_says_so_and_one_may_begin_behind() -> None:
    origins = np.array([[0.5, 0.5, 1.25]])
    up = np.array([[0.0, 0.0, 1.0]])
    assert np.isinf(cast_rays(cube(), origins, up, 0.0)[0][0])
    assert np.isclose(cast_rays(cube(), origins, up, 0.3)[0][0], -0.25)
