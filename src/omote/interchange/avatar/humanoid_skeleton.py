"""A plain skeleton in T-pose for a head without a body, as tall as the head says; and meshes bound to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Points
from omote.interchange.formats.glb_writer import FLOAT, UNSIGNED_BYTE, VERTICES, Json, Store
from omote.model.space.face_fit import FittedFace
from omote.model.space.head_size import find_chin, find_crown
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.motion.sight import NECK_METRES

Position = tuple[float, float, float]

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


@dataclass(frozen=True)
class Joint:
    """A joint at rest: metres in the scene, and the name of its parent, which comes before it; "" for the root."""

    name: str
    place: Position
    parent: str = ""


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Joints by name, feet on y = 0; shift: what brings a point of the face to its place in the scene, metres;
    eyes: from the head's joint to between the eyes."""

    joints: Mapping[str, Joint]
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
    balls = [centre for name, centre in fitted.centres.items() if space.parts[name].eye]
    middle: Points = np.array(balls or [np.zeros(3)], np.float64).mean(axis=0)
    shift = np.array([0.0, EYES * height - middle[1], -NECK_METRES])
    joints = {joint.name: joint for joint in _joints(height)}
    ahead = middle + shift - joints["head"].place
    return Skeleton(joints, shift, (0.0, float(ahead[1]), float(ahead[2])))


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


def add_joints(document: Json, joints: Mapping[str, Joint], /) -> dict[str, int]:
    """Puts joints under the root, node 0, and the meshes beside it, as bound ones have to stand: the nodes by name.

    document: the glTF's, which changes; joints: parents first.
    """
    nodes: list[Json] = document["nodes"]
    document["scenes"][0]["nodes"] += nodes[0].pop("children")
    places: dict[str, int] = {}
    for joint in joints.values():
        above = nodes[places[joint.parent] if joint.parent else 0]
        origin = joints[joint.parent].place if joint.parent else (0.0, 0.0, 0.0)
        places[joint.name] = len(nodes)
        above.setdefault("children", []).append(len(nodes))
        step = [own - start for own, start in zip(joint.place, origin, strict=True)]
        nodes.append({"name": joint.name, "translation": step})
    return places


def bind_meshes(document: Json, store: Store, joint: Joint, node: int, /) -> None:
    """Binds every mesh of a document to a joint, whose node is given; points are those of the scene.

    document, store: the glTF and its numbers, which change; joint, node: the joint, and where it stands in the
    document.
    """
    inverse = np.eye(4, dtype="<f4")
    inverse[3, :3] = -np.array(joint.place)  # the file has column after column
    matrix = {"bufferView": store.view(inverse.tobytes()), "componentType": FLOAT, "count": 1, "type": "MAT4"}
    document["skins"] = [{"joints": [node], "skeleton": node, "inverseBindMatrices": store.accessor(matrix)}]
    for place in document["scenes"][0]["nodes"][1:]:
        bound = document["nodes"][place]
        bound["skin"] = 0
        attributes = document["meshes"][bound["mesh"]]["primitives"][0]["attributes"]
        count = store.accessors[attributes["POSITION"]]["count"]
        form = {"componentType": UNSIGNED_BYTE, "count": count, "type": "VEC4"}
        first = store.view(bytes(4 * count), VERTICES)
        whole = store.view(bytes([255, 0, 0, 0]) * count, VERTICES)
        attributes["JOINTS_0"] = store.accessor({"bufferView": first, **form})
        attributes["WEIGHTS_0"] = store.accessor({"bufferView": whole, **form, "normalized": True})
