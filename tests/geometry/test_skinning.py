"""Skinning: what holds of both ways of blending, and what parts them."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from omote.geometry.skinning import skin

seeds = st.integers(0, 2**32 - 1)


def mesh_of(draw: np.random.Generator, rows: int, bones: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    weights = draw.uniform(0.0, 1.0, (rows, 3))
    return (
        draw.normal(0.0, 1.0, (rows, 3)),
        draw.integers(0, bones, (rows, 3)).astype(np.int32),
        (weights / weights.sum(1, keepdims=True)).astype(np.float32),
    )


@given(seeds, st.floats(0.0, 1.0))
def test_bones_that_move_as_one_move_the_mesh_rigidly(seed: int, share: float) -> None:
    draw = np.random.default_rng(seed)
    points, bones, weights = mesh_of(draw, 20, 4)
    turn = Rotation.random(random_state=seed % 1000).as_matrix()
    shift = draw.normal(0.0, 1.0, 3)
    moved = skin(
        points, bones, weights, np.full(20, share, np.float32), np.tile(turn, (4, 1, 1)), np.tile(shift, (4, 1))
    )
    np.testing.assert_allclose(moved, points @ turn.T + shift, atol=1e-5)


@given(seeds)
def test_without_dual_quaternions_it_is_the_weighted_sum_of_the_bones(seed: int) -> None:
    draw = np.random.default_rng(seed)
    points, bones, weights = mesh_of(draw, 20, 4)
    turns = Rotation.random(4, random_state=seed % 1000).as_matrix()
    shifts = draw.normal(0.0, 1.0, (4, 3))
    each = np.einsum("jab,nb->nja", turns, points) + shifts
    expected = np.take_along_axis(each, bones[:, :, None], axis=1) * weights[:, :, None]
    moved = skin(points, bones, weights, np.zeros(20, np.float32), turns, shifts)
    np.testing.assert_allclose(moved, expected.sum(1), atol=1e-6)


@given(st.floats(0.0, 3.0), st.floats(0.05, 0.95))
def test_dual_quaternions_keep_the_radius_of_a_twisted_limb_which_linear_blending_loses(
    angle: float, part: float
) -> None:
    ring = np.stack([np.cos(np.arange(12)), np.full(12, 0.5), np.sin(np.arange(12))], axis=1)
    bones = np.tile(np.array([0, 1], np.int32), (12, 1))
    weights = np.tile(np.array([1.0 - part, part], np.float32), (12, 1))
    turns = Rotation.from_rotvec([[0.0, 0.0, 0.0], [0.0, angle, 0.0]]).as_matrix()
    radii = [
        np.hypot(*skin(ring, bones, weights, np.full(12, share, np.float32), turns, np.zeros((2, 3)))[:, [0, 2]].T)
        for share in (0.0, 1.0)
    ]
    np.testing.assert_allclose(radii[1], 1.0, atol=1e-6)
    assert (radii[0] <= 1.0 + 1e-6).all()
