"""Bones of a humanoid from the points of a body: arms, shoulders and the trunk's lean and turn.

Rotations are those of VRM 1.0's humanoid: against the bone above, counted from the T-pose, along the character's axes
(x to its left, y up, z ahead). The right side is solved as the left of a mirror.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.inputs.camera.body_frame import BodyFrame
from omote.inputs.camera.head_pose import LENS

EAR, SHOULDER, ELBOW, WRIST, LITTLE, INDEX, HIP = 7, 11, 13, 15, 17, 19, 23
"""Points of the left side; those of the right are the next ones."""
LEAST_SEEN = 0.4
WELL_SEEN = 0.7
"""Of visibility, 0..1: below the first a point says nothing, above the second all."""
TRUNK_SHARES = {"spine": 0.3, "chest": 0.35, "upperChest": 0.35}
"""Of the trunk's rotation vector."""
TRUNK_LOWEST = np.radians([-25.0, -60.0, -35.0])
TRUNK_HIGHEST = np.radians([60.0, 60.0, 35.0])
"""Forward, to the left, leant to the right."""
TRUNK_LENGTH = 0.48
"""Metres from the seat to the shoulders: by so much who leans ahead comes nearer to the camera."""
CLAVICLE = 0.42
"""Its length, of the distance between the shoulders."""
SHRUG = math.radians(28.0)
"""The most that a shoulder is lifted."""
HINGE_FIRM = 0.3
"""The sine of an elbow's bend at which its axis comes from the points as much as from how an arm usually bends."""
HAND_SWING = math.radians(70.0)
HAND_TWIST = math.radians(100.0)
"""The most that a hand goes away from the forearm, and turns about it."""
ALONG = np.array([1.0, 0.0, 0.0])
HINGE = np.array([0.0, -1.0, 0.0])
AHEAD = np.array([0.0, 0.0, 1.0])
UP = np.array([0.0, 1.0, 0.0])
"""Of the left arm in T-pose: along it, the axis about which its elbow bends, and where its thumb's side points."""


@dataclass(frozen=True, eq=False)
class BodyRest:
    """How a performer is before the camera when nothing is played. trunk (3, 3): how the trunk is turned in the
    camera's axes; neck: how far ears are above the shoulders, of the distance between these; distance: of the shoulders
    from the camera, metres."""

    trunk: Values
    neck: float
    distance: float


@dataclass(frozen=True, eq=False)
class BodyBones:
    """What one frame shows. bones: quaternions (4,), x, y, z, w, by VRM's names; trunk, left, right: how far the trunk
    and each arm are seen, 0..1; bones of an arm that is not seen are missing."""

    bones: Mapping[str, Values]
    trunk: float
    left: float
    right: float


def measure_rest(frames: list[BodyFrame]) -> BodyRest | None:
    """A performer at rest: the median of what some frames show; None where none of them shows both shoulders."""
    seen = [frame for frame in frames if frame.found and _seen(frame, SHOULDER, SHOULDER + 1) > 0.0]
    if not seen:
        return None
    trunks = Rotation.from_matrix([_trunk(frame, 0.0) for frame in seen]).mean().as_matrix()
    necks, distances = ([measure(frame) for frame in seen] for measure in (_neck, _distance))
    return BodyRest(np.asarray(trunks), float(np.median(necks)), float(np.median(distances)))


def solve_bones(frame: BodyFrame, rest: BodyRest) -> BodyBones:
    """The bones that a frame shows; nothing is seen where it has no body.

    frame: of the camera; rest: how its performer is at rest.
    """
    trunk_seen = _seen(frame, SHOULDER, SHOULDER + 1) if frame.found else 0.0
    if trunk_seen == 0.0:
        return BodyBones({}, 0.0, 0.0, 0.0)
    lean = math.asin(min(0.8, max(-0.3, (rest.distance - _distance(frame)) / TRUNK_LENGTH)))
    heading = _heading(rest.trunk)
    turned = heading.T @ _trunk(frame, lean) @ rest.trunk.T @ heading
    vector = Rotation.from_matrix(turned).as_rotvec().clip(TRUNK_LOWEST, TRUNK_HIGHEST)
    bones = {name: Rotation.from_rotvec(share * vector).as_quat() for name, share in TRUNK_SHARES.items()}
    points = frame.points @ heading @ Rotation.from_rotvec(vector).as_matrix()  # as they lie before the chest
    shrug = min(SHRUG, math.asin(min(0.9, max(0.0, (rest.neck - _neck(frame)) / CLAVICLE))))
    seen = []
    for number, name in enumerate(("left", "right")):
        weights = frame.visible
        seen.append(trunk_seen * min(_share(weights[point + number]) for point in (SHOULDER, ELBOW, WRIST)))
        if seen[-1] > 0.0:
            side = points * (1.0, 1.0, 1.0) if number == 0 else points * (-1.0, 1.0, 1.0)
            hand = min(_share(weights[point + number]) for point in (INDEX, LITTLE))
            flip = np.array([1.0, 1.0, 1.0, 1.0] if number == 0 else [1.0, -1.0, -1.0, 1.0])
            bones |= {f"{name}{bone}": flip * turn for bone, turn in _arm(side, number, shrug, hand).items()}
    return BodyBones(bones, trunk_seen, *seen)


