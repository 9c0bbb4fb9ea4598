"""Figures as GLB and USD: what a program reads by the format alone is where a stage has it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import omote
from omote.builtin import load_figures, load_mask, load_meshes
from omote.interchange.export_face import REST, SKIN, ExportContext, named_compound_meshes
from omote.interchange.exports.export_formats import bake_face
from omote.interchange.figures.figure_rig import ExportedFigure, export_figure
from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.glb_rig import INFLUENCES
from tests.interchange.figures.figures import SUITED, posed_figure, stage_points
from tests.interchange.figures.skinned_files import SkinnedFile
from tools.gltf import inspect

CAST = omote.load_cast()
FIGURES = load_figures()
SKELETON = FIGURES.space.skeleton
CONTEXT = ExportContext(CAST, load_meshes(), load_mask())
NEAR = 2e-5
"""Metres that float32 and weights of 16 bits may be off."""


@cache
def written(face: str, body: str) -> bytes:
    """The file of a figure with one target."""
    ((_, data),) = bake_face(CONTEXT, face, ["jawOpen"], ".glb", "figure", body=body).items()
    return data


@cache
def exported(face: str, body: str) -> ExportedFigure:
    """The same figure before it is written."""
    return export_figure(CAST, face, body, influences=INFLUENCES)


def test_at_rest_every_vertex_is_where_a_stage_has_it_and_soles_are_on_the_floor() -> None:
    for face, body in (("kaori", "heavy"), ("dog", "own")):
        file = SkinnedFile.of(written(face, body))
        figure = exported(face, body)
        for mesh in SUITED:
            np.testing.assert_allclose(file.points(mesh), stage_points(figure, mesh, figure.rest), atol=NEAR)
        assert file.points("shoes")[:, 1].min() == pytest.approx(0.0, abs=NEAR)
        worn = named_compound_meshes(CAST, face, "neutral")
        pieces = {piece.name: piece for piece in read_glb(written(face, body))}  # by joints, as our own reader has it
        open_jaw = named_compound_meshes(CAST, face, "jawOpen")
        for name in (SKIN, "eye_left", "lashes"):
            piece = pieces[name]
            np.testing.assert_allclose(piece.points, worn[name][piece.rows] + figure.shift, atol=NEAR)
            moved = (open_jaw[name] - worn[name])[piece.rows]
            np.testing.assert_allclose(piece.moves.get("jawOpen", np.zeros_like(moved)), moved, atol=2 * REST)


@pytest.mark.parametrize(("face", "body"), [("kaori", "heavy"), ("dog", "own")])
def test_bones_are_ours_in_every_pose_and_the_skin_as_near_as_linear_blending_comes(face: str, body: str) -> None:
    file = SkinnedFile.of(written(face, body))
    figure = exported(face, body)
    skin = file.document["skins"][0]
    assert [file.nodes[place]["name"] for place in skin["joints"]] == list(SKELETON.names)
    for name, parent in zip(SKELETON.names[1:], SKELETON.parents[1:], strict=True):
        assert file.node(name) in file.nodes[file.node(SKELETON.names[parent])]["children"]
    assert [moved["name"] for moved in file.document["animations"]] == [*FIGURES.poses]
    off = []
    for pose in ("stand", "bow", "wave", "arms_crossed", "sit", "cheer"):
        posed = posed_figure(figure, pose)
        joints = file.worlds(pose)[skin["joints"]][:, :3, 3]
        np.testing.assert_allclose(joints, posed.joints + figure.shift, atol=NEAR)
        head = SKELETON.places["head"]
        turned = (file.points("eye_left") - figure.rest.joints[head] - figure.shift) @ posed.turns[head].T
        aim = turned + posed.joints[head] + figure.shift
        np.testing.assert_allclose(file.points("eye_left", pose), aim, atol=NEAR)
        off += [np.linalg.norm(file.points(mesh, pose) - stage_points(figure, mesh, posed), axis=1) for mesh in SUITED]
    far = np.concatenate(off)
    assert far.mean() < 0.001
    assert np.percentile(far, 99) < 0.01
    assert far.max() < 0.05


def test_where_a_stage_blends_linearly_by_few_bones_the_file_does_exactly_that() -> None:
    figure = exported("kaori", "heavy")
    file = SkinnedFile.of(written("kaori", "heavy"))
    space = figure.space
    linear = (space.shares == 0.0) & (space.weights[:, INFLUENCES] == 0.0)
    blend = figure.meshes["garment"].blend
    plain = blend @ linear.astype(np.float64) > 1.0 - 1e-9
    assert plain.sum() > 50
    away = np.linalg.norm(
        file.points("garment", "cheer") - stage_points(figure, "garment", posed_figure(figure, "cheer")), axis=1
    )
    assert np.median(away[plain]) < 3e-4
    assert (
        away[plain].max() < 2.0 * FIGURES.garments["suit"].thick.max()
    )  # cloth lies along normals, which turn with the bones here


def test_khronos_says_nothing_against_it(tmp_path: Path) -> None:
    path = tmp_path / "figure.glb"
    path.write_bytes(written("dog", "own"))
    (found,) = inspect([path])
    assert (found["validator"]["errors"], found["validator"]["warnings"]) == (0, 0)
    assert {said["code"] for said in found["validator"]["said"]} <= {"UNUSED_OBJECT"}  # places for a picture of cloth
    assert set(SUITED) <= found["three"]["meshes"].keys()


def test_what_has_no_skeleton_and_bodies_that_are_not_there_are_refused() -> None:
    for kind in (".obj", ".npz", ".csv"):
        with pytest.raises(ValueError, match=f"{kind} has none"):
            bake_face(CONTEXT, "kaori", [], kind, "figure", body="own")
    with pytest.raises(ValueError, match="no body 'hevy' in this cast"):
        bake_face(CONTEXT, "kaori", [], ".glb", "figure", body="hevy")
    with pytest.raises(ValueError, match="has no bodies"):
        export_figure(replace(CAST, figures=None), "kaori", "own", influences=INFLUENCES)
