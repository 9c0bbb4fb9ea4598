"""Which joints of a BVH are which of VRM's bones, by what programs call them and how they hang together."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise

from omote.interchange.clips.bvh_reader import BvhJoint
from omote.interchange.clips.humanoid_motion import HIPS, LEGS

_SPLIT = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+")
_SIDES = {"left": "left", "l": "left", "right": "right", "r": "right"}
_HIPS = ("hips", "hip", "pelvis")
_LIMBS: Mapping[str, str] = {
    **dict.fromkeys(("collar", "clavicle"), "Shoulder"),
    **dict.fromkeys(("arm", "upperarm", "uparm", "shldr", "bicep"), "UpperArm"),
    **dict.fromkeys(("forearm", "lowerarm", "loarm", "elbow"), "LowerArm"),
    **dict.fromkeys(("hand", "wrist"), "Hand"),
    **dict.fromkeys(("upleg", "upperleg", "thigh", "hip"), "UpperLeg"),
    **dict.fromkeys(("leg", "lowerleg", "loleg", "shin", "knee", "calf"), "LowerLeg"),
    **dict.fromkeys(("foot", "ankle"), "Foot"),
    **dict.fromkeys(("toe", "toes", "toebase", "ball"), "Toes"),
}
"""What programs (Mixamo, CMU's by cgspeed, Poser, Rokoko, Unity, Blender, 3ds Max, VRoid) call the bones of limbs,
without the side. `shoulder` is either the first or the second bone of an arm, as there are others."""
_FINGERS = {
    **dict.fromkeys(("thumb", "finger1"), "Thumb"),
    **dict.fromkeys(("index", "pointer", "finger2"), "Index"),
    **dict.fromkeys(("middle", "mid", "finger3"), "Middle"),
    **dict.fromkeys(("ring", "finger4"), "Ring"),
    **dict.fromkeys(("pinky", "little", "finger5"), "Little"),
}
_JOINTS = ("Proximal", "Intermediate", "Distal")
_THUMB = ("Metacarpal", "Proximal", "Distal")
_ENDS = ("end", "tip", "nub", "site")


def humanoid_joints(joints: Sequence[BvhJoint]) -> dict[str, int]:
    """The places of joints, by the bones of VRM that they are.

    joints: of a file.

    Raises
    ------
    ValueError
        Where hips or legs are not found, or limbs do not hang together.
    """
    named = [_words(joint.name) for joint in joints]
    found = _limbs(joints, named)
    missing = [bone for bone in LEGS if bone not in found]
    if missing:
        raise ValueError(
            f"no joint of the file is the {missing[0]} of a person; name joints as Mixamo, VRM or CMU's BVH do "
            f"(it has {', '.join(joint.name for joint in joints if joint.name)[:200]})"
        )
    hips = next((place for place, (side, key) in enumerate(named) if not side and key in _HIPS), None)
    thighs = [_ancestors(joints, found[f"{side}UpperLeg"]) for side in ("left", "right")]
    common = next((place for place in thighs[0] if place in thighs[1]), None)
    if hips is None or hips not in thighs[0]:
        hips = common
    if hips is None:
        raise ValueError("the legs of the file hang on no joint that is both's; export the skeleton as one tree")
    found[HIPS] = hips
    found |= _trunk(joints, named, found)
    for side in ("left", "right"):
        _check_chain(joints, found, side)
        found |= _fingers(joints, named, found, side)
    return found


def _words(name: str) -> tuple[str, str]:
    """The side of a joint's name ("" for none) and the rest of it, in small letters without what stands between."""
    words = [word.lower() for word in _SPLIT.findall(name.rsplit(":", 1)[-1])]
    words = [word for word in words if word not in ("mixamorig", "bip", "bone", "def", "j", "c", "sec")]
    side = ""
    for word in words:
        if word in _SIDES:
            side = _SIDES[word]
            words.remove(word)
            break
    else:
        first = words[0] if words else ""
        for letter, of in (("left", "left"), ("right", "right"), ("l", "left"), ("r", "right")):
            rest = first.removeprefix(letter)
            if rest != first and (rest in _LIMBS or rest in _FINGERS or rest in ("shoulder", "buttock")):
                side = of
                words[0] = rest
                break
    return side, "".join(words).lstrip("0123456789")


def _limbs(joints: Sequence[BvhJoint], named: Sequence[tuple[str, str]]) -> dict[str, int]:
    """The places of the bones of arms and legs, the first of each name."""
    found: dict[str, int] = {}
    shoulders: dict[str, int] = {}
    for place, (side, key) in enumerate(named):
        if not side or not joints[place].channels:
            continue
        plain = key.rstrip("0123456789")
        if plain == "shoulder":
            shoulders.setdefault(side, place)
        elif plain in _LIMBS:
            found.setdefault(f"{side}{_LIMBS[plain]}", place)
    for side, place in shoulders.items():
        found.setdefault(f"{side}UpperArm" if f"{side}UpperArm" not in found else f"{side}Shoulder", place)
    return found


def _trunk(joints: Sequence[BvhJoint], named: Sequence[tuple[str, str]], found: Mapping[str, int]) -> dict[str, int]:
    """The spine from the hips to where arms hang, or to the neck; the neck and the head."""
    trunk: dict[str, int] = {}
    head = next((place for place, (side, key) in enumerate(named) if not side and key == "head"), None)
    neck = next(
        (place for place, (side, key) in enumerate(named) if not side and key.rstrip("0123456789") == "neck"), None
    )
    if head is None and neck is None:
        return trunk
    top = head if head is not None else neck
    assert top is not None
    path = [place for place in reversed(_ancestors(joints, top)) if joints[place].channels]
    if found[HIPS] not in path:
        raise ValueError("head and legs of the file hang on no joint that is both's; export the skeleton as one tree")
    path = path[path.index(found[HIPS]) + 1 :]
    spine = path[: path.index(neck)] if neck in path else [place for place in path if "neck" not in named[place][1]]
    spine = [place for place in spine if place != top]
    if spine:
        trunk["spine"] = spine[0]
    if len(spine) > 1:
        trunk["chest"] = spine[len(spine) // 2] if len(spine) > 2 else spine[1]
    if len(spine) > 2:
        trunk["upperChest"] = spine[-1]
    if neck is not None and neck in (*path, top):
        trunk["neck"] = neck
    if head is not None:
        trunk["head"] = head
    return trunk


def _fingers(
    joints: Sequence[BvhJoint], named: Sequence[tuple[str, str]], found: Mapping[str, int], side: str
) -> dict[str, int]:
    """The bones of fingers, the first three of each below the hand."""
    hand = found.get(f"{side}Hand")
    if hand is None:
        return {}
    chains: dict[str, list[int]] = {}
    for place in range(hand + 1, len(joints)):
        key = named[place][1].removeprefix("hand")
        if not joints[place].channels or key.endswith(_ENDS) or hand not in _ancestors(joints, place):
            continue
        finger = next((finger for name, finger in _FINGERS.items() if key.startswith(name)), None)
        if finger is not None and (finger == "Thumb" or "metacarpal" not in key):
            chains.setdefault(finger, []).append(place)
    return {
        f"{side}{finger}{joint}": place
        for finger, places in chains.items()
        for joint, place in zip(_THUMB if finger == "Thumb" else _JOINTS, places, strict=False)
    }


def _check_chain(joints: Sequence[BvhJoint], found: dict[str, int], side: str) -> None:
    """Raises ValueError where a limb does not hang on itself."""
    arm = [f"{side}{name}" for name in ("Shoulder", "UpperArm", "LowerArm", "Hand")]
    leg = [f"{side}{name}" for name in ("UpperLeg", "LowerLeg", "Foot", "Toes")]
    for chain in (arm, leg):
        there = [bone for bone in chain if bone in found]
        for above, below in pairwise(there):
            if found[above] not in _ancestors(joints, found[below]):
                raise ValueError(
                    f"the {below} of the file does not hang on its {above}; export the skeleton as one tree"
                )
        for bone in there:
            if found[HIPS] not in _ancestors(joints, found[bone]):
                raise ValueError(f"the {bone} of the file does not hang on its hips; export the skeleton as one tree")


def _ancestors(joints: Sequence[BvhJoint], place: int) -> list[int]:
    """A joint and all above it, nearest first."""
    chain = []
    while place >= 0:
        chain.append(place)
        place = joints[place].parent
    return chain
