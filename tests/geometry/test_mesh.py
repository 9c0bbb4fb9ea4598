"""Meshes: checks, neighbours, loops, components, subdivision."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from omote.geometry import mesh


def ball(count: int = 60) -> tuple[np.ndarray, np.ndarray]:
    points = np.random.default_rng(3).normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    triangles = ConvexHull(points).simplices.astype(np.int32)
    a, b, c = points[triangles].transpose(1, 0, 2)
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return points, triangles


SQUARE = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
SQUARE_POINTS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)


def test_every_edge_of_a_closed_surface_is_there_once() -> None:
    points, triangles = ball()
    edges = mesh.edges(triangles)
    assert (edges[:, 0] < edges[:, 1]).all()
    assert len(np.unique(edges, axis=0)) == len(edges) == len(points) + len(triangles) - 2  # Euler


def test_neighbours_are_mutual_and_complete_on_a_closed_surface() -> None:
    _, triangles = ball()
    across = mesh.neighbours(triangles)
    assert (across >= 0).all()
    for triangle, row in enumerate(across):
        for corner, other in enumerate(row):
            shared = set(np.delete(triangles[triangle], corner))
            assert shared < set(triangles[other])
            assert triangle in across[other]


def test_an_edge_of_three_triangles_or_of_two_that_disagree_has_no_neighbours() -> None:
    fin = np.array([[0, 1, 2], [1, 0, 3], [1, 0, 4]], np.int32)
    assert (mesh.neighbours(fin) == -1).all()
    assert (mesh.neighbours(np.array([[0, 1, 2], [0, 1, 3]], np.int32)) == -1).all()


def test_the_boundary_of_a_square_is_one_loop_with_the_mesh_on_the_left() -> None:
    (loop,) = mesh.boundary_loops(SQUARE, SQUARE_POINTS[:, :2])
    start = int(np.flatnonzero(loop == 0)[0])
    assert np.roll(loop, -start).tolist() == [0, 1, 2, 3]


def test_holes_that_touch_in_a_vertex_are_two_loops() -> None:
    # A 5 x 5 grid without two quads that share one corner: two square holes, not one figure of eight.
    row, column = np.meshgrid(np.arange(4), np.arange(4), indexing="ij")
    keep = ~(((row == 1) & (column == 1)) | ((row == 2) & (column == 2)))
    a = (row * 5 + column)[keep]
    triangles = np.concatenate([np.stack([a, a + 1, a + 6], 1), np.stack([a, a + 6, a + 5], 1)]).astype(np.int32)
    plane = np.stack([np.tile(np.arange(5.0), 5), np.repeat(np.arange(5.0), 5)], axis=1)
    loops = sorted((sorted(loop.tolist()) for loop in mesh.boundary_loops(triangles, plane)), key=len)
    assert loops[:2] == [[6, 7, 11, 12], [12, 13, 17, 18]]
    assert len(loops[2]) == 16


def test_a_closed_surface_has_no_boundary_and_its_normals_point_outward() -> None:
    points, triangles = ball(400)
    assert len(mesh.boundary_edges(triangles)) == 0
    assert ((mesh.normals(points, triangles) * points).sum(axis=1) > 0.9).all()


def test_components_are_numbered_by_size() -> None:
    triangles = np.array([[0, 1, 2], [3, 4, 5], [5, 4, 6]], np.int32)
    assert mesh.components(triangles, 8).tolist() == [1, 1, 1, 0, 0, 0, 0, 2]


def test_weld_names_the_first_of_equal_points() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 0, 0], [1, 0, 0]], float)
    assert mesh.weld(points).tolist() == [0, 1, 0, 1]


@pytest.mark.parametrize(
    ("points", "sentence"),
    [
        (np.zeros((3, 2)), r"shape \(3, 2\).*expected \(V, 3\)"),
        (np.zeros((0, 3)), r"shape \(0, 3\)"),
        ([[0, 0, np.nan]], r"points\[0\] is .*nan.*finite"),
        ([[0, 0, 0], [np.inf, 0, 0]], r"points\[1\]"),
        ([[0, 0, 0], [0, 0, 1e39]], r"points\[1\] is .*at most 1e\+06 from zero"),
        (None, "points has no numbers but NoneType: expected"),
        ("abc", "points has no numbers but str"),
        ([["1", "2", "3"]], "points has no numbers but str"),
        (np.zeros((1, 3), complex), "points has no numbers but complex128"),
        (np.zeros((1, 3), bool), "points has no numbers but bool"),
        (np.zeros((1, 3), object), "points has no numbers but object"),
        (np.zeros((1, 3), "M8[s]"), "points has no numbers but datetime64"),
        ([[0, 0, 0], [1, 2]], "points has rows of different lengths"),
        (np.ma.masked_equal(np.zeros((1, 3)), 0), "points has masked values"),
    ],
)
def test_points_are_refused(points: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        mesh.validate_points(points)


@pytest.mark.parametrize(
    ("triangles", "sentence"),
    [
        (np.zeros((2, 4), int), r"shape \(2, 4\)"),
        (np.zeros((1, 3)), "dtype float64"),
        ([[0, 1, 7]], r"indices from 0 to 3"),
        ([[0, -1, 2]], r"indices from 0 to 3"),
        ([[0, 2, 2]], "degenerate"),
        ([[0, 1, 2], [0, 1]], "triangles has rows of different lengths"),
        ([[True, False, True]], "dtype bool"),
        ([[0, 1, 2], [1, 2, 3], [2, 0, 1]], r"triangle 2 is \[2 0 1\], as triangle 0 is.*remove one of them"),
    ],
)
def test_triangles_are_refused(triangles: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        mesh.validate_triangles(triangles, 4)


def test_unit_normals_stand_on_their_triangles_and_are_nothing_where_there_is_no_area() -> None:
    points, triangles = ball()
    corners = points[triangles]
    normals = mesh.unit_normals(corners)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0)
    assert np.allclose(((corners - corners[:, :1]) * normals[:, None]).sum(axis=2), 0.0, atol=1e-12)
    assert ((corners.mean(axis=1) * normals).sum(axis=1) > 0).all()
    assert not mesh.unit_normals(np.zeros((1, 3, 3))).any()
