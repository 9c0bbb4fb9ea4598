"""Hinges: the elbows and knees of a figure, how far each is bent, and which correctives that calls."""

from __future__ import annotations

import numpy as np

from omote.arrays import Points, Values
from omote.model.body.skeleton import SIDES, Skeleton

LIMBS = (("upperarm01", "lowerarm01", "wrist"), ("upperleg01", "lowerleg01", "foot"))
"""Of one side: where a limb begins, its hinge, and where it ends."""
HINGES = tuple(tuple(f"{name}.{side}" for name in limb) for limb in LIMBS for side in SIDES)
"""Elbows, then knees, the left before the right."""
BENDS = (45.0, 90.0, 130.0)
"""Degrees from the straight limb at which bodies have correctives; between them these are mixed linearly."""


def hinge_bends(skeleton: Skeleton, joints: Points) -> Values:
    """How far each hinge is bent (4,), degrees from the straight limb.

    skeleton: of the figure; joints (J, 3): where bones begin, metres.
    """
    at = joints[[[skeleton.places[name] for name in hinge] for hinge in HINGES]]
    upper = at[:, 1] - at[:, 0]
    lower = at[:, 2] - at[:, 1]
    sines = np.linalg.norm(np.cross(upper, lower), axis=1)
    return np.asarray(np.degrees(np.arctan2(sines, (upper * lower).sum(axis=1))))


def corrective_weights(bends: Values) -> Values:
    """How much of each corrective (4, 3) hinges call that are bent so far; none when straight, beyond the last it
    stays. bends (4,): degrees."""
    knots = (0.0, *BENDS)
    shapes = np.eye(len(knots))[1:]
    return np.stack([np.interp(bends, knots, shape) for shape in shapes], axis=1)
