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
from omote.inputs.camera.body_points import BodyPoints
from omote.inputs.camera.head_pose import LENS

EAR = 7
SHOULDER = 11
ELBOW = 13
WRIST = 15
LITTLE = 17
INDEX = 19
HIP = 23
"""Points of the left side; those of the right are the next ones."""
LEAST_SEEN = 0.4
WELL_SEEN = 0.7
"""Of visibility, 0..1: below the first a point says nothing, above the second all."""
TRUNK_SHARES = {"spine": 0.3, "chest": 0.35, "upperChest": 0.35}
"""Of the trunk's rotation vector."""
TRUNK_LOWEST = np.radians([-25.0, -60.0, -35.0])
TRUNK_HIGHEST = np.radians([60.0, 60.0, 35.0])
"""Forward, to the left, leant to the right."""
BACK = 1.4
"""From the seat to the shoulders, of the distance between these: by so much who leans ahead comes nearer at most."""
USUAL_LIMBS = np.array([0.80, 0.77])
"""Upper arm and forearm, of the distance between the shoulders as the model has it."""
HANGING = math.cos(math.radians(25.0))
HANGING_LONGER = 1.015
"""How much longer than it is drawn an arm is that hangs: it is bent a little."""
SHORTEST = 0.88
"""Of a limb's length: what is drawn shorter than that points to the camera, or from it, whatever the model says."""
STEADY_BACK = 0.985
"""Of the back as drawn at rest: within that nothing is said of a lean."""
CLAVICLE = 0.42
"""Its length, of the distance between the shoulders."""
SHRUG = math.radians(28.0)
"""The most that a shoulder is lifted."""
HINGE_FIRM = 0.3
"""The sine of an elbow's bend at which its axis comes from the points as much as from how an arm usually bends."""
HAND_SWING = math.radians(70.0)
HAND_TWIST = math.radians(100.0)
"""The most that a hand goes away from the forearm, and turns about it."""
FINGERS = {
    f"{finger}{joint}": np.array([0.0, 0.0, -math.sin(0.5 * math.radians(bend)), math.cos(0.5 * math.radians(bend))])
    for finger in ("Index", "Middle", "Ring", "Little")
    for joint, bend in (("Proximal", 18.0), ("Intermediate", 24.0), ("Distal", 14.0))
}
"""How fingers rest, of which nothing is seen: as of a hand that holds nothing."""
ALONG = np.array([1.0, 0.0, 0.0])
HINGE = np.array([0.0, -1.0, 0.0])
AHEAD = np.array([0.0, 0.0, 1.0])
UP = np.array([0.0, 1.0, 0.0])
"""Of the left arm in T-pose: along it, the axis about which its elbow bends, and where its thumb's side points."""


@dataclass(frozen=True, eq=False)
class BodyRest:
    """How a performer is before the camera when nothing is played; lengths in distances between the shoulders.

    trunk (3, 3): how the trunk is turned in the camera's axes; neck: how far ears are above the shoulders; distance: of
    the shoulders from the camera; back: from hips to shoulders in the picture; lean: forward, by the model's depth,
    radians; limbs (2,): the lengths of upper arm and forearm.
    """

    trunk: Values
    neck: float
    distance: float
    back: float
    lean: float
    limbs: Values


@dataclass(frozen=True, eq=False)
class SolvedBody:
    """What one frame shows. bones: quaternions (4,), x, y, z, w, by VRM's names; trunk, left, right: how far the trunk
    and each arm are seen, 0..1; bones of an arm that is not seen are missing."""

    bones: Mapping[str, Values]
    trunk: float
    left: float
    right: float


def measure_rest(frames: list[BodyPoints]) -> BodyRest | None:
    """A performer at rest: the median of what some frames show; None where none of them shows both shoulders."""
    seen = [frame for frame in frames if frame.found and _seen(frame, SHOULDER, SHOULDER + 1) > 0.0]
    if not seen:
        return None
    trunks = Rotation.from_matrix([_trunk(frame, 0.0) for frame in seen]).mean().as_matrix()
    necks, distances, backs, leans, limbs = (
        np.median([measure(frame) for frame in seen], axis=0)
        for measure in (_neck, _distance, _back, _deep_lean, _hanging_limbs)
    )
    return BodyRest(np.asarray(trunks), float(necks), float(distances), float(backs), float(leans), np.asarray(limbs))


