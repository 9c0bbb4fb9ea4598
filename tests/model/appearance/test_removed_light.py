"""Light divided out of photographs."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.appearance.photograph_albedo import remove_light

SIDE = 210


def sphere() -> np.ndarray:
    """Unit normals (k, k, 3) of a half ball."""
    x, y = np.meshgrid(np.linspace(-0.7, 0.7, SIDE), np.linspace(0.7, -0.7, SIDE))
    return np.stack([x, y, np.sqrt(1.0 - x**2 - y**2)], axis=2)


def lit(painted: np.ndarray) -> np.ndarray:
    shade = 1.0 + 0.3 * sphere()[..., 0] + 0.2 * sphere()[..., 1]
    return (painted * shade[..., None]).astype(np.float32)


def test_light_from_one_side_is_divided_out() -> None:
    painted = np.full((SIDE, SIDE, 3), [0.4, 0.25, 0.2], np.float32)
    whole = np.ones((SIDE, SIDE), np.float32)
    even = remove_light(lit(painted), whole, sphere(), painted)
    for channel in range(3):
        assert even[..., channel].std() < 0.15 * lit(painted)[..., channel].std()
        assert even[..., channel].mean() == pytest.approx(lit(painted)[..., channel].mean(), rel=0.02)


def test_what_is_painted_is_no_light() -> None:
    """Lips that usual skin has stay as they are."""
    painted = np.full((SIDE, SIDE, 3), 0.4, np.float32)
    painted[140:160, 70:140] = [0.3, 0.1, 0.1]
    even = remove_light(painted, np.ones((SIDE, SIDE), np.float32), sphere(), painted)
    assert even == pytest.approx(painted, rel=1e-3)


def test_little_skin_and_what_is_not_seen_stay() -> None:
    painted = np.full((SIDE, SIDE, 3), 0.4, np.float32)
    nothing = np.zeros((SIDE, SIDE), np.float32)
    assert np.array_equal(remove_light(lit(painted), nothing, sphere(), painted), lit(painted))
    half = np.where(np.arange(SIDE) < 100, 1.0, 0.0) * np.ones((SIDE, 1))
    even = remove_light(lit(painted), half.astype(np.float32), sphere(), painted)
    assert np.array_equal(even[:, 100:], lit(painted)[:, 100:])
