"""The pose of a skeleton that a recipe describes: anatomical degrees as rotation vectors of bones."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Values
from omote.model.body.pose import Pose
from omote.model.body.pose_recipe import Arm, PoseRecipe, Turn
from omote.model.body.skeleton import SIDES, Skeleton

SPINE_SHARES = {"spine05": 0.15, "spine04": 0.20, "spine03": 0.20, "spine02": 0.25, "spine01": 0.20}
"""Of the trunk's bend: the middle of the back bends most."""
NECK_SHARES = {"neck01": 0.2, "neck02": 0.2, "neck03": 0.2, "head": 0.4}
FOREARM_SHARES = {"lowerarm01": 0.15, "lowerarm02": 0.55, "wrist": 0.30}
"""Of the forearm's turn, which bones make it (candy wrappers: smallest radius .96 for a turn of 150 degrees)."""
FINGER_SHARES = (0.30, 0.42, 0.28)
"""Of a finger's curl of 250 degrees, by its joints."""
FIST = 250.0
THUMB_FIST = 110.0
SPREAD = 10.0
"""Degrees between neighbouring fingers at a spread of 1."""


def pose_of(recipe: PoseRecipe, skeleton: Skeleton, name: str, label: str = "") -> Pose:
    """The pose that a recipe describes, of this skeleton; ValueError where a number is out of range.

    name, label: what programs and what people call it.
    """
    turns = np.zeros((len(skeleton.names), 3))

    def put(bone: str, vector: Values) -> None:
        turns[skeleton.places[bone]] += vector

    put("root", _bend(recipe.turn))
    for shares, bend in ((SPINE_SHARES, recipe.trunk), (NECK_SHARES, recipe.head)):
        for bone, share in shares.items():
            put(bone, share * _bend(bend))
    feet = []
    for side, arm, leg in zip(SIDES, (recipe.left, recipe.right), (recipe.left_leg, recipe.right_leg), strict=True):
        out = 1.0 if side == "L" else -1.0
        for bone, vector in {**_arm_turns(arm, out), **_hand_turns(arm, out)}.items():
            put(f"{bone}.{side}", vector)
        put(f"upperleg01.{side}", np.array([0.0, out * math.radians(leg.knee), 0.0]))
        put(f"toes.{side}", np.array([-math.radians(leg.toes), 0.0, 0.0]))
        feet.append(([out * leg.at[0], leg.at[1], leg.at[2]], _foot_turn(leg.foot, out)))
    places, foot_turns = (np.array(each) for each in zip(*feet, strict=True))
    return Pose(name, turns, np.array(recipe.hips), places, foot_turns, label)


def _bend(turn: Turn) -> Values:
    """The rotation vector of a trunk, a neck or hips: forward about x, to the left about y, leant to the left about
    -z."""
    forward, left, lean = np.radians(turn)
    return _vector(Rotation.from_rotvec([0.0, left, 0.0]) * Rotation.from_rotvec([forward, 0.0, -lean]))


def _arm_turns(arm: Arm, out: float) -> Mapping[str, Values]:
    """By bone without its side; out: 1 for the left, -1 for the right."""
    elbow, forearm, shrug, reach = np.radians([arm.elbow, arm.forearm, arm.shrug, arm.reach])
    bend, aside = np.radians(arm.wrist)
    turns = {
        "clavicle": np.array([0.0, -out * reach, out * shrug]),
        "upperarm01": _vector(Rotation.from_matrix(arm_turn(arm, out))),
        "lowerarm01": np.array([-elbow, 0.0, 0.0]),
    }
    about = np.array([0.0, -out * forearm, 0.0])
    for bone, share in FOREARM_SHARES.items():
        turns[bone] = turns.get(bone, np.zeros(3)) + share * about
    turns["wrist"] = turns["wrist"] + np.array([-aside, 0.0, -out * bend])
    return turns


def arm_turn(arm: Arm, out: float) -> Values:
    """The rotation (3, 3) of an upper arm from the stand. out: 1 for the left, -1 for the right."""
    raised, spread, twist = np.radians([arm.raised, arm.spread, arm.twist])
    swing = Rotation.from_rotvec([-raised, 0.0, out * spread])  # its length is how far the arm has left hanging
    return np.asarray((swing * Rotation.from_rotvec([0.0, -out * twist, 0.0])).as_matrix())


def _hand_turns(arm: Arm, out: float) -> Mapping[str, Values]:
    """Fingers curl to the palm, which faces the thigh in the stand: about the axis ahead."""
    turns: dict[str, Values] = {}
    for finger, curl in enumerate(arm.curls[1:], start=2):
        for joint, share in enumerate(FINGER_SHARES, start=1):
            turns[f"finger{finger}-{joint}"] = np.array([0.0, 0.0, -out * math.radians(FIST * share * curl)])
        fan = math.radians(SPREAD * arm.fan * (3.5 - finger))
        turns[f"finger{finger}-1"] = turns[f"finger{finger}-1"] + np.array([-fan, 0.0, 0.0])
    thumb = math.radians(THUMB_FIST * arm.curls[0])
    turns["finger1-1"] = np.array([0.3 * thumb, 0.0, -out * 0.2 * thumb])
    turns["finger1-2"] = np.array([0.4 * thumb, 0.0, 0.0])
    turns["finger1-3"] = np.array([0.5 * thumb, 0.0, 0.0])
    return turns


def _foot_turn(foot: Turn, out: float) -> Values:
    up, outward, inner = np.radians(foot)
    return _vector(Rotation.from_rotvec([0.0, out * outward, 0.0]) * Rotation.from_rotvec([-up, 0.0, out * inner]))


def _vector(rotation: Rotation) -> Values:
    return np.asarray(rotation.as_rotvec())
