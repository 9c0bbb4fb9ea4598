"""The T-pose of a figure, in which VRM wants avatars to rest: arms and fingers along x, palms down, legs straight.

VRM Consortium, VRMC_vrm-1.0, "T-pose": https://github.com/vrm-c/vrm-specification/blob/master/specification/VRMC_vrm-1.0
"""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.model.body.posed_bones import PosedBones, place_bones
from omote.model.body.skeleton import SIDES, Skeleton
from omote.model.body.stand import (
    FOREARM,
    HAND,
    KNEE,
    OUT,
    PALM,
    TOES_OUT,
    TWIST,
    UPPER_ARM,
    frame,
    hanging,
    shortest_turn,
)
from omote.perform.figures.figure import RestingFigure

AHEAD = np.array([0.0, 0.0, 1.0])
DOWN = np.array([0.0, -1.0, 0.0])
BONES_OF_A_FINGER = 3
FINGERS = 5
THUMB = 1


def pose_t(skeleton: Skeleton, resting: RestingFigure, ends: Points, /) -> PosedBones:
    """The bones of a figure in T-pose; trunk, neck, head and shoulders are as modelled.

    skeleton: of the figure; resting: of `resting_figure`; ends (J, 3): where its bones end as modelled, metres.
    """
    frames = np.tile(np.eye(3), (len(skeleton.names), 1, 1))
    for side in SIDES:
        for names, turn in {**_arm(side), **_leg(side)}.items():
            frames[[skeleton.places[f"{name}.{side}"] for name in names]] = turn
        _straighten_fingers(skeleton, resting, ends, side, frames)
    return place_bones(skeleton, resting.joints, resting.stand, frames, np.zeros(3))


def _arm(side: str) -> dict[tuple[str, ...], Values]:
    """The rotation from the stand of each bone from the elbow's both sides down to the hand.

    Elbows bend forward, as in the stand; what turns the palm down is spread over the forearm as it is there.
    """
    out = np.array([OUT[side], 0.0, 0.0])
    upper = frame(out, np.cross(out, AHEAD).tolist()) @ frame(hanging(*UPPER_ARM, side), [-1.0, 0.0, 0.0]).T
    fore = shortest_turn(upper @ hanging(*FOREARM, side), out) @ upper
    inward = math.radians(PALM)
    thumb = [-OUT[side] * math.sin(inward), 0.0, math.cos(inward)]
    hand = frame(out, AHEAD) @ frame(hanging(*HAND, side), thumb).T
    x, y, z, w = Rotation.from_matrix(hand @ fore.T).as_quat()
    twist = 2.0 * math.atan2(float(np.dot([x, y, z], out)), float(w))
    turns: dict[tuple[str, ...], Values] = {("upperarm01", "upperarm02"): upper}
    for name, share in TWIST.items():
        turns[(name,)] = Rotation.from_rotvec(share * twist * out).as_matrix() @ fore
    return turns | {("wrist", *(f"metacarpal{number}" for number in range(1, FINGERS))): hand}


def _leg(side: str) -> dict[tuple[str, ...], Values]:
    """The rotation from the stand of each bone of a leg: straight down, the foot straight ahead."""
    foot = Rotation.from_rotvec([0.0, -OUT[side] * math.radians(TOES_OUT), 0.0]).as_matrix()
    return {
        ("upperleg01", "upperleg02"): shortest_turn(hanging(0.0, KNEE, side), DOWN),
        ("lowerleg01", "lowerleg02"): shortest_turn(hanging(0.0, -KNEE, side), DOWN),
        ("foot", "toes"): foot,
    }


def _straighten_fingers(skeleton: Skeleton, resting: RestingFigure, ends: Points, side: str, frames: Values) -> None:
    """Lays the fingers along x and the thumb half forward, each bone from where the hand has it."""
    wrist = skeleton.places[f"wrist.{side}"]
    for finger in range(1, FINGERS + 1):
        way = np.array([OUT[side], 0.0, 1.0 if finger == THUMB else 0.0])
        way /= np.linalg.norm(way)
        for number in range(1, BONES_OF_A_FINGER + 1):
            bone = skeleton.places[f"finger{finger}-{number}.{side}"]
            along = frames[wrist] @ resting.stand[bone] @ (ends[bone] - resting.joints[bone])
            frames[bone] = shortest_turn(along / np.linalg.norm(along), way) @ frames[wrist]
