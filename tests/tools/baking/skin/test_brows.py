"""Eyebrows."""

import numpy as np

from tools.baking.skin.brows import LINE, brow_cover


def places(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.stack([x, y, np.full_like(x, 0.14)], axis=1)


GRID_X, GRID_Y = (axis.ravel() for axis in np.meshgrid(np.linspace(0.0, 0.08, 161), np.linspace(-0.02, 0.05, 141)))


def test_left_and_right_are_alike() -> None:
    left, right = (brow_cover(places(sign * GRID_X, GRID_Y), seed=3) for sign in (1.0, -1.0))
    np.testing.assert_array_equal(left, right)


def test_they_lie_along_their_line_and_nowhere_else() -> None:
    cover = brow_cover(places(GRID_X, GRID_Y), seed=3)
    off = np.abs(GRID_Y - np.interp(GRID_X, LINE[:, 0], LINE[:, 1]))
    assert cover[off > 0.008].max() == 0.0
    assert cover[(GRID_X < 0.009) | (GRID_X > 0.061)].max() == 0.0
    middle = cover[(off < 0.001) & (GRID_X > 0.02) & (GRID_X < 0.045)]
    assert (middle.min() > 0.2, middle.mean() > 0.5) == (True, True)  # hairs with gaps between them
    assert (cover.min(), cover.max() <= 1.0) == (0.0, True)


def test_the_back_of_the_head_has_none() -> None:
    behind = places(GRID_X, GRID_Y) * [1, 1, -1]
    assert not brow_cover(behind, seed=3).any()


def test_another_seed_draws_other_hairs() -> None:
    assert (brow_cover(places(GRID_X, GRID_Y), seed=3) != brow_cover(places(GRID_X, GRID_Y), seed=4)).any()
