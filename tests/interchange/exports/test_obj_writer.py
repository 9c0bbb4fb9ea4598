"""OBJ files: what is read is where our compounds are, within what text keeps; shapes come back as expressions."""

import re
from pathlib import Path

import numpy as np
import pytest
import trimesh

from omote.interchange.export_face import build_scene, named_compound_meshes
from omote.interchange.exports.obj_writer import obj_files, obj_folder
from omote.interchange.formats.glb_writer import ExportScene
from omote.interchange.import_meshes import import_expressions
from omote.interchange.scans.wavefront_reader import read_obj_pieces
from tests import synthetic
from tests.stage_data.heads import context, meshes, synthetic_cast

ROUNDING = 1e-7
"""Metres of a head's coordinate that eight digits and float32 leave open."""


def scene(face: str, *expressions: str) -> ExportScene:
    """A face of the synthetic cast with expressions."""
    cast = synthetic_cast()
    return build_scene(context(), face, [(name, named_compound_meshes(cast, face, name)) for name in expressions])


@pytest.mark.parametrize("face", synthetic.FACES)
def test_vertices_are_the_compounds_in_the_order_of_the_cast(face: str) -> None:
    pieces = read_obj_pieces(obj_files(scene(face, "smile"), "face")["face.obj"])
    worn = named_compound_meshes(synthetic_cast(), face, "smile")
    assert [piece.name for piece in pieces] == ["skin", *synthetic_cast().space.parts]
    for piece in pieces:
        np.testing.assert_allclose(piece.points, worn[piece.name], atol=1e-6 + ROUNDING)


def test_without_an_expression_it_is_the_face_at_rest() -> None:
    first, *_ = read_obj_pieces(obj_files(scene("broad"), "face")["face.obj"])
    np.testing.assert_allclose(first.points, synthetic_cast().faces["broad"].positions, atol=ROUNDING)


def test_several_expressions_are_refused_with_what_to_do() -> None:
    with pytest.raises(ValueError, match=r"an OBJ holds one shape, and 2 expressions are named; .*--format obj"):
        obj_files(scene("broad", "smile", "jawOpen"), "face")


def test_faces_lead_to_the_vertices_texture_places_and_normals_of_the_scene() -> None:
    given = scene("broad", "smile")
    text = obj_files(given, "face")["face.obj"].decode()
    found = {
        word: np.array([line.split()[1:] for line in text.splitlines() if line.startswith(f"{word} ")], float)
        for word in ("v", "vt", "vn")
    }
    corners = np.array([re.findall(r"(\d+)/(\d+)/(\d+)", line) for line in text.splitlines() if line[:2] == "f "], int)
    start = 0
    for shape in given.shapes:
        own = corners[start : start + len(shape.triangles)] - 1
        start += len(shape.triangles)
        target = shape.targets["smile"]
        points = shape.points + np.asarray(shape.place) + target.moves
        np.testing.assert_allclose(found["v"][own[..., 0]], points[shape.triangles], atol=1e-6)
        np.testing.assert_allclose(found["vt"][own[..., 1]], (shape.uv * [1, -1] + [0, 1])[shape.triangles], atol=1e-6)
        normals = shape.normals + target.turns
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        np.testing.assert_allclose(found["vn"][own[..., 2]], normals[shape.triangles], atol=1e-5)
    assert start == len(corners)


def test_another_library_reads_the_same_mesh_with_its_pictures(tmp_path: Path) -> None:
    given = scene("broad")
    for name, data in obj_files(given, "face").items():
        (tmp_path / name).write_bytes(data)
    loaded = trimesh.load_scene(tmp_path / "face.obj")
    found = {each.visual.material.name: each for each in loaded.geometry.values()}
    assert found.keys() == {shape.material.name for shape in given.shapes}
    assert sum(len(each.faces) for each in found.values()) == sum(len(shape.triangles) for shape in given.shapes)
    assert all(each.visual.material.image is not None for each in found.values())


def test_a_folder_has_a_shape_for_each_expression_and_its_surfaces_once() -> None:
    files = obj_folder(scene("broad", "smile", "jawOpen"), "aunt")
    shapes = [name for name in files if name.endswith(".obj")]
    assert shapes == ["aunt/neutral.obj", "aunt/smile.obj", "aunt/jawOpen.obj"]
    assert [name for name in files if name.endswith(".mtl")] == ["aunt/broad.mtl"]
    assert all(b"mtllib broad.mtl\n" in files[name] for name in shapes)
    named = re.findall(rb"map_Kd (\S+)", files["aunt/broad.mtl"])
    assert {f"aunt/{name.decode()}" for name in named} == {name for name in files if name.endswith(".png")}


def test_shapes_come_back_as_the_expressions_that_they_were() -> None:
    cast = synthetic_cast()
    names = ("smile", "jawOpen")
    files = obj_folder(scene("broad", *names), "aunt")
    shapes = {each: read_obj_pieces(files[f"aunt/{each}.obj"]) for each in ("neutral", *names)}
    found = {each.label: each for each in import_expressions(cast, meshes(), shapes)}
    assert found.keys() == set(names)
    for name in names:
        assert found[name].face == "broad"
        assert found[name].error < 5e-5
