"""Puts joints into a glTF document, binds its meshes to them, and writes poses as animations."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from omote.arrays import Values
from omote.interchange.formats.glb_writer import (
    FLOAT,
    UNSIGNED_BYTE,
    UNSIGNED_SHORT,
    VERTICES,
    ExportScene,
    Json,
    Store,
    describe_scene,
    encode_glb,
)
from omote.interchange.formats.rig import Joint, Rig, strongest_weights, whole_weights

INFLUENCES = 4
"""Joints that move a vertex at most: what all programs read."""
STILL = 1e-7
"""A rotation whose matrix is off the unit by less turns nothing."""


@dataclass(frozen=True, eq=False)
class Binding:
    """How the vertices of a mesh hang on joints: their places among those of the skin (n, 4), and weights (n, 4) of 8
    or 16 bits, which sum to the most that these can say."""

    joints: NDArray[np.uint8]
    weights: NDArray[np.unsignedinteger]


@dataclass(frozen=True, eq=False)
class Hanging:
    """What a document's skin is: joints: the names of those that meshes hang on; inverse (k, 4, 4): from where vertices
    are kept to each one's frame; meshes: by name."""

    joints: tuple[str, ...]
    inverse: Values
    meshes: Mapping[str, Binding]


def glb_of_rig(scene: ExportScene, rig: Rig, /) -> bytes:
    """Encodes a scene on its rig as a GLB: bound meshes beside the joints, all others below the joint that carries
    them, each of the rig's motions an animation of one instant.

    scene: whose shapes stand in it; rig: theirs.
    """
    store = Store()
    document = describe_scene(scene, store)
    nodes = add_joints(document, rig.joints)
    bindings = {name: bind_strongest(rig, name) for name in rig.weights}
    hanging = Hanging(tuple(joint.name for joint in rig.joints), rig.inverse, bindings)
    bind_meshes(document, store, hanging, nodes)
    _carry_meshes(document, rig, nodes, bindings)
    animations = list(_animations(store, rig, [nodes[joint.name] for joint in rig.joints]))
    return encode_glb(document | {"animations": animations}, store)


def bind_strongest(rig: Rig, name: str, /) -> Binding:
    """The joints that move each vertex of a mesh most. rig, name: the mesh's."""
    joints, weights = strongest_weights(rig.weights[name], INFLUENCES)
    whole = whole_weights(weights, np.iinfo(np.uint16).max)
    return Binding(np.where(whole > 0, joints, 0).astype(np.uint8), whole.astype(np.uint16))


def add_joints(document: Json, joints: Iterable[Joint], /) -> dict[str, int]:
    """Puts joints under the root, node 0, and the meshes beside it, as bound ones have to stand: the nodes by name.

    document: the glTF's, which changes; joints: parents first.
    """
    nodes: list[Json] = document["nodes"]
    document["scenes"][0]["nodes"] += nodes[0].pop("children")
    places: dict[str, int] = {}
    known: dict[str, Joint] = {}
    for joint in joints:
        above = nodes[places[joint.parent] if joint.parent else 0]
        origin = known[joint.parent].place if joint.parent else (0.0, 0.0, 0.0)
        known[joint.name] = joint
        places[joint.name] = len(nodes)
        above.setdefault("children", []).append(len(nodes))
        step = [own - start for own, start in zip(joint.place, origin, strict=True)]
        nodes.append({"name": joint.name, "translation": step})
    return places


