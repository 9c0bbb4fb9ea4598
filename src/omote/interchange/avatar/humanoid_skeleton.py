"""A plain skeleton in T-pose for a head without a body, as tall as the head says; and meshes bound to it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Points, Values
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


def bind_meshes(
    document: Json, store: Store, joints: Sequence[Joint], nodes: Sequence[int], shares: Mapping[str, Values], /
) -> None:
    """Binds every mesh of a document to joints, whose nodes are given; points are those of the scene.

    document, store: the glTF and its numbers, which change; joints, nodes: the joints, four at most, and where they
    stand in the document; shares: how much of each vertex hangs on each joint but the first, (n, joints - 1) by mesh,
    which has the rest, and all of other meshes.
    """
    inverse = np.tile(np.eye(4, dtype="<f4"), (len(joints), 1, 1))
    inverse[:, 3, :3] = [[-along for along in joint.place] for joint in joints]  # the file has column after column
    form = {"componentType": FLOAT, "count": len(joints), "type": "MAT4"}
    matrix = store.accessor({"bufferView": store.view(inverse.tobytes()), **form})
    document["skins"] = [{"joints": [*nodes], "skeleton": nodes[0], "inverseBindMatrices": matrix}]
    for place in document["scenes"][0]["nodes"][1:]:
        bound = document["nodes"][place]
        bound["skin"] = 0
        mesh = document["meshes"][bound["mesh"]]
        attributes = mesh["primitives"][0]["attributes"]
        count = store.accessors[attributes["POSITION"]]["count"]
        form = {"componentType": UNSIGNED_BYTE, "count": count, "type": "VEC4"}
        weights = _weights(shares.get(mesh["name"], np.zeros((count, 0))))
        numbers = np.where(weights > 0, np.arange(4, dtype=np.uint8), np.uint8(0))
        hangs = store.view(numbers.tobytes(), VERTICES)
        parts = store.view(weights.tobytes(), VERTICES)
        attributes["JOINTS_0"] = store.accessor({"bufferView": hangs, **form})
        attributes["WEIGHTS_0"] = store.accessor({"bufferView": parts, **form, "normalized": True})


def _weights(shares: Values) -> NDArray[np.uint8]:
    """The weights of four joints, (n, 4) of 255, the first with what the others leave. shares: of those, (n, k)."""
    weights = np.zeros((len(shares), 4), np.uint8)
    weights[:, 1 : 1 + shares.shape[1]] = np.rint(255.0 * shares)
    weights[:, 0] = 255 - weights[:, 1:].sum(axis=1)
    return weights
