"""CIE L*a*b*."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.appearance.lab import to_lab


def test_greys_have_no_hue_and_a_lightness_by_their_cube_root() -> None:
    shades = np.array([0.0, 0.001, 0.18, 1.0])
    found = to_lab(np.repeat(shades[:, None], 3, axis=1))
    assert np.abs(found[:, 1:]).max() < 0.05
    assert found[[0, 3], 0] == pytest.approx([0.0, 100.0], abs=0.01)
    assert found[2, 0] == pytest.approx(116.0 * np.cbrt(0.18) - 16.0, abs=0.01)
    assert found[1, 0] == pytest.approx(0.001 * (29 / 3) ** 3, abs=0.01)  # dark ones go straight


def test_red_is_redder_and_blue_is_bluer_than_grey() -> None:
    red, blue = to_lab(np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    assert red[1] > 50.0
    assert blue[2] < -50.0
