"""The motion of a BVH as that of VRM's humanoid: its rest is turned to the T-pose, its unit is found from the leg."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Points, Values
from omote.interchange.clips.bvh_bones import humanoid_joints
from omote.interchange.clips.bvh_reader import BvhFile, BvhJoint, read_bvh
from omote.interchange.clips.humanoid_motion import HIPS, PARENTS, HumanoidMotion, parent_among, turns_of_worlds
from omote.model.body.stand import shortest_turn

STANDING = -0.5
"""Cosine of the angle at the hips between head and feet of a rest that is a person who stands."""
FLOOR_BELOW = -0.05
FLOOR_ABOVE = 0.02
"""Of a leg, how far the lowest foot may be from y = 0 before it, and not y = 0, is the floor: below it since toes that
point down are points of the file and no soles, less above it since many files have ankles without soles."""
LOWEST_SHARE = 5.0
"""Percent of the frames whose lowest foot may be below the floor."""
REST_DEGREES = 2.0
JUMP_DEGREES = 15.0
"""A first frame whose bones are all so near to the rest, and from which one jumps so far, is the rest and no motion."""
TOES_ASIDE = math.radians(12.0)
"""By which a foot that goes ahead may seem to go aside."""
_AXES = {"X": 0, "Y": 1, "Z": 2}
_ALONG = ("Middle", "Index", "Ring", "Little")
"""The fingers along which a hand goes, the best first."""
_OUT = {"left": 1.0, "right": -1.0}


def bvh_motion(data: bytes) -> HumanoidMotion:
    """The motion of the one person of a BVH.

    data: the file.

    Raises
    ------
    ValueError
        As `read_bvh`; where its joints are not those of a person, or its rest is none who stands.
    """
    file = read_bvh(data)
    joints = file.joints
    bones = humanoid_joints(joints)
    rest = _rest_places(joints)
    axes = _axes(rest, bones)
    worlds = _world_turns(file)
    if _begins_at_rest(worlds, bones):
        file = BvhFile(joints, file.step, file.table[1:], (*file.notes, "its first frame is its rest and is left out"))
        worlds = [world[1:] for world in worlds]
    turned = Rotation.from_matrix(axes)
    t_pose = _t_pose(joints, bones, rest @ axes.T)
    told = {
        bone: turned * worlds[bones[bone]] * turned.inv() * Rotation.from_matrix(t_pose[bone].T)
        for bone in PARENTS
        if bone in bones
    }
    names, turns = turns_of_worlds(told)
    hips, notes = _hips(file, worlds, bones, rest, axes, t_pose)
    times: Values = np.arange(len(file.table), dtype=np.float64) * file.step
    return HumanoidMotion(times, names, turns, hips, notes=(*file.notes, *notes))


def _rest_places(joints: Sequence[BvhJoint]) -> Points:
    """Where joints (j, 3) are where nothing turns, the root at its offset."""
    places = np.zeros((len(joints), 3))
    for place, joint in enumerate(joints):
        places[place] = np.add(joint.offset, places[joint.parent] if joint.parent >= 0 else 0.0)
    return places


def _axes(rest: Points, bones: Mapping[str, int]) -> Values:
    """The rotation (3, 3) by quarter turns that brings up along y and left along x."""
    thighs, feet = ((rest[bones[f"left{name}"]], rest[bones[f"right{name}"]]) for name in ("UpperLeg", "Foot"))
    middle = 0.5 * (thighs[0] + thighs[1])
    tops = [bone for bone in ("head", "neck", "upperChest", "chest", "spine") if bone in bones]
    down = 0.5 * (feet[0] + feet[1]) - middle
    up = rest[bones[tops[0]]] - middle if tops else -down
    cosine = float(up @ down) / max(float(np.linalg.norm(up) * np.linalg.norm(down)), 1e-12)
    left = thighs[0] - thighs[1]
    if cosine > STANDING or not np.linalg.norm(left) > 0.0:
        raise ValueError("the rest of the file, where nothing turns, is no person who stands; export it with a T-pose")
    above = _nearest_axis(up)
    aside = _nearest_axis(left - above * (left @ above))
    return np.stack([aside, above, np.cross(aside, above)])


def _nearest_axis(way: Points) -> Points:
    axis = np.zeros(3)
    place = int(np.abs(way).argmax())
    axis[place] = math.copysign(1.0, way[place])
    return axis


def _world_turns(file: BvhFile) -> list[Rotation]:
    """The rotations of each joint along the axes of the file, (n,) each."""
    worlds: list[Rotation] = []
    still = Rotation.identity(len(file.table))
    for joint in file.joints:
        above = worlds[joint.parent] if joint.parent >= 0 else still
        turning = [(at, name[0]) for at, name in enumerate(joint.channels, joint.first) if name.endswith("rotation")]
        own = above
        for column, axis in turning:
            own = own * Rotation.from_euler(axis, file.table[:, [column]], degrees=True)
        worlds.append(own)
    return worlds


def _begins_at_rest(worlds: Sequence[Rotation], bones: Mapping[str, int]) -> bool:
    """Whether the first frame is the rest, as CMU's files by cgspeed begin."""
    if len(worlds[0]) < 2:
        return False
    used = [worlds[place] for place in bones.values()]
    away = max(math.degrees(world[0].magnitude()) for world in used)
    jump = max(math.degrees((world[0].inv() * world[1]).magnitude()) for world in used)
    return away < REST_DEGREES and jump > JUMP_DEGREES


