"""The pose that the bones of a tracked body make: the floor is ours."""

from __future__ import annotations

from functools import cache

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Values
from omote.builtin import load_cast
from omote.inputs.trackers.body_bones import BodyBones
from omote.interchange.avatar.humanoid_pose import HumanoidRest, rest_humanoid
from omote.interchange.avatar.read_humanoid import pose_of_humanoid
from omote.model.body.pose_regions import POSE_REGIONS, PoseRegion
from omote.model.known_names import GENERIC
from omote.perform.figures.packed_pose import BESIDE_BONES, PLACES, pose_numbers
from omote.perform.layers.source_frame import BodyFrame

LOWEST_JUMP = 0.06
"""Of a leg, how far both feet leave the floor before it is a jump: so much a sender's legs differ from those that it
shows, and ours from both."""
FARTHEST_WALK = 1.0
"""Leg lengths that a performer goes to any side: beyond, the figure stays in the picture."""
LEAST_HEIGHT = 0.1
"""Metres of hips above the floor; less is no place."""

SOLE = (-0.07, 0.19)
"""Leg lengths from the ankle back to the heel and ahead to the toes."""


@cache
def builtin_rest() -> HumanoidRest:
    """The T-pose of the built-in figure, whose skeleton all have; made when the first body comes, since that takes some
    frames."""
    cast = load_cast()
    assert cast.figures is not None
    return rest_humanoid(cast.figures, {GENERIC: 1.0}, {GENERIC: cast.faces[GENERIC].positions})


def body_frame(rest: HumanoidRest, bones: BodyBones, regions: set[PoseRegion]) -> BodyFrame:
    """The body of these bones; the lower foot stands on our floor, but in a jump.

    rest: of our own figure; bones: as they came; regions: those that are seen.
    """
    numbers = pose_numbers(pose_of_humanoid(rest, bones.turns))
    places = numbers[-BESIDE_BONES : PLACES - BESIDE_BONES].reshape(3, 3)  # a view: hips, left and right foot
    places[:, 1] -= _lowest(rest, numbers)
    height = _hips_height(rest) + places[0, 1]
    if bones.hips is not None and bones.hips[1] > LEAST_HEIGHT:
        x, y, z = bones.hips
        leg = bones.leg or y / height
        above = max(y / leg - height - LOWEST_JUMP, 0.0) if bones.leg else 0.0
        walk = np.clip([x / leg, z / leg], -FARTHEST_WALK, FARTHEST_WALK)
        places += [walk[0], above, walk[1]]
    seen = regions | {"head"} if bones.head and regions else regions  # the head's own direction comes beside
    return BodyFrame(numbers, tuple(region for region in POSE_REGIONS if region in seen))


def _hips_height(rest: HumanoidRest) -> float:
    """Of the stand, above its floor, leg lengths."""
    return float((rest.resting.joints[0, 1] - rest.ground[1]) / rest.resting.leg)


def _lowest(rest: HumanoidRest, numbers: Values) -> float:
    """How far the lowest point of both feet is above the floor, leg lengths: heels and toes, as the feet turn."""
    feet = numbers[-BESIDE_BONES:][3:PLACES].reshape(2, 3)
    turns = Rotation.from_rotvec(numbers[-6:].reshape(2, 3)).as_matrix()
    ankle = float((rest.resting.ankles[:, 1].mean() - rest.ground[1]) / rest.resting.leg)
    soles = np.array([[0.0, -ankle, reach] for reach in SOLE])
    return float((feet[:, None, 1] + ankle + (turns @ soles.T).transpose(0, 2, 1)[:, :, 1]).min())
