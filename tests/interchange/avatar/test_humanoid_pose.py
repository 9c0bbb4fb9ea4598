"""The bones of VRM in a pose: an avatar that plays them has its limbs where the figure has them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import omote
from omote.builtin import load_figures
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.avatar.humanoid_pose import HumanoidPose, HumanoidRest, humanoid_pose, rest_humanoid
from omote.model.body.pose_regions import region_bones
from omote.perform.figures.evaluate_figure import turned_pose
from omote.perform.figures.figure import pose_figure
from omote.perform.figures.pose_mix import MixedPose, mix_poses
from omote.perform.frame import Head

CAST = omote.load_cast()
FIGURES = load_figures()
SKELETON = FIGURES.space.skeleton
FACES = {name: face.positions for name, face in CAST.faces.items()}
OURS = humanoid_bones()
ARM = 5e-3
"""Of its length, how far a hand may be off: a forearm of ours is two bones, which are not quite in one line."""
MIXES: tuple[Mapping[str, float], ...] = ({"child": 1.0}, {"heavy": 1.0}, {"dog": 1.0}, {"old": 0.4, "gaunt": 0.6})


def mixed(weights: Mapping[str, float], head: Head) -> MixedPose:
    """A mix of poses with a head that is turned."""
    pose = mix_poses(FIGURES.poses, weights, {}, region_bones(SKELETON), (0.3, -0.4, 0.0))
    return turned_pose(SKELETON, pose, head)


def played(pose: HumanoidPose) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Turns in space, and places, of an avatar whose bones hang as ours do; by VRM's names."""
    turns: dict[str, np.ndarray] = {}
    places: dict[str, np.ndarray] = {}
    by_bone = {bone: name for name, bone in OURS.items()}
    for name, turn, place in zip(pose.names, pose.turns, pose.places, strict=True):
        above = SKELETON.parents[SKELETON.places[OURS[name]]]
        while above >= 0 and SKELETON.names[above] not in by_bone:
            above = SKELETON.parents[above]
        own = Rotation.from_quat(turn).as_matrix()
        if above < 0:
            turns[name], places[name] = own, place
        else:
            parent = by_bone[SKELETON.names[above]]
            turns[name] = turns[parent] @ own
            places[name] = places[parent] + turns[parent] @ place
    return turns, places


def wanted(rest: HumanoidRest, pose: MixedPose) -> dict[str, np.ndarray]:
    """Where the figure has those bones, true metres from the floor between its feet."""
    joints = pose_figure(FIGURES.space, rest.resting, pose).joints
    return {name: (joints[SKELETON.places[bone]] - rest.ground) / rest.size for name, bone in OURS.items()}


@pytest.mark.parametrize("bodies", MIXES)
def test_an_avatar_of_the_same_body_has_its_limbs_where_the_figure_has_them(bodies: Mapping[str, float]) -> None:
    rest = rest_humanoid(FIGURES, bodies, FACES)
    elbow = [rest.names.index(bone) for bone in ("leftLowerArm", "leftHand")]
    reach = np.linalg.norm(rest.places[elbow], axis=1).sum()
    names = [*FIGURES.poses]
    for name, other in zip(names, names[7:] + names[:7], strict=True):
        pose = mixed({name: 0.7, other: 0.3}, Head(0.5, -0.2, 0.1))
        told = humanoid_pose(rest, pose)
        turns, places = played(told)
        true = wanted(rest, pose)
        frames = pose_figure(FIGURES.space, rest.resting, pose).frames
        for bone in turns.keys() - {"leftLowerArm", "rightLowerArm"}:
            turn, place = turns[bone], SKELETON.places[OURS[bone]]
            np.testing.assert_allclose(turn @ rest.frames[place], frames[place], atol=1e-9)
        for side in ("left", "right"):
            for bone in ("UpperLeg", "LowerLeg", "Foot"):  # in metres of the floor
                assert places[f"{side}{bone}"] == pytest.approx(true[f"{side}{bone}"], abs=1e-9)
            arm = places[f"{side}Hand"] - places[f"{side}UpperArm"]
            assert arm == pytest.approx(true[f"{side}Hand"] - true[f"{side}UpperArm"], abs=ARM * reach)


@pytest.mark.parametrize("bodies", MIXES)
def test_a_figure_that_stands_has_its_feet_on_the_floor_at_its_true_size(bodies: Mapping[str, float]) -> None:
    rest = rest_humanoid(FIGURES, bodies, FACES)
    _, places = played(humanoid_pose(rest, mixed({"stand": 1.0}, Head(0.0, 0.0, 0.0))))
    for side in ("left", "right"):
        assert 0.0 < places[f"{side}Toes"][1] < places[f"{side}Foot"][1] < 0.15
    assert places["leftFoot"][0] > 0.0 > places["rightFoot"][0]
