"""Strain: nothing where nothing is pressed, exactly what a linear map does, and the same however a head is turned."""

from __future__ import annotations

import numpy as np
import pytest

from omote.geometry.strain import compression, fans_of, vertex_strain

GRID = 5


def sheet() -> tuple[np.ndarray, np.ndarray]:
    """A square of triangles that looks ahead: points (25, 3), triangles."""
    across, up = np.meshgrid(np.linspace(-0.02, 0.02, GRID), np.linspace(-0.02, 0.02, GRID))
    points = np.stack([across.ravel(), up.ravel(), np.zeros(GRID * GRID)], axis=1)
    cells = [(row * GRID + column) for row in range(GRID - 1) for column in range(GRID - 1)]
    triangles = [[(c, c + 1, c + GRID), (c + 1, c + GRID + 1, c + GRID)] for c in cells]
    return points, np.array(triangles, np.int32).reshape(-1, 3)


def test_rest_has_none_and_neither_has_what_is_moved_and_turned_as_a_whole() -> None:
    points, triangles = sheet()
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    for now in (points, points + np.array([0.1, -0.2, 0.3]), points @ turn.T * np.sign(np.linalg.det(turn))):
        assert vertex_strain(points, now, triangles) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("turned", [False, True])
def test_a_linear_map_gives_its_symmetric_root(turned: bool) -> None:
    points, triangles = sheet()
    root = np.array([[0.7, 0.1], [0.1, 1.2]])
    now = points.copy()
    now[:, :2] = points[:, :2] @ root.T
    if turned:  # what happens after it does not count
        now = now @ np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0].T
    level, mixed, upright = vertex_strain(points, now, triangles).T
    assert level == pytest.approx(-0.3)
    assert mixed == pytest.approx(0.1)
    assert upright == pytest.approx(0.2)


def test_what_is_pressed_most_is_the_least_of_both_ways() -> None:
    strains = np.random.default_rng(3).normal(0.0, 0.3, (100, 3))
    least = [np.linalg.eigvalsh([[a, b], [b, c]])[0] for a, b, c in strains]
    assert compression(strains) == pytest.approx(np.maximum(0.0, -np.array(least)))


def test_a_vertex_that_is_not_asked_has_no_fan_and_leaves_no_trace() -> None:
    points, triangles = sheet()
    asked = points[:, 0] > -0.015
    kept = fans_of(triangles, asked)
    strains = vertex_strain(points, points * [0.5, 1.0, 1.0], kept)
    assert (strains[~asked] == 0.0).all()
    assert strains[asked, 0] == pytest.approx(-0.5)
