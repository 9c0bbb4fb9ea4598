"""The weighted average of poses: rotation vectors, hips and feet are summed as faces and expressions are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Values
from omote.model.body.pose import Pose
from omote.perform.mix import Weights


@dataclass(frozen=True, eq=False)
class MixedPose:
    """turns (J, 3), travel (3,), feet (2, 3), feet_turns (2, 3): as of `Pose`."""

    turns: Values
    travel: Values
    feet: Values
    feet_turns: Values


def mix_poses(poses: Mapping[str, Pose], weights: Weights) -> MixedPose:
    """The sum of poses by their weights.

    Rotation vectors are summed, not turned along the shortest way: a sum of two poses never leaves the box of a joint's
    angles in which both lie, and an arm does not swing through the side that shoulders forbid.

    poses: by name; weights: by name, of those that weigh something.
    """
    mixed = [(weight, poses[name]) for name, weight in weights.items()]
    return MixedPose(*(_sum(mixed, what) for what in ("turns", "travel", "feet", "feet_turns")))


def _sum(mixed: list[tuple[float, Pose]], what: str) -> Values:
    return np.asarray(sum(weight * getattr(pose, what) for weight, pose in mixed))