def _arm(points: Points, number: int, shrug: float, hand_seen: float) -> dict[str, Values]:
    """The bones of a left arm. points (33, 3): before the chest; number: 1 for points of a right arm in a mirror;
    shrug: radians; hand_seen: 0..1."""
    shoulder, elbow, wrist, little, index = (
        points[point + number] for point in (SHOULDER, ELBOW, WRIST, LITTLE, INDEX)
    )
    upper, fore = _unit(elbow - shoulder), _unit(wrist - elbow)
    usual = _swing(ALONG, upper).apply(HINGE)
    hinge = np.cross(upper, fore) + HINGE_FIRM * usual
    clavicle = Rotation.from_rotvec([0.0, 0.0, shrug])
    arm = _frame(upper, hinge) * _frame(ALONG, HINGE).inv()
    elbow_bend = _swing(arm.apply(ALONG), fore)
    forearm = elbow_bend * arm
    palm = 0.5 * (index + little) - wrist
    hand = _frame(_unit(palm), index - little) * _frame(ALONG, AHEAD).inv()
    own = _limit_hand(forearm.inv() * hand)
    return {
        "Shoulder": clavicle.as_quat(),
        "UpperArm": (clavicle.inv() * arm).as_quat(),
        "LowerArm": (arm.inv() * forearm).as_quat(),
        "Hand": Rotation.from_rotvec(hand_seen * own.as_rotvec()).as_quat(),
    }


def _limit_hand(turn: Rotation) -> Rotation:
    """A hand's rotation against the forearm as far as wrists go: its turn about the forearm, and its swing, apart."""
    x, _, _, w = turn.as_quat(canonical=True)
    twist = 2.0 * math.atan2(x, w)
    swing = (turn * Rotation.from_rotvec(-twist * ALONG)).as_rotvec()
    angle = float(np.linalg.norm(swing))
    swing *= min(1.0, HAND_SWING / max(angle, 1e-9))
    twist = min(HAND_TWIST, max(-HAND_TWIST, math.remainder(twist, 2.0 * math.pi)))
    return Rotation.from_rotvec(swing) * Rotation.from_rotvec(twist * ALONG)


def _trunk(frame: BodyFrame, lean: float) -> Values:
    """How the trunk is turned (3, 3) in the camera's axes: along its shoulders, and up from the hips as far as these
    are seen. lean: forward of upright by the shoulders' distance, radians, where hips are not seen."""
    points = frame.points
    across = _unit(points[SHOULDER] - points[SHOULDER + 1])
    hips = _seen(frame, HIP, HIP + 1)
    from_hips = _unit(points[[SHOULDER, SHOULDER + 1]].mean(axis=0) - points[[HIP, HIP + 1]].mean(axis=0))
    guessed = math.cos(lean) * UP + math.sin(lean) * _unit(np.cross(across, UP))
    return np.asarray(_frame(across, hips * from_hips + (1.0 - hips) * guessed).as_matrix())


def _heading(trunk: Values) -> Values:
    """The part (3, 3) of a rotation (3, 3) about the upright axis: where a performer looks who sits askew."""
    return np.asarray(Rotation.from_rotvec(math.atan2(trunk[0, 2], trunk[2, 2]) * UP).as_matrix())


def _neck(frame: BodyFrame) -> float:
    """How far ears are above the shoulders, of the distance between these."""
    points = frame.points
    across = points[SHOULDER] - points[SHOULDER + 1]
    up = _unit(UP - across * (across @ UP) / (across @ across))
    middle = points[[EAR, EAR + 1]].mean(axis=0) - points[[SHOULDER, SHOULDER + 1]].mean(axis=0)
    return float(middle @ up / np.linalg.norm(across))


def _distance(frame: BodyFrame) -> float:
    """Of the shoulders from the camera, metres, by how large they are in the picture."""
    across = frame.points[SHOULDER] - frame.points[SHOULDER + 1]
    drawn = frame.picture[SHOULDER] - frame.picture[SHOULDER + 1]
    return float(LENS * np.linalg.norm(across[:2]) / max(np.linalg.norm(drawn), 1e-3))


def _seen(frame: BodyFrame, *points: int) -> float:
    visible = frame.visible
    return min(_share(visible[point]) for point in points)


def _share(visible: float) -> float:
    """0..1 by how visible a point is, without a corner at either end."""
    along = min(1.0, max(0.0, (visible - LEAST_SEEN) / (WELL_SEEN - LEAST_SEEN)))
    return float(along * along * (3.0 - 2.0 * along))


def _frame(along: Values, about: Values) -> Rotation:
    """The rotation of a frame: its first axis, and the part of another way that stands on it (of any, where none
    does)."""
    square = about - along * (about @ along)
    if square @ square < 1e-12:
        square = np.cross(along, np.roll(along, 1) + ALONG)
    square = _unit(square)
    return Rotation.from_matrix(np.stack([along, square, np.cross(along, square)], axis=1))


def _swing(before: Values, after: Values) -> Rotation:
    """The smallest rotation that takes one direction (3,) to another."""
    axis = np.cross(before, after)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-9:
        return Rotation.identity()
    return Rotation.from_rotvec(axis / sine * math.atan2(sine, float(before @ after)))


def _unit(way: Values) -> Values:
    """Of length one; straight up where it has none."""
    length = float(np.linalg.norm(way))
    return np.asarray(way / length) if length > 1e-9 else UP
