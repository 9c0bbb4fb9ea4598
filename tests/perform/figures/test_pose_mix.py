"""Mixes of poses keep to what is mixed, region by region."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_figures
from omote.model.body.pose_regions import POSE_REGIONS, region_bones
from omote.perform.figures.pose_mix import CHEST, idle_weights, mix_poses

FIGURES = load_figures()
BONES = region_bones(FIGURES.space.skeleton)
mixes = st.dictionaries(st.sampled_from([*FIGURES.poses]), st.floats(0.01, 1.0), min_size=1, max_size=4).map(
    lambda mix: {name: weight / sum(mix.values()) for name, weight in mix.items()}
)


@given(mixes, mixes)
def test_a_mix_never_leaves_the_box_of_a_joint(one: dict[str, float], two: dict[str, float]) -> None:
    mixed = mix_poses(FIGURES.poses, one, {"arm_left": two}, BONES).turns
    for region in POSE_REGIONS:
        names = two if region == "arm_left" else one
        each = np.stack([FIGURES.poses[name].turns[BONES[region]] for name in names])
        assert (mixed[BONES[region]] <= each.max(0) + 1e-9).all()
        assert (mixed[BONES[region]] >= each.min(0) - 1e-9).all()


@given(mixes, st.floats(0.0, 2.0), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
def test_breath_weight_and_chest_are_added_to_whatever_a_figure_does(
    mix: dict[str, float], breath: float, left: float, chest: float
) -> None:
    bare = mix_poses(FIGURES.poses, mix, {"arm_left": {"bow": 1.0}}, BONES)
    idle = mix_poses(FIGURES.poses, mix, {"arm_left": {"bow": 1.0}}, BONES, (breath, left, chest))
    added = sum(weight * FIGURES.poses[name].turns for name, weight in idle_weights((breath, left, chest)).items())
    np.testing.assert_allclose(idle.turns - bare.turns, added, atol=1e-12)
    np.testing.assert_allclose(FIGURES.poses[CHEST].turns.sum(axis=0), 0.0, atol=1e-12)  # the head looks where it did
    np.testing.assert_array_equal(idle.feet, bare.feet)  # feet stay where they stand
    assert np.sign(np.round(idle.travel[0] - bare.travel[0], 12)) == np.sign(np.round(left, 10))
    assert (
        mix_poses({"stand": FIGURES.poses["stand"]}, {"stand": 1.0}, {}, BONES, (breath, left, chest)).turns.any() == 0
    )
