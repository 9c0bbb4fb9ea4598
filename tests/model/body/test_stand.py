"""The stand: limbs of all bodies, and of all mixes of them, have the same directions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given

from omote.model.body.figure_space import hang_joints
from omote.model.body.skeleton import SIDES
from omote.model.body.stand import FOREARM, HAND, UPPER_ARM, hanging, stand_turns
from tests.model.body.test_figure_space import SPACE, mixed, weights


@given(weights)
def test_all_bodies_stand_alike(values: list[float]) -> None:
    head = mixed(values, "face")
    joints = hang_joints(SPACE, mixed(values, "joints"), mixed(values, "edge"), head)
    ends = mixed(values, "ends")
    turns = stand_turns(SPACE.skeleton, joints, ends)
    np.testing.assert_allclose(
        np.einsum("jab,jcb->jac", turns, turns), np.broadcast_to(np.eye(3), turns.shape), atol=1e-9
    )
    at = SPACE.skeleton.places
    for side in SIDES:
        for names, wanted in (
            (("upperarm01", "lowerarm01"), UPPER_ARM),
            (("lowerarm01", "wrist"), FOREARM),
            (("wrist", "finger3-1"), HAND),
        ):
            first, second = (at[f"{name}.{side}"] for name in names)
            way = turns[first] @ (joints[second] - joints[first])
            np.testing.assert_allclose(way / np.linalg.norm(way), hanging(*wanted, side), atol=2e-2)
        hip, ankle = at[f"upperleg01.{side}"], at[f"foot.{side}"]
        thigh = turns[hip] @ (joints[at[f"lowerleg01.{side}"]] - joints[hip])
        assert abs(math.degrees(math.atan2(thigh[0], -thigh[1]))) < 1.0
        assert turns[ankle][1] @ [0.0, 1.0, 0.0] == pytest.approx(1.0)  # soles are flat
