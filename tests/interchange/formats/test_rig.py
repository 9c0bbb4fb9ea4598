"""Weights as files hold them: the strongest joints, and whole numbers that sum to the most."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.sparse import csr_array

from omote.interchange.formats.rig import Joint, Rig, strongest_weights, whole_weights

rows = st.lists(st.floats(0.0, 1.0), min_size=6, max_size=6).filter(lambda row: sum(row) > 0.1)


@given(st.lists(rows, min_size=1, max_size=5), st.integers(1, 6))
def test_the_strongest_are_kept_and_sum_to_one_in_whole_numbers_too(table: list[list[float]], count: int) -> None:
    weights = np.array(table) / np.sum(table, axis=1, keepdims=True)
    joints, kept = strongest_weights(csr_array(weights), count)
    assert (np.diff(kept, axis=1) <= 1e-12).all()
    np.testing.assert_allclose(kept.sum(axis=1), 1.0)
    strongest = -np.sort(-weights, axis=1)[:, :count]
    np.testing.assert_allclose(kept, strongest / strongest.sum(axis=1, keepdims=True))
    named = np.take_along_axis(weights, joints, axis=1)
    np.testing.assert_allclose(named[kept > 0.0], strongest[kept > 0.0])
    whole = whole_weights(kept, 65535)
    assert (whole.sum(axis=1) == 65535).all()
    assert np.abs(whole / 65535 - kept).max() <= count / 65535


def test_steps_lead_from_parent_to_child() -> None:
    joints = (Joint("a", (1.0, 2.0, 3.0)), Joint("b", (1.0, 2.5, 3.0), "a"), Joint("c", (0.0, 2.0, 3.0), "a"))
    rig = Rig(joints, np.tile(np.eye(4), (3, 1, 1)), {}, "b", {})
    np.testing.assert_array_equal(rig.parents, [-1, 0, 0])
    np.testing.assert_allclose(rig.steps, [[1.0, 2.0, 3.0], [0.0, 0.5, 0.0], [-1.0, 0.0, 0.0]])
