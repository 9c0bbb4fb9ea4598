"""Bones from points: arms of our own figures come back, sides are mirrors, and what is unseen says nothing."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.inputs.camera.body_points import BodyPoints
from omote.inputs.camera.solve_body import (
    AHEAD,
    ALONG,
    ELBOW,
    HAND_SWING,
    HIP,
    INDEX,
    SHOULDER,
    TRUNK_SHARES,
    WRIST,
    SolvedBody,
    measure_rest,
    solve_body,
)
from omote.model.body.compose_pose import pose_of
from omote.model.body.pose import Pose
from omote.model.body.pose_recipe import Arm, PoseRecipe
from tests.inputs.camera.bodies import FIGURES, SKELETON, filmed_body, joints_of

STANDING = joints_of(FIGURES.poses["stand"])
REST = measure_rest([filmed_body(STANDING)])
assert REST is not None
ARM = ("upperarm01", "lowerarm01", "wrist", "finger3-1")
MIRROR = np.array([1.0, -1.0, -1.0, 1.0])


def directions(bones: SolvedBody, side: str) -> list[Values]:
    """Where the upper arm, forearm and hand of an avatar point that wears the bones."""
    turn = Rotation.identity()
    for name in TRUNK_SHARES:
        turn = turn * Rotation.from_quat(bones.bones[name])
    ways = []
    for name in ("Shoulder", "UpperArm", "LowerArm", "Hand"):
        turn = turn * Rotation.from_quat(bones.bones[f"{side}{name}"])
        ways.append(turn.apply(ALONG if side == "left" else -ALONG))
    return ways[1:]


def figure_directions(joints: Points, side: str) -> list[Values]:
    """The same of a figure."""
    at = [joints[SKELETON.places[f"{name}.{side[0].upper()}"]] for name in ARM]
    return [(after - before) / np.linalg.norm(after - before) for before, after in pairwise(at)]


def errors(joints: Points, frame: BodyPoints) -> Values:
    """Degrees by which upper arms and forearms are away from a figure's, (2, 2); hands are told apart: (2,)."""
    assert REST is not None
    bones = solve_body(frame, REST)
    return np.array(
        [
            [
                np.degrees(np.arccos(min(1.0, float(found @ true))))
                for found, true in zip(directions(bones, side), figure_directions(joints, side), strict=True)
            ]
            for side in ("left", "right")
        ]
    )


def random_pose(seed: int) -> Pose:
    """Arms anywhere before and beside the body, on a trunk that leans and turns."""
    dice = np.random.default_rng(seed)

    def arm() -> Arm:
        return Arm(
            raised=dice.uniform(-20.0, 150.0), spread=dice.uniform(0.0, 80.0), twist=dice.uniform(-40.0, 40.0),
            elbow=dice.uniform(0.0, 120.0), wrist=(dice.uniform(-30.0, 30.0), 0.0),
        )  # fmt: skip

    trunk = (dice.uniform(-10.0, 35.0), dice.uniform(-25.0, 25.0), dice.uniform(-12.0, 12.0))
    return pose_of(PoseRecipe(trunk=trunk, left=arm(), right=arm()), SKELETON, "random")


@pytest.mark.parametrize("hidden", [(), (HIP, HIP + 1)], ids=["standing", "hips unseen"])
def test_arms_of_all_poses_point_where_the_figure_s_do(hidden: tuple[int, ...]) -> None:
    poses = [*FIGURES.poses.values(), *(random_pose(seed) for seed in range(40))]
    found = []
    for pose in poses:
        joints = joints_of(pose)
        found.append(errors(joints, filmed_body(joints, hidden=hidden)))
    upper, fore, hand = np.array(found).reshape(-1, 3).T
    assert np.median([upper, fore]) < 1.0
    assert max(upper.max(), fore.max()) < 15.0, "limbs are as long as they hung at rest, bent a little or not"
    assert np.quantile(hand, 0.9) < 12.0, "the knuckles of index and little finger say less than the middle one's"


def test_noise_of_a_centimetre_costs_some_degrees() -> None:
    found = []
    for seed in range(60):
        joints = joints_of(random_pose(seed))
        found.append(errors(joints, filmed_body(joints, time=float(seed), noise=0.01)))
    upper, fore, _ = np.array(found).reshape(-1, 3).T
    assert np.median([upper, fore]) < 8.0
    assert np.quantile([upper, fore], 0.95) < 20.0


@pytest.mark.parametrize(("name", "axis", "degrees"), [("bow", 0, 50.0), ("chest_left", 1, 30.0), ("listen", 2, 6.0)])
@pytest.mark.parametrize("hidden", [(), (HIP, HIP + 1)], ids=["standing", "hips unseen"])
def test_the_trunk_leans_and_turns_also_where_hips_are_not_seen(
    name: str, axis: int, degrees: float, hidden: tuple[int, ...]
) -> None:
    assert REST is not None
    bones = solve_body(filmed_body(joints_of(FIGURES.poses[name]), hidden=hidden), REST)
    vectors = [Rotation.from_quat(bones.bones[part]).as_rotvec(degrees=True) for part in TRUNK_SHARES]
    assert np.sum(vectors, axis=0)[axis] == pytest.approx(degrees, rel=0.2)
    for vector in vectors:
        assert np.linalg.norm(np.cross(vector, vectors[0])) < 1e-6, "they bend about one axis"


