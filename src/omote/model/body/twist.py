"""Twists: how far a rotation turns about an axis, and how an upper arm spreads its own along itself."""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.model.body.skeleton import SIDES, Skeleton

UPPER_ARM = ("shoulder01", "upperarm01", "upperarm02")
"""What an upper arm hangs on, and its two bones, of which the second lies along the first."""
SPREAD = 0.7
"""Of the twist of an upper arm, what its second bone makes alone: armpits fold where the first makes all of it."""


def twist_about(turn: Values, axis: Values) -> float:
    """The angle of a rotation about a direction, radians, -pi to pi: what is left without its swing.

    turn (3, 3): the rotation; axis (3,): the direction, of length one.
    """
    aside = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    return math.atan2(float(aside @ axis), float(np.trace(turn) - axis @ turn @ axis))


def spread_twist(skeleton: Skeleton, rest: Points, stand: Values, frames: Values) -> Values:
    """The rotations (J, 3, 3) of bones from the stand, upper arms twisted less where they begin.

    The first bone of each turns back about itself: neither the elbow nor what hangs on it moves.

    skeleton, rest, stand: as of `omote.model.body.posed_bones.place_bones`; frames (J, 3, 3): from the stand.
    """
    spread = frames.copy()
    for side in SIDES:
        before, first, second = (skeleton.places[f"{name}.{side}"] for name in UPPER_ARM)
        along = rest[second] - rest[first]
        along = along / np.linalg.norm(along)
        turn = frames[first] @ stand[first]
        twist = twist_about((frames[before] @ stand[before]).T @ turn, along)
        spread[first] = turn @ Rotation.from_rotvec(-SPREAD * twist * along).as_matrix() @ stand[first].T
    return spread
