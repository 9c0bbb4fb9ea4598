"""Light from afar as a polynomial of the normal."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.fitting.soft_light import fit_soft_light, harmonics, slope_harmonics


def normals(count: int) -> np.ndarray:
    drawn = np.random.default_rng(1).normal(size=(count, 3))
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1, keepdims=True))


def test_harmonics_are_orthogonal_over_the_ball() -> None:
    normals = np.random.default_rng(1).normal(size=(200_000, 3))
    basis = harmonics(normals / np.linalg.norm(normals, axis=1, keepdims=True))
    products = basis.T @ basis / len(basis)
    sizes = np.sqrt(np.diag(products))
    assert products / np.outer(sizes, sizes) == pytest.approx(np.eye(9), abs=0.02)


def test_slopes_of_harmonics_are_those_of_differences() -> None:
    way = np.array([0.3, -0.2, 0.5])
    places = normals(50)
    step = 1e-6 * way
    off = (harmonics(places + step) - harmonics(places - step)) / 2e-6
    # The last one stands for its polynomial on unit vectors: all that a caller turns are normals.
    assert slope_harmonics(places) @ way == pytest.approx(off, abs=1e-6)


def test_a_light_is_found_again_beside_what_is_odd() -> None:
    basis = harmonics(normals(800))
    draw = np.random.default_rng(2)
    light = np.array([1.0, *draw.normal(0.0, 0.1, 8)])
    ratio = basis @ light
    ratio[::10] = 3.0
    assert basis @ fit_soft_light(basis, ratio, np.ones(800)) == pytest.approx(basis @ light, abs=0.02)
