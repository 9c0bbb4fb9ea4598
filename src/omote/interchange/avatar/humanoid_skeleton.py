"""A plain skeleton in T-pose for a head without a body, as tall as the head says."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Points
from omote.interchange.formats.rig import Joint, Position
from omote.model.space.face_fit import FittedFace
from omote.model.space.head_size import find_chin, find_crown
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.motion.sight import NECK_METRES

HEAD = 0.130
EYES = 0.936
"""Of a person's height: from under the chin to the crown, and how high the eyes are (Drillis and Contini 1966)."""
SKULL = 0.905
"""Of a person's height: where the head turns on the neck."""
SMALLEST_HEAD_METRES = 0.02
_SPINE = (("hips", 0.550), ("spine", 0.600), ("chest", 0.670), ("neck", 0.830), ("head", SKULL))
_ARM = (("UpperArm", 0.129, 0.818), ("LowerArm", 0.315, 0.818), ("Hand", 0.461, 0.818))
_LEG = (("UpperLeg", 0.050, 0.530), ("LowerLeg", 0.050, 0.285), ("Foot", 0.050, 0.039))
"""Heights of joints, and how far they are from the middle, of a person's height: limbs as Drillis and Contini (1966)
have them, hips half as far apart as they are broad, and the trunk's joints between."""


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Joints by name, feet on y = 0; bones: which of them is which of VRM's, by its names; shift: what brings a point
    of the face to its place in the scene, metres; eyes: from the head's joint to between the eyes."""

    joints: Mapping[str, Joint]
    bones: Mapping[str, str]
    shift: Points
    eyes: Position


def build_skeleton(space: ParameterSpace, fitted: FittedFace, /) -> Skeleton:
    """Builds the skeleton that a face stands on.

    References
    ----------
    R. Drillis, R. Contini (1966): Body segment parameters; after D. A. Winter, Biomechanics and motor control of human
    movement, section 4.1.

    space, fitted: the face that stands on it.
    """
    crown, chin = fitted.positions[[find_crown(space), find_chin(space)], 1].tolist()
    height = max(crown - chin, SMALLEST_HEAD_METRES) / HEAD
    middle = eyes_middle(space, fitted)
    shift = np.array([0.0, EYES * height - middle[1], -NECK_METRES])
    joints = {joint.name: joint for joint in _joints(height)}
    ahead = middle + shift - joints["head"].place
    return Skeleton(joints, {name: name for name in joints}, shift, (0.0, float(ahead[1]), float(ahead[2])))


def eyes_middle(space: ParameterSpace, fitted: FittedFace, /) -> Points:
    """Where the middle between the eyeballs is, metres; the origin of a head without any. space, fitted: the face."""
    balls = [centre for name, centre in fitted.centres.items() if space.parts[name].eye]
    return np.asarray(np.array(balls or [np.zeros(3)], np.float64).mean(axis=0))


def _joints(height: float) -> list[Joint]:
    joints = []
    parent = ""
    for name, up in _SPINE:
        joints.append(Joint(name, (0.0, up * height, 0.0), parent))
        parent = name
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for limb, above in ((_ARM, "chest"), (_LEG, "hips")):
            parent = above
            for name, across, up in limb:
                joints.append(Joint(f"{side}{name}", (sign * across * height, up * height, 0.0), parent))
                parent = f"{side}{name}"
    return joints
