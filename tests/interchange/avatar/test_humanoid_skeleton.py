"""The skeleton under a head: a person's, upright, in T-pose, as tall as the head says."""

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.avatar.humanoid_skeleton import EYES, HEAD, build_skeleton
from omote.model.cast import Cast
from omote.model.space.face_fit import fit, generic_face
from tests import synthetic

REQUIRED = {"hips", "spine", "head"} | {
    side + limb
    for side in ("left", "right")
    for limb in ("UpperLeg", "LowerLeg", "Foot", "UpperArm", "LowerArm", "Hand")
}
"""The bones that no VRM 1.0 may lack."""


@pytest.fixture(scope="module")
def built_in() -> Cast:
    """The built-in cast; skipped where it was not baked."""
    return load_cast()


def test_all_bones_that_vrm_wants_are_there_each_under_its_parent() -> None:
    space = synthetic.space()
    joints = build_skeleton(space, fit(space, generic_face(space))).joints
    assert joints.keys() == REQUIRED | {"chest", "neck"}
    chain = {"spine": "hips", "chest": "spine", "neck": "chest", "head": "neck", "hips": ""}
    for side in ("left", "right"):
        chain |= {f"{side}UpperArm": "chest", f"{side}LowerArm": f"{side}UpperArm", f"{side}Hand": f"{side}LowerArm"}
        chain |= {f"{side}UpperLeg": "hips", f"{side}LowerLeg": f"{side}UpperLeg", f"{side}Foot": f"{side}LowerLeg"}
    assert {name: joint.parent for name, joint in joints.items()} == chain
    order = list(joints)
    assert all(order.index(joint.parent) < at for at, joint in enumerate(joints.values()) if joint.parent)


def test_it_stands_straight_with_its_arms_out_and_the_left_at_the_left() -> None:
    space = synthetic.space()
    joints = build_skeleton(space, fit(space, generic_face(space))).joints
    for name, joint in joints.items():
        x, y, z = joint.place
        assert (x > 0, x < 0, y > 0, z) == (name.startswith("left"), name.startswith("right"), True, 0.0)
    for one, other in (("UpperArm", "LowerArm"), ("LowerArm", "Hand")):
        assert joints[f"left{other}"].place[0] > joints[f"left{one}"].place[0]
        assert joints[f"left{other}"].place[1] == joints[f"left{one}"].place[1]
    for above, below in (("UpperLeg", "LowerLeg"), ("LowerLeg", "Foot")):
        assert joints[f"right{above}"].place[1] > joints[f"right{below}"].place[1]
    heights = [joints[name].place[1] for name in ("hips", "spine", "chest", "neck", "head")]
    assert heights == sorted(heights)
    for name, joint in joints.items():
        twin = joints[name.replace("left", "right")]
        assert np.abs(joint.place) == pytest.approx(np.abs(twin.place))


def test_a_person_is_as_tall_as_people_are_and_the_eyes_are_where_they_belong(built_in: Cast) -> None:
    for name, face in built_in.faces.items():
        fitted = fit(built_in.space, face)
        skeleton = build_skeleton(built_in.space, fitted)
        eyes = np.mean([fitted.centres["eye_left"], fitted.centres["eye_right"]], axis=0) + skeleton.shift
        np.testing.assert_allclose(skeleton.joints["head"].place + np.array(skeleton.eyes), eyes, atol=1e-6)
        assert eyes[1] / EYES == pytest.approx(skeleton.joints["leftFoot"].place[1] / 0.039)
        assert skeleton.joints["neck"].place[1] < fitted.positions[:, 1].max() + skeleton.shift[1]
        if name in ("generic", "kaori", "man", "old"):
            assert 1.5 < eyes[1] / EYES < 2.0


def test_a_head_twice_as_large_stands_on_a_body_twice_as_large() -> None:
    space = synthetic.space()
    fitted = fit(space, generic_face(space))
    large = replace(fitted, positions=2 * fitted.positions)
    one = build_skeleton(space, fitted)
    two = build_skeleton(space, large)
    for name, joint in one.joints.items():
        np.testing.assert_allclose(two.joints[name].place, 2 * np.array(joint.place))
    nothing = replace(fitted, positions=0 * fitted.positions)
    assert build_skeleton(space, nothing).joints["head"].place[1] > 0.0
    assert 0 < HEAD < EYES < 1