def bind_meshes(document: Json, store: Store, hanging: Hanging, nodes: Mapping[str, int], /) -> None:
    """Binds the meshes of a document that hang on its joints.

    document, store: the glTF and its numbers, which change; hanging: by the names of meshes; nodes: the joints' places
    in the document, by name.
    """
    inverse = np.ascontiguousarray(np.swapaxes(hanging.inverse, 1, 2), "<f4")  # the file has column after column
    form = {"componentType": FLOAT, "count": len(inverse), "type": "MAT4"}
    matrix = store.accessor({"bufferView": store.view(inverse.tobytes()), **form})
    joints = [nodes[name] for name in hanging.joints]
    document["skins"] = [{"joints": joints, "skeleton": joints[0], "inverseBindMatrices": matrix}]
    for place in document["scenes"][0]["nodes"][1:]:
        bound = document["nodes"][place]
        mesh = document["meshes"][bound["mesh"]]
        binding = hanging.meshes.get(mesh["name"])
        if binding is None:
            continue
        bound["skin"] = 0
        attributes = mesh["primitives"][0]["attributes"]
        small = binding.weights.dtype == np.uint8
        form = {"count": len(binding.weights), "type": "VEC4"}
        kind: Json = {"componentType": UNSIGNED_BYTE if small else UNSIGNED_SHORT, **form, "normalized": True}
        hangs = store.view(binding.joints.tobytes(), VERTICES)
        parts = store.view(binding.weights.astype(binding.weights.dtype.newbyteorder("<")).tobytes(), VERTICES)
        attributes["JOINTS_0"] = store.accessor({"bufferView": hangs, "componentType": UNSIGNED_BYTE, **form})
        attributes["WEIGHTS_0"] = store.accessor({"bufferView": parts, **kind})


def _carry_meshes(document: Json, rig: Rig, nodes: Mapping[str, int], bound: Mapping[str, Binding]) -> None:
    """Puts the meshes that are not bound below the joint that carries them."""
    top = document["scenes"][0]
    carrier = next(joint for joint in rig.joints if joint.name == rig.carrier)
    carried = [
        place for place in top["nodes"][1:] if document["meshes"][document["nodes"][place]["mesh"]]["name"] not in bound
    ]
    top["nodes"] = [place for place in top["nodes"] if place not in carried]
    document["nodes"][nodes[rig.carrier]].setdefault("children", []).extend(carried)
    for place in carried:
        node = document["nodes"][place]
        away = np.array(node.get("translation", (0.0, 0.0, 0.0))) - carrier.place
        node["translation"] = away.tolist()


def _animations(store: Store, rig: Rig, nodes: Sequence[int]) -> Iterable[Json]:
    """The motions as animations, of all joints that any of them turns: from one to another none keeps what it had."""
    turns = np.stack([motion.turns for motion in rig.motions.values()])
    moved = np.flatnonzero((np.abs(turns - np.eye(3)) > STILL).any(axis=(0, 2, 3))).tolist()
    start = _instant(store, np.zeros((1, 1)), "SCALAR", {"min": [0.0], "max": [0.0]})
    rotations = Rotation.from_matrix(turns[:, moved].reshape(-1, 3, 3)).as_quat().reshape(len(turns), len(moved), 4)
    kept: dict[bytes, int] = {}
    for (name, motion), rows in zip(rig.motions.items(), rotations.astype("<f4"), strict=True):
        outputs = [_once(store, kept, row[None], "VEC4") for row in rows]
        channels = [(nodes[joint], "rotation") for joint in moved]
        outputs.append(_once(store, kept, motion.travel[None].astype("<f4"), "VEC3"))
        channels.append((nodes[0], "translation"))
        yield {
            "name": name,
            "samplers": [{"input": start, "output": output} for output in outputs],
            "channels": [
                {"sampler": place, "target": {"node": node, "path": path}}
                for place, (node, path) in enumerate(channels)
            ],
        }


def _once(store: Store, kept: dict[bytes, int], values: Values, kind: str) -> int:
    """An accessor of one value, the same for the same value."""
    key = values.tobytes()
    if key not in kept:
        kept[key] = _instant(store, values, kind, {})
    return kept[key]


def _instant(store: Store, values: Values, kind: str, bounds: Json) -> int:
    view = store.view(np.ascontiguousarray(values, "<f4").tobytes())
    return store.accessor({"bufferView": view, "componentType": FLOAT, "count": 1, "type": kind, **bounds})
