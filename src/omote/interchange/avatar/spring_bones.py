"""Ears of an avatar that swing by themselves: joints at their roots and tips, and `VRMC_springBone`, which moves them.

VRM Consortium, VRMC_springBone-1.0: https://github.com/vrm-c/vrm-specification/tree/master/specification. Its springs
turn bones; jowls and cheeks are no bones, so they stay still in an avatar.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from omote.arrays import Points, Values
from omote.interchange.formats.glb_writer import Json
from omote.interchange.formats.rig import Joint, Position
from omote.model.space.ears import ear_weights, find_ear
from omote.model.space.face import Face
from omote.model.space.gain import gain_of
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.springs.cast_springs import SPRINGS

EXTENSION = "VRMC_springBone"
VERSION = "1.0"
RATE = 60.0
"""Pictures a second at which an ear swings as on our stages: what VRM calls stiffness and drag counts by picture."""
HANGS_ON = "head"
SIDES = ("leftEar", "rightEar")
_SPRING = SPRINGS["ears-sway"]


@dataclass(frozen=True, eq=False)
class EarBone:
    """An ear on a joint of its own: its root and its tip, metres in the scene, and how much of each vertex of the skin
    hangs on it, (V,) 0 to 1."""

    root: Joint
    tip: Joint
    shares: Values

    @property
    def length(self) -> float:
        """Metres from root to tip."""
        return math.dist(self.root.place, self.tip.place)


def find_ear_bones(space: ParameterSpace, face: Face, shift: Points, /) -> tuple[EarBone, ...]:
    """The ears of a face that answers with its ears; none of others, as of people.

    space: of the face; shift: what brings a point of the face to its place in the scene, metres.
    """
    if not gain_of(face.gains, "ears", _SPRING.channel):
        return ()
    rest = face.positions.astype(np.float64)
    bones = []
    for name, shares in zip(SIDES, ear_weights(space), strict=True):
        ear = find_ear(shares, rest)
        if ear is not None:
            reach = float(((rest[shares >= 1.0] - ear.root) @ ear.direction).max())
            end = ear.root + reach * ear.direction
            root = Joint(name, _place(ear.root + shift), HANGS_ON)
            bones.append(EarBone(root, Joint(f"{name}Tip", _place(end + shift), name), shares))
    return tuple(bones)


def _place(point: Points) -> Position:
    x, y, z = (float(value) for value in point)
    return x, y, z


def describe_springs(bones: Sequence[EarBone], nodes: Mapping[str, int], /) -> Json:
    """The extension of 1.0. bones: the ears; nodes: of all joints, by name."""
    return {
        "specVersion": VERSION,
        "springs": [
            {
                "name": bone.root.name,
                "joints": [{"node": nodes[bone.root.name], **_swing(bone)}, {"node": nodes[bone.tip.name]}],
            }
            for bone in bones
        ],
    }


def describe_old_springs(bones: Sequence[EarBone], nodes: Mapping[str, int], /) -> list[Json]:
    """The bone groups of 0.x. bones: the ears; nodes: of all joints, by name."""
    groups = []
    for bone in bones:
        swing = _swing(bone)
        down = dict(zip("xyz", swing.pop("gravityDir"), strict=True))
        stiffness = swing.pop("stiffness")
        place: Json = {"comment": bone.root.name, "center": -1, "bones": [nodes[bone.root.name]], "colliderGroups": []}
        groups.append(place | swing | {"stiffiness": stiffness, "gravityDir": down})  # so the specification spells it
    return groups


def _swing(bone: EarBone) -> Json:
    """How an ear swings. A picture makes `(angle + (1 - drag) (angle - before)) / (1 + pull)` of a small angle, with
    pull = stiffness / (RATE length), by the specification's algorithm: its roots are those of our spring."""
    rate = 2.0 * math.pi * _SPRING.frequency / RATE
    left = math.exp(-_SPRING.damping * rate)
    turned = math.cos(math.sqrt(1.0 - _SPRING.damping * _SPRING.damping) * rate)
    pull = 1.0 / (2.0 * left * turned - left * left) - 1.0
    return {
        "hitRadius": 0.0,
        "stiffness": round(pull * RATE * bone.length, 4),
        "gravityPower": 0.0,
        "gravityDir": [0.0, -1.0, 0.0],
        "dragForce": round(1.0 - left * left * (1.0 + pull), 4),
    }
