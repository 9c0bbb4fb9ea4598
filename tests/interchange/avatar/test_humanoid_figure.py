"""The bones of figures as VRM names them: each below the one that VRM has above it; the rest hang in between."""

from __future__ import annotations

from omote.builtin import load_figures
from omote.interchange.avatar.humanoid_figure import humanoid_bones

TRUNK = {"spine": "hips", "chest": "spine", "upperChest": "chest", "neck": "upperChest", "head": "neck"}
LIMBS = {
    "Shoulder": "upperChest", "UpperArm": "Shoulder", "LowerArm": "UpperArm", "Hand": "LowerArm",
    "UpperLeg": "hips", "LowerLeg": "UpperLeg", "Foot": "LowerLeg", "Toes": "Foot",
}  # fmt: skip


def test_each_bone_lies_below_the_one_that_vrm_has_above_it() -> None:
    skeleton = load_figures().space.skeleton
    wanted = dict(TRUNK)
    for side in ("left", "right"):
        limbs = {f"{side}{name}": parent for name, parent in LIMBS.items()}
        wanted |= {name: f"{side}{parent}" if parent in LIMBS else parent for name, parent in limbs.items()}
        for finger in ("Thumb", "Index", "Middle", "Ring", "Little"):
            first, second = ("Metacarpal", "Proximal") if finger == "Thumb" else ("Proximal", "Intermediate")
            wanted |= {f"{side}{finger}{first}": f"{side}Hand", f"{side}{finger}{second}": f"{side}{finger}{first}"}
            wanted[f"{side}{finger}Distal"] = f"{side}{finger}{second}"
    bones = humanoid_bones()
    assert bones.keys() == {"hips", *wanted}
    places = {skeleton.places[bone]: name for name, bone in bones.items()}
    assert len(places) == len(bones)
    for name, above in wanted.items():
        place = skeleton.parents[skeleton.places[bones[name]]]
        while place not in places:
            place = skeleton.parents[place]
        assert places[place] == above
        assert name[:4] != "left" or bones[name].endswith(".L")
