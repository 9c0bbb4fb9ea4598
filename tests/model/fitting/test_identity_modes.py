"""Identity modes: the mean at rest, linear, skin and parts alike; for one topology only."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.builtin import load_identity_modes
from omote.model.fitting.identity_modes import refuse_other_topology
from tests import synthetic

SPACE = omote.load_cast().space
MODES = load_identity_modes()


def test_no_weight_is_the_mean_and_weights_add() -> None:
    one, other = np.random.default_rng(0).normal(size=(2, len(MODES.moves)))
    rest = MODES.shape_skin(0 * one)
    assert np.array_equal(rest, MODES.skin)
    assert np.allclose(MODES.shape_skin(one) + MODES.shape_skin(other) - rest, MODES.shape_skin(one + other))
    for name, points in MODES.shape_parts(one).items():
        assert np.allclose(points, MODES.parts[name] + np.tensordot(one, MODES.part_moves[name], 1))


def test_modes_of_another_head_are_refused() -> None:
    refuse_other_topology(SPACE, MODES)
    with pytest.raises(ValueError, match="expected the built-in cast's space"):
        refuse_other_topology(synthetic.space(), MODES)
