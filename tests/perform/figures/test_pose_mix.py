"""Mixes of poses keep to what is mixed, region by region."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_figures
from omote.model.body.pose_regions import POSE_REGIONS, region_bones
from omote.perform.figures.pose_mix import mix_poses

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
