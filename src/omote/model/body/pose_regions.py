"""The regions of a figure in which a pose can be called alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal, get_args

import numpy as np

from omote.arrays import Mask
from omote.model.body.skeleton import Skeleton
from omote.model.known_names import check_region

PoseRegion = Literal["head", "trunk", "arm_left", "arm_right", "stance"]
POSE_REGIONS: tuple[PoseRegion, ...] = get_args(PoseRegion)
"""The neck belongs to the head, a clavicle to its arm; the stance is hips, legs and where feet are."""


def check_pose_region(name: str, /) -> PoseRegion:
    """The region of this name; ValueError where there is none."""
    return check_region(name, POSE_REGIONS, "of a pose")


def region_of_bone(bone: str) -> PoseRegion:
    """The region that a bone belongs to, by its name."""
    if bone.startswith(("head", "neck")):
        return "head"
    if bone.startswith("spine"):
        return "trunk"
    if bone.startswith(("root", "pelvis", "upperleg", "lowerleg", "foot", "toes")):
        return "stance"
    return "arm_left" if bone.endswith(".L") else "arm_right"


def region_bones(skeleton: Skeleton) -> Mapping[PoseRegion, Mask]:
    """Which bones (J,) belong to each region."""
    return regions_of_bones(skeleton.names)


def regions_of_bones(names: Sequence[str]) -> Mapping[PoseRegion, Mask]:
    """Which bones (J,) belong to each region, by their names."""
    of = [region_of_bone(name) for name in names]
    return {region: np.array([each == region for each in of], bool) for region in POSE_REGIONS}
