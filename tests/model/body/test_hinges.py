"""Hinges: how far they are bent is what bones say, and correctives come in and go out without a step."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_figures
from omote.model.body.hinges import BENDS, HINGES, corrective_weights, hinge_bends

SKELETON = load_figures().space.skeleton


@given(st.lists(st.floats(0.0, 180.0), min_size=4, max_size=4), st.integers(0, 99))
def test_bends_are_the_angles_between_segments_wherever_the_limb_points(bends: list[float], seed: int) -> None:
    rng = np.random.default_rng(seed)
    joints = np.zeros((len(SKELETON.names), 3))
    for bend, (begin, middle, end) in zip(np.radians(bends), HINGES, strict=True):
        along, aside = np.linalg.qr(rng.normal(size=(3, 3)))[0][:2]
        joints[SKELETON.places[middle]] = rng.normal(size=3)
        joints[SKELETON.places[begin]] = joints[SKELETON.places[middle]] - rng.uniform(0.1, 0.4) * along
        way = np.cos(bend) * along + np.sin(bend) * aside
        joints[SKELETON.places[end]] = joints[SKELETON.places[middle]] + rng.uniform(0.1, 0.4) * way
    assert hinge_bends(SKELETON, joints) == pytest.approx(np.array(bends), abs=1e-5)


def test_each_bend_calls_its_corrective_alone_and_a_straight_limb_none() -> None:
    np.testing.assert_allclose(corrective_weights(np.array(BENDS)), np.eye(len(BENDS)))
    assert not corrective_weights(np.zeros(4)).any()
    assert np.array_equal(corrective_weights(np.array([180.0])), [[0.0, 0.0, 1.0]])


@given(st.floats(0.0, 179.0), st.floats(0.0, 1.0))
def test_correctives_mix_without_a_step(bend: float, more: float) -> None:
    one, two = corrective_weights(np.array([bend, bend + more]))
    assert np.abs(one - two).max() <= more / 40.0 + 1e-12  # the nearest bends are 40 degrees apart
    assert one.sum() <= 1.0 + 1e-12
