"""The bones of a humanoid, as VRM 1.0 counts them, as a pose that belongs to no body: what `humanoid_pose` tells, the
other way round."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.interchange.avatar.humanoid_figure import SIDES as OUR_SIDE
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.avatar.humanoid_pose import HumanoidRest
from omote.model.body.compose_pose import NECK_SHARES, SPINE_SHARES
from omote.model.body.pose import FARTHEST, LARGEST_TURN, Pose
from omote.model.body.posed_bones import place_bones
from omote.model.body.skeleton import SIDES
from omote.model.body.stand import FOREARM, OUT, TWIST, hanging, shortest_turn, unit
from omote.model.body.twist import twist_about

TRUNK_BONES = {
    "spine": ("spine05", "spine04"), "chest": ("spine03", "spine02"), "upperChest": ("spine01",),
    "neck": ("neck01",), "head": ("neck02", "neck03", "head"),
}  # fmt: skip
"""Which of our bones each of VRM's turns; one that a humanoid has not leaves its own to those beside it."""
VRM_SIDE = {ours: side for side, ours in OUR_SIDE.items()}
BENT = (0.05, 0.25)
"""Radians by which a knee is bent: from the first on where it is says where it points, from the second on alone."""


def pose_of_humanoid(
    rest: HumanoidRest, turns: Mapping[str, ArrayLike], hips: ArrayLike = (0.0, 0.0, 0.0), *, name: str = "tracked"
) -> Pose:
    """The pose that a humanoid holds.

    Bends of trunk and neck are shared by ours that lie between VRM's; what turns a hand about its forearm is taken up
    along it as in the stand. Feet are where the ankles come to.

    Parameters
    ----------
    rest : HumanoidRest
        Of any body: angles fit all, and feet are counted in its legs.
    turns : mapping of array_like, (4,)
        By VRM's name, the quaternion x, y, z, w of a bone against its nearest parent that the humanoid has, from the
        T-pose, along our axes (x to the character's left, y up, z ahead); of length one. Bones that are left out turn
        nothing against their parents; names that no humanoid has are left out.
    hips : array_like, (3,)
        How far they are from where the T-pose has them when it stands on the floor, leg lengths.
    name : str
        Of the pose.

    Raises
    ------
    ValueError
        Where a rotation is no quaternion, or the hips are no numbers.

    References
    ----------
    VRM Consortium, VRMC_vrm-1.0, "T-pose" and "Humanoid bones".
    """
    skeleton = rest.figures.space.skeleton
    frames = _frames(rest, turns)
    for side in SIDES:
        _spread_twist(rest, frames, side)
    lift = rest.resting.ankles[:, 1].mean() - _ankles(rest, rest.frames, np.zeros(3))[:, 1].mean()
    up = np.array([0.0, lift / rest.resting.leg, 0.0])
    travel = np.clip(np.asarray(hips, np.float64) + up, -FARTHEST, FARTHEST)
    _point_knees(rest, frames, travel)
    ankles = _ankles(rest, frames, travel)
    feet = frames[[skeleton.places[f"foot.{side}"] for side in SIDES]]
    return Pose(
        name,
        _vectors(rest, frames),
        travel,
        np.clip((ankles - rest.resting.ankles) / rest.resting.leg, -FARTHEST, FARTHEST),
        Rotation.from_matrix(feet).as_rotvec(),
    )


def _frames(rest: HumanoidRest, turns: Mapping[str, ArrayLike]) -> Values:
    """The rotation (J, 3, 3) of each bone from the stand: those of VRM as told, the others as their parents."""
    skeleton = rest.figures.space.skeleton
    own = {bone: Rotation.identity() for bone in rest.names}
    own |= {bone: Rotation.from_quat(np.array(turn, np.float64)) for bone, turn in turns.items() if bone in own}
    shared: dict[str, Rotation] = {}
    for bone, (ours, shares) in _shared_bones(frozenset(turns)).items():
        vector = own.pop(bone).as_rotvec()
        shared |= {each: Rotation.from_rotvec(share * vector) for each, share in zip(ours, shares, strict=True)}
    ours_of = humanoid_bones()
    told = {skeleton.places[each]: turn.as_matrix() for each, turn in shared.items()}
    told |= {skeleton.places[ours_of[bone]]: turn.as_matrix() for bone, turn in own.items() if bone not in TRUNK_BONES}
    world = np.empty((len(skeleton.names), 3, 3))
    for place, parent in enumerate(skeleton.parents):
        above = np.eye(3) if parent < 0 else world[parent]
        world[place] = above @ told[place] if place in told else above
    return world @ rest.frames


