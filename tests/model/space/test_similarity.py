"""Similarities: every similarity is found again, and the identity where there is nothing to find."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from omote.model.space.similarity import Similarity, fit_similarity

POINTS = np.random.default_rng(1).normal(0.0, 0.1, (30, 3))
WEIGHTS = np.random.default_rng(2).uniform(0.1, 1.0, 30)


@given(seed=st.integers(0, 999), scale=st.floats(0.2, 5.0))
def test_a_similarity_is_found_from_where_it_brings_points(seed: int, scale: float) -> None:
    drawn = np.random.default_rng(seed)
    wanted = Similarity(scale, Rotation.random(rng=drawn).as_matrix(), drawn.normal(size=3))
    found = fit_similarity(POINTS, wanted(POINTS), WEIGHTS)
    assert np.isclose(found.scale, wanted.scale)
    assert np.allclose(found.rotation, wanted.rotation)
    assert np.allclose(found.shift, wanted.shift)


def test_a_mirror_image_is_met_by_a_rotation() -> None:
    found = fit_similarity(POINTS, POINTS * [-1.0, 1.0, 1.0], WEIGHTS)
    assert np.isclose(np.linalg.det(found.rotation), 1.0)


def test_the_same_points_or_no_weights_give_the_identity() -> None:
    for found in (fit_similarity(POINTS, POINTS, WEIGHTS), fit_similarity(POINTS, 2 * POINTS, np.zeros(30))):
        assert np.array_equal(found(POINTS), POINTS)


def test_points_without_weight_do_not_count() -> None:
    targets = 2.0 * POINTS
    targets[0] += 1.0
    assert np.isclose(fit_similarity(POINTS, targets, np.r_[0.0, WEIGHTS[1:]]).scale, 2.0)