def test_a_performer_who_sits_askew_plays_as_one_who_sits_straight() -> None:
    joints, turn = joints_of(random_pose(3)), Rotation.from_rotvec([0.0, 0.5, 0.0])
    middle = joints[SKELETON.places["root"]]

    def askew(places: Points) -> BodyPoints:
        return filmed_body(turn.apply(places - middle) + middle)

    rest = measure_rest([askew(STANDING)])
    assert rest is not None
    assert REST is not None
    straight = solve_body(filmed_body(joints), REST).bones
    for name, found in solve_body(askew(joints), rest).bones.items():
        assert abs(found @ straight[name]) > 1.0 - 1e-3, name


def test_a_mirrored_body_gives_mirrored_bones() -> None:
    assert REST is not None
    frame = filmed_body(joints_of(random_pose(5)))
    assert frame.values is not None
    order = [0, 4, 5, 6, 1, 2, 3, *(point + (1 if point % 2 else -1) for point in range(7, 33))]
    values = frame.values[order] * [-1, 1, 1, 1, -1, 1] + [0, 0, 0, 0, 1, 0]
    rest = replace(REST, trunk=np.diag([-1.0, 1.0, 1.0]) @ REST.trunk @ np.diag([-1.0, 1.0, 1.0]))
    bones = solve_body(frame, REST)
    mirrored = solve_body(BodyPoints(values.astype(np.float32), 640, 480, 0.0), rest)
    assert (bones.left, bones.right) == (mirrored.right, mirrored.left)
    for name, found in bones.bones.items():
        other = name.replace("left", "Right").replace("right", "left").replace("Right", "right")
        assert abs(found @ (MIRROR * mirrored.bones[other])) > 1.0 - 1e-9, name


def test_a_lifted_shoulder_lifts_both_and_the_arm_stays() -> None:
    assert REST is not None
    joints = joints_of(FIGURES.poses["shrug"])
    bones = solve_body(filmed_body(joints), REST)
    lifted = [Rotation.from_quat(bones.bones[f"{side}Shoulder"]).as_rotvec(degrees=True) for side in ("left", "right")]
    assert lifted[0][2] == pytest.approx(-lifted[1][2])
    assert 5.0 < lifted[0][2] <= 28.0
    still = solve_body(filmed_body(STANDING), REST).bones["leftShoulder"]
    assert abs(still[3]) == pytest.approx(1.0)


@pytest.mark.parametrize("point", [SHOULDER, ELBOW, WRIST])
def test_an_arm_of_which_a_point_is_missing_is_not_seen_and_the_rest_is(point: int) -> None:
    assert REST is not None
    joints = joints_of(random_pose(1))
    whole = solve_body(filmed_body(joints), REST)
    frame = filmed_body(joints)
    assert frame.values is not None
    values = frame.values.copy()
    values[point, 1] = np.nan
    bones = solve_body(BodyPoints(values, 640, 480, 0.0), REST)
    if point == SHOULDER:
        assert (bones.bones, bones.trunk) == ({}, 0.0), "shoulders say how the trunk is"
        return
    assert (bones.left, bones.right, bones.trunk) == (0.0, 1.0, 1.0)
    assert not any(name.startswith("left") for name in bones.bones)
    for name, found in bones.bones.items():
        assert found == pytest.approx(whole.bones[name], abs=1e-9)


def test_a_hand_that_is_not_seen_lies_along_its_forearm_and_one_bent_too_far_is_limited() -> None:
    assert REST is not None
    joints = joints_of(random_pose(2))
    bones = solve_body(filmed_body(joints, hidden=(INDEX,)), REST)
    assert bones.left == 1.0
    assert abs(bones.bones["leftHand"][3]) == pytest.approx(1.0)
    frame = filmed_body(joints)
    assert frame.values is not None
    values = frame.values.copy()
    values[[INDEX, INDEX - 2], :3] = values[ELBOW, :3] + [0.01, 0.0, 0.0]
    folded = solve_body(BodyPoints(values, 640, 480, 0.0), REST).bones["leftHand"]
    along = Rotation.from_quat(folded).apply(ALONG)
    assert np.arccos(along @ ALONG) <= HAND_SWING + 1e-6
    assert np.isfinite(Rotation.from_quat(folded).apply(AHEAD)).all()


def test_a_model_that_knows_no_depth_is_led_by_the_picture() -> None:
    """Of limbs that the picture shows whole, or short, whatever the model says of them."""
    assert REST is not None
    for name, most in (("arms_open", 20.0), ("point", 35.0)):
        joints = joints_of(FIGURES.poses[name])
        frame = filmed_body(joints)
        assert frame.values is not None
        for depth in (0.05, -0.05, 0.3):
            values = frame.values.copy()
            values[[ELBOW, ELBOW + 1], 2] = values[[SHOULDER, SHOULDER + 1], 2] - abs(depth)
            values[[WRIST, WRIST + 1], 2] = values[[ELBOW, ELBOW + 1], 2] - abs(depth)
            found = errors(joints, BodyPoints(values, 640, 480, 0.0))
            assert found[:, :2].max() < most, (name, depth, found)


def test_nothing_is_seen_where_there_is_no_body() -> None:
    assert REST is not None
    assert solve_body(BodyPoints(None, 640, 480, 0.0), REST).bones == {}
    assert measure_rest([BodyPoints(None, 640, 480, 0.0)]) is None
    hidden = (SHOULDER, WRIST)
    assert measure_rest([filmed_body(STANDING, hidden=hidden)]) is None
