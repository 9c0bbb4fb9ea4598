"""The bones of a figure as VRM names them, and its meshes on them, ears with joints of their own."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.sparse import csr_array, diags_array, hstack

from omote.arrays import Points, Values
from omote.interchange.avatar.humanoid_skeleton import Skeleton, eyes_middle
from omote.interchange.avatar.spring_bones import EarBone
from omote.interchange.export_face import SKIN
from omote.interchange.figures.figure_rig import HEAD, ExportedFigure
from omote.interchange.formats.glb_rig import Hanging, bind_strongest
from omote.interchange.formats.glb_writer import Shape
from omote.interchange.formats.rig import Rig
from omote.model.space.face_fit import FittedFace

_TRUNK = {
    "hips": "root", "spine": "spine04", "chest": "spine02", "upperChest": "spine01", "neck": "neck01", "head": HEAD,
}  # fmt: skip
_LIMBS = {
    "Shoulder": "clavicle", "UpperArm": "upperarm01", "LowerArm": "lowerarm01", "Hand": "wrist",
    "UpperLeg": "upperleg01", "LowerLeg": "lowerleg01", "Foot": "foot", "Toes": "toes",
}  # fmt: skip
_FINGERS = {"Thumb": 1, "Index": 2, "Middle": 3, "Ring": 4, "Little": 5}
_JOINTS = ("Proximal", "Intermediate", "Distal")
_THUMB = ("Metacarpal", "Proximal", "Distal")
SIDES = {"left": "L", "right": "R"}


def humanoid_bones() -> dict[str, str]:
    """Which of our bones is which of VRM's, by its names: the rest (twists, upper necks) follow those above them. There
    is no jaw and no eye among them: faces have expressions for both."""
    bones = dict(_TRUNK)
    for side, ending in SIDES.items():
        bones |= {f"{side}{name}": f"{bone}.{ending}" for name, bone in _LIMBS.items()}
        for finger, number in _FINGERS.items():
            names = _THUMB if finger == "Thumb" else _JOINTS
            bones |= {
                f"{side}{finger}{name}": f"finger{number}-{place}.{ending}" for place, name in enumerate(names, start=1)
            }
    return bones


def figure_skeleton(figure: ExportedFigure, fitted: FittedFace, /) -> Skeleton:
    """The joints of a figure in T-pose. figure: as it is exported; fitted: its face."""
    joints = {joint.name: joint for joint in figure.joints}
    x, y, z = (eyes_middle(figure.cast.space, fitted) + figure.shift - joints[HEAD].place).tolist()
    return Skeleton(joints, humanoid_bones(), figure.shift, (x, y, z))


def hang_figure(figure: ExportedFigure, shapes: Sequence[Shape], ears: Sequence[EarBone], /) -> Hanging:
    """How the shapes of a figure hang on its joints and those of its ears.

    figure: as it is exported; shapes: all of the scene, where they stand; ears: with joints of their own.
    """
    rig = figure.rig(shapes)
    names = (*(joint.name for joint in rig.joints), *(ear.root.name for ear in ears))
    apart = np.tile(np.eye(4), (len(ears), 1, 1))
    for matrix, ear in zip(apart, ears, strict=True):
        matrix[:3, 3] = -np.array(ear.root.place)
    weights = {shape.name: _weights(rig, shape, ears) for shape in shapes}
    whole = Rig(rig.joints, np.concatenate([rig.inverse, apart]), weights, rig.carrier, {})
    return Hanging(names, whole.inverse, {name: bind_strongest(whole, name) for name in weights})


def _weights(rig: Rig, shape: Shape, ears: Sequence[EarBone]) -> csr_array:
    """How much each joint, ears at the end, moves each vertex; what the rig does not bind is on the head."""
    count = len(shape.points)
    head = next(place for place, joint in enumerate(rig.joints) if joint.name == rig.carrier)
    on_head = csr_array((np.ones(count), (np.arange(count), np.full(count, head))), shape=(count, len(rig.joints)))
    bound = rig.weights.get(shape.name, on_head)
    shares = _ear_shares(shape, ears)
    left = diags_array(1.0 - shares.sum(axis=1))
    return csr_array(hstack([left @ bound, csr_array(shares)]))


def _ear_shares(shape: Shape, ears: Sequence[EarBone]) -> Values:
    """How much of each vertex hangs on each ear, (n, ears)."""
    nothing: Points = np.zeros((len(shape.points), len(ears)))
    if shape.name != SKIN or shape.rows is None or not ears:
        return nothing
    return np.stack([ear.shares[shape.rows] for ear in ears], axis=1)