def _shared_bones(known: frozenset[str]) -> Mapping[str, tuple[tuple[str, ...], Values]]:
    """Which of our bones each bone of the trunk turns, and by which shares.

    A trunk without a chest bends with what is left of it, since its shoulders hang there; a head without a neck turns
    the neck too. known: the bones that a humanoid has.
    """
    of: dict[str, tuple[str, ...]] = {}
    spine: list[str] = []
    for bone in ("upperChest", "chest", "spine"):
        spine = [*TRUNK_BONES[bone], *spine]
        if bone in known or bone == "spine":
            of[bone] = tuple(spine)
            spine = []
    neck = TRUNK_BONES["neck"]
    of |= {"neck": neck} if "neck" in known else {}
    of["head"] = TRUNK_BONES["head"] if "neck" in known else (*neck, *TRUNK_BONES["head"])
    shares = SPINE_SHARES | NECK_SHARES
    weights = {bone: np.array([shares[each] for each in ours]) for bone, ours in of.items()}
    return {bone: (ours, weights[bone] / weights[bone].sum()) for bone, ours in of.items()}


def _spread_twist(rest: HumanoidRest, frames: Values, side: str) -> None:
    """Turns both bones of a forearm about it by their part of what turns the hand, from an elbow that only bends; the
    hand stays where it is told."""
    places = rest.figures.space.skeleton.places
    upper, fore, hand = (frames[places[f"{name}.{side}"]].copy() for name in ("upperarm02", "lowerarm01", "wrist"))
    along = hanging(*FOREARM, side)
    way = upper.T @ fore @ along
    _, up, ahead = along
    bend = np.arctan2(way[2], -way[1]) - np.arctan2(ahead, -up)  # about x, as elbows do
    hinge = Rotation.from_rotvec([-bend, 0.0, 0.0]).as_matrix()
    elbow = upper @ shortest_turn(hinge @ along, way) @ hinge
    about = fore @ along
    twist = twist_about(hand @ elbow.T, about)
    at = [places[f"{name}.{side}"] for name in (*TWIST, "wrist")]
    parts = np.stack([Rotation.from_rotvec(share * twist * about).as_matrix() @ elbow for share in TWIST.values()])
    ways = np.diff(rest.resting.joints[at], axis=0)
    reached = (parts @ rest.resting.stand[at[:-1]] @ ways[:, :, None]).sum(axis=(0, 2))
    t_pose = rest.places[rest.names.index(f"{VRM_SIDE[side]}Hand")]
    wanted = fore @ rest.frames[at[0]].T @ t_pose
    frames[at[:-1]] = shortest_turn(unit(reached), unit(wanted)) @ parts


def _ankles(rest: HumanoidRest, frames: Values, travel: Values) -> Points:
    """Where both ankles are (2, 3), metres. travel: of the hips, leg lengths."""
    skeleton = rest.figures.space.skeleton
    placed = place_bones(skeleton, rest.resting.joints, rest.resting.stand, frames, travel * rest.resting.leg)
    return placed.joints[[skeleton.places[f"foot.{side}"] for side in SIDES]]


def _point_knees(rest: HumanoidRest, frames: Values, travel: Values) -> None:
    """Turns thighs about themselves, so that they say where a bent knee is: legs are solved from that."""
    skeleton = rest.figures.space.skeleton
    joints = place_bones(skeleton, rest.resting.joints, rest.resting.stand, frames, travel).joints
    for side in SIDES:
        places = [skeleton.places[f"{name}.{side}"] for name in ("upperleg01", "lowerleg01", "foot")]
        hip, knee, ankle = joints[places]
        thigh, shin = (way / np.linalg.norm(way) for way in (knee - hip, ankle - knee))
        bend = np.arctan2(np.linalg.norm(np.cross(thigh, shin)), thigh @ shin)
        sure = np.interp(bend, BENT, (0.0, 1.0))
        if sure > 0.0:
            ahead = frames[places[0]][:, 2]
            aside = -shin
            told, wanted = (way - thigh * (way @ thigh) for way in (ahead, aside))
            angle = np.arctan2(thigh @ np.cross(told, wanted), told @ wanted)
            turn = Rotation.from_rotvec(sure * angle * thigh).as_matrix()
            for name in ("upperleg01", "upperleg02"):
                place = skeleton.places[f"{name}.{side}"]
                frames[place] = turn @ frames[place]


def _vectors(rest: HumanoidRest, frames: Values) -> Values:
    """The rotation vector (J, 3) of each bone against its parent; of two that say the same, that of an arm that went
    up in front or at the side, as arms do."""
    skeleton = rest.figures.space.skeleton
    above = np.where(skeleton.parents[:, None, None] < 0, np.eye(3), frames[skeleton.parents])
    vectors = Rotation.from_matrix(above.transpose(0, 2, 1) @ frames).as_rotvec()
    for side in SIDES:
        arm = skeleton.places[f"upperarm01.{side}"]
        angle = np.linalg.norm(vectors[arm])
        other = 2.0 * np.pi - angle
        if other < LARGEST_TURN and vectors[arm] @ [-1.0, 0.0, OUT[side]] < 0.0:
            vectors[arm] *= -other / angle
    return np.asarray(vectors)
