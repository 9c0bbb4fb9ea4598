"""Poses that recipes describe: sides mirror one another."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_figures
from omote.model.body.compose_pose import pose_of
from omote.model.body.pose_recipe import Arm, Leg, PoseRecipe

SKELETON = load_figures().space.skeleton
angles = st.floats(-90.0, 90.0)
turns = st.tuples(angles, angles, angles)
arms = st.builds(
    Arm, raised=angles, spread=angles, twist=angles, elbow=angles, forearm=angles, shrug=angles, reach=angles
)
legs = st.builds(Leg, at=st.tuples(*[st.floats(-1.0, 1.0)] * 3), foot=turns, knee=angles, toes=angles)
ACROSS = np.array([-1.0, 1.0, 1.0])


@given(arms, arms, legs, legs, turns)
def test_a_recipe_with_its_sides_changed_is_the_mirror_image(
    one: Arm, two: Arm, first: Leg, second: Leg, bend: tuple[float, float, float]
) -> None:
    forward, left, lean = bend
    recipe = PoseRecipe(trunk=bend, left=one, right=two, left_leg=first, right_leg=second)
    mirrored = PoseRecipe(
        trunk=(forward, -left, -lean), left=two, right=one, left_leg=second, right_leg=first
    )  # fmt: skip
    pose = pose_of(recipe, SKELETON, "one")
    other = pose_of(mirrored, SKELETON, "one")
    np.testing.assert_allclose(other.turns, pose.turns[SKELETON.mirror] * -ACROSS, atol=1e-9)  # turns are axial
    np.testing.assert_allclose(other.feet, pose.feet[::-1] * ACROSS, atol=1e-12)
    np.testing.assert_allclose(other.feet_turns, pose.feet_turns[::-1] * -ACROSS, atol=1e-9)