def _t_pose(joints: Sequence[BvhJoint], bones: Mapping[str, int], rest: Points) -> dict[str, Values]:
    """The rotation (3, 3) of each bone from the rest to the T-pose, by the ways in which limbs go.

    rest (j, 3): along our axes.
    """
    turns: dict[str, Values] = {}
    for bone in (name for name in PARENTS if name in bones):
        above = parent_among(bone, bones)
        before = turns[above] if above else np.eye(3)
        wanted = _way_in_t_pose(bone)
        way = _way(joints, bones, rest, bone)
        if bone.endswith(("Foot", "Toes")):
            turns[bone] = _ahead(way) if bone.endswith("Foot") else before
        elif wanted is None or way is None:
            turns[bone] = np.eye(3) if wanted is None and not bone.endswith("Hand") else before
        else:
            turns[bone] = shortest_turn(before @ way, wanted) @ before
    return turns


def _way_in_t_pose(bone: str) -> Points | None:
    """Where a bone of a limb goes in the T-pose, a direction; None for the trunk and its shoulders."""
    side = next((side for side in _OUT if bone.startswith(side)), "")
    if not side or bone.endswith("Shoulder"):
        return None
    if bone.endswith("Leg"):
        return np.array([0.0, -1.0, 0.0])
    if "Thumb" in bone:
        return np.array([_OUT[side], 0.0, 1.0]) / math.sqrt(2.0)
    return np.array([_OUT[side], 0.0, 0.0])


def _way(joints: Sequence[BvhJoint], bones: Mapping[str, int], rest: Points, bone: str) -> Points | None:
    """Where a bone goes at rest: to the next one that is named, else to what hangs on it."""
    ends = [place for name, place in bones.items() if PARENTS[name] and parent_among(name, bones) == bone]
    if bone.endswith("Hand"):
        side = bone.removesuffix("Hand")
        ends = [bones[f"{side}{finger}Proximal"] for finger in _ALONG if f"{side}{finger}Proximal" in bones][:1]
    aside = [place for name, place in bones.items() if "Thumb" in name]
    below = [place for place, joint in enumerate(joints) if joint.parent == bones[bone]]
    hanging = ends or [place for place in below if place not in aside]
    ways = [rest[place] - rest[bones[bone]] for place in hanging]
    longest = max(ways, key=np.linalg.norm, default=np.zeros(3))
    length = float(np.linalg.norm(longest))
    return longest / length if length > 0.0 else None


def _ahead(way: Points | None) -> Values:
    """The rotation about y that brings a foot straight ahead; none for one that goes straight down, or so little aside
    that it is the shape of the foot: ankles lie inside of the toes."""
    if way is None or math.hypot(way[0], way[2]) < 0.1 or abs(math.atan2(way[0], way[2])) < TOES_ASIDE:
        return np.eye(3)
    return np.asarray(Rotation.from_rotvec([0.0, -math.atan2(way[0], way[2]), 0.0]).as_matrix())


