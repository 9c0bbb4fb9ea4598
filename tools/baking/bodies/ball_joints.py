"""Solves what skinning makes wrong of raised and hanging arms and raised thighs, on each body.

Where limbs part from the trunk skin folds because places are blended, not because turns are: those change smoothly from
row to row. So its edges as modelled, turned as the bones of their rows turn them, are summed up to a skin that has no
fold (a Poisson problem), held back to the blended places by a little.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Mask, Points, Values
from omote.model.body.compose_pose import arm_turn
from omote.model.body.correctives import ARMS, HIP_BENDS, HIPS, SHOULDERS
from omote.model.body.posed_bones import PosedBones, place_bones
from omote.model.body.skeleton import Skeleton
from omote.model.body.stand import OUT, stand_turns
from omote.model.body.twist import spread_twist
from tools.baking.bodies.correctives import Elastic, Patch, Skinning, edges_turned, elastic_of, find_patch, skinned
from tools.baking.heads.basemesh import Ints

REACH = {"upperarm01": 0.17, "upperleg01": 0.21}
"""Metres around a joint of the generic body (1.67 m) within which its rows have correctives."""
BACK = 0.02
"""How stiffly a row is held to where skinning has it, in the mean stiffness of a row: with ten times as much a
fifth of the triangles around shoulders stays turned over."""
LEAST = 0.001
"""Added to the square of how a row answers to a move as modelled: blended turns of a raised arm leave some hardly any
answer."""


@dataclass(frozen=True, eq=False)
class BallJoint:
    """A joint that swings. bone: that begins there; patch: of it."""

    bone: str
    patch: Patch


def find_ball_joints(
    skinning: Skinning, joints: Points, generic: Points, triangles: Ints, first: int, taken: Ints
) -> list[BallJoint]:
    """Both hips, then both shoulders.

    joints (J, 3), generic (R, 3): of the generic figure, metres; triangles: of figures, without parts of skirts;
    first: row of the body, those before it are the head's; taken: rows that have correctives of other joints.
    """
    usable = np.isin(np.arange(len(generic)), triangles)
    usable[:first] = False
    usable[taken] = False
    found = []
    for bone, _ in (*HIPS, *SHOULDERS):
        kind, side = bone.split(".")
        near = np.linalg.norm(generic - joints[skinning.skeleton.places[bone]], axis=1) < REACH[kind]
        own: Mask = usable & near & (OUT[side] * generic[:, 0] > 0.0)
        found.append(BallJoint(bone, find_patch(own, triangles)))
    return found


def swings_of(bone: str, stand: Values) -> list[Values]:
    """The rotations (3, 3) from the modelled pose of a limb that its correctives are for. bone: the first of the limb;
    stand (3, 3): its rotation to the stand."""
    if bone.startswith("upperarm"):
        return [arm_turn(arm, OUT[bone[-1]]) @ stand for arm in ARMS]
    return [Rotation.from_euler("x", -bend, degrees=True).as_matrix() @ stand for bend in HIP_BENDS]


def swing_limb(skeleton: Skeleton, joints: Points, bone: str, swing: Values) -> PosedBones:
    """The bones of a body as modelled (J, 3) with one limb swung. bone: its first; swing (3, 3)."""
    still = np.tile(np.eye(3), (len(joints), 1, 1))
    turns = still.copy()
    hanging = {skeleton.places[bone]}
    for place, parent in enumerate(skeleton.parents):
        if place in hanging or int(parent) in hanging:
            hanging.add(place)
            turns[place] = swing
    return place_bones(skeleton, joints, still, spread_twist(skeleton, joints, still, turns), np.zeros(3))


def solve_ball_joint(joint: BallJoint, skinning: Skinning, rows: Points, joints: Points, ends: Points) -> Values:
    """The correctives (SHAPES, n, 3) of one joint of a body, metres, to be added to its rows as modelled.

    rows (R, 3), joints (J, 3), ends (J, 3): of the body as modelled.
    """
    skeleton = skinning.skeleton
    rest = rows[joint.patch.rows]
    elastic = elastic_of(rest, joint.patch)
    stand = stand_turns(skeleton, joints, ends)[skeleton.places[joint.bone]]
    wanted = []
    answers = []
    for swing in swings_of(joint.bone, stand):
        bones = swing_limb(skeleton, joints, joint.bone, swing)
        moved, answer = skinned(joint.patch, skinning, rest, joints, bones)
        wanted.append(_missing(elastic, joint.patch, moved, _row_turns(joint.patch, skinning, bones)))
        answers.append(answer)
    free = joint.patch.free
    held = elastic.stiffness + BACK * elastic.stiff * np.eye(free)
    steps = np.linalg.solve(held, np.concatenate(wanted, axis=1)).reshape(free, -1, 3).swapaxes(0, 1)
    turned = np.stack(answers)
    back = turned.swapaxes(-1, -2)
    return np.asarray(np.linalg.solve(back @ turned + LEAST * np.eye(3), back @ steps[..., None])[..., 0])


def _missing(elastic: Elastic, patch: Patch, moved: Points, turns: Values) -> Points:
    """By how much the edges of each free row, summed (n, 3), differ from those that turn alone would make.

    moved (n + r, 3): where skinning has the rows; turns (n + r, 3, 3): of their bones.
    """
    wanted = elastic.spread @ edges_turned(elastic, turns)
    now = elastic.spread @ (elastic.w[:, None] * (moved[elastic.i] - moved[elastic.j]))
    return np.asarray((wanted - now)[: patch.free])


def _row_turns(patch: Patch, skinning: Skinning, bones: PosedBones) -> Values:
    """How the bones of each row turn it, (n + r, 3, 3): the mean of their quaternions by its weights."""
    turns = Rotation.from_matrix(bones.turns).as_quat()[skinning.bones[patch.rows]]
    turns *= np.where((turns * turns[:, :1]).sum(axis=-1, keepdims=True) < 0.0, -1.0, 1.0)
    mean = (turns * skinning.weights[patch.rows][..., None]).sum(axis=1)
    return np.asarray(Rotation.from_quat(mean).as_matrix())
