"""A skeleton in a glTF document: nodes where the joints are, and every vertex on one of them alone."""

from pathlib import Path

import numpy as np

from omote.interchange.formats.glb_rig import Binding, Hanging, add_joints, bind_meshes
from omote.interchange.formats.glb_writer import Store, describe_scene, encode_glb
from omote.interchange.formats.rig import Joint
from tests.interchange.formats.scenes import scene, taken_apart, tetrahedron
from tools.gltf import inspect

ORDER = (
    Joint("hips", (0.0, 1.0, 0.0)),
    Joint("head", (0.0, 1.5, 0.25), "hips"),
    Joint("leg", (0.5, 0.5, 0.0), "hips"),
)
JOINTS = {joint.name: joint for joint in ORDER}
AWAY = np.eye(4)
AWAY[:3, 3] = -np.array(JOINTS["head"].place)


def bound() -> bytes:
    """Two tetrahedra on the head of a skeleton of three joints."""
    store = Store()
    shapes = tetrahedron("a"), tetrahedron("b", size=3)
    document = describe_scene(scene(*shapes), store)
    nodes = add_joints(document, ORDER)
    whole = np.array([255, 0, 0, 0], np.uint8)
    meshes = {shape.name: Binding(np.tile(0 * whole, (len(shape.points), 1)), np.tile(whole, (len(shape.points), 1)))
              for shape in shapes}  # fmt: skip
    bind_meshes(document, store, Hanging(("head",), AWAY[None], meshes), nodes)
    return encode_glb(document, store)


def test_joints_are_where_they_are_and_meshes_beside_them() -> None:
    document, _ = taken_apart(bound())
    nodes = document["nodes"]
    assert [nodes[place]["name"] for place in document["scenes"][0]["nodes"]] == ["head", "a", "b"]  # the root, meshes

    def places(node: int, origin: np.ndarray) -> dict[str, list[float]]:
        here = origin + nodes[node].get("translation", [0, 0, 0])
        found = {nodes[node]["name"]: here.tolist()}
        for child in nodes[node].get("children", []):
            found |= places(child, here)
        return found

    (hips,) = nodes[0]["children"]
    assert places(hips, np.zeros(3)) == {name: list(joint.place) for name, joint in JOINTS.items()}


def test_every_vertex_is_on_the_one_joint_and_at_rest_where_it_was() -> None:
    document, binary = taken_apart(bound())
    (skin,) = document["skins"]
    (joint,) = skin["joints"]
    assert document["nodes"][joint]["name"] == "head"

    def values(accessor: int, kind: str) -> np.ndarray:
        entry = document["accessors"][accessor]
        view = document["bufferViews"][entry["bufferView"]]
        return np.frombuffer(binary[view["byteOffset"] :][: view["byteLength"]], kind)

    inverse = values(skin["inverseBindMatrices"], "<f4").reshape(4, 4).T
    stands = np.eye(4)
    stands[:3, 3] = JOINTS["head"].place
    np.testing.assert_allclose(stands @ inverse, np.eye(4))
    for node, mesh in zip(document["nodes"][1:3], document["meshes"], strict=True):
        attributes = mesh["primitives"][0]["attributes"]
        assert node["skin"] == 0
        assert not node.keys() & {"translation", "rotation", "scale"}
        weights = values(attributes["WEIGHTS_0"], "u1")
        joints = values(attributes["JOINTS_0"], "u1")
        count = document["accessors"][attributes["POSITION"]]["count"]
        np.testing.assert_array_equal(weights.reshape(count, 4), [[255, 0, 0, 0]] * count)
        np.testing.assert_array_equal(joints.reshape(count, 4), 0)


def test_khronos_says_nothing_against_it(tmp_path: Path) -> None:
    path = tmp_path / "bound.glb"
    path.write_bytes(bound())
    (found,) = inspect([path])
    assert (found["validator"]["errors"], found["validator"]["warnings"]) == (0, 0)
