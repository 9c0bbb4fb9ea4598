"""The nearest place in a triangle: inside, on edges, at corners."""

import numpy as np

from omote.model.fitting.foreign.scan_correspondence import nearest_in


def test_the_nearest_place_is_no_farther_than_any_other() -> None:
    draw = np.random.default_rng(0)
    corners, asked, shares = draw.normal(size=(50, 3, 3)), draw.normal(size=(50, 3)), draw.dirichlet(np.ones(3), 400)
    weights, off = nearest_in(corners, asked)
    np.testing.assert_allclose(weights.sum(axis=1), 1.0)
    assert weights.min() >= -1e-12
    np.testing.assert_allclose(np.einsum("mk,mkc->mc", weights, corners) + off, asked)
    others = np.linalg.norm(np.einsum("sk,mkc->msc", shares, corners) - asked[:, None], axis=2).min(axis=1)
    assert (np.linalg.norm(off, axis=1) <= others + 1e-12).all()
