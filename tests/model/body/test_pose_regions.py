"""Regions of a figure part its bones."""

from __future__ import annotations

import numpy as np
import pytest

from omote.builtin import load_figures
from omote.model.body.pose_regions import POSE_REGIONS, check_pose_region, region_bones


def test_regions_part_all_bones_and_arms_mirror_one_another() -> None:
    skeleton = load_figures().space.skeleton
    bones = region_bones(skeleton)
    assert (np.sum([bones[region] for region in POSE_REGIONS], axis=0) == 1).all()
    np.testing.assert_array_equal(bones["arm_left"][skeleton.mirror], bones["arm_right"])


def test_a_region_that_is_none_is_rejected() -> None:
    assert [check_pose_region(region) for region in POSE_REGIONS] == [*POSE_REGIONS]
    with pytest.raises(ValueError, match="tail"):
        check_pose_region("tail")
