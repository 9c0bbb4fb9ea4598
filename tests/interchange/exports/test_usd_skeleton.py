"""Figures as USD: the official library finds no fault, and skins them where a stage has them, in every pose."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, UsdValidation

import omote
from omote.builtin import load_mask, load_meshes
from omote.interchange.export_face import ExportContext
from omote.interchange.exports.export_formats import bake_face
from omote.interchange.figures.figure_rig import ExportedFigure as Figure
from omote.interchange.figures.figure_rig import export_figure
from omote.model.body.figure_space import BONES_OF_A_ROW
from tests.interchange.figures.figures import SUITED, posed_figure, stage_points

CAST = omote.load_cast()
NEAR = 2e-5
"""Metres that float32 may be off."""


@pytest.fixture(scope="module")
def figure() -> Figure:
    """The figure before it is written."""
    return export_figure(CAST, "kaori", "heavy", influences=BONES_OF_A_ROW)


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of the figure, with one expression."""
    folder = tmp_path_factory.mktemp("usd")
    context = ExportContext(CAST, load_meshes(), load_mask())
    files = bake_face(context, "kaori", ["jawOpen"], ".usdc", "figure", body="heavy", hair=False)
    for name, data in files.items():
        (folder / name).write_bytes(data)
    return folder / "figure.usdc"


def skinned(path: Path, pose: str | None) -> dict[str, np.ndarray]:
    """Where UsdSkel itself brings the points of each mesh, at rest or in a pose (n, 3)."""
    stage = Usd.Stage.Open(Sdf.Layer.OpenAsAnonymous(str(path)))  # baking changes it
    if pose is not None:
        binding = UsdSkel.BindingAPI(stage.GetPrimAtPath("/kaori/skeleton"))
        binding.GetAnimationSourceRel().SetTargets([f"/kaori/poses/{pose}"])
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath("/kaori")), Gf.Interval(0, 0))
    meshes = [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    return {mesh.GetPrim().GetName(): np.array(mesh.GetPointsAttr().Get(0)) for mesh in meshes}


def test_nothing_is_wrong_with_it_and_its_bones_are_ours(path: Path, figure: Figure) -> None:
    stage = Usd.Stage.Open(str(path))
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert UsdValidation.ValidationContext(validators).Validate(stage) == []
    skeleton = figure.space.skeleton
    names = [name.replace(".", "_").replace("-", "_") for name in skeleton.names]
    joints = [str(joint) for joint in UsdSkel.Skeleton(stage.GetPrimAtPath("/kaori/skeleton")).GetJointsAttr().Get()]
    assert [joint.split("/")[-1] for joint in joints] == [*names, "eye_left", "eye_right"]
    for joint, parent in zip(joints[1 : len(names)], skeleton.parents[1:], strict=True):
        assert joint.split("/")[-2] == names[parent]
    poses = [prim.GetCustomDataByKey("omote:name") for prim in stage.GetPrimAtPath("/kaori/poses").GetChildren()]
    assert poses == [*CAST.poses]


@pytest.mark.parametrize("pose", [None, "cheer", "sit"])
def test_points_are_where_a_stage_has_them_at_rest_and_near_in_poses(
    pose: str | None, path: Path, figure: Figure
) -> None:
    points = skinned(path, pose)
    bones = figure.rest if pose is None else posed_figure(figure, pose)
    away = [np.linalg.norm(points[mesh] - stage_points(figure, mesh, bones), axis=1) for mesh in SUITED]
    far = np.concatenate(away)
    if pose is None:
        assert far.max() < NEAR
    assert far.mean() < 0.001
    assert np.percentile(far, 99) < 0.01
