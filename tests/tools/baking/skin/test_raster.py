"""Triangles to pixels, and how much of the sky a vertex sees."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from tools.baking.skin.raster import openness, rasterise, sphere, vertex_normals


def ball(radius: float) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """A ball's vertices and triangles, counter-clockwise seen from outside."""
    points = radius * sphere(600)
    triangles = ConvexHull(points).simplices
    inwards = np.linalg.det(points[triangles]) < 0
    return points, np.where(inwards[:, None], triangles[:, ::-1], triangles).astype(np.int32)


def test_weights_give_back_the_pixels_centre() -> None:
    corners = np.array([[[1.0, 1, 0], [14, 2, 0], [3, 13, 0]]])
    owner, weights, _ = rasterise(corners, 16)
    rows, columns = np.nonzero(owner == 0)
    assert abs(len(rows) - 0.5 * (13 * 12 - 1 * 2)) < 8
    np.testing.assert_allclose(weights[rows, columns] @ corners[0, :, 0], columns + 0.5)
    np.testing.assert_allclose(weights[rows, columns] @ corners[0, :, 1], rows + 0.5)


def test_the_nearer_triangle_is_seen_in_either_order() -> None:
    low = [[0.0, 0, 1], [16, 0, 1], [0, 16, 1]]
    high = [[0.0, 0, 2], [8, 0, 2], [0, 8, 2]]
    first, second = (rasterise(np.array(pair), 16) for pair in ([low, high], [high, low]))
    np.testing.assert_array_equal(first[2], second[2])
    assert first[2][1, 1] == 2.0
    assert first[0][15, 15] == -1


def test_triangles_without_area_are_not_drawn() -> None:
    assert (rasterise(np.array([[[0.0, 0, 0], [4, 4, 0], [8, 8, 0]]]), 8)[0] == -1).all()


def test_the_directions_are_spread_evenly() -> None:
    points = sphere(200)
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 1.0)
    np.testing.assert_allclose(points.mean(axis=0), 0.0, atol=0.01)


def test_normals_of_a_ball_point_outwards() -> None:
    points, triangles = ball(1.0)
    np.testing.assert_allclose(vertex_normals(points, triangles), points, atol=0.05)


def test_a_ball_sees_all_of_its_sky_and_what_lies_in_a_shell_sees_none() -> None:
    shell, triangles = ball(0.1)
    assert openness(shell, triangles).min() > 0.9
    light = openness(np.concatenate([shell, 0.8 * shell]), np.concatenate([triangles, triangles + len(shell)]))
    assert light[len(shell) :].max() < 0.05
