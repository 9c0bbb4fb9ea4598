"""VRM 0.x says what 1.0 says, and never allows more."""

from dataclasses import replace
from typing import Any

import pytest

from omote.interchange.avatar.export_vrm import vrm_bytes
from omote.interchange.avatar.vrm0_extension import PRESETS, describe_vrm0
from omote.interchange.avatar.vrm_licence import TERMS, Credit, parse_terms
from tests.interchange.formats.scenes import taken_apart
from tests.stage_data.heads import context


def both(words: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """A face's JSON as 1.0 and as 0.x."""
    credit = Credit(("Ann", "Ben"), parse_terms([words]))
    new, _ = taken_apart(vrm_bytes(context(), "long", [], credit))
    old, _ = taken_apart(vrm_bytes(context(), "long", [], replace(credit, version="0.x")))
    return new, old


def test_the_same_meshes_move_by_the_same_targets() -> None:
    new, old = both("strict")
    assert old["extensionsUsed"] == ["VRM"]
    assert old["meshes"] == new["meshes"]
    groups = {group["name"]: group for group in old["extensions"]["VRM"]["blendShapeMaster"]["blendShapeGroups"]}
    expressions = new["extensions"]["VRMC_vrm"]["expressions"]
    assert len(groups) == len(expressions["preset"]) + len(expressions["custom"])
    called = {"relaxed": "Fun", "lookLeft": "LookLeft", "surprised": "Surprised", "aa": "A", "blinkLeft": "Blink_L"}
    for name, known in called.items():
        group = groups[known]
        each = expressions["preset"][name]
        assert group["presetName"] == PRESETS.get(name, "unknown")
        binds = [(1 + bind["mesh"], bind["index"], bind["weight"] / 100) for bind in group["binds"]]
        assert binds == [
            tuple(bind[key] for key in ("node", "index", "weight")) for bind in each.get("morphTargetBinds", [])
        ]
    for name in expressions["custom"]:
        assert groups[name]["presetName"] == "unknown"


def test_colours_are_bound_to_materials_by_their_names() -> None:
    vrm = both("strict")[0]["extensions"]["VRMC_vrm"]
    binds = [{"material": 1, "type": "color", "targetValue": [1.0, 1.0, 1.0, 0.5]}]
    vrm["expressions"]["preset"]["happy"]["materialColorBinds"] = binds
    groups = describe_vrm0(vrm, ["skin", "folds_frown"], "Omote")["blendShapeMaster"]["blendShapeGroups"]
    (bound,) = (group for group in groups if group["materialValues"])
    assert (bound["presetName"], bound["materialValues"]) == (
        "joy",
        [{"materialName": "folds_frown", "propertyName": "_Color", "targetValue": [1.0, 1.0, 1.0, 0.5]}],
    )


def test_bones_and_gaze_are_the_same_and_every_material_is_named() -> None:
    new, old = both("strict")
    one = new["extensions"]["VRMC_vrm"]
    other = old["extensions"]["VRM"]
    bones = {bone["bone"]: bone["node"] for bone in other["humanoid"]["humanBones"]}
    assert bones == {name: bone["node"] for name, bone in one["humanoid"]["humanBones"].items()}
    assert bones.keys() >= {"chest", "neck"}  # which 0.x wants
    assert other["firstPerson"]["firstPersonBone"] == bones["head"]
    assert list(other["firstPerson"]["firstPersonBoneOffset"].values()) == one["lookAt"]["offsetFromHeadBone"]
    assert other["firstPerson"]["lookAtVerticalUp"]["xRange"] == one["lookAt"]["rangeMapVerticalUp"]["inputMaxValue"]
    assert [each["name"] for each in other["materialProperties"]] == [each["name"] for each in old["materials"]]
    assert {each["mesh"] for each in other["firstPerson"]["meshAnnotations"]} == set(range(len(old["meshes"])))


def test_the_model_is_turned_to_look_along_minus_z() -> None:
    new, old = both("strict")
    for one, other in zip(new["nodes"], old["nodes"], strict=True):
        x, y, z = one.get("translation", (0.0, 0.0, 0.0))
        assert other.get("translation", [0.0, 0.0, 0.0]) == [-x, y, -z]
    for one, other in zip(new["accessors"], old["accessors"], strict=True):
        if one["type"] == "VEC3" and "min" in one:
            assert other["min"] == [-one["max"][0], one["min"][1], -one["max"][2]]


USES = [
    ("allowExcessivelyViolentUsage", "violentUssageName"),
    ("allowExcessivelySexualUsage", "sexualUssageName"),
    ("commercialUsage", "commercialUssageName"),
]


@pytest.mark.parametrize(("term", "name"), USES)
def test_uses_are_as_they_were_agreed(term: str, name: str) -> None:
    meta = both(f"{term}={'corporation' if term == 'commercialUsage' else 'yes'}")[1]["extensions"]["VRM"]["meta"]
    assert meta[name] == "Allow"
    assert [value for key, value in meta.items() if key.endswith("UssageName") and key != name] == ["Disallow"] * 2
    assert (meta["title"], meta["author"]) == ("long", "Ann, Ben")


def test_what_0_x_cannot_say_is_prohibited() -> None:
    free = both("cc0")[1]["extensions"]["VRM"]["meta"]
    assert (free["licenseName"], free["allowedUserName"], free["commercialUssageName"]) == ("CC0", "Everyone", "Allow")
    nearly = ",".join(f"{key}={values[-1]}" for key, values in TERMS.items())
    assert both(nearly)[1]["extensions"]["VRM"]["meta"]["licenseName"] == "Redistribution_Prohibited"
    some = both("commercialUsage=personalProfit")[1]["extensions"]["VRM"]["meta"]
    assert (some["commercialUssageName"], some["allowedUserName"]) == ("Disallow", "OnlyAuthor")


def test_a_face_whose_eyes_do_not_turn_looks_at_nothing() -> None:
    still = both("strict")[0]["extensions"]["VRMC_vrm"]
    del still["lookAt"]
    gaze = describe_vrm0(still, [], "Omote")["firstPerson"]
    assert gaze["lookAtHorizontalOuter"]["yRange"] == 0.0
