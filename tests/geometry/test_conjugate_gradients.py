"""The solver against the dense solution."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from omote.geometry.conjugate_gradients import solve_conjugate_gradients


@given(seed=st.integers(0, 2**32 - 1), unknowns=st.integers(1, 25), triangles=st.integers(0, 40))
def test_it_solves_the_normal_equations(seed: int, unknowns: int, triangles: int) -> None:
    rng = np.random.default_rng(seed)
    corners = rng.integers(-1, unknowns, (triangles, 3)).astype(np.int32)
    slopes = rng.normal(size=(triangles, 3, 2))
    weights = rng.uniform(0.5, 3.0, triangles)
    shift = 0.3
    matrix: NDArray[np.float64] = shift * np.eye(unknowns)
    for corner, slope, weight in zip(corners, slopes, weights, strict=True):
        gradient = np.zeros((2, unknowns + 1))  # the last column takes the vertices that are held
        for k in range(3):
            gradient[:, corner[k]] += slope[k]
        matrix += weight * gradient[:, :-1].T @ gradient[:, :-1]
    pull = rng.normal(size=(unknowns, 3))
    found = solve_conjugate_gradients(pull, np.diagonal(matrix).copy(), shift, corners, slopes, weights)
    np.testing.assert_allclose(matrix @ found, pull, atol=float(1e-3 * np.linalg.norm(pull)))


def test_nothing_pulls_nothing_moves() -> None:
    one = np.ones(1)
    found = solve_conjugate_gradients(
        np.zeros((1, 3)), one, 1.0, np.zeros((0, 3), np.int32), np.zeros((0, 3, 2)), np.zeros(0)
    )
    assert found == pytest.approx(np.zeros((1, 3)), abs=0.0)
