"""USD files: the official library opens them anew, finds no fault, and moves points where our compounds are."""

import builtins
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from pxr import Gf, Usd, UsdGeom, UsdSkel, UsdValidation, Vt

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.export_face import (
    REST,
    ExportContext,
    Meshes,
    build_scene,
    choose_expressions,
    close_over_teeth,
    named_compound_meshes,
)
from omote.interchange.exports.usd_writer import ORIGINAL, usd_files
from omote.interchange.formats.file_names import USD
from omote.interchange.formats.glb_writer import ExportScene
from omote.model.cast import Cast
from omote.model.space.face_fit import fit
from tests import synthetic
from tests.stage_data.heads import context, synthetic_cast

BAR = 5e-5
"""Metres that a point may lie off our compound."""


def poses(cast: Cast, face: str, kind: str) -> dict[str, Meshes]:
    """What a face wears, by the names of expressions."""
    return {name: named_compound_meshes(cast, face, name) for name in choose_expressions(cast, kind)}


def written(folder: Path, scene: ExportScene, suffix: str) -> Path:
    """The path of a scene that was written into a folder."""
    files = usd_files(scene, "face", suffix)
    for name, data in files.items():
        (folder / name).write_bytes(data)
    return folder / next(iter(files))


def faults(path: Path) -> list[str]:
    """What the validators of the official library say of a file."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    stage = Usd.Stage.Open(str(path))
    return [error.GetMessage() for error in UsdValidation.ValidationContext(validators).Validate(stage)]


def baked(stage: Any, top: str, names: list[str]) -> dict[str, dict[str, NDArray[np.float64]]]:
    """The points of each mesh with each expression at weight 1, as UsdSkel bakes them; "" at rest."""
    animation = UsdSkel.Animation(stage.GetPrimAtPath(f"/{top}/animation"))
    order = list(animation.GetBlendShapesAttr().Get())
    weights = animation.GetBlendShapeWeightsAttr()
    for time, name in enumerate(["", *names]):
        weights.Set(Vt.FloatArray([float(each == name) for each in order]), time)
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath(f"/{top}")), Gf.Interval(0, len(names)))
    meshes = [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    return {
        name: {mesh.GetPrim().GetName(): placed(mesh, time) for mesh in meshes}
        for time, name in enumerate(["", *names])
    }


def placed(mesh: Any, time: int) -> NDArray[np.float64]:
    """Where a mesh's points are in the world at a time: what one joint moves is moved as a whole."""
    matrix = np.array(UsdGeom.Xformable(mesh).ComputeLocalToWorldTransform(time))
    return np.asarray(np.array(mesh.GetPointsAttr().Get(time)) @ matrix[:3, :3] + matrix[3, :3])


@pytest.mark.parametrize("suffix", USD)
@pytest.mark.parametrize("face", synthetic.FACES)
def test_points_move_to_our_compounds(face: str, suffix: str, tmp_path: Path) -> None:
    worn = poses(synthetic_cast(), face, "all")
    path = written(tmp_path, build_scene(context(), face, worn.items()), suffix)
    assert faults(path) == []
    found = baked(Usd.Stage.Open(str(path)), face, [*worn])
    rows = {mesh.name: mesh.source for mesh in context().meshes}
    for name, meshes in worn.items():
        for mesh, points in meshes.items():
            np.testing.assert_allclose(found[name][mesh], points[rows[mesh]], atol=2 * REST)


@pytest.mark.parametrize("face", ["kaori", "dog"])
def test_the_built_in_faces_play_in_the_official_library(face: str, tmp_path: Path) -> None:
    cast = load_cast()
    meshes = load_meshes()
    scene = build_scene(ExportContext(cast, meshes, load_mask()), face, poses(cast, face, "arkit").items())
    worn = close_over_teeth(cast.space, fit(cast.space, cast.faces[face]), poses(cast, face, "arkit"))
    path = written(tmp_path, scene, ".usdz")
    assert faults(path) == []
    stage = Usd.Stage.Open(str(path))
    found = baked(stage, face, [*worn])
    off = [
        np.abs(found[name][mesh.name] - points[mesh.name][mesh.source]).max()
        for name, points in worn.items()
        for mesh in meshes
    ]
    assert max(off) <= BAR
    for shape in scene.shapes:  # hair has no compound of ours but its own targets
        for name in worn:
            aim = shape.points + np.asarray(shape.place) + shape.targets[name].moves
            np.testing.assert_allclose(found[name][shape.name], aim, atol=2 * REST)


