"""Correctives: the joints of a figure whose skin has some, and how much of each a pose calls.

Elbows and knees call theirs by how far they are bent, fingers and hips too, shoulders by where the arm points. Each
joint has four.
"""

from __future__ import annotations

import numpy as np

from omote.arrays import Points, Values
from omote.model.body.compose_pose import arm_turn
from omote.model.body.pose_recipe import Arm
from omote.model.body.posed_bones import PosedBones
from omote.model.body.skeleton import SIDES, Skeleton
from omote.model.body.stand import OUT, UPPER_ARM, hanging
from omote.model.body.twist import twist_about

SHAPES = 4
"""Correctives of each joint."""
LIMBS = (("upperarm01", "lowerarm01", "wrist"), ("upperleg01", "lowerleg01", "foot"))
"""Of one side: where a limb begins, its hinge, and where it ends."""
HINGES = tuple(tuple(f"{name}.{side}" for name in limb) for limb in LIMBS for side in SIDES)
"""Elbows, then knees, the left before the right."""
HINGE_BENDS = (0.0, 45.0, 90.0, 130.0)
"""Degrees from the straight limb at which these have correctives; between them these are mixed linearly."""
FINGERS = tuple(
    (f"finger{finger}-{joint - 1}.{side}" if joint > 1 else f"metacarpal{finger - 1}.{side}", bone)
    for side in SIDES
    for finger in (2, 3, 4, 5)
    for joint in (1, 2, 3)
    for bone in (f"finger{finger}-{joint}.{side}",)
)
"""The joints of fingers but the thumb: the bone before, and the one that bends."""
FINGER_BENDS = (30.0, 60.0, 85.0, 110.0)
"""Degrees towards the palm; none at 0, as fingers are modelled."""
HIPS = tuple((f"upperleg01.{side}", f"lowerleg01.{side}") for side in SIDES)
HIP_BENDS = (35.0, 65.0, 95.0, 125.0)
"""Degrees that a thigh is raised to the front of the trunk; none at 0."""
SHOULDERS = tuple((f"upperarm01.{side}", f"lowerarm01.{side}") for side in SIDES)
ARMS = (
    Arm(),
    Arm(raised=60.0, spread=-15.0),
    Arm(raised=-24.0, spread=2.0, twist=58.0),
    Arm(raised=118.0, spread=100.0),
)
"""How arms are held for which shoulders have correctives: hanging, before the chest, behind the back, overhead."""
MODELLED = Arm(spread=38.0)
"""About how they were modelled, which needs none."""
JOINTS = len(HINGES) + len(FINGERS) + len(HIPS) + len(SHOULDERS)
"""With correctives, in this order."""


def corrective_calls(skeleton: Skeleton, bones: PosedBones) -> Values:
    """How much of each corrective each joint calls (JOINTS, SHAPES). skeleton: of the figure; bones: in a pose."""
    hinges = between(hinge_bends(skeleton, bones.joints), HINGE_BENDS)
    fingers = between(finger_bends(skeleton, bones), FINGER_BENDS, bare=True)
    hips = between(hip_bends(skeleton, bones), HIP_BENDS, bare=True)
    return np.concatenate([hinges, fingers, hips, shoulder_calls(skeleton, bones)])


def hinge_bends(skeleton: Skeleton, joints: Points) -> Values:
    """How far each hinge is bent (4,), degrees from the straight limb.

    skeleton: of the figure; joints (J, 3): where bones begin, metres.
    """
    at = joints[[[skeleton.places[name] for name in hinge] for hinge in HINGES]]
    upper = at[:, 1] - at[:, 0]
    lower = at[:, 2] - at[:, 1]
    sines = np.linalg.norm(np.cross(upper, lower), axis=1)
    return np.asarray(np.degrees(np.arctan2(sines, (upper * lower).sum(axis=1))))


def finger_bends(skeleton: Skeleton, bones: PosedBones) -> Values:
    """How far each joint of the fingers is bent to the palm (24,), degrees. skeleton: of the figure; bones: in a
    pose."""
    found = []
    for before, bone in FINGERS:
        turn = bones.frames[skeleton.places[before]].T @ bones.frames[skeleton.places[bone]]
        found.append(-OUT[bone[-1]] * twist_about(turn, np.array([0.0, 0.0, 1.0])))
    return np.degrees(found)


def hip_bends(skeleton: Skeleton, bones: PosedBones) -> Values:
    """How far each thigh is raised to the front (2,), degrees from straight down the trunk; what goes aside is left
    out. skeleton: of the figure; bones: in a pose."""
    ways = _limb_ways(skeleton, bones, HIPS, "root")
    aside = np.linalg.norm(ways[:, [0, 2]], axis=1)
    ahead = np.maximum(ways[:, 2], 0.0) / np.maximum(aside, 1e-9)
    return np.asarray(np.degrees(np.arctan2(aside, -ways[:, 1])) * ahead)


def shoulder_calls(skeleton: Skeleton, bones: PosedBones) -> Values:
    """How much of each corrective of `ARMS` each shoulder calls (2, SHAPES), by where its arm points.

    Radial basis functions of the angle on the sphere of directions: each arm of `ARMS` calls its own alone, and one as
    modelled none. skeleton: of the figure; bones: in a pose.
    """
    ways = _limb_ways(skeleton, bones, SHOULDERS, "spine01")
    ways[:, 0] *= [OUT[side] for side in SIDES]
    return np.asarray(_angles(ways, SHOULDER_WAYS) @ SHOULDER_SHARES)


def between(bends: Values, at: tuple[float, ...], *, bare: bool = False) -> Values:
    """How much of each corrective (n, SHAPES) joints call, bent so far; beyond the last it stays.

    bends (n,): degrees; at: where the correctives are; bare: whether a joint at 0 calls none.
    """
    knots = (0.0, *at) if bare else at
    shapes = np.eye(len(knots))[len(knots) - len(at) :]
    return np.stack([np.interp(bends, knots, shape) for shape in shapes], axis=1)


def _limb_ways(skeleton: Skeleton, bones: PosedBones, limbs: tuple[tuple[str, ...], ...], trunk: str) -> Points:
    """Where limbs point as their trunk has it, (n, 3) of unit length."""
    begin, end = (bones.joints[[skeleton.places[limb[part]] for limb in limbs]] for part in (0, 1))
    ways = (end - begin) @ bones.frames[skeleton.places[trunk]]
    return np.asarray(ways / np.linalg.norm(ways, axis=1, keepdims=True))


def _angles(ways: Points, others: Points) -> Values:
    """Between directions (n, 3) and (m, 3): radians (n, m)."""
    return np.asarray(np.arccos(np.clip(ways @ others.T, -1.0, 1.0)))


SHOULDER_WAYS = np.array([arm_turn(arm, 1.0) @ hanging(*UPPER_ARM, "L") for arm in (MODELLED, *ARMS)])
"""Where a left arm points as modelled, then in each of `ARMS`, as the trunk has it."""
SHOULDER_SHARES = np.linalg.inv(_angles(SHOULDER_WAYS, SHOULDER_WAYS))[:, 1:]
"""By how much each of these angles calls each corrective (5, SHAPES)."""
