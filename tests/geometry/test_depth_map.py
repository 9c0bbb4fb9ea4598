"""Depth maps."""

from __future__ import annotations

import numpy as np
import pytest

from omote.geometry.depth_map import draw_depth, visible

TRIANGLE = np.array([[0, 1, 2]], np.int32)


def test_depth_is_that_of_the_plane_that_is_seen() -> None:
    """A plane z = 2 + x / 2 in space, seen through a pinhole of 10 pixels."""
    points = np.array([[-2.0, -2.0], [6.0, -2.0], [-2.0, 6.0]])
    away = 4.0 + points[:, 0] / 2.0
    screen = np.column_stack([10.0 * points / away[:, None] + 8.0, away])
    depth = draw_depth(screen, TRIANGLE, 16, 16)
    rows, columns = np.nonzero(np.isfinite(depth))
    across = (columns + 0.5 - 8.0) / 10.0
    assert depth[rows, columns] == pytest.approx(4.0 / (1.0 - across / 2.0), rel=1e-5)  # float32
    assert len(rows) > 60


def test_the_nearest_surface_is_kept_whatever_the_order() -> None:
    square = np.array([[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]])
    screen = np.vstack([np.column_stack([square, np.full(4, away)]) for away in (3.0, 2.0)])
    near = [[4, 5, 6], [4, 6, 7]]
    far = [[0, 1, 2], [0, 2, 3]]
    for triangles in (near + far, far + near):
        assert (draw_depth(screen, np.array(triangles, np.int32), 8, 8) == 2.0).all()


def test_what_lies_behind_the_camera_is_not_drawn() -> None:
    screen = np.array([[0.0, 0.0, -1.0], [8.0, 0.0, 1.0], [0.0, 8.0, 1.0]])
    assert not np.isfinite(draw_depth(screen, TRIANGLE, 8, 8)).any()


def test_points_behind_a_surface_and_outside_the_picture_are_hidden() -> None:
    depth = np.full((4, 4), 2.0, np.float32)
    screen = np.array([[1.5, 1.5, 2.0], [1.5, 1.5, 2.05], [1.5, 1.5, 2.2], [-0.5, 1.0, 1.0], [1.0, 4.0, 1.0]])
    assert visible(depth, screen, 0.1).tolist() == [True, True, False, False, False]
