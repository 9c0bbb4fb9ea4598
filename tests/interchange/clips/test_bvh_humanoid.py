"""BVH of other programs' skeletons, at rest as they like: what comes in is what the bones did."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.interchange.clips.bvh_humanoid import bvh_motion
from omote.interchange.clips.humanoid_motion import HumanoidMotion
from tests.interchange.clips.humanoids import MIXAMO, RIGS, bvh_of, degrees_apart, moving

LITTLE = 0.01
"""Degrees: angles are written with eight places."""
HANGING = {
    f"{side}{bone}": Rotation.from_rotvec([0.0, 0.0, sign * np.radians(-degrees)])
    for side, sign in (("left", 1.0), ("right", -1.0))
    for bone, degrees in {"UpperArm": 70.0, "LowerArm": 80.0, "Hand": 80.0}.items()
}
"""Arms of an A-pose, a little bent."""


@pytest.mark.parametrize("rig", RIGS)
def test_skeletons_of_programs_come_in_as_they_moved(rig: str) -> None:
    motion = moving(tuple(RIGS[rig]))
    read = bvh_motion(bvh_of(motion, RIGS[rig]))
    assert set(read.names) == set(motion.names)
    assert max(degrees_apart(motion, read).values()) < LITTLE
    assert np.abs(read.times - motion.times).max() < 1e-6


@pytest.mark.parametrize("order", ["".join(order) for order in permutations("XYZ")])
def test_rotations_are_read_in_any_order_and_any_unit(order: str) -> None:
    motion = moving(tuple(MIXAMO), seed=3)
    read = bvh_motion(bvh_of(motion, MIXAMO, order=order, unit={"X": 1.0, "Y": 39.37, "Z": 100.0}[order[0]]))
    assert max(degrees_apart(motion, read).values()) < LITTLE
    shift = read.hips - motion.hips
    assert np.ptp(shift, axis=0).max() < 1e-4  # the floor may be another


def test_a_rest_with_hanging_arms_is_turned_to_the_t_pose() -> None:
    bones = [bone for bone in MIXAMO if "Index" not in bone and "Thumb" not in bone]
    motion = moving(bones, seed=5)
    read = bvh_motion(bvh_of(motion, MIXAMO, rest=HANGING))
    assert max(degrees_apart(motion, read).values()) < LITTLE


def test_a_file_that_stands_along_z_or_looks_back_is_turned() -> None:
    motion = moving(tuple(MIXAMO), seed=6)
    for axes in (Rotation.from_euler("x", 90, degrees=True), Rotation.from_euler("y", 180, degrees=True)):
        read = bvh_motion(bvh_of(motion, MIXAMO, axes=axes))
        assert max(degrees_apart(motion, read).values()) < LITTLE
        assert np.ptp(read.hips - motion.hips, axis=0).max() < 1e-4


def test_one_without_places_stands_on_its_lower_foot() -> None:
    still = moving(tuple(MIXAMO), most=0.0)
    read = bvh_motion(bvh_of(still, MIXAMO, places=False))
    assert np.abs(read.hips).max() < 1e-6
    assert "it has no places" in read.notes[0]


def test_a_first_frame_that_is_the_rest_is_left_out() -> None:
    motion = moving(tuple(MIXAMO), seed=7)
    turns = motion.turns.copy()
    turns[0] = [0.0, 0.0, 0.0, 1.0]
    read = bvh_motion(bvh_of(HumanoidMotion(motion.times, motion.names, turns, motion.hips), MIXAMO))
    assert len(read.times) == len(motion.times) - 1
    assert "its first frame is its rest" in read.notes[0]


def test_a_rest_that_is_no_person_is_rejected() -> None:
    motion = moving(tuple(MIXAMO))
    lying = {f"{side}UpperLeg": Rotation.from_euler("x", 180, degrees=True) for side in ("left", "right")}
    lying |= {f"{side}LowerLeg": lying[f"{side}UpperLeg"] for side in ("left", "right")}
    with pytest.raises(ValueError, match="no person who stands"):
        bvh_motion(bvh_of(motion, MIXAMO, rest=lying))
