"""A plain skeleton in T-pose for a head without a body: a person's proportions, as tall as the head says."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.model.space.face_fit import FittedFace
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.motion.sight import NECK

Points = NDArray[np.float64]
Place = tuple[float, float, float]

HEAD, EYES = 0.130, 0.936
"""Of a person's height: from under the chin to the crown, and how high the eyes are (Drillis and Contini 1966)."""
SKULL = 0.905
"""Of a person's height: where the head turns on the neck."""
CROWN, CHIN = (0.0, 0.121, 0.040), (0.0, -0.113, 0.124)
"""Metres on the generic head."""
SMALLEST_HEAD = 0.02
_SPINE = (("hips", 0.550), ("spine", 0.600), ("chest", 0.670), ("neck", 0.830), ("head", SKULL))
_ARM = (("UpperArm", 0.129, 0.818), ("LowerArm", 0.315, 0.818), ("Hand", 0.461, 0.818))
_LEG = (("UpperLeg", 0.050, 0.530), ("LowerLeg", 0.050, 0.285), ("Foot", 0.050, 0.039))
"""Heights of joints, and how far they are from the middle, of a person's height: limbs as Drillis and Contini (1966)
have them, hips half as far apart as they are broad, and the trunk's joints between."""


@dataclass(frozen=True)
class Joint:
    """A joint at rest: metres in the scene, and the name of its parent, which comes before it; "" for the root."""

    name: str
    place: Place
    parent: str = ""


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Joints by name, feet on y = 0; shift: what brings a point of the face to its place in the scene, metres;
    eyes: from the head's joint to between the eyes."""

    joints: Mapping[str, Joint]
    shift: Points
    eyes: Place


def build_skeleton(space: ParameterSpace, fitted: FittedFace, /) -> Skeleton:
    """Builds the skeleton that a face stands on.

    References
    ----------
    R. Drillis, R. Contini (1966): Body segment parameters; after D. A. Winter, Biomechanics and motor control of human
    movement, section 4.1.
    """
    rows = cKDTree(space.points).query(np.array([CROWN, CHIN]))[1]
    crown, chin = fitted.positions[rows, 1].tolist()
    height = max(crown - chin, SMALLEST_HEAD) / HEAD
    balls = [centre for name, centre in fitted.centres.items() if space.parts[name].eye]
    middle: Points = np.array(balls or [np.zeros(3)], np.float64).mean(axis=0)
    shift = np.array([0.0, EYES * height - middle[1], -NECK])
    joints = {joint.name: joint for joint in _joints(height)}
    ahead = middle + shift - joints["head"].place
    return Skeleton(joints, shift, (0.0, float(ahead[1]), float(ahead[2])))


def _joints(height: float) -> list[Joint]:
    found, parent = [], ""
    for name, up in _SPINE:
        found.append(Joint(name, (0.0, up * height, 0.0), parent))
        parent = name
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for limb, above in ((_ARM, "chest"), (_LEG, "hips")):
            parent = above
            for name, across, up in limb:
                found.append(Joint(f"{side}{name}", (sign * across * height, up * height, 0.0), parent))
                parent = f"{side}{name}"
    return found