def test_what_a_stage_says_of_itself(tmp_path: Path) -> None:
    scene = build_scene(context(), "broad", poses(synthetic_cast(), "broad", "all").items())
    stage = Usd.Stage.Open(str(written(tmp_path, scene, ".usdc")))
    assert stage.GetDefaultPrim().IsA(UsdSkel.Root)
    assert (UsdGeom.GetStageUpAxis(stage), UsdGeom.GetStageMetersPerUnit(stage)) == ("Y", 1.0)
    said = stage.GetRootLayer().customLayerData
    assert {key: said[key] for key in scene.extras} == {key: str(value) for key, value in scene.extras.items()}
    shapes = [prim for prim in stage.Traverse() if prim.IsA(UsdSkel.BlendShape)]
    assert {prim.GetCustomDataByKey(ORIGINAL) for prim in shapes} == set(scene.shapes[0].targets)


def test_shapes_hold_what_moves_alone_and_turn_normals(tmp_path: Path) -> None:
    scene = build_scene(context(), "broad", poses(synthetic_cast(), "broad", "all").items())
    stage = Usd.Stage.Open(str(written(tmp_path, scene, ".usdc")))
    for shape in scene.shapes:
        named = UsdSkel.BindingAPI(stage.GetPrimAtPath(f"/broad/{shape.name}")).GetBlendShapesAttr().Get() or []
        assert list(named) == [n for n, target in shape.targets.items() if target.moves.any() or target.turns.any()]
        for name in named:
            made = UsdSkel.BlendShape(stage.GetPrimAtPath(f"/broad/{shape.name}/{name}"))
            rows = np.array(made.GetPointIndicesAttr().Get())
            target = shape.targets[name]
            for values, kept in ((target.moves, made.GetOffsetsAttr()), (target.turns, made.GetNormalOffsetsAttr())):
                whole = np.zeros_like(values)
                whole[rows] = np.array(kept.Get())
                np.testing.assert_array_equal(whole, values)
            assert (target.moves[rows].any(axis=1) | target.turns[rows].any(axis=1)).all()


def test_an_eyeball_turns_by_its_own_joint(tmp_path: Path) -> None:
    scene = build_scene(context(), "generic", [])
    stage = Usd.Stage.Open(str(written(tmp_path, scene, ".usdc")))
    animation = UsdSkel.Animation(stage.GetPrimAtPath("/generic/animation"))
    turn = Gf.Rotation(Gf.Vec3d(0, 1, 0), 30.0)
    half = Gf.Quatf(turn.GetQuat())
    animation.GetRotationsAttr().Set(
        Vt.QuatfArray(
            [half if joint == "head/eye_left" else Gf.Quatf(1.0) for joint in animation.GetJointsAttr().Get()]
        )
    )
    found = baked(stage, "generic", [])[""]
    matrix = np.array(Gf.Matrix3d(turn))  # rows are multiplied from the left
    for shape in scene.shapes:
        turned = shape.points @ matrix if shape.name == "eye_left" else shape.points
        np.testing.assert_allclose(found[shape.name], turned + np.asarray(shape.place), atol=1e-6)


def test_pictures_lie_beside_the_stage_or_in_its_package(tmp_path: Path) -> None:
    scene = build_scene(context(), "broad", [])
    beside = usd_files(scene, "aunt", ".usda")
    materials = [shape.material for shape in scene.shapes]
    pictures = {material.name: material.picture for material in materials}
    pictures |= {f"{material.name}_relief": material.relief for material in materials if material.relief is not None}
    assert beside == {"aunt.usda": beside["aunt.usda"]} | {f"aunt.{n}.png": data for n, data in pictures.items()}
    assert all(f"@./{name}@".encode() in beside["aunt.usda"] for name in [*beside][1:])
    assert [*usd_files(scene, "aunt", ".usdz")] == ["aunt.usdz"]


def test_texture_coordinates_stand_upright(tmp_path: Path) -> None:
    """A row of a picture is counted from above in glTF, from below in USD."""
    scene = build_scene(context(), "broad", [])
    stage = Usd.Stage.Open(str(written(tmp_path, scene, ".usdc")))
    for shape in scene.shapes:
        places = np.array(UsdGeom.PrimvarsAPI(stage.GetPrimAtPath(f"/broad/{shape.name}")).GetPrimvar("st").Get())
        np.testing.assert_allclose(places, shape.uv * [1, -1] + [0, 1], atol=1e-6)


def test_a_missing_library_is_told_with_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any, **more: Any) -> Any:
        if name.startswith("pxr"):
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ValueError, match=r'pip install "omote\[usd\]"'):
        usd_files(ExportScene("broad", []), "broad", ".usdc")


@pytest.mark.parametrize("suffix", USD)
def test_the_same_scene_is_the_same_bytes_at_any_time(suffix: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Otherwise a run that goes on could not tell its own files."""
    scene = build_scene(context(), "broad", [])
    first = usd_files(scene, "broad", suffix)
    real = Path.write_bytes

    def write_long_ago(path: Path, data: bytes) -> int:
        size = real(path, data)
        os.utime(path, (10**9, 10**9))
        return size

    monkeypatch.setattr(Path, "write_bytes", write_long_ago)
    assert usd_files(scene, "broad", suffix) == first
