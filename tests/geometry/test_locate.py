"""Walking: finds exactly the triangle that a search through all finds, around the seam too."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import Delaunay

from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.geometry.locate import FARTHEST, Strip, walk_face

HEIGHT = 2.0


def periodic(count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """theta, h (n,) and triangles of a periodic Delaunay strip."""
    rng = np.random.default_rng(seed)
    theta = np.r_[
        rng.uniform(-np.pi, np.pi, count), *(np.linspace(-np.pi, np.pi, 12, endpoint=False) for _ in range(2))
    ]
    h = np.r_[rng.uniform(0.05, HEIGHT - 0.05, count), np.zeros(12), np.full(12, HEIGHT)]
    total = len(theta)
    unrolled = np.r_[theta - 2 * np.pi, theta, theta + 2 * np.pi]
    found = Delaunay(np.stack([unrolled, np.tile(h, 3)], axis=1)).simplices
    lowest = np.take_along_axis(found, (found % total).argmin(axis=1)[:, None], axis=1)[:, 0]
    triangles = (found % total)[(lowest >= total) & (lowest < 2 * total)].astype(np.int32)
    corners = theta[triangles[:, :1]] + wrap(theta[triangles] - theta[triangles[:, :1]])
    height = h[triangles]
    sign = (corners[:, 1] - corners[:, 0]) * (height[:, 2] - height[:, 0]) > (corners[:, 2] - corners[:, 0]) * (
        height[:, 1] - height[:, 0]
    )
    triangles[~sign] = triangles[~sign][:, ::-1]
    return theta, h, triangles


@pytest.fixture(scope="module")
def strip() -> tuple[Strip, np.ndarray, np.ndarray]:
    theta, h, triangles = periodic(300, 1)
    corners = theta[triangles[:, :1]] + wrap(theta[triangles] - theta[triangles[:, :1]])
    return Strip.of(corners, h[triangles], mesh.neighbours(triangles)), corners, h[triangles]


def test_a_walk_from_anywhere_finds_the_point(strip: tuple[Strip, np.ndarray, np.ndarray]) -> None:
    walked, corners, heights = strip
    rng = np.random.default_rng(2)
    theta = rng.uniform(-20, 20, 2000)
    h = rng.uniform(0.0, HEIGHT, 2000)
    landing = walked.locate(theta, h, rng.integers(0, len(corners), 2000).astype(np.int32))
    assert landing.inside.all()
    assert (landing.weights >= -1e-9).all()
    assert np.allclose(landing.weights.sum(axis=1), 1.0)
    back = (landing.weights * corners[landing.triangles]).sum(axis=1)
    assert np.allclose(wrap(back - theta), 0.0, atol=1e-9)
    assert np.allclose((landing.weights * heights[landing.triangles]).sum(axis=1), h, atol=1e-9)


def test_following_a_leader_finds_the_same_points(strip: tuple[Strip, np.ndarray, np.ndarray]) -> None:
    walked, corners, _ = strip
    rng = np.random.default_rng(5)
    theta = rng.uniform(-20, 20, 2000)
    h = rng.uniform(-0.2, HEIGHT + 0.2, 2000)
    start = rng.integers(0, len(corners), 2000).astype(np.int32)
    leaders = (rng.integers(0, 2000, 2000) % np.maximum(np.arange(2000), 1)).astype(np.int32)
    leaders[rng.random(2000) < 0.1] = -1
    leaders[0] = -1
    alone = walked.locate(theta, h, start)
    led = walked.locate(theta, h, start, leaders=leaders)
    assert np.array_equal(led.inside, alone.inside)
    assert 0 < alone.inside.sum() < 2000
    assert np.array_equal(led.triangles, alone.triangles)
    assert np.allclose(led.weights, alone.weights, atol=1e-9)


def test_a_point_beyond_the_rim_is_said_to_be_outside_and_its_weights_stay_small(
    strip: tuple[Strip, np.ndarray, np.ndarray],
) -> None:
    walked = strip[0]
    theta = np.linspace(-3, 3, 50)
    landing = walked.locate(theta, np.full(50, HEIGHT + 30.0), np.zeros(50, np.int32))
    assert not landing.inside.any()
    assert landing.weights.min() >= -FARTHEST - 1e-9
    assert np.allclose(landing.weights.sum(axis=1), 1.0)


def test_a_triangle_without_positive_area_is_refused() -> None:
    with pytest.raises(ValueError, match="triangle 0 has no positive area on S"):
        Strip.of(np.array([[0.0, 0.0, 1.0]]), np.array([[0.0, 1.0, 0.0]]), np.full((1, 3), -1, np.int32))


def test_a_ray_from_the_axis_meets_the_triangle_that_it_was_aimed_at() -> None:
    theta, h, triangles = periodic(300, 5)
    r = 1.0 + 0.2 * np.sin(3 * theta) * np.cos(2 * h)
    points = np.stack([0.3 + r * np.sin(theta), h, -0.2 + r * np.cos(theta)], axis=1)
    rng = np.random.default_rng(7)
    aimed = rng.integers(0, len(triangles), 500)
    weights = rng.dirichlet([1, 1, 1], 500)
    surface = (weights[..., None] * points[triangles[aimed]]).sum(axis=1)
    # Pushed off along the radius: the walk must come back to the same place in the same triangle.
    axis = np.array([0.3, 0.0, -0.2])
    pushed = axis + (surface - axis) * np.stack([(s := rng.uniform(0.5, 2.0, 500)), np.ones(500), s], axis=1)
    found = np.empty(500, np.int32)
    back = np.empty((500, 3))
    inside = np.empty(500, np.bool_)
    start = rng.integers(0, len(triangles), 500).astype(np.int32)
    walk_face(points, triangles, mesh.neighbours(triangles), 0.3, -0.2, pushed, start, found, back, inside)
    assert inside.all()
    assert np.allclose((back[..., None] * points[triangles[found]]).sum(axis=1), surface, atol=1e-9)


def test_a_fold_in_the_way_is_searched_around() -> None:
    """A sheet folded into a Z: the ray meets three layers, and the one fewest steps from the start answers."""
    strip_points = np.array([[x, y, z] for x, z in [(0, 2.0), (2, 2.0), (1, 1.5), (3, 1.2)] for y in (-1, 1)], float)
    quads = [(0, 2, 3, 1), (2, 4, 5, 3), (4, 6, 7, 5)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))], np.int32)
    target = np.array([[1.5, 0.2, 1.6]])
    for start, layer in ((0, (0, 1)), (4, (4, 5))):
        found = np.empty(1, np.int32)
        back = np.empty((1, 3))
        inside = np.empty(1, np.bool_)
        begin = np.array([start], np.int32)
        walk_face(strip_points, triangles, mesh.neighbours(triangles), 0.0, 0.0, target, begin, found, back, inside)
        assert inside.all()
        assert found[0] in layer
