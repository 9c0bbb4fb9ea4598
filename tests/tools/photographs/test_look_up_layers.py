"""The committed layers of the skin."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.builtin.own_skin import load_skin_samples
from tools.photographs.look_up_layers import look_up_layers


def test_the_committed_layers_are_those_of_the_mask() -> None:
    rows, layers = look_up_layers()
    assert np.array_equal(load_skin_samples().corners, load_cast().space.triangles[rows])
    assert load_skin_samples().layers == pytest.approx(layers, abs=1 / 255)
