"""Humanoids that move, and files of them as other programs write them: made here, of nobody."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from omote.interchange.clips.humanoid_motion import PARENTS, HumanoidMotion, parent_among

MIXAMO = {
    "hips": "mixamorig:Hips", "spine": "mixamorig:Spine", "chest": "mixamorig:Spine1", "upperChest": "mixamorig:Spine2",
    "neck": "mixamorig:Neck", "head": "mixamorig:Head",
    **{
        f"{side}{ours}": f"mixamorig:{side.capitalize()}{theirs}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "Shoulder", "UpperArm": "Arm", "LowerArm": "ForeArm", "Hand": "Hand", "UpperLeg": "UpLeg",
            "LowerLeg": "Leg", "Foot": "Foot", "Toes": "ToeBase", "IndexProximal": "HandIndex1",
            "IndexIntermediate": "HandIndex2", "ThumbMetacarpal": "HandThumb1",
        }.items()
    },
}  # fmt: skip
POSER = {
    "hips": "hip", "spine": "abdomen", "chest": "chest", "neck": "neck",
    **{
        f"{side}{ours}": f"{side[0]}{theirs}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "collar", "UpperArm": "shldr", "LowerArm": "forearm", "Hand": "hand", "UpperLeg": "thigh",
            "LowerLeg": "shin", "Foot": "foot",
        }.items()
    },
}  # fmt: skip
OLD = {
    "hips": "Hips", "spine": "Chest", "chest": "Chest2", "neck": "Neck", "head": "Head",
    **{
        f"{side}{ours}": f"{side.capitalize()}{theirs}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "Collar", "UpperArm": "Shoulder", "LowerArm": "Elbow", "Hand": "Wrist", "UpperLeg": "Hip",
            "LowerLeg": "Knee", "Foot": "Ankle",
        }.items()
    },
}  # fmt: skip
ROKOKO = {
    "hips": "Hips", "spine": "Spine1", "chest": "Spine2", "upperChest": "Spine3", "neck": "Neck", "head": "Head",
    **{
        f"{side}{ours}": f"{side.capitalize()}{theirs}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "Shoulder", "UpperArm": "Arm", "LowerArm": "ForeArm", "Hand": "Hand", "UpperLeg": "Thigh",
            "LowerLeg": "Shin", "Foot": "Foot", "Toes": "Toe", "IndexProximal": "Finger2Proximal",
        }.items()
    },
}  # fmt: skip
UNITY = {
    **{bone: bone[0].upper() + bone[1:] for bone in ("hips", "spine", "chest", "upperChest", "neck", "head")},
    **{
        f"{side}{bone}": f"{side.capitalize()}{bone}"
        for side in ("left", "right")
        for bone in ("Shoulder", "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Toes", "RingProximal")
    },
}
BLENDER = {
    "hips": "hips", "spine": "spine", "chest": "chest", "neck": "neck", "head": "head",
    **{
        f"{side}{ours}": f"{theirs}.{side[0].upper()}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "shoulder", "UpperArm": "upper_arm", "LowerArm": "forearm", "Hand": "hand", "UpperLeg": "thigh",
            "LowerLeg": "shin", "Foot": "foot", "Toes": "toe",
        }.items()
    },
}  # fmt: skip
BIPED = {
    "hips": "Bip01 Pelvis", "spine": "Bip01 Spine", "chest": "Bip01 Spine1", "neck": "Bip01 Neck", "head": "Bip01 Head",
    **{
        f"{side}{ours}": f"Bip01 {side[0].upper()} {theirs}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "Clavicle", "UpperArm": "UpperArm", "LowerArm": "Forearm", "Hand": "Hand", "UpperLeg": "Thigh",
            "LowerLeg": "Calf", "Foot": "Foot", "Toes": "Toe0",
        }.items()
    },
}  # fmt: skip
CMU = {
    "hips": "Hips", "spine": "LowerBack", "chest": "Spine", "upperChest": "Spine1", "neck": "Neck", "head": "Head",
    **{
        f"{side}{ours}": f"{side.capitalize()}{theirs}"
        for side in ("left", "right")
        for ours, theirs in {
            "Shoulder": "Shoulder", "UpperArm": "Arm", "LowerArm": "ForeArm", "Hand": "Hand", "UpperLeg": "UpLeg",
            "LowerLeg": "Leg", "Foot": "Foot", "Toes": "ToeBase",
        }.items()
    },
    **{f"{side}ThumbMetacarpal": f"{side[0].upper()}Thumb" for side in ("left", "right")},
}  # fmt: skip
RIGS = {
    "Mixamo": MIXAMO,
    "Poser": POSER,
    "old BVH": OLD,
    "Rokoko": ROKOKO,
    "Unity": UNITY,
    "Blender": BLENDER,
    "3ds Max": BIPED,
    "CMU": CMU,
}
_OFFSETS = {
    "spine": (0, 0.1, 0), "chest": (0, 0.12, 0), "upperChest": (0, 0.1, 0), "neck": (0, 0.14, 0), "head": (0, 0.1, 0),
    "Shoulder": (0.03, 0.1, 0), "UpperArm": (0.12, 0, 0), "LowerArm": (0.28, 0, 0), "Hand": (0.24, 0, 0),
    "UpperLeg": (0.1, -0.05, 0), "LowerLeg": (0, -0.42, 0), "Foot": (0, -0.38, 0), "Toes": (0, -0.06, 0.14),
    "ThumbMetacarpal": (0.02, 0, 0.02), "IndexProximal": (0.09, 0, 0), "RingProximal": (0.09, 0, 0),
    "IndexIntermediate": (0.04, 0, 0),
}  # fmt: skip
"""Of a T-pose, metres from the parent; the hips are 0.93 above the floor."""
HIPS_METRES = 0.05 + 0.42 + 0.38 + 0.06 + 0.02
LEG_METRES = 0.8


def offset_of(bone: str) -> np.ndarray:
    """Where a bone begins from its parent in T-pose, metres."""
    name = bone.removeprefix("left").removeprefix("right")
    told = np.array(_OFFSETS[name if name != bone else bone], np.float64)
    return told * [-1.0, 1.0, 1.0] if bone.startswith("right") else told


def moving(bones: Sequence[str], frames: int = 20, seed: int = 1, most: float = 0.9) -> HumanoidMotion:
    """One whose bones all swing smoothly, hips move a little and turn farther than half round."""
    random = np.random.default_rng(seed)
    times = np.arange(frames) / 30.0
    ordered = tuple(bone for bone in PARENTS if bone in bones)
    turns = []
    for bone in ordered:
        to = random.uniform(-most, most, 3) * (0.2 if bone.endswith("Shoulder") else 1.0)
        vectors = np.linspace(0.2, 1.0, frames)[:, None] * to
        if bone == "hips":
            vectors = np.linspace(0.0, 4.0, frames)[:, None] * [0.0, 1.0, 0.0] + 0.1 * vectors
        turns.append(Rotation.from_rotvec(vectors).as_quat())
    hips = 0.3 * np.cumsum(random.uniform(-0.1, 0.1, (frames, 3)), axis=0)
    return HumanoidMotion(times, ordered, np.stack(turns, axis=1), hips)


def bvh_of(
    motion: HumanoidMotion,
    names: Mapping[str, str],
    *,
    order: str = "ZXY",
    unit: float = 100.0,
    rest: Mapping[str, Rotation] | None = None,
    places: bool = True,
    axes: Rotation | None = None,
) -> bytes:
    """A BVH of a motion.

    names: of joints; order: of rotations; unit: of a metre; rest: how far each bone is turned along the house's axes at
    rest from the T-pose (none: that); places: whether the root has any; axes: the house's, along ours.
    """
    house = Rotation.identity() if axes is None else axes
    at_rest = {bone: Rotation.identity() for bone in motion.names} | dict(rest or {})
    worlds = {bone: turn * at_rest[bone].inv() for bone, turn in motion.worlds().items()}
    lines = ["HIERARCHY"]
    columns: list[np.ndarray] = []

    def write(bone: str, depth: int) -> None:
        above = parent_among(bone, motion.names)
        local = house * (worlds[above].inv() * worlds[bone] if above else worlds[bone]) * house.inv()
        offset = house.apply(at_rest[above].apply(offset_of(bone)) if above else np.zeros(3)) * unit
        if not above and places:
            columns.append(house.apply(motion.hips * LEG_METRES + [0.0, HIPS_METRES, 0.0]) * unit)
        columns.append(local.as_euler(order, degrees=True))
        moves = "6 Xposition Yposition Zposition" if not above and places else "3"
        rotations = " ".join(f"{axis}rotation" for axis in order)
        lines.append(f"{'ROOT' if not above else 'JOINT'} {names[bone]}\n{{\nOFFSET {' '.join(map(str, offset))}")
        lines.append(f"CHANNELS {moves} {rotations}")
        below = [each for each in motion.names if each != bone and parent_among(each, motion.names) == bone]
        for each in below:
            write(each, depth + 1)
        if not below:
            ends = {"Toes": (0.0, -0.02, 0.06), "Foot": (0.0, -0.08, 0.14), "Metacarpal": (0.03, 0.0, 0.03)}
            end = next((np.array(to) for of, to in ends.items() if bone.endswith(of)), np.array([0.05, 0.0, 0.0]))
            if bone == "head" or bone == "neck":
                end = np.array([0.0, 0.1, 0.0])
            if bone.startswith("right"):
                end = end * [-1.0, 1.0, 1.0]
            lines.append(f"End Site\n{{\nOFFSET {' '.join(map(str, house.apply(at_rest[bone].apply(end)) * unit))}\n}}")
        lines.append("}")

    write("hips", 0)
    table = np.column_stack(columns)
    lines.append(f"MOTION\nFrames: {len(table)}\nFrame Time: 0.0333333333")
    lines += [" ".join(f"{number:.8f}" for number in row) for row in table.tolist()]
    return "\n".join(lines).encode()


def degrees_apart(one: HumanoidMotion, other: HumanoidMotion) -> dict[str, float]:
    """By how much bones that both have are turned otherwise, at most, along the axes of the house."""
    mine, theirs = one.worlds(), other.worlds()
    return {
        bone: float(np.degrees((mine[bone].inv() * theirs[bone]).magnitude().max())) for bone in mine if bone in theirs
    }
