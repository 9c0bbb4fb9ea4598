"""Names of joints: what is found, and what is said where a person is not."""

from __future__ import annotations

import pytest

from omote.interchange.clips.bvh_bones import humanoid_joints
from omote.interchange.clips.bvh_reader import read_bvh
from tests.interchange.clips.humanoids import OLD, RIGS, bvh_of, moving


@pytest.mark.parametrize("rig", RIGS)
def test_each_bone_is_found_by_the_name_that_a_program_gives_it(rig: str) -> None:
    names = RIGS[rig]
    joints = read_bvh(bvh_of(moving(tuple(names), frames=1), names)).joints
    assert {bone: joints[place].name for bone, place in humanoid_joints(joints).items()} == names


def test_what_is_no_person_is_said() -> None:
    for bone, name, said in (
        ("leftFoot", "Tail", "no joint of the file is the leftFoot of a person"),
        ("rightLowerLeg", "Wing", "no joint of the file is the rightLowerLeg"),
    ):
        names = OLD | {bone: name}
        joints = read_bvh(bvh_of(moving(tuple(OLD), frames=1), names)).joints
        with pytest.raises(ValueError, match=said):
            humanoid_joints(joints)


def test_limbs_that_do_not_hang_on_themselves_are_rejected() -> None:
    names = OLD | {"leftUpperLeg": "LeftKnee", "leftLowerLeg": "LeftHip"}
    joints = read_bvh(bvh_of(moving(tuple(OLD), frames=1), names)).joints
    with pytest.raises(ValueError, match="does not hang on its leftUpperLeg"):
        humanoid_joints(joints)
