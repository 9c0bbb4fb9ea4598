"""Ears of animals hang on joints that swing as VRM says; people have none."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.avatar.export_vrm import vrm_bytes
from omote.interchange.avatar.spring_bones import RATE, SIDES, EarBone, describe_springs, find_ear_bones
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.export_face import ExportContext
from omote.perform.springs.cast_springs import SPRINGS
from tests.interchange.formats.scenes import taken_apart

CAST = load_cast()
EARS = SPRINGS["ears-sway"]


def bones_of(face: str) -> tuple[EarBone, ...]:
    return find_ear_bones(CAST.space, CAST.faces[face], np.array([0.0, 1.5, 0.0]))


def values(document: dict[str, Any], binary: bytes, accessor: int, kind: str) -> np.ndarray:
    view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
    return np.frombuffer(binary[view["byteOffset"] :][: view["byteLength"]], kind)


def test_people_have_no_bones_in_their_ears() -> None:
    assert bones_of("kaori") == bones_of("heavy") == ()


@pytest.mark.parametrize("face", ["dog", "cat"])
def test_an_ear_reaches_from_its_root_on_the_head_to_its_tip(face: str) -> None:
    left, right = bones_of(face)
    assert [left.root.name, right.root.name] == [*SIDES]
    assert (left.root.parent, left.tip.parent) == ("head", "leftEar")
    np.testing.assert_allclose(left.tip.place, np.multiply(right.tip.place, [-1.0, 1.0, 1.0]), atol=1e-4)
    assert 0.03 < left.length < 0.2
    assert left.root.place[0] > 0.0


def test_a_small_swing_has_our_frequency_and_damping_at_the_rate_that_is_said() -> None:
    """As the specification computes it: inertia without drag, and a pull to rest."""
    (bone, _) = ears = bones_of("dog")
    nodes = {joint.name: 0 for ear in ears for joint in (ear.root, ear.tip)}
    joint = describe_springs(ears, nodes)["springs"][0]["joints"][0]
    angles = [0.01, 0.01]
    for _ in range(90):
        before, angle = angles[-2:]
        along = bone.length * math.cos(angle) + joint["stiffness"] / RATE
        inertia = (math.sin(angle) - math.sin(before)) * (1.0 - joint["dragForce"])
        angles.append(math.atan2(bone.length * (math.sin(angle) + inertia), along))
    rate = 2.0 * math.pi * EARS.frequency
    decay = EARS.damping * rate / RATE
    turn = math.sqrt(1.0 - EARS.damping**2) * rate / RATE
    swing = [0.01, 0.01]
    for _ in range(90):
        swing.append(2.0 * math.exp(-decay) * math.cos(turn) * swing[-1] - math.exp(-2.0 * decay) * swing[-2])
    np.testing.assert_allclose(angles, swing, atol=1e-4)


def test_a_file_has_them_in_either_version_and_every_vertex_still_hangs_whole() -> None:
    few = replace(CAST, expressions={name: CAST.expressions[name] for name in ("neutral", "jawOpen")}, titles={})
    context = ExportContext(few, load_meshes(), load_mask())
    document, binary = taken_apart(vrm_bytes(context, "dog", [], Credit(("Ann",)), hair=False))
    assert document["extensionsUsed"] == ["VRMC_vrm", "VRMC_springBone"]
    springs = document["extensions"]["VRMC_springBone"]["springs"]
    named = [[document["nodes"][joint["node"]]["name"] for joint in spring["joints"]] for spring in springs]
    assert named == [["leftEar", "leftEarTip"], ["rightEar", "rightEarTip"]]
    humans = document["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"]
    assert not set(humans) & {"leftEar", "rightEar"}
    assert [document["nodes"][node]["name"] for node in document["skins"][0]["joints"]] == ["head", *SIDES]
    attributes = document["meshes"][0]["primitives"][0]["attributes"]
    weights = values(document, binary, attributes["WEIGHTS_0"], "u1").reshape(-1, 4)
    joints = values(document, binary, attributes["JOINTS_0"], "u1").reshape(-1, 4)
    assert (weights.sum(axis=1, dtype=int) == 255).all()
    assert (weights[:, 1:3] == 255).sum() > 200
    assert not joints[weights == 0].any()
    rows = values(document, binary, attributes["_VID"], "<f4").astype(int)
    np.testing.assert_allclose(weights[:, 1] / 255.0, bones_of("dog")[0].shares[rows], atol=1 / 255)

    old, _ = taken_apart(vrm_bytes(context, "dog", [], Credit(("Ann",), version="0.x"), hair=False))
    groups = old["extensions"]["VRM"]["secondaryAnimation"]["boneGroups"]
    assert [old["nodes"][group["bones"][0]]["name"] for group in groups] == [*SIDES]
    assert groups[0]["stiffiness"] == springs[0]["joints"][0]["stiffness"]