def solve_body(frame: BodyPoints, rest: BodyRest) -> SolvedBody:
    """The bones that a frame shows; nothing is seen where it has no body.

    A picture says exactly where a point is seen, and a model only guesses how deep: what is seen of a limb, by its
    length, bounds the depth that is taken from the model.

    frame: of the camera; rest: how its performer is at rest.
    """
    trunk_seen = _seen(frame, SHOULDER, SHOULDER + 1) if frame.found else 0.0
    if trunk_seen == 0.0:
        return SolvedBody({}, 0.0, 0.0, 0.0)
    heading = _heading(rest.trunk)
    turned = heading.T @ _trunk(frame, _lean(frame, rest)) @ rest.trunk.T @ heading
    vector = Rotation.from_matrix(turned).as_rotvec().clip(TRUNK_LOWEST, TRUNK_HIGHEST)
    bones = {name: Rotation.from_rotvec(share * vector).as_quat() for name, share in TRUNK_SHARES.items()}
    before_chest = heading @ Rotation.from_rotvec(vector).as_matrix()
    shrug = min(SHRUG, math.asin(min(0.9, max(0.0, (rest.neck - _neck(frame)) / CLAVICLE))))
    weights = frame.visible
    seen = []
    for number, name in enumerate(("left", "right")):
        seen.append(trunk_seen * min(_share(weights[point + number]) for point in (SHOULDER, ELBOW, WRIST)))
        if seen[-1] > 0.0:
            mirror = np.array([1.0 - 2.0 * number, 1.0, 1.0])
            ways = _arm_ways(frame, rest, number) @ before_chest * mirror
            hand = min(_share(weights[point + number]) for point in (INDEX, LITTLE))
            flip = np.array([1.0, mirror[0], mirror[0], 1.0])
            bones |= {f"{name}{bone}": flip * turn for bone, turn in _arm(ways, shrug, hand).items()}
    return SolvedBody(bones, trunk_seen, seen[0], seen[1])


def _arm_ways(frame: BodyPoints, rest: BodyRest, number: int) -> Points:
    """Along the upper arm, the forearm and the palm, and from the little finger to the index, (4, 3), in the camera's
    axes. number: 0 for the left, 1 for the right."""
    points = frame.points
    wide = _wide(frame)
    rays = np.column_stack([_rays(frame), np.full(len(points), -1.0)])
    across = points[SHOULDER] - points[SHOULDER + 1]
    nearer = 0.5 * float(across[2]) / wide * (1.0 - 2.0 * number)
    shoulder = (_distance(frame) - nearer) * rays[SHOULDER + number]
    places = [shoulder]
    for start, end, length in ((SHOULDER, ELBOW, rest.limbs[0]), (ELBOW, WRIST, rest.limbs[1])):
        deeper = -float(points[end + number, 2] - points[start + number, 2]) / wide
        places.append(_reach(places[-1], rays[end + number], float(length), deeper))
    wrist = places[-1]
    index, little = (
        (-wrist[2] - (points[point + number, 2] - points[WRIST + number, 2]) / wide) * rays[point + number]
        for point in (INDEX, LITTLE)
    )
    return np.stack([places[1] - shoulder, wrist - places[1], 0.5 * (index + little) - wrist, index - little])


def _reach(start: Points, ray: Values, length: float, deeper: float) -> Points:
    """Where a limb ends that is seen along a ray (3,) from the camera, of which z is -1.

    start (3,): where it begins, from the camera; length: its own; deeper: by how much its end is farther away, as the
    model has it.
    """
    square = float(ray @ ray)
    middle = float(ray @ start) / square

    def half(reach: float) -> float:
        return math.sqrt(max(0.0, middle * middle - (float(start @ start) - reach * reach) / square))

    off = -start[2] + deeper - middle
    depth = middle + math.copysign(min(max(abs(off), half(SHORTEST * length)), half(length)), off)
    return np.asarray(depth * ray)


