"""The figure of a frame: bodies mixed, hung below the face, posed and skinned."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from omote.arrays import Floats, Points, Values
from omote.geometry.skinning import skin
from omote.model.body.correctives import SHAPES, corrective_calls
from omote.model.body.figure_space import FigureSpace, hang_joints, join_head
from omote.model.body.figures import Figures
from omote.model.body.posed_bones import PosedBones, place_bones, pose_bones
from omote.model.body.skeleton import LEG, SIDES, Skeleton
from omote.model.body.stand import stand_turns
from omote.model.body.twist import spread_twist
from omote.perform.figures.legs import reach_foot
from omote.perform.figures.pose_mix import MixedPose
from omote.perform.mix import Weights

HEAD_SHARES = {
    "head": 0.40, "neck03": 0.20, "neck02": 0.15, "neck01": 0.10, "spine01": 0.10, "spine02": 0.05,
}  # fmt: skip
"""Of the head's turn, how much each bone makes: frames with any fold 2 %, by neck alone 5 to 8 %, by the head alone
38 to 44 % (measured to 65 degrees of yaw)."""
SPINE = ("spine01", "spine02")
NECK_SHARE = sum(share for bone, share in HEAD_SHARES.items() if bone not in SPINE)
AHEAD = np.array([0.0, 0.0, 1.0])
"""Where knees point in the stand."""


@dataclass(frozen=True, eq=False)
class RestingFigure:
    """A figure before it is posed. rows (V + B, 3): head and body; joints (J, 3); stand (J, 3, 3): rotations to the
    stand; ankles (2, 3): where they are there; leg: its length; correctives
    (4 c, 3): of the mix, as of `Body`; metres."""

    rows: Points
    joints: Points
    stand: Values
    ankles: Points
    leg: float
    correctives: Points


def resting_figure(figures: Figures, bodies: Weights, head: Points, rest: Points | None = None) -> RestingFigure:
    """The mix of bodies below a head, as modelled.

    figures: of the cast; bodies: weights by name, sum one; head (V, 3): its skin as it is to be seen; rest (V, 3): the
    same face without an expression, which carries the joints, where that is another; metres.
    """
    space = figures.space
    still = head if rest is None else rest
    parts = [(weight, figures.body_of(name)) for name, weight in bodies.items()]
    body, edge, joints, ends, correctives = (
        sum(weight * getattr(part, what).astype(np.float64) for weight, part in parts)
        for what in ("positions", "edge", "joints", "ends", "correctives")
    )
    hung = hang_joints(space, joints, edge, still)
    turns = stand_turns(space.skeleton, hung, ends + (hung[0] - joints[0]))
    rows = np.concatenate([head, join_head(space, body, edge, head)])
    standing = place_bones(space.skeleton, hung, turns, np.tile(np.eye(3), (len(hung), 1, 1)), np.zeros(3))
    ankles = standing.joints[[space.skeleton.places[f"foot.{side}"] for side in SIDES]]
    return RestingFigure(rows, hung, turns, ankles, _leg_length(space.skeleton, hung), correctives)


def _leg_length(skeleton: Skeleton, joints: Points) -> float:
    """Of thigh and shin, the mean of both sides, metres."""
    chain = ("upperleg01", "lowerleg01", "foot")
    lengths = [
        np.linalg.norm(np.diff([joints[skeleton.places[f"{name}.{side}"]] for name in chain], axis=0), axis=1).sum()
        for side in SIDES
    ]
    return float(np.mean(lengths))


def turn_head(skeleton: Skeleton, turns: Values, head: Values, tracked: float = 0.0) -> Values:
    """The turns (J, 3) of a pose with the head's own, which neck and spine share.

    skeleton: of the figure; turns (J, 3): of the pose; head (3,): a rotation vector, radians; tracked: how much of a
    performer's trunk shows, which has turned by itself: so much of the spine's part goes to head and neck.
    """
    shared = turns.copy()
    for bone, share in HEAD_SHARES.items():
        whole = 0.0 if bone in SPINE else share / NECK_SHARE
        shared[skeleton.places[bone]] += (share + tracked * (whole - share)) * head
    return shared


def pose_figure(space: FigureSpace, resting: RestingFigure, pose: MixedPose) -> PosedBones:
    """The bones of a figure in a pose; its feet are where the pose puts them.

    space: of figures; resting: of `resting_figure`; pose: of `mix_poses`.
    """
    skeleton = space.skeleton
    travel = pose.travel * resting.leg
    bones = pose_bones(skeleton, resting.joints, resting.stand, pose.turns, travel)
    frames = bones.frames.copy()
    for number, side in enumerate(SIDES):
        at = {name: skeleton.places[f"{name}.{side}"] for name in LEG}
        target = resting.ankles[number] + pose.feet[number] * resting.leg
        hip, knee, ankle = (bones.joints[at[name]] for name in ("upperleg01", "lowerleg01", "foot"))
        thigh, shin, _ = reach_foot(hip, knee, ankle, target, frames[at["upperleg01"]] @ AHEAD)
        foot = Rotation.from_rotvec(pose.feet_turns[number]).as_matrix()
        toes = foot @ Rotation.from_rotvec(pose.turns[at["toes"]]).as_matrix()
        for names, turn in ((LEG[1:3], thigh), (LEG[3:5], shin)):
            for name in names:
                frames[at[name]] = turn @ frames[at[name]]
        frames[at["foot"]] = foot
        frames[at["toes"]] = toes
    return place_bones(skeleton, resting.joints, resting.stand, frames, travel)


def bent_rows(space: FigureSpace, resting: RestingFigure, bones: PosedBones) -> Points:
    """The rows (V + B, 3) of a figure as modelled with the correctives of its joints, metres, to be skinned.

    space, resting, bones: as of `pose_figure`.
    """
    if len(space.bending) == 0:
        return resting.rows
    weights = corrective_calls(space.skeleton, bones)[space.bending_hinges]
    rows = resting.rows.copy()
    rows[space.bending] += np.einsum("ca,acx->cx", weights, resting.correctives.reshape(SHAPES, -1, 3))
    return rows


def skin_figure(space: FigureSpace, resting: RestingFigure, bones: PosedBones) -> Floats:
    """The rows (V + B, 3) of a posed figure, metres. space, resting, bones: as of `pose_figure`."""
    rows = bent_rows(space, resting, bones)
    worn = skinning_bones(space, resting, bones)
    moved = skin(rows, space.bones, space.weights, space.shares, worn.turns, worn.shifts(resting.joints))
    return moved.astype(np.float32)


def skinning_bones(space: FigureSpace, resting: RestingFigure, bones: PosedBones) -> PosedBones:
    """The bones that skin follows: upper arms twist less where they begin (`spread_twist`), joints stay where they are.

    space, resting, bones: as of `pose_figure`.
    """
    rest = resting.joints
    frames = spread_twist(space.skeleton, rest, resting.stand, bones.frames)
    return place_bones(space.skeleton, rest, resting.stand, frames, bones.joints[0] - rest[0])
