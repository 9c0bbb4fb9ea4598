"""The bones of a humanoid as a pose: the way back of what we tell of our own."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import omote
from omote.arrays import Values
from omote.builtin import load_figures
from omote.interchange.avatar.humanoid_pose import HumanoidRest, humanoid_pose, rest_humanoid
from omote.interchange.avatar.read_humanoid import pose_of_humanoid
from omote.model.body.compose_pose import SPINE_SHARES
from omote.model.body.pose import Pose
from omote.model.body.posed_bones import place_bones
from omote.model.body.skeleton import SIDES
from omote.perform.figures.figure import pose_figure
from omote.perform.figures.pose_mix import MixedPose, mix_poses

CAST = omote.load_cast()
FIGURES = load_figures()
SKELETON = FIGURES.space.skeleton
FACES = {name: face.positions for name, face in CAST.faces.items()}
REST = rest_humanoid(FIGURES, {"generic": 1.0}, FACES)
FINGERS = ("Thumb", "Index", "Middle", "Ring", "Little")
THOUSANDTH = 1e-3
POSES = [pose for name, pose in FIGURES.poses.items() if not name.startswith(("breath", "weight", "chest"))]


def random_pose(seed: int) -> Pose:
    """A pose between three of the library."""
    random = np.random.default_rng(seed)
    three = {pose.name: pose for pose in random.choice(np.array(POSES, object), 3, replace=False)}
    mixed = mix_poses(three, dict(zip(three, random.dirichlet(np.ones(3)), strict=True)), {}, {})
    return Pose(f"random {seed}", mixed.turns, mixed.travel, mixed.feet, mixed.feet_turns)


def alone(pose: Pose) -> MixedPose:
    return mix_poses({pose.name: pose}, {pose.name: 1.0}, {}, {})


def told(pose: Pose, rest: HumanoidRest = REST) -> tuple[dict[str, Values], Values]:
    """The turns of VRM's bones in a pose, and where hips are against the T-pose, in lengths of the leg."""
    bones = humanoid_pose(rest, alone(pose))
    return dict(zip(bones.names, bones.turns, strict=True)), (bones.places[0] - rest.places[0]) / rest.leg


def joints(pose: Pose, rest: HumanoidRest) -> Values:
    return pose_figure(FIGURES.space, rest.resting, alone(pose)).joints


def ways(at: Values) -> Values:
    """The direction of each of VRM's bones from its parent."""
    below = REST.parents >= 0
    way = at[REST.bones[below]] - at[REST.bones[REST.parents[below]]]
    return np.asarray(way / np.linalg.norm(way, axis=1)[:, None])


def apart(before: Values, after: Values) -> float:
    """The largest angle between directions, degrees."""
    return float(np.degrees(np.arccos(np.clip((before * after).sum(axis=1), -1.0, 1.0))).max())


@pytest.mark.parametrize("pose", [*POSES, *map(random_pose, range(10))], ids=lambda pose: pose.name)
def test_a_pose_that_is_told_comes_back(pose: Pose) -> None:
    turns, hips = told(pose)
    back = pose_of_humanoid(REST, turns, hips)
    before, after = joints(pose, REST), joints(back, REST)
    assert apart(ways(before), ways(after)) < 1.0
    feet = [SKELETON.places[f"foot.{side}"] for side in SIDES]
    assert np.linalg.norm(before[feet] - after[feet], axis=1).max() < THOUSANDTH * REST.resting.leg
    told_feet, feet_now = (Rotation.from_rotvec(np.array(each.feet_turns)) for each in (pose, back))
    assert (told_feet.inv() * feet_now).magnitude().max() < 1e-6
    np.testing.assert_allclose(back.travel, pose.travel, atol=1e-9)
    again, _ = told(back)
    for name, turn in turns.items():  # what VRM's bones do, with their turns about themselves
        most = (
            15.0 if name.endswith(("UpperLeg", "LowerLeg")) else 6.0
        )  # a limb's skin, where ours has two bones for VRM's one
        turned = Rotation.from_quat(np.array(turn)).inv() * Rotation.from_quat(np.array(again[name]))
        assert np.degrees(turned.magnitude()) < most, name


@pytest.mark.parametrize("name", ["generic", "child", "heavy", "dog"])
def test_a_t_pose_is_ours_on_any_body_and_stands_on_the_floor(name: str) -> None:
    rest = rest_humanoid(FIGURES, {name: 1.0}, FACES)
    pose = pose_of_humanoid(REST, {})
    after = joints(pose, rest)
    t_pose = place_bones(SKELETON, rest.resting.joints, rest.resting.stand, rest.frames, np.zeros(3)).joints
    limbs = [not any(finger in name for finger in FINGERS) for name in REST.names[1:]]
    chosen = slice(None) if name == "generic" else limbs  # bodies were modelled with fingers bent differently
    assert apart(ways(t_pose)[chosen], ways(after)[chosen]) < 2.0, "our legs are never quite straight"
    assert np.abs(pose.feet[:, 1]).max() < 1e-9
    turns, hips = told(pose)
    still = Rotation.from_quat(np.stack([*turns.values()])).magnitude()
    assert np.degrees(still).max() < 4.0, "knees of a leg that is never quite straight"
    assert np.abs(hips).max() < 1e-9


def test_bones_that_a_humanoid_has_not_leave_their_bend_to_those_that_it_has() -> None:
    bow = np.radians(40.0)
    bent = Rotation.from_rotvec([bow, 0.0, 0.0]).as_quat()
    of_spine = pose_of_humanoid(REST, {"spine": bent})
    spine, neck = (
        [SKELETON.places[bone] for bone in bones] for bones in (SPINE_SHARES, ("neck01", "neck02", "neck03", "head"))
    )
    np.testing.assert_allclose(of_spine.turns[spine, 0], bow * np.array([*SPINE_SHARES.values()]), atol=1e-9)
    of_head = pose_of_humanoid(REST, {"head": bent})
    np.testing.assert_allclose(of_head.turns[neck, 0], bow * np.array([0.2, 0.2, 0.2, 0.4]), atol=1e-9)
    assert (pose_of_humanoid(REST, {"jaw": bent}).turns == pose_of_humanoid(REST, {}).turns).all()


def test_an_arm_that_goes_up_and_over_turns_on_steadily() -> None:
    """Half a turn from hanging, a rotation vector could be its own opposite; a mix with another pose would jump."""
    place = SKELETON.places["upperarm01.L"]
    seen = []
    for degrees in np.arange(60.0, 100.0, 2.0):
        raised = Rotation.from_rotvec([0.0, 0.0, np.radians(degrees)]).as_quat()
        seen.append(pose_of_humanoid(REST, {"leftUpperArm": raised}).turns[place])
    assert np.linalg.norm(np.diff(seen, axis=0), axis=1).max() < np.radians(4.0)