def _arm(ways: Points, shrug: float, hand_seen: float) -> dict[str, Values]:
    """The bones of a left arm. ways (4, 3): of `_arm_ways`, before the chest; shrug: radians; hand_seen: 0..1."""
    upper, fore, palm = (_unit(way) for way in ways[:3])
    usual = _swing(ALONG, upper).apply(HINGE)
    hinge = np.cross(upper, fore) + HINGE_FIRM * usual
    clavicle = Rotation.from_rotvec([0.0, 0.0, shrug])
    arm = _frame(upper, hinge) * _frame(ALONG, HINGE).inv()
    elbow_bend = _swing(arm.apply(ALONG), fore)
    forearm = elbow_bend * arm
    hand = _frame(palm, ways[3]) * _frame(ALONG, AHEAD).inv()
    own = _limit_hand(forearm.inv() * hand)
    return {
        "Shoulder": clavicle.as_quat(),
        "UpperArm": (clavicle.inv() * arm).as_quat(),
        "LowerArm": (arm.inv() * forearm).as_quat(),
        "Hand": Rotation.from_rotvec(hand_seen * own.as_rotvec()).as_quat(),
        **FINGERS,
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


def _trunk(frame: BodyPoints, lean: float) -> Values:
    """How the trunk is turned (3, 3) in the camera's axes: along its shoulders, and up from the hips as far as these
    are seen. lean: forward of upright, radians."""
    points = frame.points
    rays = _rays(frame)
    drawn = (rays[SHOULDER] - rays[SHOULDER + 1]) * _distance(frame)
    across = _unit(np.array([*drawn, (points[SHOULDER] - points[SHOULDER + 1])[2] / _wide(frame)]))
    hips = _seen(frame, HIP, HIP + 1)
    from_hips = _unit(np.array([*(_middle(rays, SHOULDER) - _middle(rays, HIP)), 0.0]))
    up = hips * from_hips + (1.0 - hips) * UP
    return np.asarray(_frame(across, math.cos(lean) * up + math.sin(lean) * _unit(np.cross(across, up))).as_matrix())


def _lean(frame: BodyPoints, rest: BodyRest) -> float:
    """Forward of rest, radians: by how near the shoulders have come, or, where hips are seen, by the model's depth as
    far as the back is drawn shorter."""
    nearer = math.asin(min(0.8, max(-0.3, (rest.distance - _distance(frame)) / BACK)))
    hips = _seen(frame, HIP, HIP + 1)
    if hips == 0.0:
        return nearer
    drawn = _back(frame) / rest.back
    least, most = (math.acos(min(1.0, share * drawn)) for share in (2.0 - STEADY_BACK, STEADY_BACK))
    deep = _deep_lean(frame) - rest.lean
    return hips * math.copysign(min(max(abs(deep), least), most), deep) + (1.0 - hips) * nearer


def _heading(trunk: Values) -> Values:
    """The part (3, 3) of a rotation (3, 3) about the upright axis: where a performer looks who sits askew."""
    return np.asarray(Rotation.from_rotvec(math.atan2(trunk[0, 2], trunk[2, 2]) * UP).as_matrix())


def _neck(frame: BodyPoints) -> float:
    """How far ears are above the shoulders, of the distance between these."""
    rays = _rays(frame)
    across = rays[SHOULDER] - rays[SHOULDER + 1]
    up = np.array([-across[1], across[0]]) / max(float(np.linalg.norm(across)), 1e-9)
    return float((_middle(rays, EAR) - _middle(rays, SHOULDER)) @ up * _distance(frame))


def _distance(frame: BodyPoints) -> float:
    """Of the shoulders from the camera, in distances between them, by how large they are in the picture."""
    rays = _rays(frame)
    drawn = max(float(np.linalg.norm(rays[SHOULDER] - rays[SHOULDER + 1])), 1e-3)
    across = frame.points[SHOULDER] - frame.points[SHOULDER + 1]
    return float(np.linalg.norm(across[:2])) / _wide(frame) / drawn


def _back(frame: BodyPoints) -> float:
    """From hips to shoulders as drawn, in distances between the shoulders."""
    rays = _rays(frame)
    return max(1e-3, float(np.linalg.norm(_middle(rays, SHOULDER) - _middle(rays, HIP))) * _distance(frame))


def _deep_lean(frame: BodyPoints) -> float:
    """How far the trunk leans forward by the model's depth, radians."""
    _, up, ahead = _middle(frame.points, SHOULDER) - _middle(frame.points, HIP)
    return math.atan2(ahead, up)


def _hanging_limbs(frame: BodyPoints) -> Values:
    """The lengths of upper arm and forearm (2,) of arms that hang, in distances between the shoulders; the usual ones
    where they are not seen, or do not hang."""
    rays = _rays(frame) * _distance(frame)
    lengths = np.empty((2, 2))
    for number in range(2):
        if _seen(frame, ELBOW + number, WRIST + number) == 0.0:
            return USUAL_LIMBS
        ways = np.diff([rays[point + number] for point in (SHOULDER, ELBOW, WRIST)], axis=0)
        if (-ways[:, 1] < HANGING * np.linalg.norm(ways, axis=1)).any():
            return USUAL_LIMBS
        lengths[number] = np.linalg.norm(ways, axis=1)
    return np.asarray((HANGING_LONGER * lengths.mean(axis=0)).clip(0.75 * USUAL_LIMBS, 1.25 * USUAL_LIMBS))


def _rays(frame: BodyPoints) -> Points:
    """Where each point is seen (33, 2), at a distance of one from the camera: x to the performer's left, y up."""
    return (frame.picture - [0.5, 0.5 * frame.height / frame.width]) * [1.0, -1.0] / LENS


def _wide(frame: BodyPoints) -> float:
    """Between the shoulders, metres, as the model has it."""
    return max(float(np.linalg.norm(frame.points[SHOULDER] - frame.points[SHOULDER + 1])), 0.05)


def _middle(places: Points, left: int) -> Points:
    """Between a point of the left and its like of the right."""
    return np.asarray(0.5 * (places[left] + places[left + 1]))


def _seen(frame: BodyPoints, *points: int) -> float:
    """How far all of some points are seen, 0..1."""
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
