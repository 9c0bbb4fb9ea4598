"""Adds a skeleton to a glTF document and binds all its meshes to one joint, each vertex at full weight."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from omote.interchange.avatar.humanoid_skeleton import Joint
from omote.interchange.formats.glb_writer import FLOAT, UNSIGNED_BYTE, VERTICES, Store

Json = dict[str, Any]


def add_joints(document: Json, joints: Mapping[str, Joint], /) -> dict[str, int]:
    """Puts joints under the root, node 0, and the meshes beside it, as bound ones have to stand: the nodes by name."""
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
    """Binds every mesh of a document to a joint, whose node is given; points are those of the scene."""
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
