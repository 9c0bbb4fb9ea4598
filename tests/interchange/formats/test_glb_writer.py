"""GLB files as they are written: what is in them, and that the format's own validator says nothing against them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.glb_writer import ExportScene, Material, MorphTarget, glb_bytes
from omote.interchange.formats.png import png_bytes
from tests.interchange.formats.scenes import NAMES, scene, taken_apart, tetrahedron
from tools.gltf import inspect


def test_what_is_written_is_read_again() -> None:
    shapes = tetrahedron("left", size=9, place=(0.5, 0.0, -1.0)), tetrahedron("right")
    pieces = read_glb(glb_bytes(scene(*shapes)))
    assert [piece.name for piece in pieces] == ["left", "right"]
    for piece, shape in zip(pieces, shapes, strict=True):
        np.testing.assert_array_equal(piece.points, shape.points + np.array(shape.place))
        np.testing.assert_array_equal(piece.rows, shape.rows)
        assert tuple(piece.moves) == NAMES
        for name, target in shape.targets.items():
            np.testing.assert_array_equal(piece.moves[name], target.moves)


def test_a_target_costs_what_moves() -> None:
    document, _ = taken_apart(glb_bytes(scene(tetrahedron(size=9))))
    positions = [target["POSITION"] for target in document["meshes"][0]["primitives"][0]["targets"]]
    still, one, all_ = (document["accessors"][place] for place in positions)
    assert not still.keys() & {"bufferView", "sparse"}
    assert (one["sparse"]["count"], "bufferView" in one) == (1, False)
    assert ("sparse" in all_, "bufferView" in all_) == (False, True)
    assert still["max"] == still["min"] == [0.0, 0.0, 0.0]
    assert (one["min"], one["max"]) == ([0.0, -0.5, 0.0], [0.25, 0.0, 0.125])


def test_every_mesh_names_all_targets_in_one_order_and_none_as_blender_names_its_rest() -> None:
    document, _ = taken_apart(glb_bytes(scene(tetrahedron("a"), tetrahedron("b"))))
    assert [mesh["extras"]["targetNames"] for mesh in document["meshes"]] == [list(NAMES)] * 2
    assert all(mesh["weights"] == [0.0] * 3 for mesh in document["meshes"])
    shape = tetrahedron()
    for name in ("Basis", ""):
        with pytest.raises(ValueError, match="which Blender keeps for itself"):
            scene(replace(shape, targets={name: shape.targets["one"]}))
    others = [tetrahedron("a"), replace(tetrahedron("b"), targets={})]
    with pytest.raises(ValueError, match="'b' has other targets than 'a'"):
        ExportScene("head", others)


def test_meshes_may_have_targets_of_their_own_where_who_moves_them_knows() -> None:
    shape = tetrahedron("a")
    alone = replace(shape, name="b", targets={"one": shape.targets["one"]})
    document, _ = taken_apart(glb_bytes(ExportScene("head", [shape, alone], apart=True)))
    assert [mesh["extras"]["targetNames"] for mesh in document["meshes"]] == [list(NAMES), ["one"]]
    with pytest.raises(ValueError, match="which Blender keeps for itself"):
        ExportScene("head", [shape, replace(alone, targets={"Basis": shape.targets["one"]})], apart=True)


def test_one_material_is_written_once() -> None:
    material = Material("seen", picture=png_bytes(np.full((2, 2, 3), 9, np.uint8)), cut=0.5, both=True)
    shapes = [replace(tetrahedron(name), material=material) for name in "ab"]
    document, binary = taken_apart(glb_bytes(scene(*shapes)))
    assert [len(document[kind]) for kind in ("materials", "textures", "images")] == [1, 1, 1]
    view = document["bufferViews"][document["images"][0]["bufferView"]]
    assert binary[view["byteOffset"] :][: view["byteLength"]] == material.picture


def test_the_validator_and_three_agree(tmp_path: Path) -> None:
    wet = Material("wet", picture=png_bytes(np.full((4, 4, 4), 200, np.uint8)), cut=0.0, roughness=0.2)
    shaded = replace(tetrahedron("b", size=3), rows=None, shade=np.linspace(0, 1, 12, dtype=np.float32), material=wet)
    files = {"plain": scene(), "two": scene(tetrahedron("a", place=(0.0, 1.0, 0.0)), shaded)}
    files["bare"] = scene(replace(tetrahedron(), targets={}))
    for name, each in files.items():
        (tmp_path / f"{name}.glb").write_bytes(glb_bytes(each))
    plain, two, bare = inspect(tmp_path / f"{name}.glb" for name in files)
    for found in (plain, two, bare):
        assert [said for said in found["validator"]["said"] if said["code"] != "UNUSED_OBJECT"] == []
        assert found["three"]["root"] == ["head"]
    assert two["three"]["meshes"]["a"]["targets"] == {name: place for place, name in enumerate(NAMES)}
    assert two["three"]["meshes"]["a"]["place"] == [0.0, 1.0, 0.0]
    assert bare["three"]["meshes"]["tetra"]["targets"] == {}


def test_arrays_that_do_not_belong_together_are_refused() -> None:
    shape = tetrahedron()
    with pytest.raises(ValueError, match=r"uv of 'tetra' have shape \(3, 2\); expected \(4, 2\)"):
        replace(shape, uv=shape.uv[:3])
    short = MorphTarget(shape.points[:3], shape.points[:3])
    with pytest.raises(ValueError, match="target 'x' of 'tetra' has 3 rows; expected 4"):
        replace(shape, targets={"x": short})
