"""Expressions of avatars are sums of their targets, under the names that VRM gives them; damaged ones are left out."""

from __future__ import annotations

import copy
from typing import Any

import msgspec
import numpy as np
import pytest

from omote.interchange.formats.gltf_scene import MOST_TARGETS
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_materials import SceneDocument
from omote.interchange.scans.gltf_scan import read_gltf
from omote.interchange.scans.vrm_expressions import VrmExpressions, read_vrm_expressions
from omote.model.fitting.scan import Scan
from tests.interchange.scans import scan_samples as samples

Json = dict[str, Any]
BARE = read_gltf(samples.write_gltf(*samples.gltf_document()), Companions()).shapes["jawOpen"]


def bind(index: int, weight: float = 1.0, node: int = 1) -> Json:
    """A bind of VRM 1.0."""
    return {"node": node, "index": index, "weight": weight}


def version_1(preset: Json, custom: Json | None = None) -> Json:
    """The extension of VRM 1.0, of expressions by their binds."""
    kinds = {"preset": preset, "custom": custom or {}}
    return {
        "VRMC_vrm": {
            "expressions": {
                kind: {name: {"morphTargetBinds": binds} for name, binds in each.items()}
                for kind, each in kinds.items()
            }
        }
    }


def version_0(*groups: Json) -> Json:
    """The extension of VRM 0.x."""
    return {"VRM": {"blendShapeMaster": {"blendShapeGroups": list(groups)}}}


def ball_with(extensions: Any) -> Scan:
    """The ball, whose node shows one target, with an extension."""
    document, body = samples.gltf_document()
    document = copy.deepcopy(document)
    document["extensions"] = extensions
    return read_gltf(samples.write_gltf(document, body), Companions())


def read(extensions: Any) -> VrmExpressions:
    """What a document of three nodes, the last two with mesh 0, declares."""
    nodes = [{}, {"mesh": 0}, {"mesh": 0}]
    return read_vrm_expressions(msgspec.convert({"nodes": nodes, "extensions": extensions}, SceneDocument))


NODE = next(at for at, node in enumerate(samples.gltf_document()[0]["nodes"]) if "mesh" in node)


def test_a_whole_target_takes_the_name_of_its_expression() -> None:
    scan = ball_with(version_1({"aa": [bind(0, node=NODE)]}))
    assert list(scan.shapes) == ["aa"]
    np.testing.assert_array_equal(scan.shapes["aa"], BARE)


def test_an_expression_of_several_meshes_is_the_whole_of_one_target_at_each() -> None:
    found = read(version_1({"aa": [bind(0, node=1), bind(4, node=2)], "oh": [bind(1, node=1), bind(2, node=1)]}))
    assert found.alone == {(1, 0), (2, 4)}, "a sum is the whole of none"
    halved = read(version_1({"aa": [bind(0, node=1), bind(4, 0.5, node=2)]}))
    assert halved.alone == frozenset()


def test_a_part_of_a_target_stands_beside_it() -> None:
    scan = ball_with(version_1({"aa": [bind(0, 0.25, NODE)]}, {"Agape": [bind(0, 0.5, NODE), bind(0, 0.25, NODE)]}))
    assert set(scan.shapes) == {"jawOpen", "aa", "Agape"}
    np.testing.assert_allclose(scan.shapes["aa"], 0.25 * BARE, atol=1e-12)
    np.testing.assert_allclose(scan.shapes["Agape"], 0.75 * BARE, atol=1e-12)
    np.testing.assert_array_equal(scan.shapes["jawOpen"], BARE)


def test_groups_of_0_x_are_called_by_their_preset_or_their_own_name() -> None:
    binds = [{"mesh": 0, "index": 0, "weight": 25}]
    groups = {"name": "Mouth A", "presetName": "a", "binds": binds}, {"name": "Ooh", "presetName": "unknown"}
    scan = ball_with(version_0(groups[0], groups[1] | {"binds": binds}))
    assert set(scan.shapes) == {"jawOpen", "a", "Ooh"}
    for name in ("a", "Ooh"):
        np.testing.assert_allclose(scan.shapes[name], 0.25 * BARE, atol=1e-12)


