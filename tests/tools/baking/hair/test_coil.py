"""A coil is a ball of strands that stands on the head."""

import numpy as np
import pytest

from tools.baking.hair.coil import SUNK, Coil


def test_strands_lie_on_the_ball() -> None:
    out = np.array([0.0, 0.6, -0.8])
    coil = Coil(np.array([0.0, 0.1, -0.03]), radius=0.03)
    strands = coil.wind(out, 12, seed=3)
    assert strands.shape == (coil.count, 12, 3)
    middle = coil.foot + (1.0 - SUNK) * coil.radius * out
    far = np.linalg.norm(strands - middle, axis=2)
    assert far.min() > 0.85 * coil.radius
    assert far.max() < 1.05 * coil.radius
    assert (((strands - middle) @ out) / coil.radius).max() > 0.85  # it is closed on top


def test_the_same_seed_winds_the_same_coil() -> None:
    coil = Coil(np.zeros(3), radius=0.03)
    out = np.array([0.0, 1.0, 0.0])
    assert np.array_equal(coil.wind(out, 8, seed=1), coil.wind(out, 8, seed=1))
    assert not np.array_equal(coil.wind(out, 8, seed=1), coil.wind(out, 8, seed=2))
    assert np.isfinite(Coil(np.zeros(3), radius=0.03).wind(np.array([0.0, 0.0, 1.0]), 8, seed=1)).all()


@pytest.mark.parametrize("count", [1, 40])
def test_it_has_as_many_strands_as_it_is_told(count: int) -> None:
    assert len(Coil(np.zeros(3), radius=0.02, count=count).wind(np.array([0.0, 1.0, 0.0]), 5, seed=1)) == count
