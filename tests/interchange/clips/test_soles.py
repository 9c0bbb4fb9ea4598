"""Feet are raised out of the floor, by just as much, and those above it stay."""

from __future__ import annotations

import numpy as np

import omote
from omote.interchange.clips.soles import above_floor, cast_soles
from omote.perform.figures.pose_mix import MixedPose

CAST = omote.load_cast()
SOLES = cast_soles(CAST)
TOES = (CAST.bones.index("toes.L"), CAST.bones.index("toes.R"))


def pose(left: float, right: float, pitch: float = 0.0) -> MixedPose:
    """Feet so high, the left one pitched."""
    feet = np.array([[0.0, left, 0.0], [0.0, right, 0.0]])
    return MixedPose(np.zeros((len(CAST.bones), 3)), np.zeros(3), feet, np.array([[pitch, 0.0, 0.0], [0.0, 0.0, 0.0]]))


def test_feet_in_the_floor_are_raised_onto_it_and_hips_with_both() -> None:
    (raised,) = above_floor([pose(-0.1, -0.05)], SOLES, TOES)
    assert np.abs(raised.feet[:, 1]).max() < 1e-9
    assert raised.travel[1] == 0.05
    (kept,) = above_floor([pose(0.0, 0.2)], SOLES, TOES)
    assert np.abs(kept.feet - pose(0.0, 0.2).feet).max() < 1e-6


def test_a_foot_on_its_toes_is_raised_by_them() -> None:
    (raised,) = above_floor([pose(0.0, 0.0, pitch=0.6)], SOLES, TOES)
    assert 0.03 < raised.feet[0, 1] < 0.2
    assert raised.feet[1, 1] < 1e-6