def test_a_mesh_of_0_x_is_meant_wherever_it_stands() -> None:
    found = read(version_0({"name": "Ooh", "binds": [{"mesh": 0, "index": 3, "weight": 100}]}))
    assert found.binds == {1: {"Ooh": [(3, 1.0)]}, 2: {"Ooh": [(3, 1.0)]}}
    assert found.alone == {(1, 3), (2, 3)}


@pytest.mark.parametrize(
    "damaged",
    [
        None, [], "x", {"VRMC_vrm": 3}, {"VRMC_vrm": {"expressions": []}}, {"VRM": {"blendShapeMaster": None}},
        version_1({"aa": "no"}), version_1({"aa": [None, {}, {"index": "0"}, bind(-1), bind(0, 0.0), bind(0, -2.0)]}),
        version_1({"": [bind(0)], "a\nb": [bind(0)], "x" * 81: [bind(0)]}),
        {"VRMC_vrm": {"expressions": {"preset": {"aa": 1}}}}, {"VRM": {"blendShapeMaster": {"blendShapeGroups": [3]}}},
        version_0({"name": 3, "presetName": [], "binds": [{"mesh": 0, "index": 0}]}),
    ],
)  # fmt: skip
def test_what_is_declared_wrongly_is_left_out(damaged: Any) -> None:
    assert read(damaged) == VrmExpressions({}, frozenset())


def test_targets_and_nodes_that_are_not_there_move_nothing() -> None:
    scan = ball_with(version_1({"aa": [bind(7, node=NODE)], "oh": [bind(0, node=999)]}))
    assert list(scan.shapes) == ["jawOpen"]


def test_weights_beyond_one_are_one() -> None:
    assert read(version_1({"aa": [bind(0, 5.0)]})).binds == {1: {"aa": [(0, 1.0)]}}


def test_too_many_are_refused() -> None:
    many = {f"e{at}": [bind(0)] for at in range(MOST_TARGETS + 1)}
    with pytest.raises(ValueError, match="expressions of an avatar"):
        read(version_1({}, many))


@pytest.mark.parametrize(
    "twice",
    [
        version_0(*[{"name": "Smile", "binds": [{"mesh": 0, "index": 0, "weight": 50}]}] * 2),
        version_1({"Smile": [bind(0, 0.5, NODE)]}, {"Smile": [bind(0, 0.5, NODE)]}),
    ],
)
def test_the_second_of_one_name_is_numbered_and_said(twice: Json) -> None:
    document, body = samples.gltf_document()
    beside = Companions()
    scan = read_gltf(samples.write_gltf(document | {"extensions": twice}, body), beside)
    assert list(scan.shapes) == ["jawOpen", "Smile", "Smile 2"]
    for name in ("Smile", "Smile 2"):
        np.testing.assert_allclose(scan.shapes[name], 0.5 * BARE, atol=1e-12)
    assert beside.notes == ["two of its expressions are named 'Smile': the second is read as 'Smile 2'"]


def test_a_target_named_as_an_expression_that_does_something_else_stands_beside_it() -> None:
    scan = ball_with(version_1({"jawOpen": [bind(0, 0.5, NODE)]}))
    assert set(scan.shapes) == {"jawOpen", "jawOpen 2"}
    np.testing.assert_allclose(scan.shapes["jawOpen"], 0.5 * BARE, atol=1e-12)
    np.testing.assert_array_equal(scan.shapes["jawOpen 2"], BARE)


def test_a_name_that_nobody_can_read_is_left_out_and_said() -> None:
    assert read(version_1({"a\nb": [bind(0)]})).notes == (
        "its expression 'a\\nb' is left out: its name is none that people can read",
    )
