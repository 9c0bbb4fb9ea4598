"""Forward kinematics: lengths stay, and what is turned at the root turns as one."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from omote.builtin import load_figures
from omote.model.body.posed_bones import pose_bones
from omote.model.body.stand import stand_turns

FIGURES = load_figures()
SKELETON = FIGURES.space.skeleton
BODY = FIGURES.bodies["child"]
REST = BODY.joints.astype(np.float64)
STAND = stand_turns(SKELETON, REST, BODY.ends.astype(np.float64))


@given(st.integers(0, 2**32 - 1))
def test_bones_keep_their_lengths_and_a_turn_of_the_root_turns_them_all(seed: int) -> None:
    draw = np.random.default_rng(seed)
    turns = draw.normal(0.0, 0.6, REST.shape)
    turns[0] = 0.0
    travel = draw.normal(0.0, 0.2, 3)
    posed = pose_bones(SKELETON, REST, STAND, turns, travel)
    parents = SKELETON.parents[1:]
    for joints in (posed.joints, REST):
        lengths = np.linalg.norm(joints[1:] - joints[parents], axis=1)
        np.testing.assert_allclose(lengths, np.linalg.norm(REST[1:] - REST[parents], axis=1), atol=1e-9)
    about = draw.normal(0.0, 1.0, 3)
    turned = pose_bones(SKELETON, REST, STAND, np.concatenate([about[None], turns[1:]]), travel)
    whole = Rotation.from_rotvec(about).as_matrix()
    root = posed.joints[0]
    np.testing.assert_allclose(turned.joints, (posed.joints - root) @ whole.T + root, atol=1e-9)
    np.testing.assert_allclose(turned.turns, whole @ posed.turns, atol=1e-9)


def test_a_bone_carries_where_it_begins() -> None:
    posed = pose_bones(SKELETON, REST, STAND, np.full(REST.shape, 0.1), np.zeros(3))
    carried = np.einsum("jab,jb->ja", posed.turns, REST) + posed.shifts(REST)
    np.testing.assert_allclose(carried, posed.joints, atol=1e-12)
