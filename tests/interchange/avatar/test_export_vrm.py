"""Faces as VRM 1.0: what the specification asks for is there, what it forbids is not, vertices are where ours are."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.avatar.export_vrm import TURNED, vrm_bytes
from omote.interchange.avatar.fold_overlays import PARTS, PREFIX
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.avatar.humanoid_skeleton import build_skeleton
from omote.interchange.avatar.preset_expressions import PRESETS
from omote.interchange.avatar.vrm_licence import TERMS, Credit, parse_terms
from omote.interchange.export_face import REST, ExportContext, named_compound_meshes
from omote.interchange.formats.glb_reader import read_glb
from omote.model.space.face_fit import fit
from tests import synthetic
from tests.interchange.figures.figures import SUITED
from tests.interchange.figures.skinned_files import SkinnedFile
from tests.interchange.formats.scenes import taken_apart
from tests.stage_data.heads import context, synthetic_cast
from tools.gltf import inspect

ANN = Credit(("Ann",))
KINDS = {"none", "block", "blend"}


def check_vrm(document: dict[str, Any]) -> None:
    """What VRMC_vrm 1.0 requires of any file (specification/VRMC_vrm-1.0, README and its pages)."""
    vrm = document["extensions"]["VRMC_vrm"]
    nodes = document["nodes"]
    assert "VRMC_vrm" in document["extensionsUsed"]
    assert vrm["specVersion"] == "1.0"
    assert not document.keys() & {"animations", "cameras"}
    assert isinstance(vrm["meta"]["name"], str)
    assert vrm["meta"]["authors"]
    assert all(vrm["meta"]["authors"])
    assert vrm["meta"]["licenseUrl"] == "https://vrm.dev/licenses/1.0/"
    assert all(vrm["meta"][name] in values for name, values in TERMS.items())
    bones = [bone["node"] for bone in vrm["humanoid"]["humanBones"].values()]
    assert len(set(bones)) == len(bones)
    assert not any("scale" in nodes[node] or "rotation" in nodes[node] for node in bones)
    for mesh in document["meshes"]:
        (primitive,) = mesh["primitives"]
        for named in (primitive["attributes"], *primitive.get("targets", [])):
            assert "TANGENT" not in named
        assert len(mesh.get("extras", {}).get("targetNames", [])) == len(primitive.get("targets", []))
    expressions = vrm["expressions"]
    assert not expressions["preset"].keys() & expressions["custom"].keys()
    for each in [*expressions["preset"].values(), *expressions["custom"].values()]:
        assert {each["overrideBlink"], each["overrideLookAt"], each["overrideMouth"]} <= KINDS
        for bind in each.get("morphTargetBinds", []):
            targets = document["meshes"][nodes[bind["node"]]["mesh"]]["extras"]["targetNames"]
            assert 0 <= bind["index"] < len(targets)
            assert 0.0 <= bind["weight"] <= 1.0
        for bind in each.get("materialColorBinds", []):
            material = document["materials"][bind["material"]]
            assert (material["pbrMetallicRoughness"]["baseColorFactor"][3], material["alphaMode"]) == (0.0, "BLEND")
            assert (bind["type"], len(bind["targetValue"])) == ("color", 4)
    annotated = {each["node"] for each in vrm["firstPerson"]["meshAnnotations"]}
    assert annotated == {at for at, node in enumerate(nodes) if "mesh" in node}


@pytest.mark.parametrize("face", synthetic.FACES)
def test_what_is_read_is_where_the_compounds_are_on_a_body(face: str) -> None:
    cast = synthetic_cast()
    fitted = fit(cast.space, cast.faces[face])
    data = vrm_bytes(context(), face, [], ANN)
    check_vrm(taken_apart(data)[0])
    shift = build_skeleton(cast.space, fitted).shift
    *pieces, collar = read_glb(data)
    assert [piece.name for piece in pieces] == ["skin", *cast.space.parts]
    assert (collar.name, collar.moves) == ("collar", {})
    for name in ("neutral", "smile", "jawOpen", *synthetic.LOOKS):
        worn = named_compound_meshes(cast, face, name)
        for piece in pieces:
            moved = piece.moves.get(name, 0.0)
            np.testing.assert_allclose(piece.points + moved - shift, worn[piece.name][piece.rows], atol=2 * REST)
    assert "smile" not in next(piece for piece in pieces if piece.name == "eye_left").moves  # no target moves nothing


def test_presets_and_customs_are_there_and_what_is_chosen_beside_them() -> None:
    cast = synthetic_cast()
    units = [name[0].upper() + name[1:] for name in synthetic.EXPRESSIONS if name not in ("neutral", "smile")]
    poses = [("smile", named_compound_meshes(cast, "long", "smile"))]
    for chosen, more in (([], []), (poses, ["smile"])):
        vrm = taken_apart(vrm_bytes(context(), "long", chosen, ANN))[0]["extensions"]["VRMC_vrm"]
        assert list(vrm["expressions"]["preset"]) == list(PRESETS)
        assert list(vrm["expressions"]["custom"]) == units + more


def test_terms_are_as_they_were_agreed_and_an_own_face_is_asked_about() -> None:
    meta = taken_apart(vrm_bytes(context(), "long", [], ANN))[0]["extensions"]["VRMC_vrm"]["meta"]
    assert meta["avatarPermission"] == "everyone"
    strict = Credit(("Ann", "Ben"), parse_terms(["strict"]))
    meta = taken_apart(vrm_bytes(context(), "long", [], strict, own=True))[0]["extensions"]["VRMC_vrm"]["meta"]
    assert (meta["authors"], meta["avatarPermission"]) == (["Ann", "Ben"], "onlyAuthor")
    called = replace(strict, labels={"long": "Long John"})
    assert (
        taken_apart(vrm_bytes(context(), "long", [], called))[0]["extensions"]["VRMC_vrm"]["meta"]["name"]
        == "Long John"
    )
    assert meta["name"] == "long"
    with pytest.raises(ValueError, match="'long' is an own face"):
        vrm_bytes(context(), "long", [], ANN, own=True)
    with pytest.raises(ValueError, match="there is no face 'nobody' in this cast"):
        vrm_bytes(context(), "nobody", [], ANN)


@pytest.mark.parametrize("face", ["kaori", "dog"])
def test_khronos_and_three_take_the_built_in_faces(face: str, tmp_path: Path) -> None:
    cast = load_cast()
    path = tmp_path / "face.vrm"
    path.write_bytes(vrm_bytes(ExportContext(cast, load_meshes(), load_mask()), face, [], ANN))
    document, _ = taken_apart(path.read_bytes())
    check_vrm(document)
    vrm = document["extensions"]["VRMC_vrm"]
    assert len(vrm["expressions"]["custom"]) == 52
    assert [name for name, each in vrm["expressions"]["preset"].items() if "morphTargetBinds" not in each] == [
        "neutral"
    ]
    (found,) = inspect([path])
    assert (found["validator"]["errors"], found["validator"]["warnings"]) == (0, 0)
    assert {said["code"] for said in found["validator"]["said"]} <= {"UNSUPPORTED_EXTENSION", "NODE_EMPTY"}
    hair = {"hair"} if cast.looks[face].hair_style else set()
    folds = {f"{PREFIX}{part}" for part in PARTS}
    assert found["three"]["meshes"].keys() == {"skin", "collar", *cast.space.parts} | hair | folds
    emotions = [each.get("materialColorBinds") for each in vrm["expressions"]["preset"].values()]
    assert any(emotions)


WORN = ("neutral", "joy", "jawOpen", "eyeBlinkLeft", "eyeLookUpLeft", "eyeLookDownLeft", "eyeLookOutLeft")


def test_a_figure_is_a_true_humanoid_on_its_soles_in_both_versions(tmp_path: Path) -> None:
    whole = load_cast()
    cast = replace(whole, expressions={name: whole.expressions[name] for name in WORN}, titles={})
    few = ExportContext(cast, load_meshes(), load_mask())
    data = vrm_bytes(few, "dog", [], ANN, body="heavy", hair=False)
    path = tmp_path / "figure.vrm"
    path.write_bytes(data)
    (found,) = inspect([path])
    assert (found["validator"]["errors"], found["validator"]["warnings"]) == (0, 0)
    file = SkinnedFile.of(data)
    check_vrm(file.document)
    vrm = file.document["extensions"]["VRMC_vrm"]
    bones = {name: bone["node"] for name, bone in vrm["humanoid"]["humanBones"].items()}
    assert {name: file.nodes[node]["name"] for name, node in bones.items()} == humanoid_bones()
    places = file.worlds()[:, :3, 3]
    for side, out in (("left", 1.0), ("right", -1.0)):
        for first, second in (("UpperArm", "LowerArm"), ("LowerArm", "Hand"), ("IndexProximal", "IndexDistal")):
            way = places[bones[f"{side}{second}"]] - places[bones[f"{side}{first}"]]
            np.testing.assert_allclose(way / np.linalg.norm(way), [out, 0.0, 0.0], atol=0.03)
    assert file.points("shoes")[:, 1].min() == pytest.approx(0.0, abs=2e-5)
    seen = {file.nodes[each["node"]]["name"]: each["type"] for each in vrm["firstPerson"]["meshAnnotations"]}
    assert {name for name, kind in seen.items() if kind == "both"} == set(SUITED)
    springs = file.document["extensions"]["VRMC_springBone"]["springs"]
    assert [file.nodes[spring["joints"][0]["node"]]["name"] for spring in springs] == ["leftEar", "rightEar"]
    old = SkinnedFile.of(vrm_bytes(few, "dog", [], Credit(("Ann",), version="0.x"), body="heavy", hair=False))
    for mesh in ("skin", "eye_left", *SUITED):
        np.testing.assert_allclose(old.points(mesh), file.points(mesh) * TURNED, atol=1e-6)
    named = {bone["bone"]: bone["node"] for bone in old.document["extensions"]["VRM"]["humanoid"]["humanBones"]}
    assert named["leftThumbProximal"] == bones["leftThumbMetacarpal"]
    assert named["leftThumbIntermediate"] == bones["leftThumbProximal"]