def _hips(
    file: BvhFile, worlds: Sequence[Rotation], bones: Mapping[str, int], rest: Points, axes: Values,
    t_pose: Mapping[str, Values],
) -> tuple[Values, tuple[str, ...]]:  # fmt: skip
    """Where the hips are in each frame from where the T-pose has them, leg lengths (n, 3); and what is said of it."""
    joints = file.joints
    leg, ground = _legs(joints, bones, rest @ axes.T, t_pose)
    feet = [
        place
        for place in range(len(joints))
        if any(bones[f"{side}Foot"] in _chain(joints, place) for side in ("left", "right"))
    ]
    lowest = np.min(
        [_from_hips(joints, worlds, bones[HIPS], place) @ axes[1] for place in feet], axis=0
    )  # fmt: skip
    chain = _chain(joints, bones[HIPS])
    moving = any(name.endswith("position") for place in chain for name in joints[place].channels)
    if not moving:
        up = -lowest - ground
        hips = np.column_stack([np.zeros(len(up)), up, np.zeros(len(up))])
        return hips / leg, ("it has no places, so the lower foot is on the floor in every frame",)
    places = _hips_places(file, worlds, chain, ground) @ axes.T
    floor = float(np.percentile(places[:, 1] + lowest, LOWEST_SHARE))
    notes: tuple[str, ...] = ()
    if FLOOR_BELOW * leg < floor < FLOOR_ABOVE * leg:
        floor = 0.0
    else:
        notes = ("its floor is not at 0, so it stands where its feet are lowest",)
    return (places - [0.0, floor + ground, 0.0]) / leg, notes


def _legs(
    joints: Sequence[BvhJoint], bones: Mapping[str, int], rest: Points, t_pose: Mapping[str, Values]
) -> tuple[float, float]:
    """The length of a leg, and how high the hips are in the T-pose above the lowest of the feet, units of the file."""
    lengths = []
    heights = []
    for side in ("left", "right"):
        hip, knee, ankle = (bones[f"{side}{name}"] for name in ("UpperLeg", "LowerLeg", "Foot"))
        thigh = float(np.linalg.norm(rest[knee] - rest[hip]))
        shin = float(np.linalg.norm(rest[ankle] - rest[knee]))
        foot = [place for place in range(len(joints)) if ankle in _chain(joints, place)]
        below = min(float((t_pose[f"{side}Foot"] @ (rest[place] - rest[ankle]))[1]) for place in foot)
        lengths.append(thigh + shin)
        heights.append(float(rest[bones[HIPS], 1] - rest[hip, 1]) + thigh + shin - below)
    leg = float(np.mean(lengths))
    if not leg > 0.0:
        raise ValueError("the legs of the file have no length; export its skeleton with offsets")
    return leg, float(np.mean(heights))


def _from_hips(joints: Sequence[BvhJoint], worlds: Sequence[Rotation], hips: int, place: int) -> Points:
    """Where a joint is from the hips in each frame (n, 3), units and axes of the file."""
    found: Points = np.zeros((len(worlds[0]), 3))
    for each in _chain(joints, place):
        if each == hips:
            break
        found = found + worlds[joints[each].parent].apply(joints[each].offset)
    return found


def _hips_places(file: BvhFile, worlds: Sequence[Rotation], chain: Sequence[int], ground: float) -> Points:
    """Where the hips are in each frame (n, 3). Programs write the places of a root with its offset or without it: of
    both the one is meant in which the hips are nearer to their own height. chain: the hips and all above them."""
    told = np.zeros((len(file.table), 3))
    offsets = np.zeros_like(told)
    for place in chain:
        joint = file.joints[place]
        above = worlds[joint.parent] if joint.parent >= 0 else Rotation.identity(len(told))
        columns = [
            (at, _AXES[name[0]]) for at, name in enumerate(joint.channels, joint.first) if name.endswith("position")
        ]
        own = np.zeros_like(told)
        for column, axis in columns:
            own[:, axis] = file.table[:, column]
        told += above.apply(own if columns else np.tile(joint.offset, (len(told), 1)))
        if columns:
            offsets += above.apply(np.tile(joint.offset, (len(told), 1)))
    with_offsets = told + offsets
    heights = [float(np.median(np.abs(places).max(axis=1))) for places in (told, with_offsets)]
    return told if abs(heights[0] - ground) <= abs(heights[1] - ground) else with_offsets


def _chain(joints: Sequence[BvhJoint], place: int) -> list[int]:
    """A joint and all above it, nearest first."""
    chain = []
    while place >= 0:
        chain.append(place)
        place = joints[place].parent
    return chain
