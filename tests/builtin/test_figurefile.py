"""The file of figures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from omote.builtin import FIGURES, load_figures
from omote.builtin.figurefile import figures_of


def arrays() -> dict[str, Any]:
    with np.load(FIGURES) as file:
        return dict(file)


def test_weights_of_each_row_sum_to_one_and_shares_are_shares() -> None:
    space = load_figures().space
    np.testing.assert_allclose(space.weights.sum(axis=1), 1.0, atol=1e-6)
    assert (space.shares >= 0.0).all()
    assert (space.shares <= 1.0).all()


def test_a_file_of_another_version_is_rejected() -> None:
    with pytest.raises(ValueError, match="format 99"):
        figures_of(arrays() | {"format": np.array(99)}, ())
