"""The body of a performer as a mirror shows it."""

from __future__ import annotations

from functools import cache

import numpy as np

from omote.arrays import Indices
from omote.model.body.pose_regions import PoseRegion
from omote.perform.figures.packed_pose import BESIDE_BONES
from omote.perform.layers.source_frame import BodyFrame

OTHER: dict[PoseRegion, PoseRegion] = {"arm_left": "arm_right", "arm_right": "arm_left"}
TURN = np.array([1.0, -1.0, -1.0])
"""What a mirror makes of a rotation vector."""
PLACE = np.array([-1.0, 1.0, 1.0])


def mirrored_body(body: BodyFrame) -> BodyFrame:
    """The same with left and right swapped. body: of a skeleton that all figures share."""
    count = len(body.numbers) - BESIDE_BONES
    turns = body.numbers[:count].reshape(-1, 3)
    places = body.numbers[count : count + 9].reshape(3, 3)
    feet_turns = body.numbers[count + 9 :].reshape(2, 3)
    mirrored = (turns[_mirror()] * TURN, places[[0, 2, 1]] * PLACE, feet_turns[::-1] * TURN)
    numbers = np.concatenate([part.ravel() for part in mirrored])
    return BodyFrame(numbers, tuple(OTHER.get(region, region) for region in body.regions))


@cache
def _mirror() -> Indices:
    """Of the built-in figures, whose skeleton all have; commands read names of sources without them."""
    from omote.builtin import load_figures

    return load_figures().space.skeleton.mirror
