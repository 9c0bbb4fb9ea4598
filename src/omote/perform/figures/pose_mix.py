"""The weighted average of poses: rotation vectors, hips and feet are summed as faces and expressions are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Mask, Values
from omote.model.body.pose import Pose
from omote.model.body.pose_regions import PoseRegion
from omote.perform.frame import NO_IDLE
from omote.perform.mix import Weights


@dataclass(frozen=True, eq=False)
class MixedPose:
    """turns (J, 3), travel (3,), feet (2, 3), feet_turns (2, 3): as of `Pose`."""

    turns: Values
    travel: Values
    feet: Values
    feet_turns: Values


BREATH_IN = "breath_in"
WEIGHT = ("weight_left", "weight_right")
"""The poses of a figure that breathes and shifts its weight, which the automatic motion adds."""
CHEST = "chest_left"
"""The pose of one whose chest has followed its head; its head looks where it did."""
IDLE_POSES = (BREATH_IN, *WEIGHT, CHEST)
"""Poses that figures come to by themselves: no list of what people call has them."""


def idle_weights(idle: tuple[float, float, float]) -> Weights:
    """The weights of the poses that a figure does by itself. idle: as of `Frame`."""
    breath, left, chest = idle
    return {BREATH_IN: breath, WEIGHT[0]: max(left, 0.0), WEIGHT[1]: max(-left, 0.0), CHEST: chest}


def mix_poses(
    poses: Mapping[str, Pose],
    weights: Weights,
    regions: Mapping[PoseRegion, Weights],
    bones: Mapping[PoseRegion, Mask],
    idle: tuple[float, float, float] = NO_IDLE,
) -> MixedPose:
    """The sum of poses by their weights; regions that show another mix have theirs.

    Rotation vectors are summed, not turned along the shortest way: a sum of two poses never leaves the box of a joint's
    angles in which both lie, and an arm does not swing through the side that shoulders forbid.

    poses: by name; weights: by name, of those that weigh something; regions: the weights of each that has its own;
    bones: which belong to each region (`region_bones`); idle: as of `Frame`, added to all of it where there are poses
    for it.
    """
    turns = _sum(poses, weights, "turns")
    for region, own in regions.items():
        turns[bones[region]] = _sum(poses, own, "turns")[bones[region]]
    own = {name: weight for name, weight in idle_weights(idle).items() if weight and name in poses}
    standing = regions.get("stance", weights)
    rest = (_sum(poses, standing, what) + _sum(poses, own, what) for what in ("travel", "feet", "feet_turns"))
    return MixedPose(turns + _sum(poses, own, "turns"), *rest)


def _sum(poses: Mapping[str, Pose], weights: Weights, what: str) -> Values:
    return np.asarray(sum(weight * getattr(poses[name], what) for name, weight in weights.items()))
