"""Correctives: how far joints are bent is what bones say, and correctives come in and go out without a step."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from omote.builtin import load_figures
from omote.model.body.compose_pose import arm_turn, pose_of
from omote.model.body.correctives import (
    ARMS,
    FINGER_BENDS,
    FINGERS,
    HINGE_BENDS,
    HINGES,
    HIPS,
    JOINTS,
    MODELLED,
    SHAPES,
    SHOULDERS,
    between,
    corrective_calls,
    finger_bends,
    hinge_bends,
    hip_bends,
    shoulder_calls,
)
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.body.posed_bones import PosedBones
from omote.model.body.skeleton import SIDES
from omote.model.body.stand import OUT, UPPER_ARM, hanging

SKELETON = load_figures().space.skeleton
directions = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda way: np.linalg.norm(way) > 0.1)


def bones_with(limbs: tuple[tuple[str, ...], ...], ways: list[np.ndarray], trunk: str, turn: np.ndarray) -> PosedBones:
    """Bones of which some limbs point where a trunk that is turned has them."""
    joints = np.zeros((len(SKELETON.names), 3))
    frames = np.tile(np.eye(3), (len(joints), 1, 1))
    frames[SKELETON.places[trunk]] = turn
    for (begin, end), way in zip(limbs, ways, strict=True):
        joints[SKELETON.places[end]] = joints[SKELETON.places[begin]] + 0.3 * turn @ way
    return PosedBones(frames, joints, frames)


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


def test_each_bend_calls_its_corrective_alone_and_a_joint_as_modelled_none() -> None:
    np.testing.assert_allclose(between(np.array(HINGE_BENDS), HINGE_BENDS), np.eye(SHAPES))
    np.testing.assert_allclose(between(np.array(FINGER_BENDS), FINGER_BENDS, bare=True), np.eye(SHAPES))
    assert not between(np.array([-20.0, 0.0]), FINGER_BENDS, bare=True).any()
    assert np.array_equal(between(np.array([180.0]), HINGE_BENDS), [[0.0, 0.0, 0.0, 1.0]])


@given(st.floats(-10.0, 179.0), st.floats(0.0, 1.0))
def test_correctives_mix_without_a_step(bend: float, more: float) -> None:
    for at, bare in ((HINGE_BENDS, False), (FINGER_BENDS, True)):
        one, two = between(np.array([bend, bend + more]), at, bare=bare)
        assert np.abs(one - two).max() <= more / np.diff(at).min() + 1e-12
        assert one.sum() <= 1.0 + 1e-12


@given(st.floats(0.0, 1.0), st.floats(-1.0, 1.0), directions)
def test_fingers_are_bent_as_far_as_they_curl_however_the_hand_is_held(
    curl: float, fan: float, turn: np.ndarray
) -> None:
    frames = np.tile(Rotation.from_rotvec(turn).as_matrix(), (len(SKELETON.names), 1, 1))
    for before, bone in FINGERS:
        bend = Rotation.from_euler("zx", [-OUT[bone[-1]] * 110.0 * curl, 10.0 * fan], degrees=True).as_matrix()
        frames[SKELETON.places[bone]] = frames[SKELETON.places[before]] @ bend
    bends = finger_bends(SKELETON, PosedBones(frames, np.zeros((len(frames), 3)), frames))
    np.testing.assert_allclose(bends, 110.0 * curl, atol=0.5)  # a finger that is spread bends a little farther


@given(st.floats(0.0, 150.0), directions)
def test_hips_are_bent_as_far_as_thighs_are_raised_to_the_front_of_the_trunk(bend: float, turn: np.ndarray) -> None:
    trunk = Rotation.from_rotvec(turn).as_matrix()
    way = np.array([0.0, -np.cos(np.radians(bend)), np.sin(np.radians(bend))])
    np.testing.assert_allclose(hip_bends(SKELETON, bones_with(HIPS, [way, way], "root", trunk)), bend, atol=1e-6)
    aside = [np.array([1.0, 0.0, 0.0]), way * [1.0, 1.0, -1.0]]
    assert hip_bends(SKELETON, bones_with(HIPS, aside, "root", trunk)).max() < 1e-6


def test_each_arm_calls_its_corrective_of_the_shoulder_alone_and_one_as_modelled_none() -> None:
    for place, arm in enumerate((MODELLED, *ARMS)):
        ways = [arm_turn(arm, OUT[side]) @ hanging(*UPPER_ARM, side) for side in SIDES]
        calls = shoulder_calls(SKELETON, bones_with(SHOULDERS, ways, "spine01", np.eye(3)))
        np.testing.assert_allclose(calls, [np.eye(SHAPES + 1)[place][1:]] * 2, atol=1e-6)


def test_every_joint_of_the_figure_calls_its_correctives() -> None:
    pose = pose_of(PoseRecipe(), SKELETON, "still")
    still = np.tile(np.eye(3), (len(pose.turns), 1, 1))
    joints = np.random.default_rng(1).normal(size=(len(still), 3))
    assert corrective_calls(SKELETON, PosedBones(still, joints, still)).shape == (JOINTS, SHAPES)
    assert load_figures().space.bending_hinges.max() == JOINTS - 1
