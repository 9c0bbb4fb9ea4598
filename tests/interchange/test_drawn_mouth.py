"""The mouth of exported heads: teeth, gums and tongue as stages draw them, and the cast's rows beside them."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.geometry import mesh
from omote.interchange.drawn_mouth import TONGUE, DrawnMouth
from omote.interchange.export_face import ExportContext, Meshes, build_scene, named_compound_meshes
from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.glb_writer import NO_ROW, glb_bytes
from omote.interchange.import_meshes import import_expressions, import_face
from omote.interchange.part_textures import paint_jaw
from omote.model.cast import Look
from omote.model.transfer.gum_line import GUMS
from tests.stage_data.heads import synthetic_cast

CAST = load_cast()
ROWS = len(CAST.space.parts["teeth_upper"].points)
POSES = ("jawOpen", "mouthLeft", "tongueOut")


@cache
def meshes_of(face: str, expression: str) -> Meshes:
    return named_compound_meshes(CAST, face, expression)


@cache
def file_of(face: str) -> bytes:
    context = ExportContext(CAST, load_meshes(), load_mask())
    return glb_bytes(build_scene(context, face, [(name, meshes_of(face, name)) for name in POSES], drawn=True))


@pytest.mark.parametrize("face", ["kaori", "dog"])
def test_the_rows_of_the_cast_come_back_to_the_bit(face: str) -> None:
    pieces = {piece.name: piece for piece in read_glb(file_of(face))}
    for name in (*GUMS, TONGUE):
        piece = pieces[name]
        assert piece.rows is not None
        ours = np.flatnonzero(piece.rows != NO_ROW)
        assert set(piece.rows[ours]) == set(range(len(CAST.space.parts[name].points)))
        aim = meshes_of(face, "neutral")[name][piece.rows[ours]].astype(np.float32)
        np.testing.assert_array_equal(piece.points[ours].astype(np.float32), aim)


def test_a_head_that_comes_back_is_the_one_that_was_written() -> None:
    pieces = read_glb(file_of("kaori"))
    face, _ = import_face(CAST, load_meshes(), "again", pieces)
    for name, points in CAST.faces["kaori"].parts.items():
        np.testing.assert_allclose(face.parts[name], points, atol=1e-6)
    found = {each.label: each for each in import_expressions(CAST, load_meshes(), {"kaori": pieces})}
    assert {name: found[name].expression for name in POSES} == {name: CAST.expressions[name] for name in POSES}


@pytest.mark.parametrize("face", ["kaori", "child"])
def test_the_drawn_tongue_lies_down_in_an_open_jaw_and_comes_out_where_it_is_put_out(face: str) -> None:
    mouth = DrawnMouth(CAST.space, CAST.looks[face])
    rest, opened, out = (meshes_of(face, name) for name in ("neutral", "jawOpen", "tongueOut"))
    rows = len(CAST.space.parts[TONGUE].points)

    def lower(meshes: Meshes) -> float:
        """How much lower the drawn tongue lies than the cast's, metres in the mean."""
        return float((meshes[TONGUE] - mouth.draw(meshes)[TONGUE][:rows])[:, 1].mean())

    assert lower(opened) > lower(rest) + 0.004
    assert lower(out) == pytest.approx(lower(rest), abs=5e-4)


@pytest.mark.parametrize("face", ["kaori", "dog"])
def test_what_is_drawn_has_an_area_and_normals_of_length_1(face: str) -> None:
    drawn = DrawnMouth(CAST.space, CAST.looks[face])
    meshes = drawn.draw(meshes_of(face, "jawOpen"))
    for name, part in drawn.parts.items():
        assert len(meshes[name]) == len(part.rows) == len(part.uv) == len(part.shade)
        assert ((part.uv >= 0.0) & (part.uv <= 1.0)).all()
        a, b, c = meshes[name][part.triangles].transpose(1, 0, 2)
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        kept = (part.rows[part.triangles] != NO_ROW).all(axis=1)
        assert (area[kept] == 0.0).all()
        assert (area[~kept] > 0.0).mean() > 0.99
        np.testing.assert_allclose(np.linalg.norm(mesh.normals(meshes[name], part.triangles), axis=1), 1.0)


def test_fangs_are_a_carnivores_alone() -> None:
    drawn = {}
    for fur in (0.0, 1.0):
        mouth = DrawnMouth(CAST.space, Look(fur=fur))
        drawn[fur] = mouth.draw(meshes_of("generic", "neutral"))["teeth_upper"][: -3 * ROWS]
    assert drawn[1.0][:, 1].min() < drawn[0.0][:, 1].min() - 0.001


def test_a_head_without_such_teeth_keeps_what_it_has() -> None:
    assert DrawnMouth(synthetic_cast().space, Look()).parts == {}
    assert DrawnMouth(CAST.space, None).parts == {}


def test_a_jaw_is_enamel_above_its_gum_line_and_red_below() -> None:
    picture = paint_jaw(Look(), 256).astype(int)
    assert picture.shape == (64, 256, 3)
    crown, gum = picture[16, 9], picture[48, 9]
    assert crown[0] - crown[1] < 40
    assert gum[0] - gum[1] > 60
    np.testing.assert_array_equal(paint_jaw(Look(age=1.0), 256)[48], paint_jaw(Look(), 256)[48])
