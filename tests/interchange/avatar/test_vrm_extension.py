"""The JSON of VRMC_vrm, part by part, against what the specification asks for."""

import math

import pytest

from omote.interchange.avatar.preset_expressions import Overrides
from omote.interchange.avatar.vrm_extension import (
    describe_bones,
    describe_expressions,
    describe_first_person,
    describe_gaze,
    describe_meta,
)
from omote.interchange.avatar.vrm_licence import parse_terms
from tests import synthetic
from tests.interchange.formats.scenes import tetrahedron
from tests.stage_data.heads import synthetic_cast


def test_meta_has_all_that_is_required_and_the_terms() -> None:
    terms = parse_terms(["strict"])
    assert terms is not None
    meta = describe_meta("aunt", ["Ann", "Ben"], terms, "nobody's")
    assert (meta["name"], meta["authors"]) == ("aunt", ["Ann", "Ben"])
    assert meta["licenseUrl"] == "https://vrm.dev/licenses/1.0/"
    assert terms.items() <= meta.items()


def test_an_expression_binds_each_mesh_that_it_moves_by_the_place_of_its_target() -> None:
    both = tetrahedron("a")
    one = tetrahedron("b")
    one = type(one)(**{**vars(one), "targets": {"all": one.targets["all"]}})
    found = describe_expressions(
        [both, one], {"aa": {"one": 0.25, "all": 0.5}, "neutral": {}}, {"All": "all"}, {"aa": Overrides(mouth=True)},
        lambda weights: {3: weights["all"]} if "all" in weights else {},
    )  # fmt: skip
    assert found["preset"]["aa"]["morphTargetBinds"] == [
        {"node": 1, "index": 1, "weight": 0.25},
        {"node": 1, "index": 2, "weight": 0.5},
        {"node": 2, "index": 0, "weight": 0.5},
    ]
    assert found["custom"]["All"]["morphTargetBinds"] == [
        {"node": 1, "index": 2, "weight": 1.0},
        {"node": 2, "index": 0, "weight": 1.0},
    ]
    for kind, name, shown in (("preset", "aa", 0.5), ("custom", "All", 1.0)):
        bind = {"material": 3, "type": "color", "targetValue": [1.0, 1.0, 1.0, shown]}
        assert found[kind][name]["materialColorBinds"] == [bind]
    assert "materialColorBinds" not in found["preset"]["neutral"]
    assert "morphTargetBinds" not in found["preset"]["neutral"]  # an empty list is no list
    words = [found["preset"]["aa"][f"override{what}"] for what in ("Blink", "LookAt", "Mouth")]
    assert words == ["none", "none", "blend"]
    assert not found["preset"]["aa"]["isBinary"]


def test_a_direction_is_met_by_as_much_of_a_look_as_turns_there() -> None:
    gaze = describe_gaze(synthetic_cast(), (0.0, 0.05, 0.1))
    assert (gaze["type"], gaze["offsetFromHeadBone"]) == ("expression", [0.0, 0.05, 0.1])
    for name, unit in (
        ("HorizontalInner", "eyeLookInLeft"),
        ("HorizontalOuter", "eyeLookOutLeft"),
        ("VerticalDown", "eyeLookDownLeft"),
        ("VerticalUp", "eyeLookUpRight"),
    ):
        _, yaw, pitch = synthetic.LOOKS[unit]
        reach = gaze[f"rangeMap{name}"]
        assert reach["outputScale"] == 1.0
        assert reach["inputMaxValue"] == pytest.approx(math.degrees(abs(yaw + pitch)), abs=1e-3)


def test_a_cast_whose_eyes_do_not_turn_has_no_gaze() -> None:
    cast = synthetic_cast()
    still = type(cast)(cast.space, cast.faces, {"neutral": cast.expressions["neutral"]})
    assert describe_gaze(still, (0.0, 0.0, 0.0)) == {}


def test_bones_are_nodes_and_a_head_does_not_see_itself_but_its_body() -> None:
    assert describe_bones({"hips": 4, "head": 7}) == {"humanBones": {"hips": {"node": 4}, "head": {"node": 7}}}
    assert describe_first_person({1: True, 2: False})["meshAnnotations"] == [
        {"node": 1, "type": "thirdPersonOnly"},
        {"node": 2, "type": "both"},
    ]
