"""A mirrored body is the pose of the mirrored recipe, and twice mirrored it is as it was."""

import numpy as np

from omote.builtin import load_figures
from omote.model.body.pose_regions import region_bones
from omote.model.body.posed_bones import pose_bones
from omote.perform.figures.packed_pose import pose_numbers
from omote.perform.layers.source_frame import BodyFrame
from omote.show.sources.mirrored_body import mirrored_body

FIGURES = load_figures()


def test_a_mirror_shows_the_other_side_and_a_second_one_the_first() -> None:
    skeleton = FIGURES.space.skeleton
    of_left = region_bones(skeleton)["arm_left"]
    for pose in FIGURES.poses.values():
        body = BodyFrame(pose_numbers(pose), ("head", "arm_left"))
        mirrored = mirrored_body(body)
        assert mirrored.regions == ("head", "arm_right")
        assert np.array_equal(mirrored_body(mirrored).numbers, body.numbers)
        turns = mirrored.numbers[: 3 * len(skeleton.names)].reshape(-1, 3)
        assert np.array_equal(turns[skeleton.mirror[of_left]], pose.turns[of_left] * [1.0, -1.0, -1.0])


def test_joints_of_a_mirrored_body_are_mirrored_on_a_body_that_is() -> None:
    skeleton = FIGURES.space.skeleton
    random = np.random.default_rng(431)
    joints = random.normal(size=(len(skeleton.names), 3))
    joints = 0.5 * (joints + joints[skeleton.mirror] * [-1.0, 1.0, 1.0])
    still = np.tile(np.eye(3), (len(joints), 1, 1))
    for name in ("wave", "point", "think", "shrug"):
        pose = FIGURES.poses[name]
        body = mirrored_body(BodyFrame(pose_numbers(pose)))
        count = 3 * len(skeleton.names)
        turns, travel = body.numbers[:count].reshape(-1, 3), body.numbers[count : count + 3]
        one = pose_bones(skeleton, joints, still, pose.turns.copy(), pose.travel).joints
        other = pose_bones(skeleton, joints, still, turns, travel).joints
        assert np.abs(one[skeleton.mirror] * [-1.0, 1.0, 1.0] - other).max() < 1e-9
