"""Harmonic extension: averages of anchors, constants kept, linear fields nearly so, islands said."""

from __future__ import annotations

import numpy as np

from omote.geometry.laplacian import ANCHORS, cotangents, harmonic_weights, smoothing_matrix


def grid(size: int) -> tuple[np.ndarray, np.ndarray]:
    row, column = np.meshgrid(np.arange(size - 1), np.arange(size - 1), indexing="ij")
    a = (row * size + column).ravel()
    triangles = np.concatenate([np.stack([a, a + 1, a + size + 1], 1), np.stack([a, a + size + 1, a + size], 1)])
    x, y = np.meshgrid(np.arange(size), np.arange(size))
    return np.stack([x.ravel(), y.ravel(), np.zeros(size * size)], axis=1).astype(float), triangles.astype(np.int32)


def test_the_weights_are_averages_of_few_anchors() -> None:
    points, triangles = grid(9)
    rim = (points[:, 0] % 8 == 0) | (points[:, 1] % 8 == 0)
    anchors = np.flatnonzero(rim).astype(np.int32)
    names, weights = harmonic_weights(points, triangles, ~rim, anchors)
    assert names.shape == weights.shape == ((~rim).sum(), ANCHORS)
    assert np.isin(names, anchors).all()
    assert (weights >= 0).all()
    assert np.allclose(weights.sum(axis=1), 1.0)


def test_a_vertex_amid_its_anchors_gets_their_mean() -> None:
    points, triangles = grid(3)
    free = np.zeros(9, bool)
    free[4] = True
    names, weights = harmonic_weights(points, triangles, free, np.array([1, 3, 5, 7], np.int32))
    value = (weights[0] * np.array([0, 2, 0, 4, 0, 6, 0, 8, 0.0])[names[0]]).sum()
    assert np.isclose(value, 5.0, atol=0.5)


def test_an_island_without_anchors_answers_nothing() -> None:
    points, triangles = grid(3)
    apart = np.concatenate([points, points + 100])
    both = np.concatenate([triangles, triangles + 9])
    free = np.ones(18, bool)
    free[:8] = False
    _, weights = harmonic_weights(apart, both, free, np.arange(8, dtype=np.int32))
    assert np.isclose(weights[0].sum(), 1.0)
    assert (weights[1:] == 0).all()


def test_cotangents_are_symmetric_and_positive() -> None:
    points, triangles = grid(5)
    matrix = cotangents(points, triangles).toarray()
    assert np.allclose(matrix, matrix.T)
    assert (matrix[matrix != 0] > 0).all()


def test_smoothing_keeps_constants_and_lone_vertices() -> None:
    _, triangles = grid(4)
    average = smoothing_matrix(triangles, 17)
    assert np.allclose(average @ np.full(17, 3.0), 3.0)
    assert (average @ np.arange(17.0))[16] == 16.0
